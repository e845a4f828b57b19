// Spherical joints: three rotations at once. Damping and a rotor are the same about all axes.
[[maybe_unused]] constexpr bool any_spherical_rotor() {
  for (const JointConstants& joint : kJoints)
    if (joint.kind == JointKind::kSpherical && joint.passive.rotor != 0) return true;
  return false;
}
[[maybe_unused]] constexpr bool kSphericalRotors = any_spherical_rotor();

// The torque that reaches the links, in the child link's axes: less damping.
template <class T>
ADAGEN_INLINE Vector<T> spherical_torque(const Workspace& w, const Joints<T>& joints) {
  const Vector<T> tau = each_vector(joints, w.tau, &JointConstants::v);
  if constexpr (!kAnyPassive) return tau;
  const T damping = each(joints, [](const JointConstants& own) { return own.passive.damping; });
  return tau - each_vector(joints, w.v, &JointConstants::v) * damping;
}

template <class T>
ADAGEN_INLINE T rotor_of(const Joints<T>& joints) {
  return each(joints, [](const JointConstants& own) { return own.passive.rotor; });
}

// The factors 1 / D and L of A = L D L^T: 0 1 2, 10 20 21. Without fractions (Bareiss) the three
// divisions need not wait for each other: with m = xx yy - xy^2 and so on the pivots are xx, m / xx
// and (m m' - t^2) / (xx m), as exact as by turns. Float's range is too short for fourth powers.
template <class T>
ADAGEN_INLINE void factorize_rotations(Workspace& w, const Joints<T>& joints, const Symmetric<T>& A,
                                       T* factors) {
  T* const l = factors + 3;
  const T d0 = 1 / A.xx;
  l[0] = A.xy * d0, l[1] = A.xz * d0;
  T p1, p2;
  if constexpr (std::numeric_limits<Real>::min_exponent10 < -300) {
    const T m = A.xx * A.yy - A.xy * A.xy, t = A.xx * A.yz - A.xy * A.xz;
    p1 = m, p2 = m * (A.xx * A.zz - A.xz * A.xz) - t * t;
    const T inverse = 1 / m;
    factors[1] = A.xx * inverse, factors[2] = A.xx * m / p2;
    l[2] = t * inverse;
  } else {
    const T t = A.yz - l[1] * A.xy;
    p1 = A.yy - l[0] * A.xy;
    factors[1] = 1 / p1, l[2] = t * factors[1];
    p2 = A.zz - l[1] * A.xz - l[2] * t;
    factors[2] = 1 / p2;
  }
  factors[0] = d0;
  for (const T& pivot : {A.xx, p1, p2})
    if (__builtin_expect(!all_positive(pivot), 0)) fail_one(w, joints, pivot);
}

// A x = b, by these factors.
template <class F, class T>
ADAGEN_INLINE Vector<T> solve_rotations(const F* factors, const Vector<T>& b) {
  const F *d = factors, *l = factors + 3;  // l: 10, 20, 21
  const T y1 = b.y - l[0] * b.x, y2 = b.z - l[1] * b.x - l[2] * y1;
  const T z = y2 * d[2], y = y1 * d[1] - l[2] * z;
  return {b.x * d[0] - l[0] * y - l[1] * z, y, z};
}

template <class T>
ADAGEN_INLINE Symmetric<T> with_rotor(Symmetric<T> A, const T& rotor) {
  A.xx += rotor, A.yy += rotor, A.zz += rotor;
  return A;
}

// Takes the three rotations out of the body at the joint's origin: what is left of it is C and f,
// and the torque, so that no rounding stays behind. e gets K = A^-1 B, y = A^-1 (torque - n) and
// the factors of A. With a rotor J, which is the same about all axes, A + J is in the place of A
// there, and J K, J (A + J)^-1 A and torque - J y are left, too.
template <bool reversed, class T>
ADAGEN_INLINE void take_out_rotations(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  T* const e = w.memory(joints).e;
  Vector<T> torque = matrix_at<T>(w.at(joints.slot, kAxes)) * spherical_torque(w, joints);
  if constexpr (reversed) torque = -torque;
  T* const factors = e + 12;
  const T rotor = rotor_of(joints);
  factorize_rotations(w, joints, kSphericalRotors ? with_rotor(X.A, rotor) : X.A, factors);
  const T *d = factors, *l = factors + 3;
  const Matrix<T>& B = X.B;
  // With L Y = B, B^T A^-1 B is Y^T D^-1 Y: it waits for no more than the last division.
  const Vector<T> Yx = B.x, Yy = B.y - B.x * l[0], Yz = (B.z - B.x * l[1]) - Yy * l[2];
  const Vector<T> Zx = Yx * d[0], Zy = Yy * d[1], Zz = Yz * d[2];
  using V = Vector<T>;
  const auto subtract = [&](T& c, T V::* i, T V::* k) ADAGEN_ALWAYS {
    c = ((c - Yx.*i * Zx.*k) - Yy.*i * Zy.*k) - Yz.*i * Zz.*k;
  };
  subtract(X.C.xx, &V::x, &V::x), subtract(X.C.xy, &V::x, &V::y), subtract(X.C.xz, &V::x, &V::z);
  subtract(X.C.yy, &V::y, &V::y), subtract(X.C.yz, &V::y, &V::z), subtract(X.C.zz, &V::z, &V::z);
  const Vector<T> Kz = Zz, Ky = Zy - Kz * l[2], Kx = (Zx - Kz * l[1]) - Ky * l[0];
  const Vector<T> y = solve_rotations(factors, torque - X.n);
  e[0] = Kx.x, e[1] = Kx.y, e[2] = Kx.z, e[3] = Ky.x, e[4] = Ky.y, e[5] = Ky.z;
  e[6] = Kz.x, e[7] = Kz.y, e[8] = Kz.z, e[9] = y.x, e[10] = y.y, e[11] = y.z;
  X.f += transposed_times(B, y);
  X.n = torque;
  if constexpr (kSphericalRotors) {
    const Symmetric<T>& A = X.A;
    const auto solve = [&](const Vector<T>& b) { return solve_rotations(factors, b); };
    const Vector<T> x = solve(Vector<T>{A.xx, A.xy, A.xz}), z = solve(Vector<T>{A.xz, A.yz, A.zz});
    const T yy = solve(Vector<T>{A.xy, A.yy, A.yz}).y;
    X.A = {x.x * rotor, x.y * rotor, x.z * rotor, yy * rotor, z.y * rotor, z.z * rotor};
    X.B = {Kx * rotor, Ky * rotor, Kz * rotor};
    X.n += -(y * rotor);
  } else {
    X.A = Symmetric<T>{}, X.B = Matrix<T>{};
  }
}

// The same, from the far link's side to the near link's origin.
template <bool reversed, class T>
ADAGEN_INLINE void eliminate_rotations(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  const Vector<T>& r = w.memory(joints).r;
  if constexpr (reversed) shift(X, -r);
  take_out_rotations<reversed>(w, joints, X);
  if constexpr (!reversed && kSphericalRotors) shift(X, r);
  if constexpr (!reversed && !kSphericalRotors) shift_mass(X, r);
}

// Whether joints first .. last leave of a body no more than its mass.
constexpr bool leave_mass_alone(int first, int last) {
  for (int j = first; j <= last; ++j)
    if (kJoints[j].kind != JointKind::kSpherical) return false;
  return !kSphericalRotors;
}
