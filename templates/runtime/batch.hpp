// Solves many states at once, one in each lane of a register. Each process solves states of its
// own; where process 0 has them all, it hands them out (handout.hpp).
class Solver {
 public:
  Workspace w;
  Channel channel;
  std::string text;  // of the last failure

  // States one after the other, as are their accelerations; nothing is said to other processes.
  // Accelerations of a state that fails are not numbers; the others are what they should be.
  int solve_batch(int count, const Number* q, const Number* v, const Number* tau, Number* qdd) {
    forget();
    return solve_rows(count, q, v, tau, qdd) ? kFine : name_failures(count, q, v, tau, qdd);
  }

  int solve(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    return solve_batch(1, q, v, tau, qdd);
  }

  // Collective: process 0 has all states and gets all accelerations, and to know what failed; the
  // others return once it has. Of them, processes 1 to helpers help.
  int solve_batch_at_root(int count, const Number* q, const Number* v, const Number* tau,
                          Number* qdd, int helpers = kProcesses - 1) {
    if constexpr (kProcesses == 1) return solve_batch(count, q, v, tau, qdd);
    forget();
    const auto solve = [this](auto... rows) { return solve_rows(rows...); };
    int status = channel.broken() ? failure(kNoAnswer, 0) : kFine;
    if (status == kFine && channel.rank() > 0)
      handout_.help(channel, solve, status);
    else if (status == kFine &&
             !handout_.hand_out(channel, helpers, {count, q, v, tau, qdd}, solve, status))
      return name_failures(count, q, v, tau, qdd);
    if (status != kFine) text = describe(status);
    return status;
  }

  // The k-th failure of the last call: its state, counted from 0; -1 where there is none.
  int failed_state(std::size_t k) {
    if (k >= failures_.size()) return -1;
    text = in_words(failures_[k]);
    return failures_[k].state;
  }

  // What simulates asks for one state at a time.
  int solve_at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    return solve(q, v, tau, qdd);
  }
  int end_at_root() { return kFine; }

 private:
  struct FailedState {
    int state, status;
  };

  static std::size_t size(int n) { return static_cast<std::size_t>(n); }

  void forget() {
    failures_.clear();
    text.clear();
  }

  // Returns whether all states could be solved.
  bool solve_rows(int count, const Number* q, const Number* v, const Number* tau, Number* qdd) {
    bool good = true;
    for (int first = 0, states; first < count; first += states) {
      states = std::min(kLanes, count - first);
      const long row = first;
      spread(states, q + row * kNq, kNq, q_.data());
      spread(states, v + row * kNv, kNv, v_.data());
      spread(states, tau + row * kNtau, kNtau, tau_.data());
      if (run() == kFine) {
        for (int s = 0; s < states; ++s) take(s, qdd + (row + s) * kNv);
        continue;
      }
      good = false;
      const auto all_q = q_;
      const auto all_v = v_;
      const auto all_tau = tau_;
      for (int s = 0; s < states; ++s) {
        everywhere(q_, all_q, s), everywhere(v_, all_v, s), everywhere(tau_, all_tau, s);
        if (run() == kFine)
          take(s, qdd + (row + s) * kNv);
        else
          std::fill_n(qdd + (row + s) * kNv, kNv, std::numeric_limits<Number>::quiet_NaN());
      }
    }
    return good;
  }

  // Tries the states that have no accelerations once more, each by itself; returns the first
  // failure.
  int name_failures(int count, const Number* q, const Number* v, const Number* tau,
                    const Number* qdd) {
    for (int s = 0; s < count; ++s) {
      const long row = s;
      if (qdd[row * kNv] == qdd[row * kNv]) continue;
      spread(1, q + row * kNq, kNq, q_.data());
      spread(1, v + row * kNv, kNv, v_.data());
      spread(1, tau + row * kNtau, kNtau, tau_.data());
      failures_.push_back({s, run()});
    }
    text = in_words(failures_.front());
    if (failures_.size() > 1)
      text += " (and " + std::to_string(failures_.size() - 1) + " more states)";
    return failures_.front().status;
  }

  static std::string in_words(const FailedState& failed) {
    return "state " + std::to_string(failed.state + 1) + ": " + describe(failed.status);
  }

  // Rows of numbers into lanes; lanes without a state repeat the last one.
  static void spread(int states, const Number* rows, int width, Value* lanes) {
    if (states == kLanes) {
      for (int k = 0; k < width; ++k)
        ADAGEN_FOR (s, 0, kLanes) lanes[k][s] = rows[s * width + k];
      return;
    }
    for (int k = 0; k < width; ++k)
      for (int s = 0; s < kLanes; ++s) lanes[k][s] = rows[std::min(s, states - 1) * width + k];
  }

  // One lane of some values in all lanes.
  template <class Values>
  static void everywhere(Values& lanes, const Values& all, int s) {
    for (std::size_t k = 0; k < lanes.size(); ++k) lanes[k] = Value{} + all[k][s];
  }

  void take(int s, Number* qdd) const {
    for (int k = 0; k < kNv; ++k) qdd[k] = qdd_[size(k)][s];
  }

  int run() {
    w.q = q_.data(), w.v = v_.data(), w.tau = tau_.data(), w.qdd = qdd_.data();
    w.status = kFine;
    run_0(w, channel);
    return w.status;
  }

  std::array<Value, kNq> q_{};
  std::array<Value, kNv> v_{}, qdd_{};
  std::array<Value, kNtau> tau_{};
  std::vector<FailedState> failures_;
  Handout handout_;
};
