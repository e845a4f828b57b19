// adagen's runtime, the same for all robots.
#pragma once

#include <mpi.h>

#include <array>
#include <exception>
#include <memory>
#include <new>
#include <string>

#include "open_failure.hpp"
#include "relax.hpp"
#include "sizes.hpp"
#include "status.hpp"

namespace {

// Why no solver can be opened over a communicator; an empty string if one can. The same on all of
// its processes.
inline std::string why_not_over(MPI_Comm comm) {
  int ready = 0, over = 0, remote = 0, size = 0;
  MPI_Initialized(&ready);
  if (ready == 0) return "MPI is not initialised: call MPI_Init first";
  MPI_Finalized(&over);
  if (over != 0) return "MPI is finalised already: open solvers before MPI_Finalize";
  if (comm == MPI_COMM_NULL) return "the communicator is MPI_COMM_NULL";
  MPI_Comm_test_inter(comm, &remote);
  if (remote != 0) return "the communicator is an intercommunicator";
  MPI_Comm_size(comm, &size);
  if (size != kProcesses)
    return "this solver is for exactly " + std::to_string(kProcesses) +
           " processes, the communicator has " + std::to_string(size);
  return "";
}

// Why the arguments of one process are refused; an empty string if they are not.
inline std::string why_not_open(const std::string& kind, double time_limit) {
  if (kind != "auto" && kind != "window" && kind != "message")
    return "channel takes auto, window or message, not " + kind;
  return time_limit > 0 ? "" : "the time limit must be more than 0 s";
}

inline ChannelMode mode_of(const std::string& kind) {
  return kind == "window"    ? ChannelMode::kWindow
         : kind == "message" ? ChannelMode::kMessage
                             : ChannelMode::kAuto;
}

// Collective. Why none of the processes opens a solver, each knowing what is wrong with its own
// arguments: otherwise some would wait for ever for one that has given up.
inline std::string agreed(MPI_Comm comm, const std::string& wrong, const std::string& kind) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  const int mode = static_cast<int>(mode_of(kind));
  std::array<int, 3> least{wrong.empty() ? kProcesses : rank, mode, -mode};
  MPI_Allreduce(MPI_IN_PLACE, least.data(), 3, MPI_INT, MPI_MIN, comm);
  if (!wrong.empty()) return wrong;
  if (least[0] < kProcesses)
    return "process " + std::to_string(least[0]) +
           " of the communicator cannot open it, and says why";
  return least[1] == -least[2] ? "" : "processes name different channels";
}

// refused: why this process cannot have the solver; null if it can.
template <class AnySolver>
AnySolver* opened(MPI_Comm comm, const char* channel, double time_limit, const char* refused) {
  open_failure.clear();
  try {
    const std::string kind = channel == nullptr ? "auto" : channel;
    std::string wrong = why_not_over(comm);
    std::unique_ptr<AnySolver> solver;
    if (wrong.empty()) {
      solver.reset(new (std::nothrow) AnySolver);
      wrong = refused != nullptr ? refused : why_not_open(kind, time_limit);
      if (solver == nullptr) wrong = "not enough memory";
      wrong = agreed(comm, wrong, kind);
    }
    if (wrong.empty()) {
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
