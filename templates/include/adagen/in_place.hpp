// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "failures.hpp"
#include "sample/channel.hpp"
#include "sample/processes.hpp"
#include "sample/workspace.hpp"
#include "sizes.hpp"
#include "stamp.hpp"
#include "status.hpp"
#include "tiny_numbers.hpp"

namespace {

// One process, or thread, of a solver: state and result in place.
class InPlace {
 public:
  Workspace w;
  Channel channel;
  Text text;  // of the last failure

  [[maybe_unused]] static constexpr int kWorkspaces = 1;
  Workspace& workspace(int) { return w; }

  // Reads what this process needs, writes what it owns.
  int solve(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    if (kAlone && kProcesses > 1 && channel.rank() != 0) return finish(kFine);
    if (channel.broken()) return finish(channel.no_answer());
    prepare(q, v, tau, qdd);
    run();
    return finish(w.status);
  }

 protected:
  // A pose that a try cannot stand is known to all processes: they try the next way together.
  void run() {
    [[maybe_unused]] const TinyAreZero tiny;
    const std::size_t rank = kAlone ? 0 : static_cast<std::size_t>(channel.rank());
    stamp(0);
    kRun[rank](w, channel);
#ifdef ADAGEN_RECOVERS
    for (std::size_t k = rank; k < kRecover.size(); k += std::size_t(kProcesses)) {
      if (failure_kind(w.status) != kSingularPose) return;
      w.status = kFine;
      stamp(0);
      kRecover[k](w, channel);
    }
#endif
  }

  void prepare(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    w.q = q;
    w.v = velocities_of(v);
    w.tau = tau;
    w.qdd = qdd;
    w.status = kFine;
  }

  int finish(int status) {
    if (status != kFine) text = describe(status);
    return status;
  }
};

}  // namespace
