// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

#include "../common.hpp"
#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../value.hpp"
#include "accelerate.hpp"
#include "algebra.hpp"
#include "certify.hpp"
#include "lanes.hpp"
#include "links.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "outward.hpp"
#include "parts.hpp"
#include "parts_joined.hpp"
#include "scans.hpp"
#include "shuffles.hpp"
#include "strips.hpp"
#include "weights.hpp"

namespace {

// A bound of the error of a chain that is swept in parts (docs/explanation/certificates.md). Each
// part is weighed as if it floated and nothing but the wrenches on its ends acted on it that were
// found in the evaluation: whatever they are, they do no work on motions that the joints between
// parts allow. How its first link moves differs in the last digits from how the links before it
// have it: by so much the whole part moves as one body in the answer, and lengths of both errors
// are added.

// What each lane has from the lane before it, or beyond it; nothing at the end.
ADAGEN_INLINE Lanes from_before(const Lanes& x) { return beyond<1>(before<1>(x), Lanes{}); }
ADAGEN_INLINE Vector<Lanes> from_before(const Vector<Lanes>& x) {
  return {from_before(x.x), from_before(x.y), from_before(x.z)};
}
template <std::size_t... lane>
ADAGEN_INLINE Lanes from_beyond(const Lanes& x, std::index_sequence<lane...>) {
  return shuffled<static_cast<int>(lane + 1)...>(x, Lanes{});
}
ADAGEN_INLINE Lanes from_beyond(const Lanes& x) { return from_beyond(x, kEachLane); }
ADAGEN_INLINE Vector<Lanes> from_beyond(const Vector<Lanes>& x) {
  return {from_beyond(x.x), from_beyond(x.y), from_beyond(x.z)};
}

// What the sweep outwards tells of the parts: how their last links move and lie from the first
// ones, the energy of the answer and what is uncertain of it, and sums over their links: masses,
// times squares of distances from the first one, and traces of inertias.
struct MovedParts {
  Motion<Lanes> last;
  Reached<Lanes> reached;
  Vector<Lanes> span;
  Lanes energy, rounded, masses, distances, traces;
};

// What the links of a row take of their motion, as weigh_links has it; empty: but lanes that are
// not filled.
template <class Run, bool empty>
ADAGEN_INLINE void weigh_row(Workspace& w, int row, const Motion<Lanes>& a, MovedParts& to) {
  const Joints<Lanes> joints = Run::row(row, 0);
  const auto at = [&](Entry entry) { return vector_at<Lanes>(w.at(joints.slot, entry)); };
  const auto sum = [](Lanes& found, const Lanes& more) ADAGEN_ALWAYS {
    found += empty ? chosen(filled_lanes<Run>(kEachLane), more, Lanes{}) : more;
  };
  const Vector<Lanes> Ax = at(kRotational), c = at(kMoments);
  const Vector<Lanes> Ay = vector_at<Lanes>(w.at(joints.slot, kRotational) + 3 * kPerBlock);
  const Symmetric<Lanes> A{Ax.x, Ax.y, Ax.z, Ay.x, Ay.y, Ay.z};
  const Lanes mass = mass_of(w, joints), trace = A.xx + A.yy + A.zz;
  Vector<Lanes> n = A * a.angular + cross(c, a.linear);
  Vector<Lanes> f = a.linear * mass + cross(a.angular, c);
  sum(to.energy, dot(a.angular, n) + dot(a.linear, f));
  n += at(kTorque), f += at(kForce);
  Lanes units = number_at<Lanes>(w.at(joints.slot, kTakenUnits));
  const Lanes spin = dot(a.angular, a.angular);
  units += trace * trace * spin + dot(c, c) * dot(a.linear, a.linear);
  if constexpr (empty) {
    constexpr LaneBits filled = filled_lanes<Run>(kEachLane);
    clear_others(filled, n), clear_others(filled, f), clear_others(filled, units);
  }
  put_at(w.at(joints.slot, kTakenTorque), n), put_at(w.at(joints.slot, kTakenForce), f);
  put_at(w.at(joints.slot, kTakenUnits), units);
  to.reached.turning = larger(to.reached.turning, spin);
  sum(to.rounded, trace * to.reached.turning + mass * to.reached.sliding);
  sum(to.masses, mass), sum(to.traces, trace);
  sum(to.distances, mass * dot(to.span, to.span));
}

// See accelerate_in_parts; each link is weighed as soon as it is known how it moves.
template <int first, int last>
ADAGEN_NOINLINE MovedParts accelerate_weighed_in_parts(Workspace& w, const StartedParts& started) {
  using Run = Strips<first, last>;
  MovedParts moved{};
  moved.reached.sliding = dot(started.first.linear, started.first.linear) + w.reached[0].sliding;
  weigh_row<Run, false>(w, 0, started.first, moved);
  pass_parts_outward<Run>(w, started,
                          [&](int row, const Motion<Lanes>& a, auto empty) ADAGEN_ALWAYS {
                            const Vector<Lanes>& r = w.memory(Run::row(row, 0)).r;
                            moved.span += r;
                            moved.reached.sliding += dot(r, r) * moved.reached.turning;
                            moved.last = a;
                            weigh_row<Run, decltype(empty)::value>(w, row, a, moved);
                          });
  return moved;
}

// What drives the joints that parts hang on by, less what their rotors need.
template <class Run>
ADAGEN_INLINE Lanes driving_parts(Workspace& w, int row) {
  Lanes tau = torques<Run>(w, row, kEachLane);
  if constexpr (kAnyRotor)
    tau -= each(Run::row(row, 0), [&w](const JointConstants& own) {
      return w.answer[static_cast<std::size_t>(own.v)] * Real(own.passive.rotor);
    });
  return tau;
}

// Adds what the parts take for moving as the links before them have it, and what of that may be
// rounding. Of x angular and y linear at its first link a part takes at most K |x|^2 + M |y|^2; a
// link's motion is uncertain by what turns any link before it, over the whole way from there.
template <class Run>
ADAGEN_INLINE Lanes part_from_before(Workspace& w, const StartedParts& started,
                                     const MovedParts& moved, Lanes& rounded) {
  const Joints<Lanes> row = Run::row(0, 0);
  const auto add = [](const auto& x, const auto& y) ADAGEN_ALWAYS { return x + y; };
  const Vector<Lanes> axis = axis_at<Lanes>(w.at(row.slot, kAxes)), &r = w.memory(row).r;
  const Vector<Lanes> arm = from_before(moved.span + from_beyond(r));
  const Vector<Lanes> turned = from_before(moved.last.angular);
  const Lanes found = each(
      row, [&w](const JointConstants& own) { return w.answer[static_cast<std::size_t>(own.v)]; });
  const Vector<Lanes> turn = (turned + axis * found) - started.first.angular;
  const Vector<Lanes> slide =
      (from_before(moved.last.linear) + cross(turned, r)) - started.first.linear;
  const Vector<Lanes> place = joined_up(arm, add), x = joined_up(turn, add);
  const Vector<Lanes> y = joined_up(slide - cross(turn, place), add) + cross(x, place);
  const Lanes turning = from_before(moved.reached.turning), length = dot(arm, arm);
  const Lanes turns = joined_up(turning + dot(started.first.angular, started.first.angular), add);
  const Lanes slides = joined_up(from_before(moved.reached.sliding) + length * turning +
                                     dot(started.first.linear, started.first.linear),
                                 add) +
                       turns * joined_up(length, add) * Real(kPerBlock);
  const Lanes K = 4 * moved.distances + moved.traces, M = 4 * moved.masses;
  rounded += K * (turns + moved.reached.turning) + M * slides;
  return K * dot(x, x) + M * dot(y, y);
}

// What the parts leave over is swept to their first links, and weighed there by what these show.
template <int first, int last>
ADAGEN_NOINLINE void weigh_parts(Workspace& w, const SweptParts& swept, const ShownParts& shown,
                                 const EndForces& forces, const StartedParts& started,
                                 const MovedParts& moved) {
  using Run = Strips<first, last>;
  const Joints<Lanes> row0 = Run::row(0, 0);
  Found<Lanes> found{{}, moved.rounded};
  const Lanes parted = part_from_before<Run>(w, started, moved, found.rounded);
  // Wrenches on the first links, with torques along the joints, to the bit; and against them on the
  // last links before these.
  const Vector<Lanes> axis0 = axis_at<Lanes>(w.at(row0.slot, kAxes)), &r0 = w.memory(row0).r;
  Vector<Lanes> n{forces.near[0], forces.near[1], forces.near[2]};
  const Vector<Lanes> f{forces.near[3], forces.near[4], forces.near[5]};
  n += axis0 * (driving_parts<Run>(w, 0) - dot(axis0, n));
  Lanes moments = dot(n, n);
  if constexpr (kAnySpent) moments += spent_square(w, row0);
  const Lanes pull = dot(f, f);
  Left<Lanes> X{from_beyond(n + cross(r0, f)), from_beyond(f),
                from_beyond(moments + dot(r0, r0) * pull), from_beyond(pull)};
  for (int row = Run::kRows - 1; row > 0; --row) {
    const Joints<Lanes> joints = Run::row(row, 0);
    add_weighed_link(w, joints, X);
    X.moments += dot(X.n, X.n), X.forces += dot(X.f, X.f);
    if constexpr (kAnySpent) X.moments += spent_square(w, joints);
    const Lanes brought = dot(axis_at<Lanes>(w.at(joints.slot, kAxes)), X.n);
    const Lanes u = driving_parts<Run>(w, row) - brought;
    weigh_freedom<false>(w, joints, u, X.moments, X, found);
    const Vector<Lanes>& r = w.memory(joints).r;
    X.moments += dot(r, r) * X.forces;
  }
  add_weighed_link(w, row0, X);
  X.moments += dot(X.n, X.n) + moments, X.forces += dot(X.f, X.f) + pull;
  X.n += -n, X.f += -f;
  if constexpr (kOnGround<Run>) {  // the ground takes all but what is along the joint
    choose(kFirstLane, axis0 * dot(axis0, X.n), X.n, X.n),
        choose(kFirstLane, Vector<Lanes>{}, X.f, X.f);
  }
  const Lanes left[6]{X.n.x, X.n.y, X.n.z, X.f.x, X.f.y, X.f.z};
  Lanes own{};
  ADAGEN_FOR (i, 0, 6)
    ADAGEN_FOR (k, 0, 6) own += left[i] * shown.Phi[i][k] * left[k];
  const Lanes turns = shown.Phi[0][0] + shown.Phi[1][1] + shown.Phi[2][2];
  const Lanes slides = shown.Phi[3][3] + shown.Phi[4][4] + shown.Phi[5][5];
  found.rounded += X.moments * turns + X.forces * slides;
  const Symmetric<Lanes>&A = swept.bodies.A, &C = swept.bodies.C;
  const Lanes known =  // of the least pivots; see seen_by
      1 - Real(kUnit) * (turns * (A.xx + A.yy + A.zz) + slides * (C.xx + C.yy + C.zz));
  found.seen += chosen(known > Lanes{}, own / known, own + std::numeric_limits<Real>::infinity());
  const Value seen = over_links(found.seen), apart = over_links(parted);
  w.seen += seen + apart + 2 * std::sqrt(larger(seen * apart, Value{}));
  w.rounded += over_links(found.rounded), w.energy += over_links(moved.energy);
}

}  // namespace
