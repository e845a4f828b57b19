// adagen's runtime, the same for all robots.
#pragma once

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "certificates.hpp"
#include "corrections.hpp"
#include "json.hpp"
#include "open_by.hpp"
#include "options.hpp"
#include "program_setting.hpp"
#include "session.hpp"
#include "simulate.hpp"
#include "states.hpp"
#include "status.hpp"
#include "timing.hpp"
#include "verdict.hpp"

namespace adagen {
namespace {

// The program around the solver: solves given states, checks, times, simulates, reports.

class Program {
 public:
  Program(Options options, Solver& solver, int rank) : session_(std::move(options), solver, rank) {}

  int run() {
    const Options& options = session_.options;
    session_.watch.start(session_.rank, options.time_limit);
    const Opening how{options.channel.c_str(), options.time_limit, options.hosts, options.pin};
    const std::string wrong = session_.solver.open(MPI_COMM_WORLD, how);
    if (!wrong.empty()) return session_.complain(kFault, wrong);
    int status = options.simulation.seconds > 0 ? simulation_.run() : answer();
    const auto also = [&status](bool asked, auto task) {
      if (!asked || status == kFault || status == kUsage) return;
      const int found = task();
      if (status == kDone) status = found;
    };
    also(options.time, [this] { return timing_.time_all(); });
    also(!options.trace.empty(), [this] { return timing_.trace_all(); });
    if (status != kFault) collect_warnings();
    if (session_.rank == 0 && status != kFault) report();
    session_.watch.again();
    session_.solver.close();
    return status;
  }

 private:
  // Solves the given states, or random ones to be checked.
  int answer() {
    const Options& options = session_.options;
    int status = kDone;
    if (!options.states.empty()) {
      status = session_.load_states();
      const bool loaded = status == kDone;
      if (loaded) status = solve_all();
      if ((status == kDone || (about.batch && loaded)) && session_.rank == 0) {
        const std::string path = options.result.empty() ? "/dev/stdout" : options.result;
        if (!write_result(path, session_.qdd, session_.states.count,
                          corrections_.every() + certificates_.every()))
          status = session_.complain(kFault, "cannot write the result", path);
      }
      MPI_Bcast(&status, 1, MPI_INT, 0, session_.comm());
    } else if (options.check) {
      session_.states = random_states(kRandomStates, options.seed, session_.solver);
      status = solve_all();
    }
    session_.watch.again();
    if (status == kDone && options.check) status = check_all();
    return status;
  }

  // Accelerations of all states, in place, then gathered at process 0.
  int solve_all() {
    Session& on = session_;
    on.use(std::move(on.states));
    if (about.batch) return solve_many();
    int at = 0;
    const int failed = solve_each(at, [&] {
      corrections_.note(on.solver);
      if (about.certified) certificates_.note(on.solver.error_bound(0));
    });
    if (failed != kFine)
      return on.complain(kInputAtFault,
                         "state " + std::to_string(at + 1) + ": " + on.solver.in_words(failed) +
                             loops::how_far(failed, on.q(at), on.v(at)) +
                             (on.options.check ? Verdict::of_model() : ""),
                         on.options.states);
    bring_together();
    return kDone;
  }

  // One state after the other, up to the first that fails; then does after each.
  template <class Then>
  int solve_each(int& at, Then then) {
    Session& on = session_;
    int failed = kFine;
    for (int s = 0; s < on.states.count && failed == kFine; ++s) {
      on.watch.again();
      failed = on.solver.solve(on.q(s), on.v(s), on.tau(s), on.acceleration(s));
      on.give_up_if_broken(failed);
      then();
      // Processes that share no joint's motion do not hear of each other's failures by themselves.
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, on.comm());
      at = s;
    }
    return failed;
  }

  // As many states at once as there are lanes. States that fail are named, all others solved.
  int solve_many() {
    constexpr int kNamed = 20;
    Session& on = session_;
    Solver& solver = on.solver;
    int status = kDone;
    solve_batch();
    for (int s = 0; s < on.states.count && about.certified; ++s)
      certificates_.note(solver.error_bound(s));
    solved_ = on.states.count - solver.failures();
    if (solver.failures() > 0) status = kInputAtFault;
    for (int k = 0; k < kNamed; ++k) {
      const int s = solver.failed_state(k);
      if (s < 0) break;
      const std::string far = loops::how_far(solver.failed_status(k), on.q(s), on.v(s));
      on.complain(status, solver.why() + far, on.options.states);
    }
    if (solver.failures() > kNamed) on.complain(status, "and more states", on.options.states);
    MPI_Bcast(&status, 1, MPI_INT, 0, on.comm());
    return status;
  }

