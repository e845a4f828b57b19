// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "channel.hpp"
#include "constants.hpp"
#include "in_place.hpp"
#include "sample/parameters.hpp"
#include "sample/processes.hpp"
#include "sizes.hpp"
#include "status.hpp"

namespace {

// The entries of a vector that a process needs, one after another, and back.
inline Number* pack(Number* to, const Ranges& which, const Number* x) {
  for (int k = 0; k < which.count; ++k)
    to = std::copy_n(x + which.ranges[k].first, which.ranges[k].count, to);
  return to;
}
inline const Number* unpack(const Number* from, const Ranges& which, Number* x) {
  for (int k = 0; k < which.count; ++k) {
    const auto& [first, count] = which.ranges[k];
    std::copy_n(from, count, x + first);
    from += count;
  }
  return from;
}

// Hands states and accelerations between process 0 and the others. Messages behind the plan's own:
// first the state to each process, then the accelerations from each.
class Solver : public InPlace {
 public:
  // Everything through process 0: it has the state and gets all accelerations.
  int solve_at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    if constexpr (kAlone) return solve(q, v, tau, qdd);
    if (channel.broken()) return finish(channel.no_answer());
    return channel.rank() == 0 ? solve_as_root(q, v, tau, qdd) : solve_for_root();
  }

  // At process 0: the others' next solve_at_root returns kEnded, and so does this.
  int end_at_root() {
    if constexpr (kAlone) return kFine;
    return solve_as_root(q_.data(), v_.data(), tau_.data(), qdd_.data(), failure(kEnded, 0));
  }

  // On other processes: evaluates together with process 0 until that ends.
  int serve() {
    const int rank = channel.rank();
    if (rank == 0) return kFine;
    int status = kFine;
    if (has_part(rank)) do
        status = channel.broken() ? channel.no_answer() : solve_for_root(true);
      while (failure_kind(status) != kEnded && failure_kind(status) != kNoAnswer);
    else
      channel.await_end();
    return failure_kind(status) == kEnded ? kFine : finish(status);
  }

  // Collective.
  void close() { channel.close(); }

  // At process 0: the others serve no longer.
  int end() {
    if (channel.rank() != 0) return kFine;
    const int status = end_at_root();
    for (int p = 1; p < kProcesses; ++p)
      if (!has_part(p)) channel.send_end(p);
    return failure_kind(status) == kEnded ? kFine : finish(status);
  }

 private:
  // Whether a process computes when all data goes through process 0.
  static bool has_part(int p) {
    return !kAlone && kProcess[static_cast<std::size_t>(p)].takes_part();
  }

  // patient: however long process 0 lets it wait.
  int solve_for_root(bool patient = false) {
    const int rank = channel.rank();
    const ProcessInfo& own = kProcess[static_cast<std::size_t>(rank)];
    if (!own.takes_part()) return finish(kFine);
    int status = kFine;
    const Number* content = channel.receive(state_message(rank), status, patient);
    content = unpack(content, own.q, q_.data());
    content = unpack(content, own.v, v_.data());
    content = unpack(content, own.tau, tau_.data());
    unpack_parameters(content, w);
    prepare(q_.data(), v_.data(), tau_.data(), qdd_.data());
    Channel::fail(w.status, status);
    run();
    Number* result = channel.outgoing(result_message(rank), w.status);
    pack(result, own.own, qdd_.data());
    channel.send(result_message(rank), w.status);
    return finish(w.status);
  }

  int solve_as_root(const Number* q, const Number* v, const Number* tau, Number* qdd,
                    int status = kFine) {
    for (int p = 1; p < kProcesses; ++p) {
      const ProcessInfo& other = kProcess[static_cast<std::size_t>(p)];
      if (!other.takes_part()) continue;
      Number* content = channel.outgoing(state_message(p), status);
      content = pack(content, other.q, q);
      content = pack(content, other.v, velocities_of(v));
      content = pack(content, other.tau, tau);
      pack_parameters(content, w);
      channel.send(state_message(p), status);
    }
    prepare(q, v, tau, qdd_.data());
    Channel::fail(w.status, status);
    run();
    for (int p = 1; p < kProcesses; ++p) {
      const ProcessInfo& other = kProcess[static_cast<std::size_t>(p)];
      if (!other.takes_part()) continue;
      const Number* result = channel.receive(result_message(p), w.status);
      unpack(result, other.own, qdd_.data());
    }
    if (w.status == kFine) std::copy(qdd_.begin(), qdd_.end(), qdd);
    return finish(w.status);
  }

  static int state_message(int process) { return kPlanMessages + 2 * (process - 1); }
  static int result_message(int process) { return kPlanMessages + 2 * (process - 1) + 1; }

  std::array<Number, kNq> q_{};
  std::array<Number, kNv> v_{};
  std::array<Number, kNqdd> qdd_{};
  std::array<Number, kNtau> tau_{};
};

}  // namespace
