// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_BATCH  // read alone, it is of a solver for batches
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "bounds.hpp"
#include "failures.hpp"
#include "group.hpp"
#include "kernels/lanes.hpp"
#include "rows.hpp"
#include "sample/channel.hpp"
#include "sample/handout.hpp"
#include "sample/parameters.hpp"
#include "sample/processes.hpp"
#include "sample/robot.hpp"
#include "sample/workspace.hpp"
#include "sizes.hpp"
#include "status.hpp"
#include "tiny_numbers.hpp"
#include "value.hpp"

namespace {

// Solves many states: at once, one in each lane of a register, or one after the other, where its
// Value is one number. Each process solves states of its own; where process 0 has them all, it
// hands them out (handout.hpp). Some solvers have several ways to solve a state: those whose poses
// one cannot stand are put side by side and go the next one.
class Solver {
  // Reads the parameters that come with states.
  auto take_parameters() {
    return [this](const Number* x) {
      for (Group& group : groups_) unpack_parameters(x, group.w);
    };
  }

 public:
  Channel channel;
  Text text;  // of the last failure

  [[maybe_unused]] static constexpr int kWorkspaces = kGroups;
  Workspace& workspace(int k) { return groups_[size(k)].w; }

  void close() { channel.close(); }

  // States one after the other, as are their accelerations; nothing is sent to other processes.
  // Accelerations of a state that fails are not numbers; the others are what they should be. What
  // bounds the errors of certified ones goes to bounds, a number for each state, unless it is null.
  int solve_batch(int count, const Number* q, const Number* v, const Number* tau, Number* qdd,
                  double* bounds = nullptr) {
    forget();
    return solve_rows(count, q, v, tau, qdd, bounds) ? kFine : name_failures(count, q, v, tau, qdd);
  }

  int solve(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    return solve_batch(1, q, v, tau, qdd);
  }

  // Collective: process 0 has all states and gets all accelerations and bounds, and to know what
  // failed; the others return once it has. Of them, processes 1 to helpers help.
  int solve_batch_at_root(int count, const Number* q, const Number* v, const Number* tau,
                          Number* qdd, double* bounds = nullptr, int helpers = kProcesses - 1) {
    if constexpr (kProcesses == 1) return solve_batch(count, q, v, tau, qdd, bounds);
    forget();
    if (channel.rank() == 0 && bounds != nullptr)  // none is left over where a process is gone
      std::fill_n(bounds, std::max(0, count), std::numeric_limits<double>::quiet_NaN());
    const auto solve = [this](auto... rows) { return solve_rows(rows...); };
    const Batch batch{count, q, v, tau, qdd, bounds};
    int status = channel.broken() ? channel.no_answer() : kFine;
    if (channel.rank() > 0) {
      if (status == kFine) handout_.help(channel, solve, take_parameters(), status, false);
    } else if (status != kFine) {
      Handout::lose_all(batch);
    } else {
      const bool good = handout_.hand_out(channel, helpers, batch, workspace(0), solve, status);
      if (status == kFine && !good) return name_failures(count, q, v, tau, qdd);
    }
    if (status != kFine) text = describe(status);
    return status;
  }

  // At the others: helps process 0 with batch after batch, until it ends that.
  int serve() {
    if (channel.rank() == 0) return kFine;
    const auto solve = [this](auto... rows) { return solve_rows(rows...); };
    int status = channel.broken() ? channel.no_answer() : kFine;
    while (status == kFine) handout_.help(channel, solve, take_parameters(), status, true);
    if (failure_kind(status) == kEnded) return kFine;
    text = describe(status);
    return status;
  }

  // At process 0: the others serve no longer.
  int end() {
    int status = kFine;
    if (channel.rank() == 0) handout_.end(channel, status);
    if (status != kFine) text = describe(status);
    return status;
  }

  // How many states of the last call could not be solved.
  int failures() const { return count_; }

  // The k-th of them, counted from 0; -1 where there is none, or it is not one of the first kKept.
  int failed_state(int k) {
    if (k < 0 || k >= std::min(count_, kKept)) return -1;
    text = in_words(failures_[size(k)]);
    return failures_[size(k)].state;
  }

