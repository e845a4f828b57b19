// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "common.hpp"
#include "inertia.hpp"
#include "joins.hpp"
#include "sizes.hpp"
#include "spatial.hpp"

namespace {

// Articulated bodies: what one process does alone between its cuts. A joint is treated in its own
// frame, the child link's. Seen from the segment's root, a_far = a_near + sigma (S qdd + c) and
// sigma tau = S^T f_far; sigma is -1 where the far link is the parent.

template <std::size_t n>
std::array<std::array<Real, kColumns>, n> negated(std::array<std::array<Real, kColumns>, n> x) {
  for (auto& row : x)
    for (Real& value : row) value = -value;
  return x;
}

// I^A and p^A of a link start as its own inertia and v x* I v.
ADAGEN_NOINLINE void start_link(const Inertia& inertia, const Vec6& velocity, Inertia& IA,
                                Columns6& pA) {
  IA = inertia;
  const auto& A = inertia.A;
  const Vec3 w(velocity[0], velocity[1], velocity[2]), v(velocity[3], velocity[4], velocity[5]);
  const Real mass = inertia.C[0];
  const Vec3 mc(inertia.B[7], inertia.B[2], inertia.B[3]);  // mass times centre of mass
  const Vec3 carried = cross(mc, v), turned = cross(w, mc);
  const Vec3 angular(A[0] * w[0] + A[1] * w[1] + A[2] * w[2] + carried[0],
                     A[1] * w[0] + A[3] * w[1] + A[4] * w[2] + carried[1],
                     A[2] * w[0] + A[4] * w[1] + A[5] * w[2] + carried[2]);
  const Vec3 linear(mass * v[0] + turned[0], mass * v[1] + turned[1], mass * v[2] + turned[2]);
  const Vec3 moment = cross(w, angular), of_speed = cross(v, linear), force = cross(w, linear);
  if constexpr (kColumns > 1) pA.setZero();
  ADAGEN_FOR (k, 0, 3) {
    pA(k, 0) = moment[k] + of_speed[k];
    pA(3 + k, 0) = force[k];
  }
}

template <class Kind>
struct Articulated {
  static constexpr int n = kFree<Kind>;
  std::array<std::array<Real, n>, n> D;         // for n = 1 the inverse of D = S^T I^A S, else its
                                                // Cholesky factor, the diagonal inverted
  std::array<std::array<Real, 6>, n> E;         // D^-1 S^T I^A at the constrained rows, else zero
  std::array<std::array<Real, kColumns>, n> u;  // sigma tau - S^T p^A
  std::array<std::array<Real, kColumns>, n> tau;
  Columns6 c;  // sigma c

