// From the base outwards: where links are and how they would move without joint accelerations.

ADAGEN_INLINE Frame frame_of(Workspace& w, int joint) {
  const Value* R = w.of(joint, kAxes);
  return {matrix_at(R), vector_at(w.of(joint, kOmega)), vector_at(w.of(joint, kAlpha)),
          vector_at(w.of(joint, kAcceleration))};
}

ADAGEN_INLINE void keep(Workspace& w, int joint, const Frame& frame) {
  put_at(w.of(joint, kAxes), frame.R);
  put_at(w.of(joint, kOmega), frame.omega);
  put_at(w.of(joint, kAlpha), frame.alpha);
  put_at(w.of(joint, kAcceleration), frame.a);
}

// The ground accelerates against gravity: accelerations are relative to free fall.
ADAGEN_INLINE Frame ground() {
  const Value one = Value{} + 1, none{};
  return {{{one, none, none}, {none, one, none}, {none, none, one}},
          {none, none, none},
          {none, none, none},
          {none - Real(kGravity[0]), none - Real(kGravity[1]), none - Real(kGravity[2])}};
}

// The axes of a floating base are the link's own: only gravity is turned.
template <int j>
void free_base_frame(Workspace& w) {
  constexpr const JointConstants& joint = kJoints[j];
  const Value* q = w.q + joint.q + 3;
  Matrix<Value> turn;
  require_length(w, rotation(q[0], q[1], q[2], q[3], turn), j);
  Frame frame = ground();
  const Vector<Real> gravity{Real(kGravity[0]), Real(kGravity[1]), Real(kGravity[2])};
  const Real* const P = joint.rotation;
  const Vector<Real> fixed{P[0] * gravity.x + P[3] * gravity.y + P[6] * gravity.z,
                           P[1] * gravity.x + P[4] * gravity.y + P[7] * gravity.z,
                           P[2] * gravity.x + P[5] * gravity.y + P[8] * gravity.z};
  const Value none{};
  frame.a = -transposed_times(turn, Vector<Value>{none + fixed.x, none + fixed.y, none + fixed.z});
  const Value* v = w.v + joint.v + 3;
  frame.omega = {v[0], v[1], v[2]};
  keep(w, j, frame);
}

ADAGEN_INLINE Matrix<Real> placement(const JointConstants& joint) {
  const Real* const P = joint.rotation;
  return {{P[0], P[1], P[2]}, {P[3], P[4], P[5]}, {P[6], P[7], P[8]}};
}

// The turn of a joint with a quaternion.
template <int j>
void orient(Workspace& w) {
  constexpr const JointConstants& joint = kJoints[j];
  const Value* q = w.q + joint.q + joint.nq - 4;
  Matrix<Value> turn;
  require_length(w, rotation(q[0], q[1], q[2], q[3], turn), j);
  if constexpr (!is_identity(joint.rotation)) {
    const Matrix<Real> P = placement(joint);
    turn = {turn.x * P.x.x + turn.y * P.x.y + turn.z * P.x.z,
            turn.x * P.y.x + turn.y * P.y.y + turn.z * P.y.z,
            turn.x * P.z.x + turn.y * P.z.y + turn.z * P.z.z};
  }
  put_at(w.of(j, kTurn), turn);
}

// One joint outwards from its parent link's frame; what a joint is treated with later is kept.
template <bool kept>
ADAGEN_INLINE void step_outward(Workspace& w, int j, Frame& at) {
  const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
  const Value* v = w.v + joint.v;
  Vector<Real> origin{joint.translation[0], joint.translation[1], joint.translation[2]};
  const Matrix<Value> R = at.R * matrix_at(w.of(j, kTurn));
  const Vector<Value> axis{R.x.z, R.y.z, R.z.z};
  Vector<Value> r = at.R * origin;
  const Vector<Value> omega = at.omega;
  const auto turn_with = [&](const Vector<Value>& relative) {
    at.omega += relative;
    return cross(omega, relative);
  };
  const auto ride_along = [&] {
    at.a += cross(omega, cross(omega, r));
    at.a += cross(at.alpha, r);
  };
  const auto slide_and_spin = [&](const Vector<Value>& q, const Vector<Value>& slide,
                                  const Vector<Value>& spin) {
    const Matrix<Real> P = placement(joint);
    r += at.R * Vector<Value>{dot(q, P.x), dot(q, P.y), dot(q, P.z)};
    ride_along();
    at.a += cross(omega + omega + spin, slide);
    at.alpha += turn_with(spin);
  };
  switch (joint.kind) {
    case JointKind::kRevolute:
      ride_along();
      at.alpha += turn_with(axis * v[0]);
      break;
    case JointKind::kPrismatic:
      r += axis * w.q[joint.q];
      ride_along();
      at.a += cross(omega, axis * (v[0] + v[0]));
      break;
    case JointKind::kSpherical:
      ride_along();
      at.alpha += turn_with(R * Vector<Value>{v[0], v[1], v[2]});
      break;
    case JointKind::kPlanar:
      if constexpr (kAnyPlanar) {
        const Value* q = w.q + joint.q;
        const Vector<Value> x{R.x.x, R.y.x, R.z.x}, y{R.x.y, R.y.y, R.z.y};
        slide_and_spin(Vector<Value>{q[0], q[1], Value{}}, x * v[0] + y * v[1], axis * v[2]);
      }
      break;
    case JointKind::kFloating:
      if constexpr (kAnyFloating) {
        const Value* q = w.q + joint.q;
        slide_and_spin(Vector<Value>{q[0], q[1], q[2]}, R * Vector<Value>{v[0], v[1], v[2]},
                       R * Vector<Value>{v[3], v[4], v[5]});
      }
      break;
  }
  at.R = R;
  if constexpr (!kept) return;
  w.joints[static_cast<std::size_t>(j)].r = r;
  keep(w, j, at);
}

// Joints first .. last, each on the link of the one before.
template <int first, int last>
void outward(Workspace& w) {
  constexpr int parent = kJoints[first].parent - 1;
  Frame at = parent < 0 ? ground() : frame_of(w, parent < 0 ? 0 : parent);
  for (int j = first; j <= last; ++j) step_outward<true>(w, j, at);
}

// The same on the way to joints that are treated: only the last link's frame is kept.
template <int first, int last>
void pass_outward(Workspace& w) {
  constexpr int parent = kJoints[first].parent - 1;
  Frame at = parent < 0 ? ground() : frame_of(w, parent < 0 ? 0 : parent);
  for (int j = first; j <= last; ++j) step_outward<false>(w, j, at);
  keep(w, last, at);
}
