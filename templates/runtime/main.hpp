// The program around the solver: solves given states, checks, times, reports.

// Random states, the same on every machine (splitmix64).
States random_states(int count, std::uint64_t seed) {
  const auto uniform = [&seed] {
    std::uint64_t z = (seed += 0x9E3779B97F4A7C15ULL);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;  // in [-1, 1)
  };
  States states;
  states.count = count;
  const auto size = [count](int n) {
    return static_cast<std::size_t>(count) * static_cast<std::size_t>(n);
  };
  states.q.resize(size(kNq));
  states.v.resize(size(kNv));
  states.tau.resize(size(kNv));
  for (int s = 0; s < count; ++s) {
    Real* q =
        states.q.data() + size(kNq) / static_cast<std::size_t>(count) * static_cast<std::size_t>(s);
    Real* v =
        states.v.data() + size(kNv) / static_cast<std::size_t>(count) * static_cast<std::size_t>(s);
    Real* tau = states.tau.data() + (v - states.v.data());
    for (const JointConstants& joint : kJoints) {
      const bool turns = joint.kind == JointKind::kRevolute;
      for (int k = 0; k < joint.nq; ++k)
        q[joint.q + k] = static_cast<Real>(turns ? 3.141592653589793 * uniform() : uniform());
      if (joint.nq >= 4) {
        double p[4], squared;
        do {
          squared = 0;
          for (double& x : p) x = uniform(), squared += x * x;
        } while (squared > 1 || squared < 0.01);
        for (int k = 0; k < 4; ++k)
          q[joint.q + joint.nq - 4 + k] = static_cast<Real>(p[k] / std::sqrt(squared));
      }
      for (int k = 0; k < joint.nv; ++k) {
        v[joint.v + k] = static_cast<Real>(uniform());
        tau[joint.v + k] = static_cast<Real>(uniform());
      }
    }
    slave(q, v);
  }
  return states;
}

// The states file, read by process 0 and handed to all.
int load(const std::string& path, MPI_Comm comm, int rank, States& states) {
  int status = kDone;
  if (rank == 0) {
    std::ifstream file(path, std::ios::binary);
    file.peek();  // tells a folder from a file
    std::ostringstream text;
    if (!file.bad()) text << file.rdbuf();
    std::string wrong;
    if (!file.is_open() || file.bad())
      wrong = " error: cannot read the states file";
    else
      wrong = StatesReader(text.str()).read(states);
    if (!wrong.empty()) {
      std::fprintf(stderr, "%s:%s\n", path.c_str(), wrong.c_str());
      status = kInputAtFault;
    }
  }
  MPI_Bcast(&status, 1, MPI_INT, 0, comm);
  if (status != kDone) return status;
  MPI_Bcast(&states.count, 1, MPI_INT, 0, comm);
  const auto share = [&](std::vector<Real>& x, int n) {
    x.resize(static_cast<std::size_t>(states.count) * static_cast<std::size_t>(n));
    MPI_Bcast(x.data(), static_cast<int>(x.size()), kMpiReal, 0, comm);
  };
  share(states.q, kNq);
  share(states.v, kNv);
  share(states.tau, kNv);
  return status;
}

struct Statistics {
  double median = 0, least = 0, percentile99 = 0;
};

Statistics statistics(std::vector<double> ns) {
  std::sort(ns.begin(), ns.end());
  const auto at = [&ns](double part) {
    return ns[std::min(ns.size() - 1,
                       static_cast<std::size_t>(part * static_cast<double>(ns.size())))];
  };
  return {at(0.5), ns.front(), at(0.99)};
}

class Program {
 public:
  Program(Options options, int rank) : options_(std::move(options)), rank_(rank) {}

