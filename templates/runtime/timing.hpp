// How long an evaluation takes (--time), and where the time goes (--trace).
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

class Timing {
 public:
  explicit Timing(Session& session) : session_(session) {}

  int time_all() {
    if constexpr (kBatch) return time_batch(session_.solver);
    session_.use(random_states(kRandomStates, session_.options.seed));
    session_.pinned = pin();
    std::vector<double> in_place, at_root;
    int failed = kFine;
    for (int pass = -1; pass < session_.options.repeat && failed == kFine;
         ++pass) {  // the first one warms up
      session_.watch.again();
      for (int s = 0; s < session_.states.count; ++s) {
        Real* const qdd = session_.acceleration(s);
        const Clock::time_point start = start_together();
        const int first = session_.solver.solve(session_.q(s), session_.v(s), session_.tau(s), qdd);
        const double in_place_ns =
            std::chrono::duration<double, std::nano>(Clock::now() - start).count();
        if (kProcesses > 1) MPI_Barrier(session_.comm());
        const Clock::time_point start_root = Clock::now();
        const int second =
            session_.solver.solve_at_root(session_.q(s), session_.v(s), session_.tau(s), qdd);
        const double root_ns =
            std::chrono::duration<double, std::nano>(Clock::now() - start_root).count();
        session_.give_up_if_broken(first);
        session_.give_up_if_broken(second);
        if (failed == kFine) failed = first != kFine ? first : second;
        if (pass < 0) continue;
        in_place.push_back(in_place_ns);
        at_root.push_back(root_ns);
      }
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, session_.comm());
    }
    if (failed != kFine)
      return session_.complain(kInputAtFault, "random state: " + describe(failed));
    // An evaluation is over when its last process is done.
    MPI_Allreduce(MPI_IN_PLACE, in_place.data(), static_cast<int>(in_place.size()), MPI_DOUBLE,
                  MPI_MAX, session_.comm());
    in_place_ = statistics(std::move(in_place));
    at_root_ = statistics(std::move(at_root));
    timed_ = true;
    return kDone;
  }

  // A batch of as many random states for each process; nanoseconds for each state and process.
  template <class S>
  int time_batch(S& solver) {
    constexpr int kCount = kRandomStates * kProcesses;
    session_.use(random_states(kCount, session_.options.seed));
    session_.pinned = pin();
    std::vector<double> in_place, at_root;
    int failed = kFine;
    for (int pass = -1; pass < session_.options.repeat && failed == kFine; ++pass) {
      session_.watch.again();
      if constexpr (kBatch) {
        const int first = kRandomStates * session_.rank;
        const Clock::time_point start = start_together();
        failed = solver.solve_batch(kRandomStates, session_.q(first), session_.v(first),
                                    session_.tau(first), session_.acceleration(first));
        const double in_place_ns =
            std::chrono::duration<double, std::nano>(Clock::now() - start).count();
        const Clock::time_point start_root = start_together();
        const int second = solver.solve_batch_at_root(kCount, session_.q(0), session_.v(0),
                                                      session_.tau(0), session_.acceleration(0));
        const double root_ns =
            std::chrono::duration<double, std::nano>(Clock::now() - start_root).count();
        if (failed == kFine) failed = second;
        if (pass < 0) continue;
        in_place.push_back(in_place_ns / kRandomStates);
        at_root.push_back(root_ns / kRandomStates);
      }
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, session_.comm());
    }
    if (failed != kFine)
      return session_.complain(kInputAtFault, "random states: " + describe(failed));
    for (std::vector<double>* ns : {&in_place, &at_root})  // over when the last process is done
      MPI_Allreduce(MPI_IN_PLACE, ns->data(), static_cast<int>(ns->size()), MPI_DOUBLE, MPI_MAX,
                    session_.comm());
    in_place_ = statistics(std::move(in_place));
    at_root_ = statistics(std::move(at_root));
    timed_ = true;
    return kDone;
  }

  // The same evaluations with time stamps between the stages of each process.
  int trace_all() {
    session_.use(random_states(kRandomStates, session_.options.seed));
    session_.pinned = session_.pinned || pin();
    Trace trace(session_.rank);
    int failed = kFine;
    for (int pass = -1; pass < session_.options.repeat && failed == kFine; ++pass) {
      session_.watch.again();
      for (int s = 0; s < session_.states.count; ++s) {
        start_together();
        trace.begin();
        const int found = session_.solver.solve(session_.q(s), session_.v(s), session_.tau(s),
                                                session_.acceleration(s));
        session_.give_up_if_broken(found);
        trace.end(session_.comm(), pass >= 0);
        if (failed == kFine) failed = found;
      }
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, session_.comm());
    }
    if (failed != kFine)
      return session_.complain(kInputAtFault, "random state: " + describe(failed));
    const std::string text = trace.text(session_.comm(), session_.channel_name(), session_.pinned);
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
    if (!timed_) return "";
    char text[300];
    std::snprintf(text, sizeof text,
                  ", \"time\": {\"evaluations\": %d, \"pinned\": %s, "
                  "\"in_place\": {\"median_ns\": %.0f, \"min_ns\": %.0f, \"p99_ns\": %.0f}, "
                  "\"through_root\": {\"median_ns\": %.0f, \"min_ns\": %.0f, \"p99_ns\": %.0f}}",
                  session_.options.repeat * kRandomStates, session_.pinned ? "true" : "false",
                  in_place_.median, in_place_.least, in_place_.percentile99, at_root_.median,
                  at_root_.least, at_root_.percentile99);
    return text;
  }

  void print(std::FILE* out) const {
    if (!timed_) return;
    std::fprintf(out, "time   %d process%s%s, ns per %s: median, minimum, 99th percentile\n",
                 kProcesses, kProcesses == 1 ? "" : "es", session_.pinned ? ", pinned" : "",
                 kBatch ? "state and process" : "evaluation");
    std::fprintf(out, "       state and result in place       %8.0f %8.0f %8.0f\n",
                 in_place_.median, in_place_.least, in_place_.percentile99);
    std::fprintf(out, "       everything through process 0    %8.0f %8.0f %8.0f\n", at_root_.median,
                 at_root_.least, at_root_.percentile99);
    if (kBatch)
      std::fprintf(out, "       states per second in place      %8.3g (%.3g per process)\n",
                   1e9 * kProcesses / in_place_.median, 1e9 / in_place_.median);
  }

 private:
  using Clock = std::chrono::steady_clock;

  // Each process on a core of its own, where there are enough of them.
  bool pin() {
    int pinned = 0;
#if defined(__linux__)
    MPI_Comm node;
    int place = 0, count = 1;
    MPI_Comm_split_type(session_.comm(), MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
    MPI_Comm_rank(node, &place);
    MPI_Comm_size(node, &count);
    MPI_Comm_free(&node);
    cpu_set_t allowed, one;
    if (session_.options.pin && sched_getaffinity(0, sizeof allowed, &allowed) == 0 &&
        CPU_COUNT(&allowed) >= count) {
      int cpu = 0;
      for (int k = -1; cpu < CPU_SETSIZE; ++cpu)
        if (CPU_ISSET(cpu, &allowed) && ++k == place) break;
      CPU_ZERO(&one);
      CPU_SET(cpu, &one);
      pinned = sched_setaffinity(0, sizeof one, &one) == 0;
    }
#endif
    MPI_Allreduce(MPI_IN_PLACE, &pinned, 1, MPI_INT, MPI_MIN, session_.comm());
    return pinned != 0;
  }

  // All processes start an evaluation at the same instant of their common clock (on one node).
  Clock::time_point start_together() const {
    if (kProcesses == 1) return Clock::now();
    Clock::rep start = 0;
    if (session_.rank == 0)
      start = (Clock::now() + std::chrono::microseconds(5)).time_since_epoch().count();
    MPI_Bcast(&start, static_cast<int>(sizeof start), MPI_BYTE, 0, session_.comm());
    const Clock::time_point at{Clock::duration(start)};
    const Clock::time_point latest = Clock::now() + std::chrono::microseconds(50);
    Clock::time_point now;
    while ((now = Clock::now()) < at && now < latest) relax();
    return now;
  }

  Session& session_;
  bool timed_ = false;
  Statistics in_place_, at_root_;
};
