// Inwards: articulated bodies. A joint is treated at its own origin, the child link's, and the body
// is handed on about the near link's origin. Seen from the sweep's root, the child link may be the
// near one (the joint is reversed): then sigma = -1, and -qdd takes the place of qdd.

ADAGEN_INLINE void add_bare_link(Workspace& w, int link, Body<Value>& X) {
  const int j = link - 1;
  const Value *A = w.of(j, kRotational), *c = w.of(j, kMoments);
  const Real mass = kInertias[static_cast<std::size_t>(j)].mass;
  constexpr int n = kPerBlock;
  X.A += Symmetric<Value>{A[0], A[n], A[2 * n], A[3 * n], A[4 * n], A[5 * n]};
  X.B.x.y -= c[2 * n], X.B.x.z += c[n], X.B.y.x += c[2 * n];
  X.B.y.z -= c[0], X.B.z.x -= c[n], X.B.z.y += c[0];
  X.C.xx += mass, X.C.yy += mass, X.C.zz += mass;
  X.n += vector_at(w.of(j, kTorque));
  X.f += vector_at(w.of(j, kForce));
}

constexpr Real kLeast = 8 * std::numeric_limits<Real>::epsilon();

// Takes one freedom out of the body, which is shifted by r before the subtraction, so that the
// division has time. e gets U / D, u / D and 1 / D, told at the near link's origin: outwards the
// joint has the acceleration u / D - (U / D) a, a being the near link's.
template <bool along, bool reversed>
ADAGEN_INLINE void eliminate(Workspace& w, int j, Body<Value>& X, const Vector<Value>& s,
                             const Vector<Value>& r, const Value& tau, Value* e) {
  if constexpr (reversed) shift(X, -r);
  Vector<Value> n = along ? X.B * s : X.A * s;
  const Vector<Value> f = along ? X.C * s : transposed_times(X.B, s);
  Value D = dot(s, along ? f : n);
  if constexpr (kAnyPassive) D += kJoints[static_cast<std::size_t>(j)].passive.rotor;
  const Value inverse = 1 / D;
  const Value u = ((reversed ? -tau : tau) - dot(s, along ? X.f : X.n)) * inverse;
  const Symmetric<Value>& whole = along ? X.C : X.A;  // D beside it tells what digits are left
  if (__builtin_expect(!all_positive(D - kLeast * (whole.xx + whole.yy + whole.zz)), 0))
    fail(w, kFactorization, j);
  if constexpr (!reversed) {
    shift(X, r);
    n += cross(r, f);
  }
  const Vector<Value> e_n = n * inverse, e_f = f * inverse;
  e[0] = e_n.x, e[1] = e_n.y, e[2] = e_n.z, e[3] = e_f.x, e[4] = e_f.y, e[5] = e_f.z, e[6] = u;
  e[7] = inverse;
  subtract(X, n, f, e_n, e_f);
  X.n += n * u;
  X.f += f * u;
}

// A x = b, by the factors 1 / D and L of A = L D L^T.
ADAGEN_INLINE Vector<Value> solve_rotations(const Value* factors, const Vector<Value>& b) {
  const Value *d = factors, *l = factors + 3;  // l: 10, 20, 21
  const Value y1 = b.y - l[0] * b.x, y2 = b.z - l[1] * b.x - l[2] * y1;
  const Value z = y2 * d[2], y = y1 * d[1] - l[2] * z;
  return {b.x * d[0] - l[0] * y - l[1] * z, y, z};
}

