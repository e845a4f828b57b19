// Mobility: what a segment shows at its handles, and what forces there do inside it. Phi and b are
// in the axes of the base about the handles' origins; b are accelerations beyond those of a Frame.
using Vec3 = Eigen::Matrix<Real, 3, 1>;

ADAGEN_INLINE Motion<Value> motion_of(const Columns6& a) {
  return {{a[0], a[1], a[2]}, {a[3], a[4], a[5]}};
}
ADAGEN_INLINE Columns6 columns_of(const Motion<Value>& a) {
  Columns6 result;
  result << a.angular.x, a.angular.y, a.angular.z, a.linear.x, a.linear.y, a.linear.z;
  return result;
}

inline Mat6 inertia_of(const Body<Value>& X) {
  Mat6 I;
  I << X.A.xx, X.A.xy, X.A.xz, X.B.x.x, X.B.x.y, X.B.x.z,  //
      X.A.xy, X.A.yy, X.A.yz, X.B.y.x, X.B.y.y, X.B.y.z,   //
      X.A.xz, X.A.yz, X.A.zz, X.B.z.x, X.B.z.y, X.B.z.z,   //
      X.B.x.x, X.B.y.x, X.B.z.x, X.C.xx, X.C.xy, X.C.xz,   //
      X.B.x.y, X.B.y.y, X.B.z.y, X.C.xy, X.C.yy, X.C.yz,   //
      X.B.x.z, X.B.y.z, X.B.z.z, X.C.xz, X.C.yz, X.C.zz;
  return I;
}
inline Columns6 force_of(const Body<Value>& X) { return columns_of({X.n, X.f}); }

// Phi = (I^A)^-1 and b = -Phi p^A of a segment's root, by Cholesky's factorization.
[[maybe_unused]] inline bool invert(const Body<Value>& X, Mat6& Phi, Columns6& b) {
  const Mat6 I = inertia_of(X);
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
  b.noalias() = -Phi * force_of(X);
  return good;
}

template <int p, int link>
void invert_root(Workspace& w, Mat6& Phi, Columns6& b) {
  if (!invert(whole<p>(w, link), Phi, b)) fail(w, kFactorization, link - 1);
}

// Motions of a link, side by side: what the far link does, with what drives the joint beyond L a
// (of a joint with one freedom x).
template <bool reversed>
ADAGEN_INLINE void pass(Workspace& w, int j, Motion<Lanes>& a,
                        const Vector<Lanes>& drive = Vector<Lanes>{}) {
  const JointKind kind = kJoints[static_cast<std::size_t>(j)].kind;
  const Memory& memory = w.joints[static_cast<std::size_t>(j)];
  const Value* const e = memory.e;
  const Vector<Value> axis = axis_at(w.of(j, kAxes));
  if (kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) {
      if constexpr (!reversed) carry(a, memory.r);
      const Vector<Lanes> v = a.linear, spin = a.angular;
      a.angular = {drive.x - (e[0] * v.x + e[1] * v.y + e[2] * v.z),
                   drive.y - (e[3] * v.x + e[4] * v.y + e[5] * v.z),
                   drive.z - (e[6] * v.x + e[7] * v.y + e[8] * v.z)};
      if constexpr (kSphericalRotors)
        a.angular += solve_rotations(e + 12, spin) * rotor_of(single(j));
      if constexpr (reversed) carry(a, -memory.r);
    }
    return;
  }
  const Lanes x = drive.x - ((e[0] * a.angular.x + e[1] * a.angular.y) +
                             (e[2] * a.angular.z + e[3] * a.linear.x) +
                             (e[4] * a.linear.y + e[5] * a.linear.z));
  const Vector<Lanes> moved{axis.x * x, axis.y * x, axis.z * x};
  if constexpr (!reversed) carry(a, memory.r);
  if (kind == JointKind::kPrismatic)
    a.linear += moved;
  else
    a.angular += moved;
  if constexpr (reversed) carry(a, -memory.r);
}

