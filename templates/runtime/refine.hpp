// Iterative refinement. The unknowns are the joints' accelerations and forces together; both are
// summed up in wide numbers. From them follows what is left over at each link,
// rho = f - sum X_c^T f_c - I a - v x* I v, and from rho, with the factors at hand, a correction
// that is as large as the error was.
using Wide = std::conditional_t<std::is_same_v<Real, float>, double, long double>;
using Wide3 = Eigen::Matrix<Wide, 3, 1>;
using Wide6 = Eigen::Matrix<Wide, 6, 1>;
using WideMat3 = Eigen::Matrix<Wide, 3, 3>;
template <class T>
using Six = Eigen::Matrix<T, 6, 1>;

template <class T>
Six<T> spatial(const Eigen::Matrix<T, 3, 1>& angular, const Eigen::Matrix<T, 3, 1>& linear) {
  Six<T> result;
  result << angular, linear;
  return result;
}
inline Wide6 wide(const Wide3& angular, const Wide3& linear) { return spatial(angular, linear); }

// From a joint's parent link's coordinates to its child link's.
template <class T>
struct Carrier {
  Eigen::Matrix<T, 3, 3> E;
  Eigen::Matrix<T, 3, 1> r;  // origin of the child frame in the parent's

  Six<T> operator()(const Six<T>& m) const {
    const Eigen::Matrix<T, 3, 1> angular = m.template head<3>();
    return spatial<T>(E * angular, E * (m.template tail<3>() - r.cross(angular)));
  }
};

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
  Carrier<Wide> carried;
  Wide6 v, c;      // velocity of the link; v x S qd
  Wide6 gyration;  // v x* I v
  Wide6 f;         // the joint's force on the link
  Wide6 a;         // acceleration of the link, relative to free fall
  // What of it comes of qdd, and of the last step: for sizes, of which a digit or two matter.
  Carrier<double> roughly_carried;
  Six<double> moved, stepped;
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
  double step_energy = 0, energy = 0, whole_energy = 0;
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
    const Six<double> still = Six<double>::Zero();
    for (const int j : own.path) {
      const int parent = kJoints[j].parent;
      WideJoint& i = joints_[j];
      const auto& carried = i.roughly_carried;
      i.moved =
          carried(parent > 0 ? joints_[parent - 1].moved : still) + along<double>(j, qdd.data());
      i.stepped =
          carried(parent > 0 ? joints_[parent - 1].stepped : still) + along<double>(j, step.data());
    }
    energy = step_energy = whole_energy = 0;
    for (const int link : own.links) {
      const WideJoint& i = joints_[link - 1];
      energy += i.moved.dot(times_inertia(link, i.moved));
      step_energy += i.stepped.dot(times_inertia(link, i.stepped));
      const Six<double> a = i.a.cast<double>();
      whole_energy += a.dot(times_inertia(link, a));
    }
  }

  // What is left over at the process's links.
  void residual(const RefinedProcess& own) {
    Wide6 ground = Wide6::Zero();
    for (int k = 0; k < 3; ++k) ground[3 + k] = -Wide(kGravity[k]);
    for (const int j : own.path) {
      const int parent = kJoints[j].parent;
      WideJoint& i = joints_[j];
      i.a =
          i.carried(parent > 0 ? joints_[parent - 1].a : ground) + along<Wide>(j, qdd.data()) + i.c;
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
  template <class T, class Rate>
  static Six<T> along(int j, const Rate* rates) {
    Six<T> result = Six<T>::Zero();
    const JointConstants& joint = kJoints[j];
    for (int k = 0; k < joint.nv; ++k)
      result[free_row(joint.kind, k)] = static_cast<T>(rates[joint.v + k]);
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

  // A wrench on a joint's child link, in its parent link's frame.
  static Wide6 returned(const WideJoint& i, const Wide6& f) {
    const auto& [E, r] = i.carried;
    const Wide3 linear = E.transpose() * f.tail<3>();
    return wide(E.transpose() * f.head<3>() + r.cross(linear), linear);
  }

  // I m of a link: its mass at the centre of mass, its tensor about it.
  template <class T>
  static Six<T> times_inertia(int link, const Six<T>& m) {
    using Vector = Eigen::Matrix<T, 3, 1>;
    const LinkConstants& body = kLinks[link];
    const Vector c(body.com[0], body.com[1], body.com[2]), angular = m.template head<3>();
    const Vector force = T(body.mass) * (m.template tail<3>() + angular.cross(c));
    Vector moment = c.cross(force);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) moment[i] += T(body.tensor[3 * i + k]) * angular[k];
    return spatial(moment, force);
  }

  void place(int j, const Number* q) {
    const JointConstants& joint = kJoints[j];
    auto& [E, r] = joints_[j].carried;
    WideMat3 base;
    for (int k = 0; k < 9; ++k) base(k / 3, k % 3) = Wide(joint.rotation[k]);
    for (int k = 0; k < 3; ++k) r[k] = Wide(joint.translation[k]);
    const Number* const own = q + (joint.source < 0 ? joint.q : kJoints[joint.source].q);
    const auto scalar = [&joint, own](int k) {
      if (joint.source < 0) return Wide(own[k]);
      return Wide(joint.multiplier) * Wide(own[k]) + Wide(joint.offset);
    };
    const auto turned = [&E = E, &base](Wide angle) {
      const Wide c = std::cos(angle), s = std::sin(angle);
      for (int k = 0; k < 3; ++k) {
        E(0, k) = c * base(k, 0) + s * base(k, 1);
        E(1, k) = c * base(k, 1) - s * base(k, 0);
        E(2, k) = base(k, 2);
      }
    };
    switch (joint.kind) {
      case JointKind::kRevolute:
        turned(scalar(0));
        break;
      case JointKind::kPrismatic:
        E = base.transpose();
        r += base.col(2) * scalar(0);
        break;
      case JointKind::kPlanar:
        turned(Wide(own[2]));
        r += base.col(0) * Wide(own[0]) + base.col(1) * Wide(own[1]);
        break;
      case JointKind::kFloating:
        E = (base * oriented(own + 3)).transpose();
        r += base * Wide3(Wide(own[0]), Wide(own[1]), Wide(own[2]));
        break;
      case JointKind::kSpherical:
        E = (base * oriented(own)).transpose();
        break;
    }
    joints_[j].roughly_carried = {E.cast<double>(), r.cast<double>()};
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
      motion = along<Wide>(j, v);
    } else {
      motion.setZero();
      motion[free_row(joint.kind, 0)] = Wide(joint.multiplier) * Wide(v[kJoints[joint.source].v]);
    }
    i.v = motion;
    if (joint.parent > 0) i.v += i.carried(joints_[joint.parent - 1].v);
    const Wide3 w = i.v.head<3>(), u = i.v.tail<3>(), turning = motion.head<3>();
    i.c = wide(w.cross(turning), w.cross(Wide3(motion.tail<3>())) + u.cross(turning));
  }

  std::array<WideJoint, kJointCount> joints_;
  std::array<Wide6, kLinkCount> left_;
};
