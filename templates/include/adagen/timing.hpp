// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>
#include <cstdio>
#include <fstream>
#include <ios>
#include <string>
#include <utility>
#include <vector>

#include "batch_timing.hpp"
#include "cores.hpp"
#include "options.hpp"
#include "program_setting.hpp"
#include "session.hpp"
#include "statistics.hpp"
#include "status.hpp"
#include "stretches.hpp"
#include "trace.hpp"

namespace adagen {
namespace {

// How long an evaluation takes (--time, --stretches), and where the time goes (--trace).
class Timing {
 public:
  explicit Timing(Session& session) : session_(session) {}

  int time_all() {
    const Cores cores(session_.comm());
    crowded_ = !cores.enough() || cores.count() < about.threads;
    cores_ = cores.count();
    if (about.batch) return time_batch(cores);
    session_.use(random_states(kRandomStates, session_.options.seed, session_.solver));
    if ((crowded_ && about.threads == 1) || session_.options.stretches)
      return time_stretches(cores);
    session_.pinned = session_.options.pin && cores.pin();
    std::vector<double> in_place, at_root;
    int failed = kFine;
    for (int pass = -1; pass < session_.options.repeat && failed == kFine;
         ++pass) {  // the first one warms up
      session_.watch.again();
      for (int s = 0; s < session_.states.count; ++s) {
        const Elapsed found = session_.solver.time(session_.q(s), session_.v(s), session_.tau(s),
                                                   session_.acceleration(s));
        const int first = found.status_in_place, second = found.status_at_root;
        session_.give_up_if_broken(first);
        session_.give_up_if_broken(second);
        if (failed == kFine) failed = first != kFine ? first : second;
        if (pass < 0) continue;
        in_place.push_back(found.in_place);
        at_root.push_back(found.at_root);
      }
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, session_.comm());
    }
    if (failed != kFine)
      return session_.complain(kInputAtFault,
                               "random state: " + std::string(session_.solver.in_words(failed)));
    // An evaluation is over when its last process is done.
    MPI_Allreduce(MPI_IN_PLACE, in_place.data(), static_cast<int>(in_place.size()), MPI_DOUBLE,
                  MPI_MAX, session_.comm());
    in_place_ = statistics(std::move(in_place));
    at_root_ = statistics(std::move(at_root));
    evaluations_ = session_.options.repeat * kRandomStates;
    return kDone;
  }

  // Where processes share cores, or where it is asked for.
  int time_stretches(const Cores& cores) {
    const auto turn = [&] {
      if (session_.options.pin) cores.pin_in_turn();
    };
    Stretches stretches(session_);
    int failed = stretches.measure(true, turn);
    if (failed == kFine) at_root_ = stretches.played_through();
    if (failed == kFine) failed = stretches.measure(false, turn);
    if (failed != kFine)
      return session_.complain(kInputAtFault,
                               "random state: " + std::string(session_.solver.in_words(failed)));
    in_place_ = stretches.played_through();
    work_ = stretches.work();
    evaluations_ = stretches.evaluations();
    return kDone;
  }

  int time_batch(const Cores& cores) {
    session_.pinned = session_.options.pin && cores.pin();
    const int failed = batches_.measure();
    if (failed != kFine)
      return session_.complain(kInputAtFault,
                               "random states: " + std::string(session_.solver.in_words(failed)));
    in_place_ = batches_.in_place();
    at_root_ = batches_.at_root();
    evaluations_ = session_.options.repeat * BatchTiming::kStates;
    return kDone;
  }