  // Why: its status.
  int failed_status(int k) const { return failures_[size(k)].status; }

  // What simulates asks for one state at a time.
  int solve_at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    return solve(q, v, tau, qdd);
  }
  int end_at_root() { return kFine; }

 private:
  struct FailedState {
    int state = 0, status = kFine;
  };

  static std::size_t size(int n) { return static_cast<std::size_t>(n); }

  void forget() {
    count_ = 0;
    text.clear();
  }

  // States one after the other, their accelerations and, unless that is null, what bounds errors.
  struct Rows {
    const Number *q, *v, *tau;
    Number* qdd;
    double* bounds;
  };

  // Returns whether all states could be solved.
  bool solve_rows(int count, const Number* q, const Number* v, const Number* tau, Number* qdd,
                  double* bounds) {
    const Rows rows{q, v, tau, qdd, bounds};
    bool good = true;
    begin_ways();
    for (int first = 0, states; first < count; first += states) {
      states = std::min(at_once() * kTogether, count - first);
      good &= solve_some(first_way(), rows, first, states);
      good &= make_room(rows);
    }
    return solve_kept(rows) && good;
  }

  // Those from the one numbered first on, at most as many as all groups have lanes, a first way.
  bool solve_some(std::size_t way, const Rows& rows, int first, int states) {
    const int groups = (states + kTogether - 1) / kTogether;
    for (int g = 0; g < groups; ++g) {
      const int at = g * kTogether;
      take(groups_[size(g)], first + at, std::min(kTogether, states - at), rows.q, rows.v,
           rows.tau);
    }
    std::array<bool, kGroups> well{};
    {
      [[maybe_unused]] const TinyAreZero tiny;
      go(way, groups);
      for (int g = 0; g < groups; ++g) {
        const int at = g * kTogether;
        well[size(g)] =
            ends_well(way, groups_[size(g)].w, rows, first + at, std::min(kTogether, states - at));
      }
    }
    bool good = true;
    for (int g = 0; g < groups; ++g) {
      const int at = g * kTogether;
      give(groups_[size(g)], well[size(g)], rows, first + at, std::min(kTogether, states - at));
      good &= well[size(g)];
    }
    return good;
  }

  // The states from the one numbered first on.
  static void take(Group& group, int first, int states, const Number* q,
                   [[maybe_unused]] const Number* v, const Number* tau) {
    to_lanes(states, q + size(first) * kNq, group.q);
    if constexpr (!Settings::kAtRest) to_lanes(states, v + size(first) * kNv, group.v);
    to_lanes(states, tau + size(first) * kNtau, group.tau);
  }

  // Where a group fails, each of its states is tried once more, by itself.
  void give(Group& group, bool well, const Rows& rows, int first, int states) {
    Number* const qdd = rows.qdd + size(first) * kNqdd;
    double* const bounds = rows.bounds == nullptr ? nullptr : rows.bounds + first;
    if (!well) return give_one_by_one(group, states, qdd, bounds);
    to_rows(states, group.qdd, qdd);
    for (int s = 0; s < states && bounds != nullptr; ++s) bounds[s] = bound_of_state(group, s, 0);
  }

  void give_one_by_one(const Group& group, int states, Number* qdd, double* bounds) {
    Group& alone = groups_.front();
    const auto all_q = group.q;
    const auto all_v = group.v;
    const auto all_tau = group.tau;
    for (int s = 0; s < states; ++s, qdd += kNqdd) {
      everywhere(alone.q, all_q, s), everywhere(alone.v, all_v, s);
      everywhere(alone.tau, all_tau, s);
      const bool solved = solve_first() == kFine;
      if (solved)
        to_rows(1, alone.qdd, qdd);
      else
        std::fill_n(qdd, kNqdd, std::numeric_limits<Number>::quiet_NaN());
      if (bounds != nullptr)
        bounds[s] = solved ? bound_of_state(alone, 0, 0) : std::numeric_limits<double>::quiet_NaN();
    }
  }

