// Outwards again: the joints' accelerations.

ADAGEN_INLINE Value freedom(const Value* e, const Motion<Value>& a) {
  return (e[6] - (e[0] * a.angular.x + e[1] * a.angular.y)) -
         ((e[2] * a.angular.z + e[3] * a.linear.x) + (e[4] * a.linear.y + e[5] * a.linear.z));
}

// The same for joints with several freedoms, told at the joint's origin throughout.
template <bool reversed>
ADAGEN_INLINE void move_at_joint(Workspace& w, int j, Motion<Value>& a) {
  const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
  [[maybe_unused]] const Value* const e = w.joints[static_cast<std::size_t>(j)].e;
  [[maybe_unused]] const Value* R = w.of(j, kAxes);
  [[maybe_unused]] Value* qdd = &w.answer[static_cast<std::size_t>(joint.v)];
  switch (joint.kind) {
    case JointKind::kSpherical:
      if constexpr (kAnySpherical) {
        const Matrix<Value> K{{e[0], e[1], e[2]}, {e[3], e[4], e[5]}, {e[6], e[7], e[8]}};
        const Vector<Value> far = Vector<Value>{e[9], e[10], e[11]} - K * a.linear;
        const Vector<Value> x = transposed_times(matrix_at(R), far - a.angular);
        qdd[0] = reversed ? -x.x : x.x, qdd[1] = reversed ? -x.y : x.y;
        qdd[2] = reversed ? -x.z : x.z;
        a.angular = far;
      }
      break;
    case JointKind::kPlanar:
      if constexpr (kAnyPlanar) {
        const Value spin = freedom(e + 16, a);
        a.angular += axis_at(R) * spin;
        const Value y = freedom(e + 8, a);
        a.linear += Vector<Value>{R[kPerBlock], R[4 * kPerBlock], R[7 * kPerBlock]} * y;
        const Value x = freedom(e, a);
        a.linear += Vector<Value>{R[0], R[3 * kPerBlock], R[6 * kPerBlock]} * x;
        qdd[0] = reversed ? -x : x, qdd[1] = reversed ? -y : y, qdd[2] = reversed ? -spin : spin;
      }
      break;
    case JointKind::kFloating:
      if constexpr (kAnyFloating) {
        const Matrix<Value> axes = matrix_at(R);
        const Motion<Value> far{{e[0], e[1], e[2]}, {e[3], e[4], e[5]}};
        const Vector<Value> slide = transposed_times(axes, far.linear - a.linear);
        const Vector<Value> spin = transposed_times(axes, far.angular - a.angular);
        const Value x[6] = {slide.x, slide.y, slide.z, spin.x, spin.y, spin.z};
        ADAGEN_FOR (k, 0, 6) qdd[k] = reversed ? -x[k] : x[k];
        a = far;
      }
      break;
    default:
      break;
  }
}

// A joint's acceleration from the near link's, which becomes the far link's; each is told at its
// own origin. Where the joint is reversed, the far link's acceleration differs by -S qdd.
template <bool reversed>
ADAGEN_INLINE void move(Workspace& w, int j, Motion<Value>& a) {
  const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
  const Value* const e = w.joints[static_cast<std::size_t>(j)].e;
  const Vector<Value>& r = w.joints[static_cast<std::size_t>(j)].r;
  const Value* R = w.of(j, kAxes);
  Value* qdd = &w.answer[static_cast<std::size_t>(joint.v)];
  switch (joint.kind) {
    case JointKind::kRevolute: {
      const Vector<Value> axis = axis_at(R);
      const Value x = freedom(e, a);
      qdd[0] = reversed ? -x : x;
      carry(a, reversed ? -r : r);
      a.angular += axis * x;
      if constexpr (reversed) a.linear += cross(r, axis) * x;
      break;
    }
    case JointKind::kPrismatic: {
      const Value x = freedom(e, a);
      qdd[0] = reversed ? -x : x;
      carry(a, reversed ? -r : r);
      a.linear += axis_at(R) * x;
      break;
    }
    default:
      if constexpr (!reversed) carry(a, r);
      move_at_joint<reversed>(w, j, a);
      if constexpr (reversed) carry(a, -r);
  }
}

// Joints first .. last outwards; what moves along with a link is kept where other paths start.
template <int p, int first, int last>
void accelerate(Workspace& w) {
  Motion<Value> a = w.motions[static_cast<std::size_t>(kJoints[first].parent)];
  for (int j = first; j <= last; ++j) {
    move<false>(w, j, a);
    if (kRoles[p][static_cast<std::size_t>(j + 1)].parts)
      w.motions[static_cast<std::size_t>(j + 1)] = a;
  }
}

template <int p, int first, int last>
void accelerate_reversed(Workspace& w) {
  Motion<Value> a = w.motions[last + 1];
  for (int j = last; j >= first; --j) {
    move<true>(w, j, a);
    const std::size_t far = static_cast<std::size_t>(kJoints[static_cast<std::size_t>(j)].parent);
    if (kRoles[p][far].parts) w.motions[far] = a;
  }
}

// The Frame of a floating base knows nothing of its linear velocity, whose axes turn with the base.
template <int j>
void as_joint_acceleration(Workspace& w) {
  const Value* v = w.v + kJoints[j].v;
  Value* qdd = &w.answer[kJoints[j].v];
  const Vector<Value> turned =
      cross(Vector<Value>{v[3], v[4], v[5]}, Vector<Value>{v[0], v[1], v[2]});
  qdd[0] -= turned.x, qdd[1] -= turned.y, qdd[2] -= turned.z;
}

// A floating base's joint acceleration, [linear; angular] in its own axes.
template <int j>
void free_acceleration(Workspace& w) {
  const Motion<Value>& a = w.motions[j + 1];
  Value* qdd = &w.answer[kJoints[j].v];
  qdd[0] = a.linear.x, qdd[1] = a.linear.y, qdd[2] = a.linear.z;
  qdd[3] = a.angular.x, qdd[4] = a.angular.y, qdd[5] = a.angular.z;
  as_joint_acceleration<j>(w);
}