  template <std::size_t k>
  void solve(std::array<std::array<Real, k>, n>& x) const {
    if constexpr (n == 1) {
      for (Real& value : x[0]) value *= D[0][0];
    } else {
      forward_substitute(D, x);
      backward_substitute(D, x);
    }
  }
};

// The joint's share of the articulated body with inertia I and bias p on its far side: what it
// passes on to its near side, by exact projection: nothing along S but the torque. Returns false
// where D cannot be factorized.
template <class Kind>
ADAGEN_NOINLINE bool articulate(Articulated<Kind>& i, Real sigma, const Inertia& I,
                                const Columns6& p, Inertia& passed, Columns6& force) {
  constexpr int n = kFree<Kind>, m = kConstrained<Kind>;
  constexpr auto& free = Kind::Free::row;
  [[maybe_unused]] constexpr auto& constrained = Kind::Constrained::row;
  bool good = true;
  ADAGEN_FOR (k, 0, n) {
    ADAGEN_FOR (l, 0, n) i.D[k][l] = I(free[k], free[l]);
    i.E[k] = {};
    ADAGEN_FOR (l, 0, m) i.E[k][constrained[l]] = I(free[k], constrained[l]);
    ADAGEN_FOR (c, 0, kColumns) i.u[k][c] = sigma * i.tau[k][c] - p(free[k], c);
  }
  if constexpr (n == 1) {
    // Beside the inertia about other axes (in other directions), D must be more than rounding.
    constexpr int row = free[0] < 3 ? 0 : 3;
    const Real whole = I(row, row) + I(row + 1, row + 1) + I(row + 2, row + 2);
    good = i.D[0][0] > 8 * std::numeric_limits<Real>::epsilon() * whole &&
           i.D[0][0] <= std::numeric_limits<Real>::max();
    i.D[0][0] = 1 / i.D[0][0];
  } else {
    good = factorize(i.D);
  }
  i.solve(i.E);
  auto moved = i.u;
  i.solve(moved);
  ADAGEN_FOR (k, 0, n)
    ADAGEN_FOR (l, 0, 6) passed.set(free[k], l, 0);
  if constexpr (m > 0) {
    ADAGEN_FOR (r, 0, m)
      ADAGEN_FOR (s, r, m) {
        Real x = I(constrained[r], constrained[s]);
        ADAGEN_FOR (k, 0, n) x -= I(constrained[r], free[k]) * i.E[k][constrained[s]];
        passed.set(constrained[r], constrained[s], x);
      }
    ADAGEN_FOR (c, 0, kColumns)
      ADAGEN_FOR (r, 0, m) {
        Real x = p(constrained[r], c);
        ADAGEN_FOR (k, 0, n) x += I(constrained[r], free[k]) * moved[k][c];
        ADAGEN_FOR (s, 0, m) x += passed(constrained[r], constrained[s]) * i.c(constrained[s], c);
        force(constrained[r], c) = x;
      }
  }
  ADAGEN_FOR (k, 0, n)
    ADAGEN_FOR (c, 0, kColumns) force(free[k], c) = sigma * i.tau[k][c];
  return good;
}

// a becomes the far link's acceleration (joint frame) from the near link's; returns sigma qdd.
template <class Kind>
std::array<std::array<Real, kColumns>, kFree<Kind>> accelerate(const Articulated<Kind>& i,
                                                               Columns6& a) {
  a += i.c;
  auto moved = i.u;
  i.solve(moved);
  ADAGEN_FOR (k, 0, (kFree<Kind>))
    ADAGEN_FOR (c, 0, kColumns) {
      const int row = Kind::Free::row[k];
      Real x = moved[k][c];
      for (int l : Kind::Constrained::row) x -= i.E[k][l] * a(l, c);
      moved[k][c] = x - a(row, c);
    }
  ADAGEN_FOR (k, 0, (kFree<Kind>))
    ADAGEN_FOR (c, 0, kColumns) a(Kind::Free::row[k], c) += moved[k][c];
  return moved;
}

// K m with K = 1 - S D^-1 S^T I^A, what of a motion of the near side the far side shares.
template <class Kind>
ADAGEN_NOINLINE void share(const Articulated<Kind>& i, Mat6& m) {
  ADAGEN_FOR (column, 0, 6)
    ADAGEN_FOR (k, 0, (kFree<Kind>)) {
      Real x = 0;
      for (int l : Kind::Constrained::row) x -= i.E[k][l] * m(l, column);
      m(Kind::Free::row[k], column) = x;
    }
}

// Omega of the far side: K m K^T + S D^-1 S^T, m being the near side's (zero: the ground's).
template <class Kind>
ADAGEN_NOINLINE void carry(const Articulated<Kind>& i, Mat6& m) {
  constexpr int n = kFree<Kind>;
  share(i, m);
  m.transposeInPlace();
  share(i, m);
  std::array<std::array<Real, n>, n> inverse{};
  ADAGEN_FOR (k, 0, n) inverse[k][k] = 1;
  i.solve(inverse);
  ADAGEN_FOR (k, 0, n)
    ADAGEN_FOR (l, 0, n) m(Kind::Free::row[k], Kind::Free::row[l]) += inverse[k][l];
}

// A load on the far side (joint frame) moves the joint; what is left of it, K^T load, goes on.
template <class Kind>
void deliver(Articulated<Kind>& i, Columns6& load) {
  ADAGEN_FOR (k, 0, (kFree<Kind>))
    ADAGEN_FOR (c, 0, kColumns) {
      Real& along = load(Kind::Free::row[k], c);
      i.u[k][c] += along;
      for (int l : Kind::Constrained::row) load(l, c) -= i.E[k][l] * along;
      along = 0;
    }
}

// Phi = (I^A)^-1 and b = -Phi p^A, by Cholesky's factorization.
template <class Columns>
ADAGEN_NOINLINE bool invert(const Inertia& I, const Columns& p, Mat6& Phi, Columns& b) {
  std::array<std::array<Real, 6>, 6> L, x{};
  ADAGEN_FOR (i, 0, 6) {
    ADAGEN_FOR (k, 0, 6) L[i][k] = I(i, k);
    x[i][i] = 1;
  }
  const bool good = factorize(L);
  forward_substitute(L, x);
  ADAGEN_FOR (i, 0, 6)
    ADAGEN_FOR (k, i, 6) {
      Real sum = 0;
      ADAGEN_FOR (row, 0, 6) sum += x[row][i] * x[row][k];
      Phi(i, k) = Phi(k, i) = sum;
    }
  b = Phi * p;
  ADAGEN_FOR (k, 0, int(Columns::SizeAtCompileTime)) b.data()[k] = -b.data()[k];
  return good;
}

// a with I^A a = -p^A: nothing else acts on the link.
ADAGEN_NOINLINE bool solve_root(const Inertia& I, const Columns6& p, Columns6& a) {
  std::array<std::array<Real, 6>, 6> L;
  std::array<std::array<Real, kColumns>, 6> x;
  ADAGEN_FOR (i, 0, 6) {
    ADAGEN_FOR (k, 0, 6) L[i][k] = I(i, k);
    ADAGEN_FOR (c, 0, kColumns) x[i][c] = -p(i, c);
  }
  const bool good = factorize(L);
  forward_substitute(L, x);
  backward_substitute(L, x);
  ADAGEN_FOR (i, 0, 6)
    ADAGEN_FOR (c, 0, kColumns) a(i, c) = x[i][c];
  return good;
}

}  // namespace
