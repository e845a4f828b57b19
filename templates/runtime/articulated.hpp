// Articulated bodies: what one process does alone between its cuts. A joint is treated in its own
// frame, the child link's. Seen from the segment's root, a_far = a_near + sigma (S qdd + c) and
// sigma tau = S^T f_far; sigma is -1 where the far link is the parent.

// A spatial inertia [[A, B], [B^T, C]]: A and C symmetric, their upper triangles row by row; B row
// by row. 21 numbers, and half the work of a 6x6 matrix.
struct Inertia {
  std::array<Real, 6> A, C;
  std::array<Real, 9> B;

  static constexpr int symmetric(int i, int k) {
    return i <= k ? i * (5 - i) / 2 + k : symmetric(k, i);
  }

  constexpr Real operator()(int i, int k) const {
    if (i < 3 && k < 3) return A[symmetric(i, k)];
    if (i >= 3 && k >= 3) return C[symmetric(i - 3, k - 3)];
    return i < 3 ? B[3 * i + k - 3] : B[3 * k + i - 3];
  }

  // Sets the entries (i, k) and (k, i), which are one.
  constexpr void set(int i, int k, Real value) {
    if (i < 3 && k < 3)
      A[symmetric(i, k)] = value;
    else if (i >= 3 && k >= 3)
      C[symmetric(i - 3, k - 3)] = value;
    else if (i < 3)
      B[3 * i + k - 3] = value;
    else
      B[3 * k + i - 3] = value;
  }

  Inertia& operator+=(const Inertia& other) {
    ADAGEN_FOR (k, 0, 6) A[k] += other.A[k], C[k] += other.C[k];
    ADAGEN_FOR (k, 0, 9) B[k] += other.B[k];
    return *this;
  }
};

// T^T m T for a symmetric m, T being E or, transposed, E^T; both row by row.
template <bool transposed>
std::array<Real, 6> rotated(const Mat3& E, const std::array<Real, 6>& m) {
  const auto T = [&E](int i, int k) { return transposed ? E(k, i) : E(i, k); };
  std::array<Real, 9> half;  // m T
  ADAGEN_FOR (i, 0, 3)
    ADAGEN_FOR (k, 0, 3)
      half[3 * i + k] = m[Inertia::symmetric(i, 0)] * T(0, k) +
                        m[Inertia::symmetric(i, 1)] * T(1, k) +
                        m[Inertia::symmetric(i, 2)] * T(2, k);
  std::array<Real, 6> result;
  ADAGEN_FOR (i, 0, 3)
    ADAGEN_FOR (k, i, 3)
      result[Inertia::symmetric(i, k)] =
          T(0, i) * half[k] + T(1, i) * half[3 + k] + T(2, i) * half[6 + k];
  return result;
}

template <bool transposed>
std::array<Real, 9> rotated(const Mat3& E, const std::array<Real, 9>& m) {
  const auto T = [&E](int i, int k) { return transposed ? E(k, i) : E(i, k); };
  std::array<Real, 9> half, result;
  ADAGEN_FOR (i, 0, 3)
    ADAGEN_FOR (k, 0, 3)
      half[3 * i + k] = m[3 * i] * T(0, k) + m[3 * i + 1] * T(1, k) + m[3 * i + 2] * T(2, k);
  ADAGEN_FOR (i, 0, 3)
    ADAGEN_FOR (k, 0, 3)
      result[3 * i + k] = T(0, i) * half[k] + T(1, i) * half[3 + k] + T(2, i) * half[6 + k];
  return result;
}

// The inertia m told at a point whose origin is at -r from the one it is told at:
// B + rx C, and A + rx (B + rx C)^T - B rx.
inline void shift(const Vec3& r, Inertia& m) {
  const auto& C = m.C;
  auto& A = m.A;
  const std::array<Real, 9> B = m.B;
  auto& S = m.B;
  const auto c = [&C](int i, int k) { return C[Inertia::symmetric(i, k)]; };
  ADAGEN_FOR (k, 0, 3) {
    S[k] += r[1] * c(2, k) - r[2] * c(1, k);
    S[3 + k] += r[2] * c(0, k) - r[0] * c(2, k);
    S[6 + k] += r[0] * c(1, k) - r[1] * c(0, k);
  }
  A[0] += r[1] * S[2] - r[2] * S[1] - (B[1] * r[2] - B[2] * r[1]);
  A[1] += r[1] * S[5] - r[2] * S[4] - (B[2] * r[0] - B[0] * r[2]);
  A[2] += r[1] * S[8] - r[2] * S[7] - (B[0] * r[1] - B[1] * r[0]);
  A[3] += r[2] * S[3] - r[0] * S[5] - (B[5] * r[0] - B[3] * r[2]);
  A[4] += r[2] * S[6] - r[0] * S[8] - (B[3] * r[1] - B[4] * r[0]);
  A[5] += r[0] * S[7] - r[1] * S[6] - (B[6] * r[1] - B[7] * r[0]);
}

// target += X^T m X: an inertia in the child's frame, felt in the parent's.
ADAGEN_NOINLINE void add_in_parent(const Transform& X, const Inertia& m, Inertia& target) {
  Inertia turned{rotated<false>(X.E, m.A), rotated<false>(X.E, m.C), rotated<false>(X.E, m.B)};
  shift(X.r, turned);
  target += turned;
}

