// The program around the solver: solves given states, checks, times, simulates, reports.

class Program {
 public:
  Program(Options options, Solver& solver, int rank) : session_(std::move(options), solver, rank) {}

  int run() {
    const Options& options = session_.options;
    session_.watch.start(session_.rank, options.time_limit);
    const std::string wrong = session_.solver.open(MPI_COMM_WORLD, options.channel.c_str(),
                                                   options.time_limit, options.hosts);
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
      status = load(options.states, session_.comm(), session_.rank, session_.states);
      const bool loaded = status == kDone;
      if (loaded) status = solve_all();
      if ((status == kDone || (about.batch && loaded)) && session_.rank == 0) {
        const std::string path = options.result.empty() ? "/dev/stdout" : options.result;
        if (!write_result(path, session_.qdd, session_.states.count, corrections_.every()))
          status = session_.complain(kFault, "cannot write the result", path);
      }
      MPI_Bcast(&status, 1, MPI_INT, 0, session_.comm());
    } else if (options.check) {
      session_.states = random_states(kRandomStates, options.seed);
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
    int failed = kFine, at = 0;
    for (int s = 0; s < on.states.count && failed == kFine; ++s) {
      on.watch.again();
      failed = on.solver.solve(on.q(s), on.v(s), on.tau(s), on.acceleration(s));
      on.give_up_if_broken(failed);
      corrections_.note(on.solver);
      // Processes that share no joint's motion do not hear of each other's failures by themselves.
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, on.comm());
      at = s;
    }
    if (failed != kFine)
      return on.complain(kInputAtFault,
                         "state " + std::to_string(at + 1) + ": " + on.solver.in_words(failed),
                         on.options.states);
    return bring_together();
  }

  // As many states at once as there are lanes. States that fail are named, all others solved.
  int solve_many() {
    constexpr int kNamed = 20;
    Session& on = session_;
    Solver& solver = on.solver;
    int status = kDone;
    on.give_up_if_broken(solver.solve_batch_at_root(on.states.count, on.q(0), on.v(0), on.tau(0),
                                                    on.acceleration(0)));
    solved_ = on.states.count - solver.failures();
    if (solver.failures() > 0) status = kInputAtFault;
    for (int k = 0; k < kNamed && solver.failed_state(k) >= 0; ++k)
      on.complain(status, solver.why(), on.options.states);
    if (solver.failures() > kNamed) on.complain(status, "and more states", on.options.states);
    MPI_Bcast(&status, 1, MPI_INT, 0, on.comm());
    return status;
  }

  int bring_together() {
    Session& on = session_;
    solved_ = on.states.count;
    // Each process wrote its own joints and left the others zero.
    void* const all = on.qdd.data();
    const int size = static_cast<int>(on.qdd.size());
    if (on.rank == 0)
      MPI_Reduce(MPI_IN_PLACE, all, size, kMpiNumber, MPI_SUM, 0, on.comm());
    else
      MPI_Reduce(all, nullptr, size, kMpiNumber, MPI_SUM, 0, on.comm());
    return kDone;
  }

  int check_all() {
    Session& on = session_;
    int status = kDone;
    if (on.rank == 0) {
      std::vector<double> residuals;
      for (int s = 0; s < on.states.count; ++s)
        residuals.push_back(check::residual(on.q(s), on.v(s), on.tau(s), on.acceleration(s)));
      std::sort(residuals.begin(), residuals.end());
      residual_median_ = residuals[residuals.size() / 2];
      residual_max_ = residuals.back();
      checked_ = true;
      if (!(residual_max_ <= on.options.tolerance)) status = kInputAtFault;
    }
    MPI_Bcast(&status, 1, MPI_INT, 0, on.comm());
    return status;
  }

  // What processes have met that costs digits but is no failure, told once.
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
    const bool right = residual_max_ <= options.tolerance;
    if (options.json) {
      std::printf("{\"model\": %s, \"processes\": %d, \"channel\": \"%s\"",
                  quoted(about.robot).c_str(), about.processes, session_.solver.channel_name());
      if (!options.states.empty() && options.simulation.seconds == 0)
        std::printf(", \"solved\": %d", solved_);
      if (!warning_.empty()) std::printf(", \"warnings\": [%s]", quoted(warning_.c_str()).c_str());
      if (checked_)
        std::printf(
            ", \"check\": {\"residual_median\": %.3g, \"residual_max\": %.3g, \"tolerance\": %.3g, "
            "\"ok\": %s}",
            residual_median_, residual_max_, options.tolerance, right ? "true" : "false");
      std::printf("%s%s%s}\n", corrections_.json().c_str(), timing_.json().c_str(),
                  simulation_.json().c_str());
      return;
    }
    std::FILE* const out = options.states.empty() || !options.result.empty() ? stdout : stderr;
    if (checked_)
      std::fprintf(out, "check  residual of inverse dynamics: median %.1e, largest %.1e: %s\n",
                   residual_median_, residual_max_, right ? "right" : "WRONG");
    corrections_.print(out);
    timing_.print(out);
    simulation_.print();
  }

  Session session_;
  Timing timing_{session_};
  Simulation simulation_{session_};
  Corrections corrections_;
  bool checked_ = false;
  int solved_ = 0;
  std::string warning_;
  double residual_median_ = 0, residual_max_ = 0;
};
