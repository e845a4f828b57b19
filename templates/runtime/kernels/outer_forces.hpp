// Outer force k, given as [force; moment] in tau behind all torques, acts on its link: that much
// less bias force.
template <int k>
void push(Workspace& w) {
  constexpr const OuterForce& outer = kOuterForces[k];
  constexpr int j = outer.link - 1;
  const Value* const given = w.tau + kNv + 6 * k;
  if (__builtin_expect(!finite(given, 6), 0)) fail(w, kNotFinite, j);
  const Real *const P = outer.rotation, *const x = outer.translation;
  const auto told_in_link = [P](const Value* a) {
    return Vector<Value>{a[0] * P[0] + (a[1] * P[1] + a[2] * P[2]),
                         a[0] * P[3] + (a[1] * P[4] + a[2] * P[5]),
                         a[0] * P[6] + (a[1] * P[7] + a[2] * P[8])};
  };
  const Vector<Value> f = told_in_link(given);
  Vector<Value> n = told_in_link(given + 3);
  n += -cross(f, Vector<Real>{x[0], x[1], x[2]});
  const Matrix<Value> R = matrix_at(w.of(j, kAxes));
  put_at(w.of(j, kTorque), vector_at(w.of(j, kTorque)) - R * n);
  put_at(w.of(j, kForce), vector_at(w.of(j, kForce)) - R * f);
}
