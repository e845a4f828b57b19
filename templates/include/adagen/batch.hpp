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
// Value is one number. Each process solves states of its
// own; where process 0 has them all, it hands them out (handout.hpp).
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

  // Returns whether all states could be solved.
  bool solve_rows(int count, const Number* q, const Number* v, const Number* tau, Number* qdd,
                  double* bounds) {
    bool good = true;
#if defined(ADAGEN_RECOVERS) && !defined(ADAGEN_EACH_ITS_WAY)
    tried_ = poor_ = 0;
#endif
    for (int first = 0, groups; first < count; first += groups * kTogether) {
      groups = std::min(at_once(), (count - first + kTogether - 1) / kTogether);
      for (int g = 0; g < groups; ++g) {
        const int at = first + g * kTogether;
        take(groups_[size(g)], at, std::min(kTogether, count - at), q, v, tau);
      }
      run(groups);
      for (int g = 0; g < groups; ++g) {
        const int at = first + g * kTogether;
        good &= give(groups_[size(g)], std::min(kTogether, count - at), qdd + size(at) * kNqdd,
                     bounds == nullptr ? nullptr : bounds + at);
      }
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

  // Where a group fails, each of its states is tried once more, by itself; returns whether all were
  // solved.
  bool give(Group& group, int states, Number* qdd, double* bounds) {
    if (group.w.status == kFine) {
      to_rows(states, group.qdd, qdd);
      for (int s = 0; s < states && bounds != nullptr; ++s) bounds[s] = bound_of_state(group, s, 0);
      return true;
    }
    Group& alone = groups_.front();
    const auto all_q = group.q;
    const auto all_v = group.v;
    const auto all_tau = group.tau;
    for (int s = 0; s < states; ++s, qdd += kNqdd) {
      everywhere(alone.q, all_q, s), everywhere(alone.v, all_v, s);
      everywhere(alone.tau, all_tau, s);
      const bool solved = run(1) == kFine;
      if (solved)
        to_rows(1, alone.qdd, qdd);
      else
        std::fill_n(qdd, kNqdd, std::numeric_limits<Number>::quiet_NaN());
      if (bounds != nullptr)
        bounds[s] = solved ? bound_of_state(alone, 0, 0) : std::numeric_limits<double>::quiet_NaN();
    }
    return false;
  }

  // Tries the states that have no accelerations once more, each by itself; returns the first
  // failure, if there is one: where a group failed, each of its states may have been solved alone.
  int name_failures(int count, const Number* q, const Number* v, const Number* tau,
                    const Number* qdd) {
    for (int s = 0; s < count; ++s) {
      const Number first = qdd[size(s) * kNqdd + first_computed()];
      if (first == first) continue;
      take(groups_.front(), s, 1, q, v, tau);
      const int status = run(1);
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

  // Returns how the first group fares.
  int run(int groups) {
    for (int g = 0; g < groups; ++g) {
      Group& group = groups_[size(g)];
      group.w.q = group.q.data(), group.w.v = group.v.data();
      group.w.tau = group.tau.data(), group.w.qdd = group.qdd.data();
      group.w.status = kFine;
    }
    [[maybe_unused]] const TinyAreZero tiny;
#if defined(ADAGEN_EACH_ITS_WAY)
    go_each_its_way(groups);
#elif defined(ADAGEN_RECOVERS)
    std::array<bool, kGroups> poor;
    poor.fill(true);
    if (2 * poor_ <= tried_) {
      go_through(kParts, groups, poor);
      for (int g = 0; g < groups; ++g) {
        int& status = groups_[size(g)].w.status;
        poor[size(g)] = failure_kind(status) == kSingularPose;
        if (poor[size(g)]) status = kFine, ++poor_;
      }
      tried_ += groups;
    }
    go_through(kRecoverParts, groups, poor);
#else
    for (const auto part : kParts)
      for (int g = 0; g < groups; ++g) part(groups_[size(g)].w);
#endif
    return groups_.front().w.status;
  }

  // How many groups are next: one that shows which way to go, if there are several.
  int at_once() const {
#if defined(ADAGEN_RECOVERS) && !defined(ADAGEN_EACH_ITS_WAY)
    if (tried_ == 0) return 1;
#endif
    return kGroups;
  }

#if defined(ADAGEN_EACH_ITS_WAY)
  // Groups go the first way; those in which it cannot stand a pose of a state go the next, too.
  void go_each_its_way(int groups) {
    std::array<bool, kGroups> left;
    left.fill(true);
    for (int g = 0; g < groups; ++g) groups_[size(g)].w.ways.begin();
    for (const Way& way : kWays) {
      for (std::size_t k = 0; k + 1 < way.count; ++k)
        for (int g = 0; g < groups; ++g)
          if (left[size(g)]) way.parts[k](groups_[size(g)].w);
      for (int g = 0; g < groups; ++g) {
        Workspace& w = groups_[size(g)].w;
        if (left[size(g)] && !(left[size(g)] = goes_on(w))) way.parts[way.count - 1](w);
      }
    }
  }

  // Returns whether a state of a group is to go the next way; what the others gave is kept.
  static bool goes_on(Workspace& w) {
    LaneWays& ways = w.ways;
    if (any_of(ways.refused & ~ways.poor)) {  // its states are solved one by one
      if (failure_kind(w.status) == kSingularPose) w.status = failure(kLoopSingular, 0);
      return false;
    }
    const bool more = any_of(ways.poor);
    if (!more && !any_of(ways.done)) return false;
    const LaneBits solved = ~(ways.poor | ways.done);
    take_in(ways.result, w.result, solved);
#if defined(ADAGEN_CERTIFIED)
    take_in(ways.certificate, w.certificate, solved);
#endif
    if (more) {
      ways.done |= solved;
      ways.poor = ways.refused = LaneBits{};
      w.status = kFine;
      return true;
    }
    w.result = ways.result;
#if defined(ADAGEN_CERTIFIED)
    w.certificate = ways.certificate;
#endif
    return false;
  }

  // Some lanes of values.
  template <class Values>
  static void take_in(Values& to, const Values& from, const LaneBits& lanes) {
    for (std::size_t k = 0; k < to.size(); ++k) to[k] = chosen(lanes, from[k], to[k]);
  }
#elif defined(ADAGEN_RECOVERS)
  // Some of the groups go through all parts.
  template <class Parts>
  void go_through(const Parts& parts, int groups, const std::array<bool, kGroups>& which) {
    for (const auto part : parts)
      for (int g = 0; g < groups; ++g)
        if (which[size(g)]) part(groups_[size(g)].w);
  }

  // Groups of a call that went the first way, and those of them in which it cannot stand a pose. If
  // that is more than half of them, the rest of the call goes the other way at once.
  int tried_ = 0, poor_ = 0;
#endif

  std::array<Group, kGroups> groups_;
  static constexpr int kKept = 256;  // what fails beyond is only counted
  std::array<FailedState, kKept> failures_;
  int count_ = 0;
  Handout handout_;
};

}  // namespace
