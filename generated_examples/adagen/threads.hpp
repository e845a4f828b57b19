// adagen's runtime, the same for all robots.
#pragma once

#if __has_include(<pthread.h>)
#include <pthread.h>
#endif
#if defined(__linux__)
#include <sched.h>
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <thread>

#include "channel_threads.hpp"
#include "common.hpp"
#include "in_place.hpp"
#include "relax.hpp"
#include "sample/channel.hpp"
#include "sample/parameters.hpp"
#include "sample/processes.hpp"
#include "sizes.hpp"
#include "status.hpp"

namespace {

// How often this process became the copy of another, by fork: a copy has none of its threads.
std::atomic<std::uint64_t> forks{0};

// Has forks counted from now on. Returns whether the system can.
inline bool count_forks() {
#if __has_include(<pthread.h>)
  static const bool counted = pthread_atfork(nullptr, nullptr, [] { ++forks; }) == 0;
  return counted;
#else
  return true;  // nor is there a fork
#endif
}

// The threads of processes 1, 2, .. and what they share with the caller's, which is process 0. They
// wait for its evaluations, at first awake, then asleep.
class Team {
 public:
  // What the threads answer. Each writes its own; those that nobody asks for are not numbers.
  alignas(kCacheLine) std::array<Number, kNqdd> qdd;
  Slots slots{};

  Team() { qdd.fill(std::numeric_limits<Number>::quiet_NaN()); }
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  // Ends the threads.
  ~Team() {
    ending_ = true;
    call();
    for (Member& member : members_)
      if (member.thread.joinable()) member.thread.join();
  }

  // Starts the threads. cores: where those of processes 1, 2, .. are to stay, null for anywhere.
  // set: whose parameters they take before each evaluation. Returns what is wrong, or an empty
  // string. Allocates all memory that is ever needed.
  Text start(const int* cores, std::chrono::nanoseconds limit, Channel& channel,
             const Workspace& set) {
    for (int p = 1; p < kProcesses; ++p) {
      if (!has_part(p)) continue;
      Member& member = members_[at(p)];
      try {
        member.thread = std::thread([this, p, limit, &set] { work(p, limit, set); });
      } catch (const std::exception&) {
        return Text("the system gives no more threads");
      }
      if (cores != nullptr && !pin(member.thread, cores[p - 1])) {
        Text wrong("this process has no core ");
        return wrong += cores[p - 1];
      }
    }
    pinned_ = cores != nullptr;
    if (!pinned_) leave_callers_core();
    for (int p = 1; p < kProcesses; ++p) {
      if (!has_part(p)) continue;
      if (!channel.wait_for(members_[at(p)].done, 1, p))
        return Text("a thread did not start within the time limit");
      if (!members_[at(p)].ready) return Text("not enough memory");
    }
    return {};
  }

  // Calls the threads to the next evaluation; returns its number. A thread that is late may still
  // read the state when the call is over, and the caller's memory somebody else's: it is copied.
  std::uint64_t call(const Number* q, const Number* v, const Number* tau) {
    if constexpr (!kAlone) {
      std::copy_n(q, kNq, q_.data());
      std::copy_n(velocities_of(v), kNv, v_.data());
      std::copy_n(tau, kNtau, tau_.data());
    }
    return call();
  }

  // Waits for the threads' part of an evaluation. Whether all answered in time; what failed there
  // joins the status.
  bool wait(std::uint64_t number, Channel& channel, int& status) {
    for (int p = 1; p < kProcesses; ++p) {
      if (!has_part(p)) continue;
      if (!channel.wait_for(members_[at(p)].done, number, p)) return false;
      Channel::fail(status, members_[at(p)].status);
    }
    return true;
  }

 private:
  struct alignas(kCacheLine) Member {
    std::atomic<std::uint64_t> done{0};  // evaluations, the start being the first
    int status = kFine;
    bool ready = false;
    std::thread thread;
  };

  // How long a thread looks for the next evaluation before it sleeps. It only glances where the
  // last one came after a rest, as the next will: a loop of 1 kHz leaves its core to others.
  static constexpr std::chrono::microseconds kAwake{20}, kRest{100};

  static constexpr std::size_t at(int p) { return static_cast<std::size_t>(p); }
  static bool has_part(int p) { return !kAlone && kProcess[at(p)].takes_part(); }

  // Lets the threads run on any core but the caller's. Linux may leave two threads that rest
  // between calls on one core, beside an idle one, and each call would wait until they take turns.
  void leave_callers_core() {
#if defined(__linux__)
    const int core = sched_getcpu();
    if (core < 0 || core >= CPU_SETSIZE || core == callers_core_) return;
    callers_core_ = core;
    cpu_set_t others = allowed_;
    CPU_CLR(static_cast<std::size_t>(core), &others);
    for (Member& member : members_)
      if (member.thread.joinable())  // there may be no other core
        pthread_setaffinity_np(member.thread.native_handle(), sizeof others, &others);
#endif
  }

#if defined(__linux__)
  // The cores of this process, or all of the machine where those are fewer than the threads.
  static cpu_set_t allowed() {
    cpu_set_t cores;
    CPU_ZERO(&cores);
    if (sched_getaffinity(0, sizeof cores, &cores) == 0 && CPU_COUNT(&cores) >= kProcesses)
      return cores;
    for (std::size_t core = 0; core < CPU_SETSIZE; ++core) CPU_SET(core, &cores);
    return cores;
  }
#endif

