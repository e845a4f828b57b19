// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <cstddef>

#include "../sample/robot.hpp"
#include "../spatial.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "certify.hpp"
#include "memory.hpp"
#include "mobility.hpp"
#include "shared_bound.hpp"
#include "weights.hpp"

namespace {

// A link that the ground holds, whose mobility is taken for a body beyond, or shown to others.
// Whatever force acts between the two, what each leaves over makes up the error: it is the one that
// the link was loaded with, so that both are small. The way to the ground is weighed first, as if
// nothing hung on it but that force, and lengths of both errors are added. How the link moves as
// the way to the ground has it is the answer, and what is beyond moves along, as limbs of other
// processes do.
inline void keep_held(Workspace& w, int link) {
  w.unheld = w.motions[static_cast<std::size_t>(link)];
}
template <class Load>
Left<Value> as_left(const Load& load, Value sign) {
  const Vector<Value> n{load[0], load[1], load[2]}, f{load[3], load[4], load[5]};
  return {n * sign, f * sign, dot(n, n), dot(f, f)};
}
template <int link>
void weigh_load(Workspace& w) {
  leave_left<false>(w, link, as_left(w.loads[link], -1));
}
inline void begin_rest(Workspace& w) { w.held = w.seen, w.seen = Value{}; }
template <int link>
void part(Workspace& w, Value turning, Value sliding) {
  const Motion<Value>& a = w.motions[static_cast<std::size_t>(link)];
  const Vector<Value> turn = a.angular - w.unheld.angular, slide = a.linear - w.unheld.linear;
  w.parted += turning * dot(turn, turn) + sliding * dot(slide, slide);
}
template <int link>
void weigh_held(Workspace& w, Value turning, Value sliding) {
  leave_left<true>(w, link, as_left(w.loads[link], 1));
  part<link>(w, turning, sliding);
}
// A root whose mobility is shown: what hangs on it makes its error less than by that alone.
template <int p, int link>
void weigh_shown(Workspace& w, const Mat6& Phi, Value turning, Value sliding) {
  Left<Value> X = as_left(w.loads[link], 1);
  X += w.lefts[link];
  X.moments += dot(X.n, X.n), X.forces += dot(X.f, X.f);
  const Columns6 x = as_told(w, link, columns_of({X.n, X.f}));
  w.seen += x.dot(Phi * x);
  const Value turns = Phi(0, 0) + Phi(1, 1) + Phi(2, 2);
  const Value slides = Phi(3, 3) + Phi(4, 4) + Phi(5, 5);
  w.rounded += X.moments * turns + X.forces * slides;
  part<link>(w, turning, sliding);
}

}  // namespace
