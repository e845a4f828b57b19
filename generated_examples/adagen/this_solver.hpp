// adagen's runtime, the same for all robots.
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "common.hpp"
#include "description.hpp"
#include "error_bound.hpp"
#include "failures.hpp"
#include "sample/channel.hpp"
#include "sample/measured.hpp"
#include "sample/parameters.hpp"
#include "sample/processes.hpp"
#include "sample/solver.hpp"
#include "stamp.hpp"
#include "tell.hpp"

namespace {

// What the program has in place of a communicator, and this solver's.
#if defined(ADAGEN_MPI)
using Comm = MPI_Comm;
inline Comm own_comm(const Channel& channel) { return channel.comm(); }
#else
using Comm = adagen::OneProcess;
inline Comm own_comm(const Channel&) { return {}; }
#endif

// Solvers that do not refine have no corrections.
template <class S>
auto correction_of(const S& solver, int k, int)
    -> decltype(double(solver.w.refinement.corrections[0])) {
  return solver.w.refinement.corrections[static_cast<std::size_t>(k)];
}
template <class S>
double correction_of(const S&, int, long) {
  return 0;
}

// Nor have those bounds of errors whose answers are not certified.
template <class S>
auto error_bound_of(const S& solver, int)
    -> decltype(bound_of(double(solver.w.certificate[0]), double(solver.w.certificate[1]))) {
  return bound_of(double(solver.w.certificate[0]), double(solver.w.certificate[1]));
}
template <class S>
double error_bound_of(const S&, long) {
  return 0;
}

// The solver, through the interface that the program uses.
class ThisSolver final : public adagen::AnySolver<Number, Comm> {
 public:
  const char* open(Comm comm, const adagen::Opening& how) override {
#if defined(ADAGEN_REPRODUCIBLE)
    if (const char* const why = why_not_reproducible()) return why;
#endif
    words_ = open_solver(solver_, comm, how);
    return words_.c_str();
  }
  void close() override { solver_.close(); }
#if defined(ADAGEN_SETS_GRAVITY)
  void set_gravity(const double* gravity) override {
    Number numbers[3];
    for (int k = 0; k < 3; ++k) numbers[k] = static_cast<Number>(gravity[k]);
    set_parameters(solver_, kGravityEntry, 3, numbers);
  }
#endif
  Comm comm() const override { return own_comm(solver_.channel); }
  const char* channel_name() const override { return kAlone ? "none" : solver_.channel.name(); }
  bool windowed() const override { return solver_.channel.windowed(); }

  int solve(const Number* q, const Number* v, const Number* tau, Number* qdd) override {
    return in_place(q, v, tau, qdd);
  }
  int solve_at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) override {
    return at_root(q, v, tau, qdd);
  }
  int end_at_root() override { return solver_.end_at_root(); }
  bool has_part() const override {
#if defined(ADAGEN_MPI) || defined(ADAGEN_THREADS)
    return kProcess[static_cast<std::size_t>(solver_.channel.rank())].takes_part();
#else
    return true;
#endif
  }
#if defined(ADAGEN_BATCH)

  int solve_batch_at_root(int count, const Number* q, const Number* v, const Number* tau,
                          Number* qdd) override {
    return solver_.solve_batch_at_root(count, q, v, tau, qdd, bounds_of(count));
  }
  double error_bound(int k) const override { return bounds_[static_cast<std::size_t>(k)]; }
  int failures() const override { return solver_.failures(); }
  int failed_state(int k) override { return solver_.failed_state(k); }
  const char* why() const override { return solver_.text.c_str(); }
  int failed_status(int k) const override { return solver_.failed_status(k); }
#else
  double error_bound(int) const override { return error_bound_of(solver_, 0); }
#endif

  const char* in_words(int status) override {
    words_ = describe(status);
    return words_.c_str();
  }
  const char* names_of_run(int joint) override {
    words_.clear();
    add_names_of_run(words_, joint);
    return words_.c_str();
  }
  double correction([[maybe_unused]] int k) const override { return correction_of(solver_, k, 0); }
  int near_lock() const override { return near_lock_of(solver_, 0); }

  adagen::Elapsed time(const Number* q, const Number* v, const Number* tau, Number* qdd) override {
    const Clock::time_point start = start_together(solver_.channel);
    const int first = solver_.solve(q, v, tau, qdd);
    const double in_place_ns = since(start);
    const Clock::time_point again = start_again(solver_.channel);
    const int second = solver_.solve_at_root(q, v, tau, qdd);
    const double at_root_ns = since(again);
    return {in_place_ns, at_root_ns, first, second};
  }
#if defined(ADAGEN_BATCH)
  adagen::Elapsed time_batch(int states, int active, const Number* q, const Number* v,
                             const Number* tau, Number* qdd) override {
    double* const bounds = bounds_of(states * active);
    const Clock::time_point start = start_together(solver_.channel);
    const int first =
        solver_.solve_batch(solver_.channel.rank() < active ? states : 0, q, v, tau, qdd, bounds);
    const double in_place_ns = since(start);
    const Clock::time_point again = start_together(solver_.channel);
    const int second =
        solver_.solve_batch_at_root(states * active, q, v, tau, qdd, bounds, active - 1);
    const double at_root_ns = since(again);
    return {in_place_ns, at_root_ns, first, second};
  }
#endif
  int trace(const Number* q, const Number* v, const Number* tau, Number* qdd,
            Ticks* stamps) override {
    start_together(solver_.channel);
    trace_stamps = stamps;
    const int status = in_place(q, v, tau, qdd);
    trace_stamps = nullptr;
    return status;
  }

  void forget(int count) override { takes_.forget(count); }
  int record(int k, bool root, const Number* q, const Number* v, const Number* tau,
             Number* qdd) override {
    return takes_.record(solver_.channel, k,
                         [&] { return root ? at_root(q, v, tau, qdd) : in_place(q, v, tau, qdd); });
  }
  void play(int k, bool root, const Number* q, const Number* v, const Number* tau, Number* qdd,
            Ticks* looks) override {
    if (root)
      takes_.play(solver_.channel, k, looks, [&] { at_root(q, v, tau, qdd); });
    else
      takes_.play(solver_.channel, k, looks, [&] { in_place(q, v, tau, qdd); });
  }
  adagen::Table<int> noted(int k) const override { return takes_.messages(k); }

 private:
  // For all callers but the clock: not inlined, so that the code exists once.
  ADAGEN_NOINLINE int in_place(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    return solver_.solve(q, v, tau, qdd);
  }
  ADAGEN_NOINLINE int at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    return solver_.solve_at_root(q, v, tau, qdd);
  }

#if defined(ADAGEN_BATCH)
  // Where bounds of errors of so many states go; null where answers are not certified.
  double* bounds_of(int count) {
    if (!kCertified) return nullptr;
    bounds_.resize(static_cast<std::size_t>(count));
    return bounds_.data();
  }
#endif

  static double since(Clock::time_point start) {
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
  }

  Solver solver_;
  std::vector<double> bounds_;  // error bounds of the last batch, if certified
  Takes takes_;
  Text words_;
};

}  // namespace