  int run() {
    watch_.start(rank_, options_.time_limit);
    const std::string wrong =
        solver_.channel.open(MPI_COMM_WORLD, options_.channel, options_.time_limit);
    if (!wrong.empty()) return complain(kFault, wrong);
    int status = kDone;
    if (!options_.states.empty()) {
      status = load(options_.states, solver_.channel.comm(), rank_, states_);
      if (status == kDone) status = solve_all();
      if (status == kDone && rank_ == 0) {
        const std::string path = options_.result.empty() ? "/dev/stdout" : options_.result;
        if (!write_result(path, qdd_, states_.count))
          status = complain(kFault, "cannot write the result", path);
      }
      MPI_Bcast(&status, 1, MPI_INT, 0, solver_.channel.comm());
    } else if (options_.check) {
      states_ = random_states(kRandomStates, options_.seed);
      status = solve_all();
    }
    watch_.again();
    if (status == kDone && options_.check) status = check_all();
    if (status != kFault && status != kUsage && options_.time) {
      const int timed = time_all();
      if (status == kDone) status = timed;
    }
    if (status != kFault && status != kUsage && !options_.trace.empty()) {
      const int traced = trace_all();
      if (status == kDone) status = traced;
    }
    if (rank_ == 0 && status != kFault) report();
    watch_.again();
    solver_.channel.close();
    return status;
  }

 private:
  using Clock = std::chrono::steady_clock;

  int complain(int status, const std::string& what, const std::string& file = "") const {
    const std::string place = file.empty() ? "" : file + ": ";
    if (rank_ == 0) std::fprintf(stderr, "%serror: %s\n", place.c_str(), what.c_str());
    return status;
  }

  const Real* q(int s) const { return states_.q.data() + static_cast<long>(s) * kNq; }
  const Real* v(int s) const { return states_.v.data() + static_cast<long>(s) * kNv; }
  const Real* tau(int s) const { return states_.tau.data() + static_cast<long>(s) * kNv; }

  // A process that waited in vain cannot be waited for: the whole run ends.
  void give_up_if_broken(int failed) const {
    if (failure_kind(failed) != kNoAnswer) return;
    std::fprintf(stderr, "error: process %d: %s\n", rank_, describe(failed).c_str());
    std::fflush(stderr);
    MPI_Abort(MPI_COMM_WORLD, kFault);
  }

