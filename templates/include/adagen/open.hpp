// adagen's runtime, the same for all robots.
#pragma once

#include <mpi.h>

#include <exception>
#include <memory>
#include <string>

#include "open_failure.hpp"
#include "relax.hpp"
#include "sizes.hpp"
#include "status.hpp"

namespace {

// Why the arguments are refused; an empty string if they are not.
inline std::string why_not_open(MPI_Comm comm, const std::string& kind, double time_limit) {
  int ready = 0, size = 0;
  MPI_Initialized(&ready);
  if (ready == 0) return "MPI is not initialised: call MPI_Init first";
  MPI_Comm_size(comm, &size);
  if (size != kProcesses)
    return "this solver is for exactly " + std::to_string(kProcesses) +
           " processes, the communicator has " + std::to_string(size);
  if (kind != "auto" && kind != "window" && kind != "message")
    return "channel takes auto, window or message, not " + kind;
  return time_limit > 0 ? "" : "the time limit must be more than 0 s";
}

inline ChannelMode mode_of(const std::string& kind) {
  return kind == "window"    ? ChannelMode::kWindow
         : kind == "message" ? ChannelMode::kMessage
                             : ChannelMode::kAuto;
}

template <class AnySolver>
AnySolver* opened(MPI_Comm comm, const char* channel, double time_limit) {
  open_failure.clear();
  try {
    const std::string kind = channel == nullptr ? "auto" : channel;
    std::string wrong = why_not_open(comm, kind, time_limit);
    if (wrong.empty()) {
      auto solver = std::make_unique<AnySolver>();
      wrong = solver->channel.open(comm, mode_of(kind), time_limit);
      if (wrong.empty()) return solver.release();
      solver->channel.close();
    }
    open_failure += wrong.c_str();
  } catch (const std::exception& error) {
    open_failure += error.what();
  }
  return nullptr;
}

}  // namespace