  static bool pin([[maybe_unused]] std::thread& thread, [[maybe_unused]] int core) {
#if defined(__linux__)
    if (core < 0 || core >= CPU_SETSIZE) return false;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(core, &one);
    return pthread_setaffinity_np(thread.native_handle(), sizeof one, &one) == 0;
#else
    return false;
#endif
  }

  // Calls the others to the next evaluation; returns its number.
  std::uint64_t call() {
    const std::uint64_t number = called_.fetch_add(1) + 1;  // ordered before the look at asleep_
    if (asleep_.load() > 0) {
      if (!pinned_) leave_callers_core();
      const std::lock_guard<std::mutex> held(mutex_);
      bell_.notify_all();
    }
    return number;
  }

  // Waits for an evaluation of this number. Returns whether it came after a rest;
  // ``rested``: whether the last one did.
  bool await(std::uint64_t number, bool rested) {
    const auto called = [&] { return called_.load(std::memory_order_acquire) >= number; };
    const auto start = std::chrono::steady_clock::now();
    do {
      for (int k = 0; k < 64; ++k) {
        if (called()) return false;
        relax();
      }
    } while (!rested && std::chrono::steady_clock::now() < start + kAwake);
    std::unique_lock<std::mutex> held(mutex_);
    ++asleep_;
    bell_.wait(held, [&] { return called_.load() >= number; });
    --asleep_;
    return std::chrono::steady_clock::now() > start + kRest;
  }

  // What the thread of process p does. Its memory is its own: touched here first.
  void work(int p, std::chrono::nanoseconds limit, const Workspace& set) {
    Member& member = members_[at(p)];
    const std::unique_ptr<InPlace> own(new (std::nothrow) InPlace);
    member.ready = own != nullptr;
    member.done.store(1, std::memory_order_release);
    if (!member.ready) return;
    own->channel.open(p, slots, limit);
    bool rested = false;
    for (std::uint64_t number = 2;; ++number) {
      rested = await(number, rested);
      if (ending_) return;
      copy_parameters(set, own->w);
      member.status = own->solve(q_.data(), v_.data(), tau_.data(), qdd.data());
      member.done.store(number, std::memory_order_release);
    }
  }

  bool pinned_ = true;  // to cores that the caller named
#if defined(__linux__)
  const cpu_set_t allowed_ = allowed();
  int callers_core_ = -1;
#endif
  std::array<Member, static_cast<std::size_t>(kProcesses)> members_{};
  alignas(kCacheLine) std::atomic<std::uint64_t> called_{1};
  std::atomic<int> asleep_{0};
  std::atomic<bool> ending_{false};
  std::mutex mutex_;
  std::condition_variable bell_;
  // The state of the current evaluation.
  alignas(kCacheLine) std::array<Number, kNq> q_{};
  std::array<Number, kNv> v_{};
  std::array<Number, kNtau> tau_{};
};

// A solver whose processes are threads of one.
class Solver : public InPlace {
 public:
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  ~Solver() { close(); }

  // Starts the threads. cores: where those of processes 1, 2, .. are to stay, null for anywhere.
  // Returns what is wrong, or an empty string. Allocates all memory that is ever needed.
  Text open(const int* cores, double time_limit) {
    if (!(time_limit > 0)) return Text("the time limit must be more than 0 s");
    limit_ = std::chrono::duration_cast<std::chrono::nanoseconds>(
        std::chrono::duration<double>(std::min(time_limit, 1e8)));
    pinned_ = cores != nullptr;
    if (pinned_) std::copy_n(cores, kProcesses - 1, cores_.data());
    return start();
  }

  // Ends the threads.
  void close() {
    leave_behind();
    team_.reset();
  }

  int solve(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    if (forked() && !start().empty()) return team_.reset(), finish(failure(kNoAnswer, 1));
    if (channel.broken()) return finish(channel.no_answer());
    const std::uint64_t number = team_->call(q, v, tau);
    int status = InPlace::solve(q, v, tau, kAlone ? qdd : team_->qdd.data());
    if (!team_->wait(number, channel, status)) return finish(channel.no_answer());
    if (!kAlone && status == kFine) std::copy(team_->qdd.begin(), team_->qdd.end(), qdd);
    return finish(status);
  }
  int solve_at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    return solve(q, v, tau, qdd);
  }
  int end_at_root() { return kFine; }

 private:
  Text start() {
    leave_behind();
    team_.reset(new (std::nothrow) Team);
    if (team_ == nullptr || !count_forks()) return Text("not enough memory");
    forks_ = forks;
    channel = Channel();
    channel.open(0, team_->slots, limit_);
    return team_->start(pinned_ ? cores_.data() : nullptr, limit_, channel, w);
  }

  // Whether this process is a copy of the one that started the threads.
  bool forked() const {
    return team_ == nullptr || forks_ != forks.load(std::memory_order_relaxed);
  }

  // In a copy nobody ends the threads, which are not there: who waited for them would hang, and so
  // would who took away the locks that they held.
  void leave_behind() {
    if (forked()) static_cast<void>(team_.release());
  }

  std::unique_ptr<Team> team_;
  std::uint64_t forks_ = 0;
  std::chrono::nanoseconds limit_{};
  bool pinned_ = false;  // to cores that the caller named
  std::array<int, static_cast<std::size_t>(kProcesses)> cores_{};
};

}  // namespace
