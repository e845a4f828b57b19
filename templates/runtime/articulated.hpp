// Articulated bodies: what one process does alone between its cuts. A joint is treated in its own
// frame, the child link's. Seen from the segment's root, a_far = a_near + sigma (S qdd + c) and
// sigma tau = S^T f_far; sigma is -1 where the far link is the parent.

[[maybe_unused]] Mat3 cross_from_left(const Vec3& r, const Mat3& m) {
  Mat3 result;
  for (int k = 0; k < 3; ++k) result.col(k) = r.cross(m.col(k));
  return result;
}

// m rx
[[maybe_unused]] Mat3 cross_from_right(const Mat3& m, const Vec3& r) {
  Mat3 result;
  for (int k = 0; k < 3; ++k) result.row(k) = m.row(k).transpose().cross(r).transpose();
  return result;
}

// target += X^T m X: an inertia in the child's frame, felt in the parent's.
ADAGEN_NOINLINE void add_in_parent(const Transform& X, const Mat6& m, Mat6& target) {
  const Mat3 A = X.E.transpose() * m.topLeftCorner<3, 3>() * X.E;
  const Mat3 B = X.E.transpose() * m.topRightCorner<3, 3>() * X.E;
  const Mat3 C = X.E.transpose() * m.bottomRightCorner<3, 3>() * X.E;
  const Mat3 shifted = B + cross_from_left(X.r, C);
  target.topLeftCorner<3, 3>() +=
      A + cross_from_left(X.r, shifted.transpose()) - cross_from_right(B, X.r);
  target.topRightCorner<3, 3>() += shifted;
  target.bottomLeftCorner<3, 3>() += shifted.transpose();
  target.bottomRightCorner<3, 3>() += C;
}

// X^-T m X^-1: an inertia in the parent's frame, felt in the child's.
ADAGEN_NOINLINE Mat6 in_child(const Transform& X, const Mat6& m) {
  const Mat3 B = m.topRightCorner<3, 3>(), C = m.bottomRightCorner<3, 3>();
  const Mat3 shifted = B - cross_from_left(X.r, C);
  const Mat3 A = m.topLeftCorner<3, 3>() - cross_from_left(X.r, shifted.transpose()) +
                 cross_from_right(B, X.r);
  Mat6 result;
  result.topLeftCorner<3, 3>() = X.E * A * X.E.transpose();
  result.topRightCorner<3, 3>() = X.E * shifted * X.E.transpose();
  result.bottomLeftCorner<3, 3>() = result.topRightCorner<3, 3>().transpose();
  result.bottomRightCorner<3, 3>() = X.E * C * X.E.transpose();
  return result;
}

