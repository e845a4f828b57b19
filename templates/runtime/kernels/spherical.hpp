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

// The factors 1 / D and L of A = L D L^T: 0 1 2, 10 20 21.
template <class T>
ADAGEN_INLINE void factorize_rotations(Workspace& w, const Joints<T>& joints, const Symmetric<T>& A,
                                       T* factors) {
  const T d0 = 1 / A.xx, l10 = A.xy * d0, l20 = A.xz * d0;
  const T p1 = A.yy - l10 * A.xy, d1 = 1 / p1, t = A.yz - l20 * A.xy, l21 = t * d1;
  const T p2 = A.zz - l20 * A.xz - l21 * t, d2 = 1 / p2;
  for (const T& pivot : {A.xx, p1, p2})
    if (__builtin_expect(!all_positive(pivot), 0)) fail_one(w, joints, pivot);
  factors[0] = d0, factors[1] = d1, factors[2] = d2;
  factors[3] = l10, factors[4] = l20, factors[5] = l21;
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

// Takes the three rotations out of the body: what is left of it is C and f, so that no rounding
// stays behind. e gets K = A^-1 B, y = A^-1 (tau - n) and the factors of A. With a rotor J, which
// is the same about all axes, A + J is in the place of A there, and J K, J (A + J)^-1 A and tau - J
// y are left, too.
template <bool reversed, class T>
ADAGEN_INLINE void eliminate_rotations(Workspace& w, const Joints<T>& joints, Body<T>& X,
                                       const Vector<T>& r, const Vector<T>& tau, T* e) {
  if constexpr (reversed) shift(X, -r);
  Vector<T> torque = matrix_at<T>(w.at(joints.slot, kAxes)) * tau;
  if constexpr (reversed) torque = -torque;
  T* const factors = e + 12;
  const T rotor = rotor_of(joints);
  factorize_rotations(w, joints, kSphericalRotors ? with_rotor(X.A, rotor) : X.A, factors);
  const auto solve = [&](const Vector<T>& b) { return solve_rotations(factors, b); };
  const Matrix<T>& B = X.B;
  const Vector<T> Bx{B.x.x, B.y.x, B.z.x}, By{B.x.y, B.y.y, B.z.y}, Bz{B.x.z, B.y.z, B.z.z};
  const Vector<T> Kx = solve(Bx), Ky = solve(By), Kz = solve(Bz), y = solve(torque - X.n);
  e[0] = Kx.x, e[1] = Ky.x, e[2] = Kz.x, e[3] = Kx.y, e[4] = Ky.y, e[5] = Kz.y;
  e[6] = Kx.z, e[7] = Ky.z, e[8] = Kz.z, e[9] = y.x, e[10] = y.y, e[11] = y.z;
  X.C.xx -= dot(Bx, Kx), X.C.xy -= dot(Bx, Ky), X.C.xz -= dot(Bx, Kz);
  X.C.yy -= dot(By, Ky), X.C.yz -= dot(By, Kz), X.C.zz -= dot(Bz, Kz);
  X.f += transposed_times(B, y);
  X.n = torque;
  if constexpr (kSphericalRotors) {
    const Symmetric<T>& A = X.A;
    const Vector<T> x = solve(Vector<T>{A.xx, A.xy, A.xz}), z = solve(Vector<T>{A.xz, A.yz, A.zz});
    const T yy = solve(Vector<T>{A.xy, A.yy, A.yz}).y;
    X.A = {x.x * rotor, x.y * rotor, x.z * rotor, yy * rotor, z.y * rotor, z.z * rotor};
    X.B = {Vector<T>{Kx.x, Ky.x, Kz.x} * rotor, Vector<T>{Kx.y, Ky.y, Kz.y} * rotor,
           Vector<T>{Kx.z, Ky.z, Kz.z} * rotor};
    X.n += -(y * rotor);
    if constexpr (!reversed) shift(X, r);
  } else if constexpr (reversed) {
    X.A = Symmetric<T>{}, X.B = Matrix<T>{};
  } else {
    shift_mass(X, r);
  }
}
