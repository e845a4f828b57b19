// adagen's runtime, the same for all robots.
#pragma once

#include <cstring>

#include "../common.hpp"
#include "../sizes.hpp"
#include "algebra.hpp"
#include "lanes.hpp"
#include "shuffles.hpp"

namespace {

// A body by columns of eight lanes, one register each, for sweeps of one joint at a time.
typedef Real Column __attribute__((vector_size(8 * sizeof(Real))));  // [angular, -, linear, -]

#if defined(__AVX512F__)
constexpr bool kInColumns = sizeof(Column) <= 64;
#elif defined(__AVX2__)
constexpr bool kInColumns = sizeof(Column) <= 32;
#else
constexpr bool kInColumns = false;
#endif

// An articulated body about a point: the columns of its inertia along three rotations and three
// translations, and its bias force.
struct Columns {
  Column angular[3]{}, linear[3]{}, force{};
};

ADAGEN_INLINE void operator+=(Columns& a, const Columns& b) {
  ADAGEN_FOR (k, 0, 3) {
    a.angular[k] += b.angular[k];
    a.linear[k] += b.linear[k];
  }
  a.force += b.force;
}

ADAGEN_INLINE Column column(const Vector<Real>& angular, const Vector<Real>& linear) {
  return Column{angular.x, angular.y, angular.z, 0, linear.x, linear.y, linear.z, 0};
}
ADAGEN_INLINE Columns columns(const Body<Real>& X) {
  const auto& [A, B, C, n, f] = X;
  return {{column({A.xx, A.xy, A.xz}, B.x), column({A.xy, A.yy, A.yz}, B.y),
           column({A.xz, A.yz, A.zz}, B.z)},
          {column({B.x.x, B.y.x, B.z.x}, {C.xx, C.xy, C.xz}),
           column({B.x.y, B.y.y, B.z.y}, {C.xy, C.yy, C.yz}),
           column({B.x.z, B.y.z, B.z.z}, {C.xz, C.yz, C.zz})},
          column(n, f)};
}
ADAGEN_INLINE Body<Real> body(const Columns& X) {
  const Column &x = X.angular[0], &y = X.angular[1], &z = X.angular[2];
  const Column &u = X.linear[0], &v = X.linear[1], &w = X.linear[2], &p = X.force;
  return {{x[0], x[1], x[2], y[1], y[2], z[2]},
          {{x[4], x[5], x[6]}, {y[4], y[5], y[6]}, {z[4], z[5], z[6]}},
          {u[4], u[5], u[6], v[5], v[6], w[6]},
          {p[0], p[1], p[2]},
          {p[4], p[5], p[6]}};
}

// Eight lanes of a register that may hold more.
template <int first>
ADAGEN_INLINE Column eight(const Lanes& x) {
  Real numbers[kLanes];
  to_memory(x, numbers);
  return from_memory<Column>(numbers + first);
}

// One number of a column in all lanes.
template <int k>
ADAGEN_INLINE Column spread(const Column& x) {
  return shuffled<k, k, k, k, k, k, k, k>(x, x);
}

// The lever arm r of a force: [n; f] becomes [n + r x f; f].
struct Arm {
  Column ahead, behind;  // y z x and z x y of r in the angular lanes
  Vector<Real> r;
};
ADAGEN_INLINE Arm arm(const Vector<Real>& r) {
  return {Column{r.y, r.z, r.x}, Column{r.z, r.x, r.y}, r};
}
// The same where x, too, has r as its linear half.
ADAGEN_INLINE Arm arm(const Column& x, const Vector<Real>& r) {
  return {shuffled<5, 6, 4, 7, 7, 7, 7, 7>(x, x), shuffled<6, 4, 5, 7, 7, 7, 7, 7>(x, x), r};
}
ADAGEN_INLINE Column carried(const Arm& arm, const Column& x) {
  return x + arm.ahead * shuffled<6, 4, 5, 7, 7, 7, 7, 7>(x, x) -
         arm.behind * shuffled<5, 6, 4, 7, 7, 7, 7, 7>(x, x);
}

// Copies A's upper triangle to its lower one. Rounding along axes that joints have eliminated
// decreases from joint to joint while the inertia is symmetric, and grows where it is not.
ADAGEN_INLINE void mirror(Columns& X) {
  X.angular[1] = shuffled<0, 1, 9, 3, 4, 5, 6, 7>(X.angular[1], X.angular[2]);
  const Column xy = shuffled<0, 8, 2, 3, 4, 5, 6, 7>(X.angular[0], X.angular[1]);
  X.angular[0] = shuffled<0, 1, 8, 3, 4, 5, 6, 7>(xy, X.angular[2]);
}

// The body expressed about the point at -r from the one that it is expressed about: what forces
// become, then what motions were, term by term in the same order.
ADAGEN_INLINE void shift(Columns& X, const Arm& arm) {
  ADAGEN_FOR (k, 0, 3) {
    X.angular[k] = carried(arm, X.angular[k]);
    X.linear[k] = carried(arm, X.linear[k]);
  }
  const auto& [x, y, z] = arm.r;
  X.angular[0] = X.angular[0] + X.linear[2] * y - X.linear[1] * z;
  X.angular[1] = X.angular[1] + X.linear[0] * z - X.linear[2] * x;
  X.angular[2] = X.angular[2] + X.linear[1] * x - X.linear[0] * y;
  X.force = carried(arm, X.force);
}

// U and 1 / D of the joint before: what is still to be subtracted from the body. So the next D need
// not wait for that.
struct Due {
  Column U{};
  Real inverse = 0, root = 0;  // root: of the inverse
};

// The inertia less U U^T / D, as g g^T: as symmetric to the last bit as it was.
ADAGEN_INLINE void subtract(Columns& X, const Due& due) {
  const Column g = due.U * due.root;
  X.angular[0] -= g * spread<0>(g);
  X.angular[1] -= g * spread<1>(g);
  X.angular[2] -= g * spread<2>(g);
  X.linear[0] -= g * spread<4>(g);
  X.linear[1] -= g * spread<5>(g);
  X.linear[2] -= g * spread<6>(g);
}
ADAGEN_INLINE void settle(Columns& X, Due& due) {
  subtract(X, due);
  due = {};
}
ADAGEN_INLINE Body<Real> settled(Columns X, Due due) {
  settle(X, due);
  return body(X);
}

}  // namespace