// Takes the three rotations out of the body: what is left of it is C and f, so that no rounding
// stays behind. e gets K = A^-1 B, y = A^-1 (tau - n) and the factors of A.
template <bool reversed>
ADAGEN_INLINE void eliminate_rotations(Workspace& w, int j, Body<Value>& X, const Vector<Value>& r,
                                       const Value* tau, Value* e) {
  if constexpr (reversed) shift(X, -r);
  const Matrix<Value> R = matrix_at(w.of(j, kAxes));
  Vector<Value> torque = R * Vector<Value>{tau[0], tau[1], tau[2]};
  if constexpr (reversed) torque = -torque;
  const Value d0 = 1 / X.A.xx, l10 = X.A.xy * d0, l20 = X.A.xz * d0;
  const Value p1 = X.A.yy - l10 * X.A.xy, d1 = 1 / p1, t = X.A.yz - l20 * X.A.xy, l21 = t * d1;
  const Value p2 = X.A.zz - l20 * X.A.xz - l21 * t, d2 = 1 / p2;
  if (__builtin_expect(!(all_positive(X.A.xx) && all_positive(p1) && all_positive(p2)), 0))
    fail(w, kFactorization, j);
  Value* const factors = e + 12;
  factors[0] = d0, factors[1] = d1, factors[2] = d2;
  factors[3] = l10, factors[4] = l20, factors[5] = l21;
  const auto solve = [&](const Vector<Value>& b) { return solve_rotations(factors, b); };
  const Matrix<Value>& B = X.B;
  const Vector<Value> Bx{B.x.x, B.y.x, B.z.x}, By{B.x.y, B.y.y, B.z.y}, Bz{B.x.z, B.y.z, B.z.z};
  const Vector<Value> Kx = solve(Bx), Ky = solve(By), Kz = solve(Bz), y = solve(torque - X.n);
  e[0] = Kx.x, e[1] = Ky.x, e[2] = Kz.x, e[3] = Kx.y, e[4] = Ky.y, e[5] = Kz.y;
  e[6] = Kx.z, e[7] = Ky.z, e[8] = Kz.z, e[9] = y.x, e[10] = y.y, e[11] = y.z;
  X.C.xx -= dot(Bx, Kx), X.C.xy -= dot(Bx, Ky), X.C.xz -= dot(Bx, Kz);
  X.C.yy -= dot(By, Ky), X.C.yz -= dot(By, Kz), X.C.zz -= dot(Bz, Kz);
  X.f += transposed_times(B, y);
  X.A = Symmetric<Value>{}, X.B = Matrix<Value>{};
  X.n = torque;
  if constexpr (!reversed) shift(X, r);
}