// X^-T f: a wrench on the parent, felt in the child's frame.
[[maybe_unused]] Columns6 wrench_in_child(const Transform& X, const Columns6& f) {
  Columns6 result;
  for (int k = 0; k < kColumns; ++k) {
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
  for (int k = 0; k < columns; ++k) {
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
Mat6 spatial_inertia(const LinkConstants& link) {
  const Vec3 c(link.com[0], link.com[1], link.com[2]);
  const Mat3 cx = cross_from_left(c, Mat3::Identity());
  Mat6 result;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) result(i, k) = link.tensor[3 * i + k];
  result.topLeftCorner<3, 3>() -= link.mass * cx * cx;
  result.topRightCorner<3, 3>() = link.mass * cx;
  result.bottomLeftCorner<3, 3>() = -link.mass * cx;
  result.bottomRightCorner<3, 3>() = link.mass * Mat3::Identity();
  return result;
}

// I^A and p^A of a link start as its own inertia and v x* I v.
ADAGEN_NOINLINE void start_link(const Mat6& inertia, const Vec6& velocity, Mat6& IA, Columns6& pA) {
  IA = inertia;
  const Vec6 momentum = inertia * velocity;
  const Vec3 omega = velocity.head<3>(), v = velocity.tail<3>();
  const Vec3 angular = momentum.head<3>(), linear = momentum.tail<3>();
  pA.setZero();
  pA.col(0).template head<3>() = omega.cross(angular) + v.cross(linear);
  pA.col(0).template tail<3>() = omega.cross(linear);
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
ADAGEN_NOINLINE bool articulate(Articulated<Kind>& i, Real sigma, const Mat6& I, const Columns6& p,
                                Mat6& handed, Columns6& force) {
  constexpr int n = kFree<Kind>, m = kConstrained<Kind>;
  constexpr auto& free = Kind::Free::row;
  [[maybe_unused]] constexpr auto& constrained = Kind::Constrained::row;
  bool good = true;
  for (int k = 0; k < n; ++k) {
    for (int l = 0; l < n; ++l) i.D[k][l] = I(free[k], free[l]);
    i.E[k] = {};
    for (int l = 0; l < m; ++l) i.E[k][constrained[l]] = I(free[k], constrained[l]);
    for (int c = 0; c < kColumns; ++c) i.u[k][c] = sigma * i.tau[k][c] - p(free[k], c);
  }
  if constexpr (n == 1) {
    good = i.D[0][0] > 0 && i.D[0][0] <= std::numeric_limits<Real>::max();
    i.D[0][0] = 1 / i.D[0][0];
  } else {
    good = factorize(i.D);
  }
  i.solve(i.E);
  auto moved = i.u;
  i.solve(moved);
  handed.setZero();
  force.setZero();
  if constexpr (m > 0) {
    for (int r = 0; r < m; ++r)
      for (int s = 0; s < m; ++s) {
        Real x = I(constrained[r], constrained[s]);
        for (int k = 0; k < n; ++k) x -= I(constrained[r], free[k]) * i.E[k][constrained[s]];
        handed(constrained[r], constrained[s]) = x;
      }
    for (int c = 0; c < kColumns; ++c)
      for (int r = 0; r < m; ++r) {
        Real x = p(constrained[r], c);
        for (int k = 0; k < n; ++k) x += I(constrained[r], free[k]) * moved[k][c];
        for (int s = 0; s < m; ++s)
          x += handed(constrained[r], constrained[s]) * i.c(constrained[s], c);
        force(constrained[r], c) = x;
      }
  }
  for (int k = 0; k < n; ++k)
    for (int c = 0; c < kColumns; ++c) force(free[k], c) = sigma * i.tau[k][c];
  return good;
}

// a becomes the far link's acceleration (joint frame) from the near link's; returns sigma qdd.
template <class Kind>
std::array<std::array<Real, kColumns>, kFree<Kind>> accelerate(const Articulated<Kind>& i,
                                                               Columns6& a) {
  a += i.c;
  auto moved = i.u;
  i.solve(moved);
  for (int k = 0; k < kFree<Kind>; ++k)
    for (int c = 0; c < kColumns; ++c) {
      const int row = Kind::Free::row[k];
      Real x = moved[k][c];
      for (int l : Kind::Constrained::row) x -= i.E[k][l] * a(l, c);
      moved[k][c] = x - a(row, c);
    }
  for (int k = 0; k < kFree<Kind>; ++k)
    for (int c = 0; c < kColumns; ++c) a(Kind::Free::row[k], c) += moved[k][c];
  return moved;
}

// K m with K = 1 - S D^-1 S^T I^A, what of a motion of the near side the far side shares.
template <class Kind>
ADAGEN_NOINLINE void share(const Articulated<Kind>& i, Mat6& m) {
  for (int k = 0; k < kFree<Kind>; ++k) m.row(Kind::Free::row[k]).setZero();
  for (int k = 0; k < kFree<Kind>; ++k)
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
  for (int k = 0; k < n; ++k) inverse[k][k] = 1;
  i.solve(inverse);
  for (int k = 0; k < n; ++k)
    for (int l = 0; l < n; ++l) m(Kind::Free::row[k], Kind::Free::row[l]) += inverse[k][l];
}

// A load on the far side (joint frame) moves the joint; what is left of it, K^T load, goes on.
template <class Kind>
void deliver(Articulated<Kind>& i, Columns6& load) {
  for (int k = 0; k < kFree<Kind>; ++k)
    for (int c = 0; c < kColumns; ++c) {
      Real& along = load(Kind::Free::row[k], c);
      i.u[k][c] += along;
      for (int l : Kind::Constrained::row) load(l, c) -= i.E[k][l] * along;
      along = 0;
    }
}

// Phi = (I^A)^-1 and b = -Phi p^A, by Cholesky's factorization.
ADAGEN_NOINLINE bool invert(const Mat6& I, const Columns6& p, Mat6& Phi, Columns6& b) {
  std::array<std::array<Real, 6>, 6> L, x{};
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k < 6; ++k) L[i][k] = I(i, k);
    x[i][i] = 1;
  }
  const bool good = factorize(L);
  forward_substitute(L, x);
  for (int i = 0; i < 6; ++i)
    for (int k = i; k < 6; ++k) {
      Real sum = 0;
      for (int row = 0; row < 6; ++row) sum += x[row][i] * x[row][k];
      Phi(i, k) = Phi(k, i) = sum;
    }
  b.noalias() = -Phi * p;
  return good;
}

// a with I^A a = -p^A: nothing else acts on the link.
ADAGEN_NOINLINE bool solve_root(const Mat6& I, const Columns6& p, Columns6& a) {
  std::array<std::array<Real, 6>, 6> L;
  std::array<std::array<Real, kColumns>, 6> x;
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k < 6; ++k) L[i][k] = I(i, k);
    for (int c = 0; c < kColumns; ++c) x[i][c] = -p(i, c);
  }
  const bool good = factorize(L);
  forward_substitute(L, x);
  backward_substitute(L, x);
  for (int i = 0; i < 6; ++i)
    for (int c = 0; c < kColumns; ++c) a(i, c) = x[i][c];
  return good;
}