  void solve_batch() {
    Session& on = session_;
    on.give_up_if_broken(on.solver.solve_batch_at_root(on.states.count, on.q(0), on.v(0), on.tau(0),
                                                       on.acceleration(0)));
  }

  // The same for generated states: whether all were solved.
  bool solve_quietly() {
    Session& on = session_;
    on.use(std::move(on.states));
    int failed = kFine, at = 0;
    if (about.batch) {
      solve_batch();
      failed = on.rank == 0 ? on.solver.failures() : 0;
      MPI_Bcast(&failed, 1, MPI_INT, 0, on.comm());
    } else {
      failed = solve_each(at, [] {});
      if (failed == kFine) bring_together();
    }
    return failed == kFine;
  }

  void bring_together() {
    Session& on = session_;
    solved_ = on.states.count;
    // Each process wrote its own joints and left the others zero.
    void* const all = on.qdd.data();
    const int size = static_cast<int>(on.qdd.size());
    if (on.rank == 0)
      MPI_Reduce(MPI_IN_PLACE, all, size, kMpiNumber, MPI_SUM, 0, on.comm());
    else
      MPI_Reduce(all, nullptr, size, kMpiNumber, MPI_SUM, 0, on.comm());
  }

  // Judges the answers; asks the solver for some more, to see how much an error in a row matters.
  int check_all() {
    Session& on = session_;
    const States states = on.states;
    const std::vector<Number> qdd = on.qdd;
    verdict_.listen(on.rank, states);
    for (int s = 0; s < states.count && on.rank == 0; ++s)
      verdict_.note_answer(s, on.acceleration(s));
    for (int probe = 0; probe < Verdict::kProbes; ++probe) {
      if (on.rank == 0) on.states = verdict_.states_of(probe);
      if (!about.batch) on.share_states();
      if (!solve_quietly()) break;
      for (int s = 0; s < states.count && on.rank == 0; ++s)
        verdict_.note_response(probe, s, on.states, on.acceleration(s));
    }
    on.states = states, on.qdd = qdd;
    int status = on.rank > 0 || verdict_.judge(on.options.tolerance) ? kDone : kInputAtFault;
    MPI_Bcast(&status, 1, MPI_INT, 0, on.comm());
    return status;
  }

  // Conditions that cost digits but are no failure, each reported once.
  void collect_warnings() {
    int joint = session_.solver.near_lock();
    MPI_Allreduce(MPI_IN_PLACE, &joint, 1, MPI_INT, MPI_MAX, session_.comm());
    if (joint == 0) return;
    warning_ = std::string("joints ") + session_.solver.names_of_run(joint - 1) +
               ": near gimbal lock at some state: accelerations lose three digits or more";
    if (session_.rank == 0) std::fprintf(stderr, "warning: %s\n", warning_.c_str());
  }

  void report() const {
    const Options& options = session_.options;
    if (options.json) {
      std::printf("{\"model\": %s, \"processes\": %d, \"channel\": \"%s\"",
                  quoted(about.robot).c_str(), about.processes, session_.solver.channel_name());
      if (!options.states.empty() && options.simulation.seconds == 0)
        std::printf(", \"solved\": %d", solved_);
      if (!warning_.empty()) std::printf(", \"warnings\": [%s]", quoted(warning_.c_str()).c_str());
      std::printf("%s%s%s%s%s}\n", verdict_.json().c_str(), corrections_.json().c_str(),
                  certificates_.json().c_str(), timing_.json().c_str(), simulation_.json().c_str());
      return;
    }
    std::FILE* const out = options.states.empty() || !options.result.empty() ? stdout : stderr;
    verdict_.print(out);
    corrections_.print(out);
    certificates_.print(out);
    timing_.print(out);
    simulation_.print();
  }

  Session session_;
  Timing timing_{session_};
  Simulation simulation_{session_};
  Corrections corrections_;
  Certificates certificates_;
  Verdict verdict_;
  int solved_ = 0;
  std::string warning_;
};

}  // namespace
}  // namespace adagen