  // Accelerations of all states, in place, then gathered at process 0.
  int solve_all() {
    qdd_.assign(static_cast<std::size_t>(states_.count) * kNv, Real(0));
    int failed = kFine, at = 0;
    for (int s = 0; s < states_.count && failed == kFine; ++s) {
      watch_.again();
      failed = solver_.solve(q(s), v(s), tau(s), qdd_.data() + static_cast<long>(s) * kNv);
      give_up_if_broken(failed);
      // Processes that share no joint's motion do not hear of each other's failures by themselves.
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, solver_.channel.comm());
      at = s;
    }
    if (failed != kFine)
      return complain(kInputAtFault, "state " + std::to_string(at + 1) + ": " + describe(failed),
                      options_.states);
    solved_ = states_.count;
    // Each process wrote its own joints and left the others zero.
    void* const all = qdd_.data();
    const int size = static_cast<int>(qdd_.size());
    if (rank_ == 0)
      MPI_Reduce(MPI_IN_PLACE, all, size, kMpiReal, MPI_SUM, 0, solver_.channel.comm());
    else
      MPI_Reduce(all, nullptr, size, kMpiReal, MPI_SUM, 0, solver_.channel.comm());
    return kDone;
  }

  int check_all() {
    int status = kDone;
    if (rank_ == 0) {
      std::vector<double> residuals;
      for (int s = 0; s < states_.count; ++s)
        residuals.push_back(
            check::residual(q(s), v(s), tau(s), qdd_.data() + static_cast<long>(s) * kNv));
      std::sort(residuals.begin(), residuals.end());
      residual_median_ = residuals[residuals.size() / 2];
      residual_max_ = residuals.back();
      checked_ = true;
      if (!(residual_max_ <= options_.tolerance)) status = kInputAtFault;
    }
    MPI_Bcast(&status, 1, MPI_INT, 0, solver_.channel.comm());
    return status;
  }

  // Each process on a core of its own, where there are enough of them.
  bool pin() const {
    int pinned = 0;
#if defined(__linux__)
    MPI_Comm node;
    int place = 0, count = 1;
    MPI_Comm_split_type(solver_.channel.comm(), MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
    MPI_Comm_rank(node, &place);
    MPI_Comm_size(node, &count);
    MPI_Comm_free(&node);
    cpu_set_t allowed, one;
    if (options_.pin && sched_getaffinity(0, sizeof allowed, &allowed) == 0 &&
        CPU_COUNT(&allowed) >= count) {
      int cpu = 0;
      for (int k = -1; cpu < CPU_SETSIZE; ++cpu)
        if (CPU_ISSET(cpu, &allowed) && ++k == place) break;
      CPU_ZERO(&one);
      CPU_SET(cpu, &one);
      pinned = sched_setaffinity(0, sizeof one, &one) == 0;
    }
#endif
    MPI_Allreduce(MPI_IN_PLACE, &pinned, 1, MPI_INT, MPI_MIN, solver_.channel.comm());
    return pinned != 0;
  }

  // All processes start an evaluation at the same instant of their common clock (on one node).
  Clock::time_point start_together() const {
    if (kProcesses == 1) return Clock::now();
    Clock::rep start = 0;
    if (rank_ == 0)
      start = (Clock::now() + std::chrono::microseconds(5)).time_since_epoch().count();
    MPI_Bcast(&start, static_cast<int>(sizeof start), MPI_BYTE, 0, solver_.channel.comm());
    const Clock::time_point at{Clock::duration(start)};
    const Clock::time_point latest = Clock::now() + std::chrono::microseconds(50);
    Clock::time_point now;
    while ((now = Clock::now()) < at && now < latest) relax();
    return now;
  }

  int time_all() {
    states_ = random_states(kRandomStates, options_.seed);
    qdd_.assign(static_cast<std::size_t>(states_.count) * kNv, Real(0));
    pinned_ = pin();
    std::vector<double> in_place, at_root;
    int failed = kFine;
    for (int pass = -1; pass < options_.repeat && failed == kFine;
         ++pass) {  // the first one warms up
      watch_.again();
      for (int s = 0; s < states_.count; ++s) {
        Real* const qdd = qdd_.data() + static_cast<long>(s) * kNv;
        const Clock::time_point start = start_together();
        const int first = solver_.solve(q(s), v(s), tau(s), qdd);
        const double in_place_ns =
            std::chrono::duration<double, std::nano>(Clock::now() - start).count();
        if (kProcesses > 1) MPI_Barrier(solver_.channel.comm());
        const Clock::time_point start_root = Clock::now();
        const int second = solver_.solve_at_root(q(s), v(s), tau(s), qdd);
        const double root_ns =
            std::chrono::duration<double, std::nano>(Clock::now() - start_root).count();
        give_up_if_broken(first);
        give_up_if_broken(second);
        if (failed == kFine) failed = first != kFine ? first : second;
        if (pass < 0) continue;
        in_place.push_back(in_place_ns);
        at_root.push_back(root_ns);
      }
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, solver_.channel.comm());
    }
    if (failed != kFine) return complain(kInputAtFault, "random state: " + describe(failed));
    // An evaluation is over when its last process is done.
    MPI_Allreduce(MPI_IN_PLACE, in_place.data(), static_cast<int>(in_place.size()), MPI_DOUBLE,
                  MPI_MAX, solver_.channel.comm());
    in_place_ = statistics(std::move(in_place));
    at_root_ = statistics(std::move(at_root));
    timed_ = true;
    return kDone;
  }

  // The same evaluations with time stamps between the stages of each process.
  int trace_all() {
    states_ = random_states(kRandomStates, options_.seed);
    qdd_.assign(static_cast<std::size_t>(states_.count) * kNv, Real(0));
    pinned_ = pinned_ || pin();
    Trace trace(rank_);
    int failed = kFine;
    for (int pass = -1; pass < options_.repeat && failed == kFine; ++pass) {
      watch_.again();
      for (int s = 0; s < states_.count; ++s) {
        start_together();
        trace.begin();
        const int found =
            solver_.solve(q(s), v(s), tau(s), qdd_.data() + static_cast<long>(s) * kNv);
        give_up_if_broken(found);
        trace.end(solver_.channel.comm(), pass >= 0);
        if (failed == kFine) failed = found;
      }
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, solver_.channel.comm());
    }
    if (failed != kFine) return complain(kInputAtFault, "random state: " + describe(failed));
    const std::string text = trace.text(solver_.channel.comm(), channel_name(), pinned_);
    int status = kDone;
    if (rank_ == 0) {
      std::ofstream file(options_.trace, std::ios::binary);
      if (!(file << text << std::flush))
        status = complain(kFault, "cannot write the trace", options_.trace);
    }
    MPI_Bcast(&status, 1, MPI_INT, 0, solver_.channel.comm());
    return status;
  }

  const char* channel_name() const {
    if (kProcesses == 1) return "none";
    return solver_.channel.windowed() ? "window" : "message";
  }

  void report() const {
    const auto times = [](const Statistics& t, const char* format) {
      std::printf(format, t.median, t.least, t.percentile99);
    };
    if (options_.json) {
      std::printf("{\"model\": %s, \"processes\": %d, \"channel\": \"%s\"", quoted(kRobot).c_str(),
                  kProcesses, channel_name());
      if (!options_.states.empty()) std::printf(", \"solved\": %d", solved_);
      if (checked_)
        std::printf(
            ", \"check\": {\"residual_median\": %.3g, \"residual_max\": %.3g, \"tolerance\": %.3g, "
            "\"ok\": %s}",
            residual_median_, residual_max_, options_.tolerance,
            residual_max_ <= options_.tolerance ? "true" : "false");
      if (timed_) {
        std::printf(", \"time\": {\"evaluations\": %d, \"pinned\": %s",
                    options_.repeat * kRandomStates, pinned_ ? "true" : "false");
        times(in_place_,
              ", \"in_place\": {\"median_ns\": %.0f, \"min_ns\": %.0f, \"p99_ns\": %.0f}");
        times(at_root_,
              ", \"through_root\": {\"median_ns\": %.0f, \"min_ns\": %.0f, \"p99_ns\": %.0f}}");
      }
      std::printf("}\n");
      return;
    }
    std::FILE* const out = options_.states.empty() || !options_.result.empty() ? stdout : stderr;
    if (checked_)
      std::fprintf(out, "check  residual of inverse dynamics: median %.1e, largest %.1e: %s\n",
                   residual_median_, residual_max_,
                   residual_max_ <= options_.tolerance ? "right" : "WRONG");
    if (timed_) {
      std::fprintf(out,
                   "time   %d process%s%s, ns per evaluation: median, minimum, 99th percentile\n",
                   kProcesses, kProcesses == 1 ? "" : "es", pinned_ ? ", pinned" : "");
      std::fprintf(out, "       state and result in place       %8.0f %8.0f %8.0f\n",
                   in_place_.median, in_place_.least, in_place_.percentile99);
      std::fprintf(out, "       everything through process 0    %8.0f %8.0f %8.0f\n",
                   at_root_.median, at_root_.least, at_root_.percentile99);
    }
  }

  Options options_;
  int rank_;
  Watch watch_;
  Solver solver_;
  States states_;
  std::vector<Real> qdd_;
  bool checked_ = false, timed_ = false, pinned_ = false;
  int solved_ = 0;
  double residual_median_ = 0, residual_max_ = 0;
  Statistics in_place_, at_root_;
};
