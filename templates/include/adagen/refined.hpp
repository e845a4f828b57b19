// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "error_bound.hpp"
#include "gravity.hpp"
#include "refine.hpp"
#include "sample/channel.hpp"
#include "sample/correct.hpp"
#include "sample/refinement.hpp"
#include "sample/workspace.hpp"
#include "sizes.hpp"
#include "status.hpp"
#include "wide.hpp"

namespace {

// One evaluation, refined: as if it were a process's only list of steps.
inline void exchange_step(Workspace& w, Channel& channel) {
  Refinement& r = w.refinement;
  int number = kFirstExchange;
  for (const ExchangeInfo& info : kExchanges) {
    const int message = number++;
    if (info.source != channel.rank()) continue;
    Number* to = channel.outgoing(message, w.status);
    for (const int k : info.entries) *to++ = r.step[k];
    for (const int j : info.forces) to = std::copy_n(r.force[j].data(), 6, to);
    channel.send(message, w.status);
  }
  number = kFirstExchange;
  for (const ExchangeInfo& info : kExchanges) {
    const int message = number++;
    if (info.target != channel.rank()) continue;
    const Number* from = channel.receive(message, w.status);
    for (const int k : info.entries) r.step[k] = *from++;
    for (const int j : info.forces) std::copy_n(from, 6, r.force[j].data()), from += 6;
  }
}

// The joints' forces with the torques that hold slaved joints in step.
inline void collect_forces(Workspace& w, const RefinedProcess& own, const Number* tau) {
  Refinement& r = w.refinement;
  for (const int j : own.forces) {
    r.collect(j, tau);
    for (int c = 1; c < kSides; ++c) r.couple(j, c, Number(coupling_torque(w, c - 1)));
  }
  for (int k = 0; k < own.inner.count; ++k) r.hand_on(own.inner.first[k], own.beyond.first[k]);
}

// Sends energies to process 0, and what their sums tell back to all. Their roots are sent: the
// squares of small ones leave the range of floats.
inline double share_size(Workspace& w, Channel& channel) {
  Refinement& r = w.refinement;
  double e = r.step_energy, t = r.energy, s = r.whole_energy;
  int message = kFirstShare;
  for (const int p : kSharing) {
    if (channel.rank() == 0) {
      const Number* from = channel.receive(message, w.status);
      e += double(from[0]) * double(from[0]);
      t += double(from[1]) * double(from[1]);
      s += double(from[2]) * double(from[2]);
    } else if (channel.rank() == p) {
      Number* to = channel.outgoing(message, w.status);
      to[0] = static_cast<Number>(std::sqrt(e));
      to[1] = static_cast<Number>(std::sqrt(t));
      to[2] = static_cast<Number>(std::sqrt(s));
      channel.send(message, w.status);
    }
    ++message;
  }
  double size = energy_ratio(e, t);
  // What leaves the range of numbers is rounding, too.
  r.rounding = energy_ratio(static_cast<Number>(e), static_cast<Number>(std::max(t, s)));
  for (const int p : kSharing) {
    if (channel.rank() == 0) {
      Number* to = channel.outgoing(message, w.status);
      to[0] = static_cast<Number>(size), to[1] = static_cast<Number>(r.rounding);
      channel.send(message, w.status);
    } else if (channel.rank() == p) {
      const Number* from = channel.receive(message, w.status);
      size = double(from[0]), r.rounding = double(from[1]);
    }
    ++message;
  }
  return size;
}

// Corrections of this size need not fall further. Where hardly anything accelerates, the answer is
// a small difference of what holds it, which sets the size of rounding.
constexpr double kSettled = 16 * double(std::numeric_limits<Number>::epsilon());

// A correction must be smaller than the one before (the first, than all that accelerates), down to
// rounding.
inline void require_convergence(Workspace& w, int k) {
  const Refinement& r = w.refinement;
  const double size = r.corrections[k];
  const bool settled = r.rounding < kSettled;
  if (!(settled || (k > 0 ? size < r.corrections[k - 1] / 2 : r.rounding < 0.5)))
    fail(w, kNotRefined, 0);
}

using Steps = void (*)(Workspace&, Channel&);
inline void refine(Workspace& w, Channel& channel, Steps solve, Steps correct) {
  const RefinedProcess& own = kRefined[channel.rank()];
  if (own.own.count == 0) return;
  Refinement& r = w.refinement;
  const Number* const tau = given(w.tau);
  Number* const qdd = w.qdd;
  for (int k = 0; k < 3; ++k) r.ground[3 + k] = -Wide(gravity(w, k));
  r.begin(own, given(w.q), given(w.v));
  r.step.fill(0);
  w.qdd = r.step.data();
  begin_answer(w);
  solve(w, channel);
  for (int k = 0;; ++k) {
    collect_forces(w, own, k == 0 ? tau : r.lacking.data());
    exchange_step(w, channel);
    r.add(own);
    if (k > 0) {
      r.weigh(own);
      r.corrections[k - 1] = share_size(w, channel);
      require_convergence(w, k - 1);
    }
    if (k == kRefine) break;
    r.residual(own);
    r.miss(own, tau);
    w.tau = r.lacking.data();
    begin_correction(w, own);
    correct(w, channel);
  }
  w.tau = tau;
  w.qdd = qdd;
  if (w.status != kFine) return;
  for (const int k : own.own) qdd[k] = static_cast<Number>(r.qdd[k]);
}

void refined(Workspace& w, Channel& channel) {
  refine(w, channel, kSolve[channel.rank()], kCorrect[channel.rank()]);
}

}  // namespace
