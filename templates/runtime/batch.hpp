// Solves many states at once, one in each lane of a register. Each process solves states of its
// own; where process 0 has them all, it hands out as equal shares as there are.
class Solver {
 public:
  Workspace w;
  Channel channel;
  std::string text;  // of the last failure

  // States one after the other, as are their accelerations; nothing is said to other processes.
  int solve_batch(int count, const Real* q, const Real* v, const Real* tau, Real* qdd) {
    for (int first = 0; first < count; first += kLanes) {
      const int states = std::min(kLanes, count - first);
      const long row = first;
      spread(states, q + row * kNq, kNq, q_.data());
      spread(states, v + row * kNv, kNv, v_.data());
      spread(states, tau + row * kNv, kNv, tau_.data());
      const int status = run();
      if (status != kFine) {
        text = "state " + std::to_string(first + 1 + culprit(states)) + ": " + describe(status);
        return status;
      }
      for (int s = 0; s < states; ++s)
        for (int k = 0; k < kNv; ++k) qdd[(row + s) * kNv + k] = qdd_[size(k)][s];
    }
    return kFine;
  }

  int solve(const Real* q, const Real* v, const Real* tau, Real* qdd) {
    return solve_batch(1, q, v, tau, qdd);
  }

  // Collective: process 0 has all states and gets all accelerations.
  int solve_batch_at_root(int count, const Real* q, const Real* v, const Real* tau, Real* qdd) {
    MPI_Bcast(&count, 1, MPI_INT, 0, channel.comm());
    const int own = share(count, channel.rank() + 1) - share(count, channel.rank());
    std::vector<Real> own_q(size(own) * kNq), own_v(size(own) * kNv), own_tau(size(own) * kNv),
        own_qdd(size(own) * kNv);
    scatter(count, q, kNq, own_q);
    scatter(count, v, kNv, own_v);
    scatter(count, tau, kNv, own_tau);
    int status = solve_batch(own, own_q.data(), own_v.data(), own_tau.data(), own_qdd.data());
    std::vector<int> counts(kProcesses), starts(kProcesses);
    rows_of(count, kNv, counts, starts);
    MPI_Gatherv(own_qdd.data(), own * kNv, kMpiReal, qdd, counts.data(), starts.data(), kMpiReal, 0,
                channel.comm());
    MPI_Allreduce(MPI_IN_PLACE, &status, 1, MPI_INT, MPI_MAX, channel.comm());
    if (status != kFine && text.empty()) text = describe(status);
    return status;
  }

  // What simulates asks for one state at a time.
  int solve_at_root(const Real* q, const Real* v, const Real* tau, Real* qdd) {
    return solve(q, v, tau, qdd);
  }
  int end_at_root() { return kFine; }

  // The first of the states of process p, of so many.
  static int share(int count, int p) {
    return static_cast<int>(static_cast<long long>(count) * p / kProcesses);
  }

 private:
  static std::size_t size(int n) { return static_cast<std::size_t>(n); }

  // Rows of numbers into lanes; lanes without a state repeat the last one.
  static void spread(int states, const Real* rows, int width, Value* lanes) {
    if (states == kLanes) {
      for (int k = 0; k < width; ++k)
        ADAGEN_FOR (s, 0, kLanes) lanes[k][s] = rows[s * width + k];
      return;
    }
    for (int k = 0; k < width; ++k)
      for (int s = 0; s < kLanes; ++s) lanes[k][s] = rows[std::min(s, states - 1) * width + k];
  }

  int run() {
    w.q = q_.data(), w.v = v_.data(), w.tau = tau_.data(), w.qdd = qdd_.data();
    w.status = kFine;
    run_0(w, channel);
    return w.status;
  }

  // The lane that failed: each is tried by itself.
  int culprit(int states) {
    const auto all_q = q_;
    const auto all_v = v_, all_tau = tau_;
    const auto only = [](auto& lanes, const auto& all, int s) {
      for (std::size_t k = 0; k < lanes.size(); ++k) lanes[k] = Value{} + all[k][s];
    };
    for (int s = 0; s < states; ++s) {
      only(q_, all_q, s), only(v_, all_v, s), only(tau_, all_tau, s);
      if (run() != kFine) return s;
    }
    return 0;
  }

  void rows_of(int count, int width, std::vector<int>& counts, std::vector<int>& starts) const {
    for (int p = 0; p < kProcesses; ++p) {
      starts[size(p)] = share(count, p) * width;
      counts[size(p)] = share(count, p + 1) * width - starts[size(p)];
    }
  }

  void scatter(int count, const Real* all, int width, std::vector<Real>& own) const {
    std::vector<int> counts(kProcesses), starts(kProcesses);
    rows_of(count, width, counts, starts);
    MPI_Scatterv(all, counts.data(), starts.data(), kMpiReal, own.data(),
                 static_cast<int>(own.size()), kMpiReal, 0, channel.comm());
  }

  std::array<Value, kNq> q_{};
  std::array<Value, kNv> v_{}, tau_{}, qdd_{};
};