ADAGEN_INLINE Motion<Lanes> rows_of(const Mat6& transposed) {
  const auto row = [&transposed](int k) {
    Lanes result{};
    std::memcpy(&result, transposed.data() + 6 * k, 6 * sizeof(Real));
    return result;
  };
  return {{row(0), row(1), row(2)}, {row(3), row(4), row(5)}};
}
ADAGEN_INLINE Mat6 from_rows(const Motion<Lanes>& a) {  // transposed
  Mat6 result;
  const Lanes* rows[6] = {&a.angular.x, &a.angular.y, &a.angular.z,
                          &a.linear.x,  &a.linear.y,  &a.linear.z};
  for (int k = 0; k < 6; ++k) std::memcpy(result.data() + 6 * k, rows[k], 6 * sizeof(Real));
  return result;
}

// L m, m being told with the near link in its rows.
template <bool reversed>
Mat6 passed(Workspace& w, int j, const Mat6& m) {
  Motion<Lanes> rows = rows_of(m.transpose());
  pass<reversed>(w, j, rows);
  return from_rows(rows).transpose();
}

// S D^-1 S^T at the far link's origin.
template <bool reversed>
Mat6 own_mobility(Workspace& w, int j) {
  const JointKind kind = kJoints[static_cast<std::size_t>(j)].kind;
  const Memory& memory = w.joints[static_cast<std::size_t>(j)];
  Mat6 result = Mat6::Zero();
  if (kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) {
      for (int k = 0; k < 3; ++k) {
        const Vector<Value> unit{Value(k == 0), Value(k == 1), Value(k == 2)};
        const Vector<Value> x = solve_rotations(memory.e + 12, unit);
        result(0, k) = x.x, result(1, k) = x.y, result(2, k) = x.z;
      }
    }
    if constexpr (reversed) {
      Mat6 shifted = Mat6::Identity();
      const Vector<Value> r = -memory.r;  // linear += angular x r
      shifted(3, 1) = r.z, shifted(3, 2) = -r.y, shifted(4, 0) = -r.z;
      shifted(4, 2) = r.x, shifted(5, 0) = r.y, shifted(5, 1) = -r.x;
      result = shifted * result * shifted.transpose();
    }
    return result;
  }
  Motion<Value> S{};
  (kind == JointKind::kPrismatic ? S.linear : S.angular) = axis_at(w.of(j, kAxes));
  if constexpr (reversed) carry(S, -memory.r);
  const Columns6 s = columns_of(S);
  return s * memory.e[7] * s.transpose();
}

// Omega and b outwards across a joint: L Omega L^T + S D^-1 S^T. Nothing is subtracted.
template <bool reversed>
void propagate(Workspace& w, int j, const Mat6& near, const Columns6& near_bias, Mat6& far,
               Columns6& far_bias) {
  const Mat6 half = passed<reversed>(w, j, near);
  far = passed<reversed>(w, j, half.transpose()) + own_mobility<reversed>(w, j);
  Motion<Value> a = motion_of(near_bias);
  move<reversed>(w, single(j), kJoints[static_cast<std::size_t>(j)].kind, a);
  far_bias = columns_of(a);
}

// A wrench on the far link becomes what the near link feels of it, L^T times it; what it drives the
// joint with, D^-1 S^T times it, is returned.
template <bool reversed, class T>
ADAGEN_INLINE Vector<T> hand_on(Workspace& w, int j, Vector<T>& n, Vector<T>& f) {
  const JointKind kind = kJoints[static_cast<std::size_t>(j)].kind;
  const Memory& memory = w.joints[static_cast<std::size_t>(j)];
  const Value* const e = memory.e;
  const Vector<Value>& r = memory.r;
  if constexpr (reversed) n += cross(f, r);
  Vector<T> driven{};
  if (kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) {
      driven = solve_rotations(e + 12, n);
      f.x -= e[0] * n.x + e[3] * n.y + e[6] * n.z;
      f.y -= e[1] * n.x + e[4] * n.y + e[7] * n.z;
      f.z -= e[2] * n.x + e[5] * n.y + e[8] * n.z;
      n = kSphericalRotors ? driven * rotor_of(single(j)) : Vector<T>{};
      if constexpr (!reversed) n += -cross(f, r);
    }
    return driven;
  }
  const T x = dot(kind == JointKind::kPrismatic ? f : n, axis_at(w.of(j, kAxes)));
  driven.x = x * e[7];
  if constexpr (!reversed) n += -cross(f, r);
  n.x -= e[0] * x, n.y -= e[1] * x, n.z -= e[2] * x;
  f.x -= e[3] * x, f.y -= e[4] * x, f.z -= e[5] * x;
  return driven;
}

