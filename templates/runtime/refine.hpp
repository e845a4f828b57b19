// Iterative refinement. The unknowns are the joints' accelerations and forces together; both are
// summed up in wide numbers. From them follows what is left over at each link,
// rho = f - sum X_c^T f_c - I a - v x* I v, and from rho, with the factors at hand, a correction
// that is as large as the error was.
using Wide = std::conditional_t<std::is_same_v<Real, float>, double, long double>;
using Wide3 = Eigen::Matrix<Wide, 3, 1>;
using Wide6 = Eigen::Matrix<Wide, 6, 1>;
using WideMat3 = Eigen::Matrix<Wide, 3, 3>;

inline Wide6 wide(const Wide3& angular, const Wide3& linear) {
  Wide6 result;
  result << angular, linear;
  return result;
}

// Numbers of joints, links or entries, ascending.
struct Table {
  int count;
  const int* first;
  const int* begin() const { return first; }
  const int* end() const { return first + count; }
};

// A process's part in the refinement.
struct RefinedProcess {
  Table own;      // velocity entries whose acceleration it gives
  Table entries;  // velocity entries whose acceleration it sums up: those that it needs
  Table forces;   // joints whose force it computes
  Table path;     // joints between its links and the ground
  Table at;       // joints at its links
  Table links;    // its links
  Table slaved;   // slaved joints among all of these
  Table inner;    // joints of its runs whose far link has no mass, from the ends inwards
  Table beyond;   // the joint beyond each of them
};

// What one process tells another of a step.
struct ExchangeInfo {
  int source, target;
  Table entries;  // of the velocity, whose acceleration is told
  Table forces;   // joints whose force is told
};

// The slaved joint that a right-hand side is of; the first is of none.
constexpr std::array<int, kColumns> kSlaved = [] {
  std::array<int, kColumns> result{};
  for (int j = 0, column = 0; j < kJointCount; ++j)
    if (kJoints[j].source >= 0) result[++column] = j;
  return result;
}();

// A joint and the link under it.
struct WideJoint {
  WideMat3 E;            // parent to child coordinates
  Wide3 r;               // origin of the child frame in the parent's
  Wide6 v, c;            // velocity of the link; v x S qd
  Wide6 gyration;        // v x* I v
  Wide6 f;               // the joint's force on the link
  Wide6 a;               // acceleration of the link, relative to free fall
  Wide6 moved, stepped;  // what of it comes of qdd, and of the last step
};

class Refinement {
 public:
  std::array<Columns6, kJointCount> f;  // joint forces of the last step, every right-hand side
  std::array<Eigen::Matrix<Number, 6, 1>, kJointCount> force;  // the same with coupling torques
  std::array<Number, kNv> step{};                              // accelerations of the last step
  std::array<Number, kNv> lacking{};  // torques that forces inside runs lack along the joints
  std::array<Vec6, kLinkCount> rho;
  std::array<Wide, kNv> qdd{};
  // Its process's shares of e^T H e, t^T H t, and the same of all that holds links in free fall.
  Wide step_energy = 0, energy = 0, whole_energy = 0;
  std::array<double, kRefine> corrections{};
  double rounding = 0;  // the last correction, relative to the larger of these

  void begin(const RefinedProcess& own, const Number* q, const Number* v) {
    qdd.fill(0);
    for (const int j : own.path) place(j, q), move(j, v);
    for (const int j : own.at) {
      if (!std::binary_search(own.path.begin(), own.path.end(), j)) place(j, q);
      joints_[j].f.setZero();
    }
    for (const int link : own.links) {
      WideJoint& i = joints_[link - 1];
      const Wide6 momentum = times_inertia(link, i.v);
      const Wide3 w = i.v.head<3>(), n = momentum.head<3>(), p = momentum.tail<3>();
      i.gyration = wide(w.cross(n) + Wide3(i.v.tail<3>()).cross(p), w.cross(p));
    }
  }

  // The joint's force, column by column, along the joint the torque as it was given.
  void collect(int j, const Number* tau) {
    const JointConstants& joint = kJoints[j];
    force[j] = f[j].col(0).cast<Number>();
    for (int k = 0; k < joint.nv; ++k) force[j][free_row(joint.kind, k)] = tau[joint.v + k];
  }