  // Tries the states that have no accelerations once more, each by itself; returns the first
  // failure, if there is one: where a group failed, each of its states may have been solved alone.
  int name_failures(int count, const Number* q, const Number* v, const Number* tau,
                    const Number* qdd) {
    for (int s = 0; s < count; ++s) {
      const Number first = qdd[size(s) * kNqdd + first_computed()];
      if (first == first) continue;
      take(groups_.front(), s, 1, q, v, tau);
      const int status = solve_first();
      if (count_ < kKept) failures_[size(count_)] = {s, status};
      ++count_;
    }
    if (count_ == 0) return kFine;
    text = in_words(failures_.front());
    if (count_ > 1) {
      text += " (and ";
      text += count_ - 1;
      text += " more states)";
    }
    return failures_.front().status;
  }

  // An entry of qdd that each state has which is solved.
  static std::size_t first_computed() {
    for (const JointConstants& joint : kJoints)
      if (joint.given) return size(joint.v);
    return size(kNv);
  }

  static Text in_words(const FailedState& failed) {
    Text words;
    words += "state ";
    words += failed.state + 1;
    words += ": ";
    return words += describe(failed.status).c_str();
  }

  // One lane of some values in all lanes.
  template <class Values>
  static void everywhere(Values& lanes, const Values& all, [[maybe_unused]] int s) {
    if constexpr (kTogether == 1)
      lanes = all;
    else
      for (std::size_t k = 0; k < lanes.size(); ++k) lanes[k] = Value{} + all[k][s];
  }

  static void begin(Group& group) {
    group.w.q = group.q.data(), group.w.v = group.v.data();
    group.w.tau = group.tau.data(), group.w.qdd = group.qdd.data();
    group.w.status = kFine;
#if defined(ADAGEN_RECOVERS)
    group.w.ways = LaneWays{};
#endif
  }

#if defined(ADAGEN_RECOVERS)
  static constexpr int kAtOnce = kGroups * kTogether, kRoom = std::max(2 * kAtOnce, 4 * kTogether);

  // States that go a way because one before cannot stand their poses, side by side, so that lanes
  // are full; and which states of the call they are.
  struct Kept {
    int count = 0;
    std::array<int, kRoom> state{};
    std::array<Number, kRoom * kNq> q{};
    std::array<Number, kRoom * kNv> v{};
    std::array<Number, kRoom * kNtau> tau{};
    std::array<Number, kRoom * kNqdd> qdd{};
    std::array<double, kRoom> bounds{};
  };
  Kept& kept(std::size_t way) { return kept_[way - 1]; }

  void begin_ways() {
    tried_ = left_ = 0;
    for (Kept& each : kept_) each.count = 0;
  }

  // How many groups are next: one that shows which way to go, then as many as there are.
  int at_once() const { return tried_ == 0 ? 1 : kGroups; }

  // Where answers are to have the same bits, a state goes the ways that it goes alone. Otherwise,
  // if the first way is left by more than half of the states of a call, the rest do not try it.
  std::size_t first_way() const {
#if defined(ADAGEN_REPRODUCIBLE)
    return 0;
#else
    static_assert(kWays.size() == 2);  // what leaves the second way would not be numbered
    return 2 * left_ > tried_ ? 1 : 0;
#endif
  }

  // Has some groups go a way but for its last function, which gives results.
  void go(std::size_t way, int groups) {
    for (int g = 0; g < groups; ++g) begin(groups_[size(g)]);
    const Way& own = kWays[way];
    for (std::size_t k = 0; k + 1 < own.count; ++k)
      for (int g = 0; g < groups; ++g) own.parts[k](groups_[size(g)].w);
  }

  // The last function of a way; returns whether all is well.
  static bool ends(std::size_t way, Workspace& w) {
    const Way& own = kWays[way];
    own.parts[own.count - 1](w);
    return w.status == kFine;
  }

  // Whether states of a group leave a way, and all others are solved.
  static bool is_left(std::size_t way, const Workspace& w) {
    const LaneWays& lanes = w.ways;
    return way + 1 < kWays.size() && any_of(lanes.poor) && !any_of(lanes.refused & ~lanes.poor);
  }