// X^-T m X^-1: an inertia in the parent's frame, felt in the child's.
ADAGEN_NOINLINE Inertia in_child(const Transform& X, const Inertia& m) {
  Inertia moved = m;
  shift(-X.r, moved);
  return {rotated<true>(X.E, moved.A), rotated<true>(X.E, moved.C), rotated<true>(X.E, moved.B)};
}

// X^-T f: a wrench on the parent, felt in the child's frame.
[[maybe_unused]] Columns6 wrench_in_child(const Transform& X, const Columns6& f) {
  Columns6 result;
  ADAGEN_FOR (k, 0, kColumns) {
    const Vec3 moment = f.col(k).template head<3>(), force = f.col(k).template tail<3>();
    result.col(k).template head<3>() = X.E * (moment - X.r.cross(force));
    result.col(k).template tail<3>() = X.E * force;
  }
  return result;
}

// X^-1 m: motions in the child's frame, told in the parent's.
template <int columns>
Eigen::Matrix<Real, 6, columns> motion_in_parent(const Transform& X,
                                                 const Eigen::Matrix<Real, 6, columns>& m) {
  Eigen::Matrix<Real, 6, columns> result;
  ADAGEN_FOR (k, 0, columns) {
    const Vec3 angular = X.E.transpose() * m.col(k).template head<3>();
    result.col(k).template head<3>() = angular;
    result.col(k).template tail<3>() =
        X.E.transpose() * m.col(k).template tail<3>() + X.r.cross(angular);
  }
  return result;
}

// X^-1 m X^-T: a mobility in the child's frame, told in the parent's.
ADAGEN_NOINLINE Mat6 congruent_in_parent(const Transform& X, const Mat6& m) {
  const Mat6 half = motion_in_parent(X, m).transpose();
  return motion_in_parent(X, half);
}

template <std::size_t n>
std::array<std::array<Real, kColumns>, n> negated(std::array<std::array<Real, kColumns>, n> x) {
  for (auto& row : x)
    for (Real& value : row) value = -value;
  return x;
}

// Spatial inertia of a link at its origin.
Inertia spatial_inertia(const LinkConstants& link) {
  const Real x = link.com[0], y = link.com[1], z = link.com[2], m = link.mass;
  const Real* const t = link.tensor;
  return {{t[0] + m * (y * y + z * z), t[1] - m * x * y, t[2] - m * x * z,
           t[4] + m * (x * x + z * z), t[5] - m * y * z, t[8] + m * (x * x + y * y)},
          {m, 0, 0, m, 0, m},
          {0, -m * z, m * y, m * z, 0, -m * x, -m * y, m * x, 0}};
}

// I^A and p^A of a link start as its own inertia and v x* I v.
ADAGEN_NOINLINE void start_link(const Inertia& inertia, const Vec6& velocity, Inertia& IA,
                                Columns6& pA) {
  IA = inertia;
  const auto& A = inertia.A;
  const Vec3 w = velocity.head<3>(), v = velocity.tail<3>();
  const Real mass = inertia.C[0];
  const Vec3 mc(inertia.B[7], inertia.B[2], inertia.B[3]);  // mass times centre of mass
  const Vec3 angular =
      Vec3(A[0] * w[0] + A[1] * w[1] + A[2] * w[2], A[1] * w[0] + A[3] * w[1] + A[4] * w[2],
           A[2] * w[0] + A[4] * w[1] + A[5] * w[2]) +
      mc.cross(v);
  const Vec3 linear = mass * v + w.cross(mc);
  if constexpr (kColumns > 1) pA.setZero();
  pA.col(0).template head<3>() = w.cross(angular) + v.cross(linear);
  pA.col(0).template tail<3>() = w.cross(linear);
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
// hands on to its near side, by exact projection: nothing along S but the torque. Returns false
// where D cannot be factorized.
template <class Kind>
ADAGEN_NOINLINE bool articulate(Articulated<Kind>& i, Real sigma, const Inertia& I,
                                const Columns6& p, Inertia& handed, Columns6& force) {
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
    ADAGEN_FOR (l, 0, 6) handed.set(free[k], l, 0);
  if constexpr (m > 0) {
    ADAGEN_FOR (r, 0, m)
      ADAGEN_FOR (s, r, m) {
        Real x = I(constrained[r], constrained[s]);
        ADAGEN_FOR (k, 0, n) x -= I(constrained[r], free[k]) * i.E[k][constrained[s]];
        handed.set(constrained[r], constrained[s], x);
      }
    ADAGEN_FOR (c, 0, kColumns)
      ADAGEN_FOR (r, 0, m) {
        Real x = p(constrained[r], c);
        ADAGEN_FOR (k, 0, n) x += I(constrained[r], free[k]) * moved[k][c];
        ADAGEN_FOR (s, 0, m) x += handed(constrained[r], constrained[s]) * i.c(constrained[s], c);
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
  ADAGEN_FOR (k, 0, (kFree<Kind>)) m.row(Kind::Free::row[k]).setZero();
  ADAGEN_FOR (k, 0, (kFree<Kind>))
    for (int l : Kind::Constrained::row) m.row(Kind::Free::row[k]) -= i.E[k][l] * m.row(l);
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
ADAGEN_NOINLINE bool invert(const Inertia& I, const Columns6& p, Mat6& Phi, Columns6& b) {
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
  b.noalias() = -Phi * p;
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