  // The same evaluations with time stamps between the stages of each process.
  int trace_all() {
    session_.use(random_states(kRandomStates, session_.options.seed, session_.solver));
    if (!session_.pinned && session_.options.pin) session_.pinned = Cores(session_.comm()).pin();
    Trace trace(session_.rank);
    int failed = kFine;
    for (int pass = -1; pass < session_.options.repeat && failed == kFine; ++pass) {
      session_.watch.again();
      for (int s = 0; s < session_.states.count; ++s) {
        const int found = session_.solver.trace(session_.q(s), session_.v(s), session_.tau(s),
                                                session_.acceleration(s), trace.stamps());
        session_.give_up_if_broken(found);
        trace.end(session_.comm(), pass >= 0);
        if (failed == kFine) failed = found;
      }
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, session_.comm());
    }
    if (failed != kFine)
      return session_.complain(kInputAtFault,
                               "random state: " + std::string(session_.solver.in_words(failed)));
    const std::string text =
        trace.text(session_.comm(), session_.solver.channel_name(), session_.pinned);
    int status = kDone;
    if (session_.rank == 0) {
      std::ofstream file(session_.options.trace, std::ios::binary);
      if (!(file << text << std::flush))
        status = session_.complain(kFault, "cannot write the trace", session_.options.trace);
    }
    MPI_Bcast(&status, 1, MPI_INT, 0, session_.comm());
    return status;
  }

  // Nothing where nothing was timed.
  std::string json() const {
    if (evaluations_ == 0) return "";
    std::string text = ", \"time\": {\"source\": ";
    text += work_.empty() ? "\"clock\"" : "\"stretches\"";
    text += ", \"evaluations\": " + std::to_string(evaluations_);
    text += session_.pinned ? ", \"pinned\": true" : ", \"pinned\": false";
    text += figures("in_place", in_place_) + figures("through_root", at_root_);
    std::string each;
    for (const double ns : work_) each += (each.empty() ? "" : ", ") + whole(ns);
    if (!each.empty()) text += ", \"work_ns\": [" + each + "]";
    return text + batches_.json() + "}";
  }

  void print(std::FILE* out) const {
    if (evaluations_ == 0) return;
    const bool threads = about.threads > 1;
    const int count = threads ? about.threads : about.processes;
    const char* const what = threads ? "thread" : "process";
    const char* const many = count == 1 ? "" : threads ? "s" : "es";
    std::fprintf(out, "time   %d %s%s%s, ns per %s: median, minimum, 99th percentile\n", count,
                 what, many, session_.pinned ? ", pinned" : "",
                 about.batch ? "state and process" : "evaluation");
    if (crowded_)
      std::fprintf(out, "       (%d cores for %d %s%s: a wall time %s)\n", cores_, count, what,
                   many, about.batch || threads ? "says little" : "would mean nothing");
    if (!work_.empty())
      std::fprintf(out,
                   "       (computed from the stretches of each process, measured by itself, and "
                   "from\n        messages of %.0f ns each and %.2f per number)\n",
                   hop().send + hop().latency, hop().number);
    std::fprintf(out, "       state and result in place       %8.0f %8.0f %8.0f\n",
                 in_place_.median, in_place_.least, in_place_.percentile99);
    std::fprintf(out, "       everything through process 0    %8.0f %8.0f %8.0f\n", at_root_.median,
                 at_root_.least, at_root_.percentile99);
    if (!work_.empty()) {
      std::fprintf(out, "       each process computes           ");
      for (const double ns : work_) std::fprintf(out, "%8.0f ", ns);
      std::fprintf(out, "\n");
    }
    batches_.print(out);
  }

 private:
  static std::string whole(double ns) { return std::to_string(std::llround(ns)); }

  static std::string figures(const char* what, const Statistics& of) {
    char middle[40];
    std::snprintf(middle, sizeof middle, ", \"middle_ns\": %.1f}", of.middle);
    return std::string(", \"") + what + "\": {\"median_ns\": " + whole(of.median) +
           ", \"min_ns\": " + whole(of.least) + ", \"p99_ns\": " + whole(of.percentile99) + middle;
  }

  const Hop& hop() const { return hop_of(session_.solver); }

  Session& session_;
  int evaluations_ = 0;
  bool crowded_ = false;  // not a core for each process
  int cores_ = 0;
  Statistics in_place_, at_root_;
  BatchTiming batches_{session_};
  std::vector<double> work_;  // of each process, where times are from stretches
};

}  // namespace
}  // namespace adagen
