// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <thread>
#include <utility>
#include <vector>

#include "makespan.hpp"
#include "program_setting.hpp"
#include "session.hpp"
#include "statistics.hpp"
#include "status.hpp"

namespace adagen {
namespace {

// What messages cost on a channel.
inline const Hop& hop_of(const Solver& solver) {
  return solver.windowed() ? about.window_hop : about.message_hop;
}

// How long an evaluation would take if each process had a core of its own, where they have not: its
// processes compute one at a time, the others asleep, with the messages that they have once had
// (take.hpp); then these stretches and what messages cost are played through (makespan.hpp).
class Stretches {
 public:
  explicit Stretches(Session& session) : session_(session) {}

  // Collective. Evaluates each state of the session, at the root or in place; turn is called before
  // each turn. Returns the first failure.
  template <class Turn>
  int measure(bool at_root, Turn turn) {
    session_.solver.forget(session_.states.count);
    lengths_.assign(count(), {});
    int failed = record(at_root);
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, session_.comm());
    if (failed != kFine) return failed;
    const int repeat = evaluations() / session_.states.count, rounds = std::min(kRounds, repeat);
    for (int round = 0; round < rounds; ++round)
      for (int p = 0; p < about.processes; ++p) {
        rest();
        if (p != session_.rank) continue;
        turn();
        play(at_root, repeat * (round + 1) / rounds - repeat * round / rounds);
      }
    rest();
    return kFine;
  }

  // Of each state, at most as many as are kept.
  int evaluations() const {
    return std::min(session_.options.repeat, kMost) * session_.states.count;
  }

  // Collective. Over the states, at process 0: medians of the stretches played through, and the
  // least of all. Holds one look at the clock, as other times do.
  Statistics played_through() {
    const std::vector<std::vector<double>> gathered = bring_together();
    if (session_.rank != 0) return {};
    const std::vector<Message> messages(about.messages.begin(), about.messages.end());
    std::vector<const double*> next;
    next.reserve(gathered.size());
    for (const std::vector<double>& one : gathered) next.push_back(one.data());
    work_.assign(processes(), 0);
    std::vector<double> typical, least;
    for (std::size_t s = 0; s < count(); ++s) {
      std::vector<Part> medians(processes()), leasts(processes());
      for (std::size_t p = 0; p < processes(); ++p) {
        next[p] = read(next[p], medians[p], leasts[p]);
        for (const double ns : medians[p].stretches) work_[p] += ns / static_cast<double>(count());
      }
      typical.push_back(makespan(medians, messages, hop()) + look_);
      least.push_back(makespan(leasts, messages, hop()) + look_);
    }
    Statistics found = statistics(std::move(typical));
    found.least = *std::min_element(least.begin(), least.end());
    return found;
  }

  // For how long each process computes in an evaluation, ns, as last played through.
  const std::vector<double>& work() const { return work_; }

 private:
  static constexpr int kTag = 0x57e7, kRounds = 5, kMost = 1000;

  std::size_t count() const { return static_cast<std::size_t>(session_.states.count); }
  static std::size_t processes() { return static_cast<std::size_t>(about.processes); }
  const Hop& hop() const { return hop_of(session_.solver); }

  int record(bool at_root) {
    int failed = kFine;
    for (int s = 0; s < session_.states.count; ++s) {
      const int found = session_.solver.record(s, at_root, session_.q(s), session_.v(s),
                                               session_.tau(s), session_.acceleration(s));
      session_.give_up_if_broken(found);
      if (failed == kFine) failed = found;
    }
    return failed;
  }

  // A turn: all states as often as asked for, after once to warm up.
  void play(bool at_root, int passes) {
    look_ = clock_cost();
    std::vector<Solver::Ticks> looks;
    for (int pass = -1; pass < passes; ++pass)
      for (int s = 0; s < session_.states.count; ++s) {
        looks.resize(static_cast<std::size_t>(session_.solver.noted(s).count) + 2);
        session_.solver.play(s, at_root, session_.q(s), session_.v(s), session_.tau(s),
                             session_.acceleration(s), looks.data());
        if (pass >= 0) keep(looks, lengths_[static_cast<std::size_t>(s)]);
      }
  }

  void keep(const std::vector<Solver::Ticks>& looks, std::vector<double>& lengths) const {
    for (std::size_t k = 1; k < looks.size(); ++k)
      lengths.push_back(std::max(0.0, nanoseconds(looks[k] - looks[k - 1]) - look_));
  }

  // Waits for the others without using the processor, so that computing processes are not
  // disturbed.
  void rest() const {
    MPI_Request request;
    MPI_Ibarrier(session_.comm(), &request);
    for (int done = 0; MPI_Test(&request, &done, MPI_STATUS_IGNORE), !done;)
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    session_.watch.again();
  }

  // Collective. At process 0, for each process what it found of all states, one after the other:
  // number of messages, the messages, then medians and least of their stretches.
  std::vector<std::vector<double>> bring_together() {
    std::vector<double> own;
    for (std::size_t s = 0; s < count(); ++s) {
      const Table<int> messages = session_.solver.noted(static_cast<int>(s));
      own.push_back(messages.count);
      own.insert(own.end(), messages.begin(), messages.end());
      const std::vector<Statistics> found =
          of_stretches(lengths_[s], static_cast<std::size_t>(messages.count) + 1);
      for (const Statistics& one : found) own.push_back(one.median);
      for (const Statistics& one : found) own.push_back(one.least);
    }
    std::vector<std::vector<double>> all(processes());
    if (session_.rank != 0) {
      MPI_Send(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, 0, kTag, session_.comm());
      return all;
    }
    all[0] = std::move(own);
    for (int p = 1; p < about.processes; ++p) {
      MPI_Status status;
      int size = 0;
      MPI_Probe(p, kTag, session_.comm(), &status);
      MPI_Get_count(&status, MPI_DOUBLE, &size);
      all[static_cast<std::size_t>(p)].resize(static_cast<std::size_t>(size));
      MPI_Recv(all[static_cast<std::size_t>(p)].data(), size, MPI_DOUBLE, p, kTag, session_.comm(),
               MPI_STATUS_IGNORE);
    }
    return all;
  }

  static std::vector<Statistics> of_stretches(const std::vector<double>& lengths,
                                              std::size_t stretches) {
    std::vector<Statistics> found;
    for (std::size_t first = 0; first < stretches; ++first) {
      std::vector<double> one;
      for (std::size_t k = first; k < lengths.size(); k += stretches) one.push_back(lengths[k]);
      found.push_back(statistics(std::move(one)));
    }
    return found;
  }

  static const double* read(const double* from, Part& median, Part& least) {
    const std::size_t messages = static_cast<std::size_t>(*from++);
    median.messages.assign(from, from + messages);
    least.messages = median.messages;
    from += messages;
    median.stretches.assign(from, from + messages + 1);
    from += messages + 1;
    least.stretches.assign(from, from + messages + 1);
    return from + messages + 1;
  }

  Session& session_;
  std::vector<std::vector<double>> lengths_;  // of each state: one evaluation after the other
  double look_ = 0;                           // at the clock
  std::vector<double> work_;
};

}  // namespace
}  // namespace adagen