  // What a coupling torque adds to it. Along the source that is the torque times the multiplier,
  // which may be rounded in f.
  void couple(int j, int column, Number torque) {
    const JointConstants& slaved = kJoints[kSlaved[column]];
    force[j] += f[j].col(column).cast<Number>() * torque;
    if (slaved.source != j) return;
    const int row = free_row(kJoints[j].kind, 0);
    force[j][row] -= (Number(slaved.multiplier) + Number(f[j](row, column))) * torque;
  }

  // A link without mass hands on what it gets.
  void hand_on(int j, int beyond) {
    force[j] = returned(joints_[beyond], force[beyond].cast<Wide>()).cast<Number>();
  }

  // What the forces inside runs lack of these torques.
  void miss(const RefinedProcess& own, const Number* tau) {
    for (const int j : own.inner) {
      const JointConstants& joint = kJoints[j];
      for (int k = 0; k < joint.nv; ++k)
        lacking[joint.v + k] =
            static_cast<Number>(Wide(tau[joint.v + k]) - joints_[j].f[free_row(joint.kind, k)]);
    }
  }

  // The last step becomes part of the answer.
  void add(const RefinedProcess& own) {
    for (const int k : own.entries) qdd[k] += Wide(step[k]);
    for (const int j : own.at) joints_[j].f += force[j].cast<Wide>();
    for (const int j : own.slaved) {
      const JointConstants& joint = kJoints[j];
      const int source = kJoints[joint.source].v;
      qdd[joint.v] = Wide(joint.multiplier) * qdd[source];
      step[joint.v] = static_cast<Number>(joint.multiplier * double(step[source]));
    }
  }

  // What the answer and its last step weigh, and all accelerations relative to free fall.
  void weigh(const RefinedProcess& own) {
    const Wide6 still = Wide6::Zero();
    for (const int j : own.path) {
      const int parent = kJoints[j].parent;
      WideJoint& i = joints_[j];
      i.moved = carried(i, parent > 0 ? joints_[parent - 1].moved : still) + along(j, qdd.data());
      i.stepped =
          carried(i, parent > 0 ? joints_[parent - 1].stepped : still) + along(j, step.data());
    }
    energy = step_energy = whole_energy = 0;
    for (const int link : own.links) {
      const WideJoint& i = joints_[link - 1];
      energy += i.moved.dot(times_inertia(link, i.moved));
      step_energy += i.stepped.dot(times_inertia(link, i.stepped));
      whole_energy += i.a.dot(times_inertia(link, i.a));
    }
  }

  // What is left over at the process's links.
  void residual(const RefinedProcess& own) {
    Wide6 ground = Wide6::Zero();
    for (int k = 0; k < 3; ++k) ground[3 + k] = -Wide(kGravity[k]);
    for (const int j : own.path) {
      const int parent = kJoints[j].parent;
      WideJoint& i = joints_[j];
      i.a = carried(i, parent > 0 ? joints_[parent - 1].a : ground) + along(j, qdd.data()) + i.c;
    }
    for (const int link : own.links)
      left_[link] = -times_inertia(link, joints_[link - 1].a) - joints_[link - 1].gyration;
    for (const int j : own.at) {  // adds to other processes' links, too, which nobody reads
      const WideJoint& i = joints_[j];
      left_[j + 1] += i.f;
      left_[kJoints[j].parent] -= returned(i, i.f);
    }
    for (const int link : own.links) rho[link] = left_[link].cast<Real>();
  }

 private:
  template <class T>
  static Wide6 along(int j, const T* rates) {
    Wide6 result = Wide6::Zero();
    const JointConstants& joint = kJoints[j];
    for (int k = 0; k < joint.nv; ++k) result[free_row(joint.kind, k)] = Wide(rates[joint.v + k]);
    return result;
  }