// What a link is loaded with is added to what is handed on to it.
ADAGEN_INLINE void take_load(const Workspace& w, int link, Vector<Value>& n, Vector<Value>& f) {
  const Columns6& load = w.loads[static_cast<std::size_t>(link)];
  n += Vector<Value>{load[0], load[1], load[2]};
  f += Vector<Value>{load[3], load[4], load[5]};
}

// A wrench on the far link: the joint is told, and what the near link feels is left.
template <bool reversed>
ADAGEN_INLINE void deliver(Workspace& w, int j, Vector<Value>& n, Vector<Value>& f) {
  Value* const e = w.joints[static_cast<std::size_t>(j)].e;
  const Vector<Value> driven = hand_on<reversed>(w, j, n, f);
  if (kJoints[static_cast<std::size_t>(j)].kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) e[9] += driven.x, e[10] += driven.y, e[11] += driven.z;
  } else {
    e[6] += driven.x;
  }
}

// The loads of links beyond joints first .. last, each on the link of the one before, from the last
// link to the one that the first joint is on.
template <int first, int last>
void deliver(Workspace& w) {
  Vector<Value> n{}, f{};
  for (int j = last; j >= first; --j) {
    take_load(w, j + 1, n, f);
    deliver<false>(w, j, n, f);
  }
  w.loads[kJoints[first].parent] += columns_of({n, f});
}
// The same where the ground's side lies beyond: from the first joint's link to the last one's.
template <int first, int last>
void deliver_reversed(Workspace& w) {
  Vector<Value> n{}, f{};
  for (int j = first; j <= last; ++j) {
    take_load(w, kJoints[static_cast<std::size_t>(j)].parent, n, f);
    deliver<true>(w, j, n, f);
  }
  w.loads[last + 1] += columns_of({n, f});
}

// Phi and b of the last of joints first .. last, which hang on the ground: what six wrenches on its
// link make it do, one in each lane, and in a further lane what it does under none.
template <int first, int last>
void respond(Workspace& w, Mat6& Phi, Columns6& b) {
  static_assert(sizeof(Value) == sizeof(Real));
  Vector<Lanes> drives[last - first + 1], n{}, f{};
  n.x[0] = n.y[1] = n.z[2] = f.x[3] = f.y[4] = f.z[5] = 1;
  for (int j = last; j >= first; --j) {
    Vector<Lanes>& own = drives[j - first] = hand_on<false>(w, j, n, f);
    const Value* const e = w.joints[static_cast<std::size_t>(j)].e;
    if (kJoints[static_cast<std::size_t>(j)].kind != JointKind::kSpherical) {
      own.x[6] = e[6];
    } else if constexpr (kAnySpherical) {
      own.x[6] = e[9], own.y[6] = e[10], own.z[6] = e[11];
    }
  }
  Motion<Lanes> a{};
  for (int j = first; j <= last; ++j) pass<false>(w, j, a, drives[j - first]);
  const Vector<Lanes> halves[2] = {a.angular, a.linear};
  ADAGEN_FOR (half, 0, 2) {
    const Lanes* const rows[3] = {&halves[half].x, &halves[half].y, &halves[half].z};
    ADAGEN_FOR (i, 0, 3) {
      ADAGEN_FOR (k, 0, 6) Phi(3 * half + i, k) = (*rows[i])[k];
      b[3 * half + i] = (*rows[i])[6];
    }
  }
}