// Acceleration of a body that nothing holds: (A, B; B^T, C) a = -(n; f), by L D L^T. Whether that
// could be done.
ADAGEN_INLINE bool solve_free(const Body<Value>& X, Motion<Value>& a) {
  Value L[6][6] = {{X.A.xx},
                   {X.A.xy, X.A.yy},
                   {X.A.xz, X.A.yz, X.A.zz},
                   {X.B.x.x, X.B.y.x, X.B.z.x, X.C.xx},
                   {X.B.x.y, X.B.y.y, X.B.z.y, X.C.xy, X.C.yy},
                   {X.B.x.z, X.B.y.z, X.B.z.z, X.C.xz, X.C.yz, X.C.zz}};
  Value x[6] = {-X.n.x, -X.n.y, -X.n.z, -X.f.x, -X.f.y, -X.f.z}, inverse[6];
  bool fine = true;
  ADAGEN_FOR (c, 0, 6) {
    fine &= all_positive(L[c][c]);
    inverse[c] = 1 / L[c][c];
    ADAGEN_FOR (i, c + 1, 6) {
      const Value l = L[i][c] * inverse[c];
      ADAGEN_FOR (k, c + 1, i + 1) L[i][k] -= l * L[k][c];
      x[i] -= l * x[c];
    }
  }
  ADAGEN_FOR (c, 0, 6) {
    const int i = 5 - c;
    x[i] *= inverse[i];
    ADAGEN_FOR (k, i + 1, 6) x[i] -= L[k][i] * inverse[i] * x[k];
  }
  a = {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
  return fine;
}

// A joint with all freedoms hands on its force alone; e gets the acceleration of the body beyond.
template <bool reversed>
ADAGEN_INLINE void set_free(Workspace& w, int j, Body<Value>& X, const Vector<Value>& r,
                            const Value* tau, Value* e) {
  if constexpr (reversed) shift(X, -r);
  const Matrix<Value> R = matrix_at(w.of(j, kAxes));
  Vector<Value> n = R * Vector<Value>{tau[3], tau[4], tau[5]};
  Vector<Value> f = R * Vector<Value>{tau[0], tau[1], tau[2]};
  if constexpr (reversed) n = -n, f = -f;
  X.n += -n, X.f += -f;
  Motion<Value> a;
  if (!solve_free(X, a)) fail(w, kFactorization, j);
  e[0] = a.angular.x, e[1] = a.angular.y, e[2] = a.angular.z;
  e[3] = a.linear.x, e[4] = a.linear.y, e[5] = a.linear.z;
  X = Body<Value>{};
  X.n = n, X.f = f;
  if constexpr (!reversed) shift(X, r);
}

template <bool reversed>
ADAGEN_INLINE void step_inward(Workspace& w, int j, Body<Value>& X) {
  const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
  Memory& memory = w.joints[static_cast<std::size_t>(j)];
  const Value* tau = w.tau + joint.v;
  const Value* R = w.of(j, kAxes);
  const Vector<Value> none{};
  switch (joint.kind) {
    case JointKind::kRevolute:
      eliminate<false, reversed>(w, j, X, axis_at(R), memory.r, torque(w, joint), memory.e);
      break;
    case JointKind::kPrismatic:
      eliminate<true, reversed>(w, j, X, axis_at(R), memory.r, torque(w, joint), memory.e);
      break;
    case JointKind::kSpherical:
      if constexpr (kAnySpherical) eliminate_rotations<reversed>(w, j, X, memory.r, tau, memory.e);
      break;
    case JointKind::kPlanar:
      if constexpr (kAnyPlanar) {
        const Vector<Value> x{R[0], R[3 * kPerBlock], R[6 * kPerBlock]};
        const Vector<Value> y{R[kPerBlock], R[4 * kPerBlock], R[7 * kPerBlock]};
        if constexpr (reversed) shift(X, -memory.r);
        eliminate<true, false>(w, j, X, x, none, reversed ? -tau[0] : tau[0], memory.e);
        eliminate<true, false>(w, j, X, y, none, reversed ? -tau[1] : tau[1], memory.e + 8);
        eliminate<false, false>(w, j, X, axis_at(R), none, reversed ? -tau[2] : tau[2],
                                memory.e + 16);
        if constexpr (!reversed) shift(X, memory.r);
      }
      break;
    case JointKind::kFloating:
      if constexpr (kAnyFloating) set_free<reversed>(w, j, X, memory.r, tau, memory.e);
      break;
  }
}

// Adds to a body what the sweep finds at a link.
template <int p>
ADAGEN_INLINE void meet(Workspace& w, int link, Body<Value>& X) {
  const LinkRole role = kRoles[p][static_cast<std::size_t>(link)];
  if (role.gathers) X += w.bodies[static_cast<std::size_t>(link)];
  if (role.adds_own) add_bare_link(w, link, X);
}

template <bool starts>
ADAGEN_INLINE void leave(Workspace& w, int link, const Body<Value>& X) {
  Body<Value>& body = w.bodies[static_cast<std::size_t>(link)];
  if constexpr (starts)
    body = X;
  else
    body += X;
}

// Process p takes joints last .. first inwards, each on the link of the one before.
template <int p, int first, int last, bool starts>
void inward(Workspace& w) {
  Body<Value> X{};
  for (int j = last; j >= first; --j) {
    meet<p>(w, j + 1, X);
    step_inward<false>(w, j, X);
  }
  constexpr int near = kJoints[first].parent;
  if constexpr (near > 0) leave<starts>(w, near, X);
}

// The same for a root beyond joint last: from the parent link of joint first to the child of last.
template <int p, int first, int last, bool starts>
void inward_reversed(Workspace& w) {
  Body<Value> X{};
  for (int j = first; j <= last; ++j) {
    meet<p>(w, kJoints[static_cast<std::size_t>(j)].parent, X);
    step_inward<true>(w, j, X);
  }
  leave<starts>(w, last + 1, X);
}

// Adds a link itself to what was found at it.
template <int link, bool starts>
void place(Workspace& w) {
  Body<Value> X{};
  add_bare_link(w, link, X);
  leave<starts>(w, link, X);
}

// A floating joint on the ground only adds its torque to the link.
template <int j, bool starts>
void free_base(Workspace& w) {
  const Value* tau = w.tau + kJoints[j].v;
  Body<Value> X{};
  X.n = {-tau[3], -tau[4], -tau[5]};
  X.f = {-tau[0], -tau[1], -tau[2]};
  leave<starts>(w, j + 1, X);
}

// What was left at a link, with the link itself where it is this process's to add.
template <int p, int link>
ADAGEN_INLINE Body<Value> whole(Workspace& w) {
  Body<Value> X{};
  meet<p>(w, link, X);
  return X;
}

// Acceleration of a root that nothing holds.
template <int p, int link>
void solve_root(Workspace& w) {
  if (!solve_free(whole<p, link>(w), w.motions[link])) fail(w, kFactorization, link - 1);
}