  // Ends a way; keeps the states that leave it for the next one. Their lanes hold nothing then.
  bool ends_well(std::size_t way, Workspace& w, const Rows& rows, int first, int states) {
    if (way == 0) tried_ += states;
    if (!is_left(way, w)) return ends(way, w);
    const LaneBits poor = w.ways.poor;
    for (Value& x : w.result) x = chosen(poor, Value{}, x);
#if defined(ADAGEN_CERTIFIED)
    for (Value& x : w.certificate) x = chosen(poor, Value{}, x);
#endif
    w.status = kFine;
    if (!ends(way, w)) return false;
    for (int s = 0; s < states; ++s)
      if (poor[s]) keep(way + 1, rows, first + s);
    return true;
  }

  // The row numbered k of those that went the way before.
  void keep(std::size_t way, const Rows& rows, int k) {
    Kept& next = kept(way);
    const std::size_t at = size(next.count++), row = size(k);
    next.state[at] = way == 1 ? k : kept(way - 1).state[row];
    std::copy_n(rows.q + row * kNq, kNq, next.q.data() + at * kNq);
    if constexpr (!Settings::kAtRest)
      std::copy_n(rows.v + row * kNv, kNv, next.v.data() + at * kNv);
    std::copy_n(rows.tau + row * kNtau, kNtau, next.tau.data() + at * kNtau);
    if (way == 1) ++left_;
  }

  // Room for as many as may leave the first way, or another one, at once.
  bool make_room(const Rows& all, std::size_t way = 1) {
    return way == kWays.size() || kept(way).count <= kRoom - kAtOnce || solve_kept(way, all);
  }

  bool solve_kept(const Rows& all) {
    bool good = true;
    for (std::size_t way = 1; way < kWays.size(); ++way) good &= solve_kept(way, all);
    return good;
  }

  // Solves the states that are kept for a way, and gives their answers to the call's states.
  bool solve_kept(std::size_t way, const Rows& all) {
    Kept& own = kept(way);
    const bool bounded = all.bounds != nullptr;
    const Rows rows{own.q.data(), own.v.data(), own.tau.data(), own.qdd.data(),
                    bounded ? own.bounds.data() : nullptr};
    bool good = true;
    for (int first = 0, states; first < own.count; first += states) {
      states = std::min(kAtOnce, own.count - first);
      good &= solve_some(way, rows, first, states);
      for (int k = first; k < first + states; ++k) {
        const std::size_t state = size(own.state[size(k)]);
        std::copy_n(own.qdd.data() + size(k) * kNqdd, kNqdd, all.qdd + state * kNqdd);
        if (bounded) all.bounds[state] = own.bounds[size(k)];
      }
      good &= make_room(all, way + 1);
    }
    own.count = 0;
    return good;
  }

  // Solves the one state that all lanes of the first group have; returns how it fares.
  int solve_first() {
    [[maybe_unused]] const TinyAreZero tiny;
    Workspace& w = groups_.front().w;
    std::size_t way = 0;
    for (go(way, 1); is_left(way, w); go(way, 1)) ++way;
    ends(way, w);
    return w.status;
  }

  int tried_ = 0, left_ = 0;  // states of a call that went the first way; those that left it
  std::array<Kept, kWays.size() - 1> kept_;
#else
  static void begin_ways() {}
  static int at_once() { return kGroups; }
  static std::size_t first_way() { return 0; }

  void go(std::size_t, int groups) {
    for (int g = 0; g < groups; ++g) begin(groups_[size(g)]);
    for (const auto part : kParts)
      for (int g = 0; g < groups; ++g) part(groups_[size(g)].w);
  }

  static bool ends_well(std::size_t, const Workspace& w, const Rows&, int, int) {
    return w.status == kFine;
  }

  static bool make_room(const Rows&) { return true; }
  static bool solve_kept(const Rows&) { return true; }

  int solve_first() {
    [[maybe_unused]] const TinyAreZero tiny;
    go(0, 1);
    return groups_.front().w.status;
  }
#endif

  std::array<Group, kGroups> groups_;
  static constexpr int kKept = 256;  // what fails beyond is only counted
  std::array<FailedState, kKept> failures_;
  int count_ = 0;
  Handout handout_;
};

}  // namespace
