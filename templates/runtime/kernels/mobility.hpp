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

// The inverse of a symmetric matrix of six rows, and as symmetric: L^-T D^-1 L^-1, L^-1 by
// elimination of all six unit vectors at once. Where masses differ much, subtracting on the way
// back instead would cost digits. Whether each pivot exceeds what it must at least.
ADAGEN_INLINE bool invert(const Mat6& m, const Real (&least)[6], Mat6& inverse) {
  Lanes rows[6]{}, X[6]{};
  Real over[6];
  bool good = true;
  ADAGEN_FOR (i, 0, 6) {
    std::memcpy(&rows[i], m.data() + 6 * i, 6 * sizeof(Real));
    X[i][i] = 1;
  }
  ADAGEN_FOR (c, 0, 6) {
    const Real pivot = rows[c][c];
    good = good && pivot > least[c] && pivot <= std::numeric_limits<Real>::max();
    over[c] = 1 / pivot;
    ADAGEN_FOR (i, c + 1, 6) {
      const Real l = rows[i][c] * over[c];
      rows[i] -= rows[c] * l;
      X[i] -= X[c] * l;
    }
  }
  ADAGEN_FOR (i, 0, 6) {
    Lanes sum{};
    ADAGEN_FOR (k, i, 6) sum += X[k] * (X[k][i] * over[k]);
    std::memcpy(inverse.data() + 6 * i, &sum, 6 * sizeof(Real));
  }
  ADAGEN_FOR (i, 0, 6)
    ADAGEN_FOR (k, 0, i) inverse(k, i) = inverse(i, k);
  return good;
}

// Phi = (I^A)^-1 and b = -Phi p^A of a segment's root.
[[maybe_unused]] inline bool invert(const Body<Value>& X, Mat6& Phi, Columns6& b) {
  constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();
  const Mat6 I = inertia_of(X);
  Real least[6];
  ADAGEN_FOR (k, 0, 6) least[k] = kRounding * I(k, k);
  const bool good = invert(I, least, Phi);
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
      if constexpr (kSphericalRotors) a.angular += solved(e + 12, spin) * rotor_of(single(j));
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
        const Vector<Value> x = solved(memory.e + 12, unit);
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

// A link whose other side shows Phi and b: (1 + Phi I^A) a = b - Phi p^A.
template <int link>
void solve_mobility(Workspace& w, const Mat6& Phi, const Columns6& b) {
  Body<Value> X = w.bodies[link];
  to_base(w, link, X);
  const Mat6 M = Mat6::Identity() + Phi * inertia_of(X);
  w.motions[link] = motion_of(M.partialPivLu().solve(b - Phi * force_of(X)));
}

// The force that what was left at a link needs to move as the link does.
template <int link>
Columns6 force_on(Workspace& w) {
  Body<Value> X = w.bodies[link];
  to_base(w, link, X);
  return inertia_of(X) * columns_of(w.motions[link]) + force_of(X);
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

// The torques of a joint that reach the links, or its prescribed accelerations.
template <std::size_t n>
void load_torque(Workspace& w, int j, int, std::array<std::array<Real, kColumns>, n>& tau) {
  const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
  for (std::size_t k = 0; k < n; ++k) {
    const int entry = static_cast<int>(k);
    tau[k][0] = joint.passive.prescribed ? w.tau[joint.v + entry] : torque(w, joint, entry);
  }
}

template <std::size_t n>
void store_acceleration(Workspace& w, int, int v,
                        const std::array<std::array<Real, kColumns>, n>& qdd) {
  for (std::size_t k = 0; k < n; ++k) w.answer[static_cast<std::size_t>(v) + k] = qdd[k][0];
}