// A link whose other side shows Phi and b: (1 + Phi I^A) a = b - Phi p^A.
template <int link>
void solve_mobility(Workspace& w, const Mat6& Phi, const Columns6& b) {
  const Body<Value>& X = w.bodies[link];
  const Mat6 M = Mat6::Identity() + Phi * inertia_of(X);
  w.motions[link] = motion_of(M.partialPivLu().solve(b - Phi * force_of(X)));
}

// The force that what was left at a link needs to move as the link does.
template <int link>
Columns6 force_on(Workspace& w) {
  const Body<Value>& X = w.bodies[link];
  return inertia_of(X) * columns_of(w.motions[link]) + force_of(X);
}

// What holds a link taken for a body: Phi^-1 and -Phi^-1 b. Pivots tell whether Phi is too near to
// a singular matrix for that, angular and linear ones beside the largest of their kind.
template <int link>
void hold(Workspace& w, const Mat6& Phi, const Columns6& b) {
  constexpr Real kLeastPivot = sizeof(Real) == 8 ? Real(1e-5) : Real(1e-2);
  std::array<std::array<Real, 6>, 6> L, x{};
  ADAGEN_FOR (i, 0, 6) {
    ADAGEN_FOR (k, 0, 6) L[i][k] = Phi(i, k);
    x[i][i] = 1;
  }
  bool good = factorize(L);  // leaves inverse roots of the pivots on the diagonal
  const Real most[2] = {Phi.diagonal().template head<3>().maxCoeff(),
                        Phi.diagonal().template tail<3>().maxCoeff()};
  ADAGEN_FOR (i, 0, 6) good = good && L[i][i] * L[i][i] * kLeastPivot * most[i / 3] < 1;
  if (!good) return fail(w, kSingularPose, link - 1);
  forward_substitute(L, x);
  const auto entry = [&x](int i, int k) {
    Real sum = 0;
    ADAGEN_FOR (row, 0, 6) sum += x[row][i] * x[row][k];
    return sum;
  };
  Body<Value>& X = w.bodies[link];
  X.A = {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
  X.B = {{entry(0, 3), entry(0, 4), entry(0, 5)},
         {entry(1, 3), entry(1, 4), entry(1, 5)},
         {entry(2, 3), entry(2, 4), entry(2, 5)}};
  X.C = {entry(3, 3), entry(3, 4), entry(3, 5), entry(4, 4), entry(4, 5), entry(5, 5)};
  const Columns6 p = -(inertia_of(X) * b);
  X.n = {p[0], p[1], p[2]}, X.f = {p[3], p[4], p[5]};
}

// --- joins: adapters to the joints' own frames ---------------------------------------------------

// From the axes of the base about the parent's (X) and the child link's origin (Y) to the joint's.
[[maybe_unused]] inline void set_transforms(Workspace& w, int j, Transform& X, Transform& Y) {
  const Matrix<Value> R = matrix_at(w.of(j, kAxes));
  X.E << R.x.x, R.y.x, R.z.x, R.x.y, R.y.y, R.z.y, R.x.z, R.y.z, R.z.z;
  Y.E = X.E;
  const Vector<Value>& r = w.joints[static_cast<std::size_t>(j)].r;
  X.r << r.x, r.y, r.z;
  Y.r.setZero();
}

template <std::size_t n>
void load_torque(Workspace& w, int, int v, std::array<std::array<Real, kColumns>, n>& tau) {
  for (std::size_t k = 0; k < n; ++k) tau[k][0] = w.tau[v + static_cast<int>(k)];
}

template <std::size_t n>
void store_acceleration(Workspace& w, int, int v,
                        const std::array<std::array<Real, kColumns>, n>& qdd) {
  for (std::size_t k = 0; k < n; ++k) w.answer[static_cast<std::size_t>(v) + k] = qdd[k][0];
}