  static int free_row(JointKind kind, int k) {
    switch (kind) {
      case JointKind::kRevolute:
        return Revolute::Free::row[k];
      case JointKind::kPrismatic:
        return Prismatic::Free::row[k];
      case JointKind::kSpherical:
        return Spherical::Free::row[k];
      case JointKind::kPlanar:
        return Planar::Free::row[k];
      case JointKind::kFloating:
        return Floating::Free::row[k];
    }
    return 0;
  }

  static Wide6 carried(const WideJoint& i, const Wide6& m) {
    const Wide3 angular = m.head<3>();
    return wide(i.E * angular, i.E * (m.tail<3>() - i.r.cross(angular)));
  }

  // A wrench on a joint's child link, in its parent link's frame.
  static Wide6 returned(const WideJoint& i, const Wide6& f) {
    const Wide3 linear = i.E.transpose() * f.tail<3>();
    return wide(i.E.transpose() * f.head<3>() + i.r.cross(linear), linear);
  }

  // I m of a link: its mass at the centre of mass, its tensor about it.
  static Wide6 times_inertia(int link, const Wide6& m) {
    const LinkConstants& body = kLinks[link];
    const Wide3 c(body.com[0], body.com[1], body.com[2]), angular = m.head<3>();
    const Wide3 force = Wide(body.mass) * (m.tail<3>() + angular.cross(c));
    Wide3 moment = c.cross(force);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) moment[i] += Wide(body.tensor[3 * i + k]) * angular[k];
    return wide(moment, force);
  }

  void place(int j, const Number* q) {
    const JointConstants& joint = kJoints[j];
    WideMat3 base, turn = WideMat3::Identity();
    Wide3 shift = Wide3::Zero();
    for (int k = 0; k < 9; ++k) base(k / 3, k % 3) = Wide(joint.rotation[k]);
    const Number* const own = q + (joint.source < 0 ? joint.q : kJoints[joint.source].q);
    const auto scalar = [&joint, own](int k) {
      if (joint.source < 0) return Wide(own[k]);
      return Wide(joint.multiplier) * Wide(own[k]) + Wide(joint.offset);
    };
    const auto about_z = [&turn](Wide angle) {
      const Wide c = std::cos(angle), s = std::sin(angle);
      turn << c, -s, 0, s, c, 0, 0, 0, 1;
    };
    switch (joint.kind) {
      case JointKind::kRevolute:
        about_z(scalar(0));
        break;
      case JointKind::kPrismatic:
        shift[2] = scalar(0);
        break;
      case JointKind::kPlanar:
        shift << Wide(own[0]), Wide(own[1]), 0;
        about_z(Wide(own[2]));
        break;
      case JointKind::kFloating:
        shift << Wide(own[0]), Wide(own[1]), Wide(own[2]);
        turn = oriented(own + 3);
        break;
      case JointKind::kSpherical:
        turn = oriented(own);
        break;
    }
    joints_[j].E = (base * turn).transpose();
    joints_[j].r = base * shift;
    for (int k = 0; k < 3; ++k) joints_[j].r[k] += Wide(joint.translation[k]);
  }

  static WideMat3 oriented(const Number* quaternion) {
    const Wide x = quaternion[0], y = quaternion[1], z = quaternion[2], w = quaternion[3];
    const Wide s = 2 / (x * x + y * y + z * z + w * w);
    WideMat3 turn;
    turn << 1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w),  //
        s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w),      //
        s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y);
    return turn;
  }

  void move(int j, const Number* v) {
    const JointConstants& joint = kJoints[j];
    WideJoint& i = joints_[j];
    Wide6 motion;
    if (joint.source < 0) {
      motion = along(j, v);
    } else {
      motion.setZero();
      motion[free_row(joint.kind, 0)] = Wide(joint.multiplier) * Wide(v[kJoints[joint.source].v]);
    }
    i.v = motion;
    if (joint.parent > 0) i.v += carried(i, joints_[joint.parent - 1].v);
    const Wide3 w = i.v.head<3>(), u = i.v.tail<3>(), turning = motion.head<3>();
    i.c = wide(w.cross(turning), w.cross(Wide3(motion.tail<3>())) + u.cross(turning));
  }

  std::array<WideJoint, kJointCount> joints_;
  std::array<Wide6, kLinkCount> left_;
};
