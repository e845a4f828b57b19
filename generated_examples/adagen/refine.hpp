// adagen's runtime, the same for all robots.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

#include "constants.hpp"
#include "sample/robot.hpp"
#include "sizes.hpp"
#include "spatial.hpp"
#include "wide.hpp"

namespace {

// Iterative refinement. The unknowns are the joints' accelerations and forces together; both are
// summed up in wide numbers. From them follows what is left over at each link,
// rho = f - sum X_c^T f_c - I a - v x* I v, and from rho, with the factors at hand, a correction
// that is as large as the error was.
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

// The message from one process to another about a step.
struct ExchangeInfo {
  int source, target;
  Table entries;  // entries of v whose acceleration is sent
  Table forces;   // joints whose force is sent
};

// The slaved joint that a right-hand side is of; the first is of none.
constexpr int kSides = 1 + kSlavedCount;
constexpr std::array<int, kSides> kSlaved = [] {
  std::array<int, kSides> result{};
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

[[maybe_unused]] inline const Number* given(const Number* x) { return x; }

class Refinement {
 public:
  // Joint forces of the last step, every right-hand side, and which of these is being found where
  // they are found one after the other.
  std::array<Eigen::Matrix<Real, 6, kSides>, kJointCount> f;
  int side = 0;
  std::array<Eigen::Matrix<Number, 6, 1>, kJointCount> force;  // the same with coupling torques
  std::array<Number, kNv> step{};                              // accelerations of the last step
  std::array<Number, kNv> still{};                             // no velocities
  std::array<Number, kNv> lacking{};  // torques that forces inside runs lack along the joints
  std::array<Vec6, kLinkCount> rho;
  std::array<Wide, kNv> qdd{};
  // Its process's shares of e^T H e, t^T H t, and the same of all that holds links in free fall.
  double step_energy = 0, energy = 0, whole_energy = 0;
  std::array<double, kRefine> corrections{};
  double rounding = 0;           // the last correction, relative to the larger of these
  Wide6 ground = Wide6::Zero();  // its acceleration, relative to free fall

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
      const Wide3 w = angular_of(i.v), n = angular_of(momentum), p = linear_of(momentum);
      i.gyration = spatial(sum(crossed(w, n), crossed(linear_of(i.v), p)), crossed(w, p));
    }
  }

  // The joint's force, column by column, along the joint the torque as it was given.
  void collect(int j, const Number* tau) {
    const JointConstants& joint = kJoints[j];
    force[j] = f[j].col(0).cast<Number>();
    for (int k = 0; k < joint.nv; ++k) force[j][free_row(joint.kind, k)] = tau[joint.v + k];
  }

  // What a coupling torque adds to it: along the slaved joint the torque itself, along the source
  // that times the multiplier, and nothing along others.
  void couple(int j, int column, Number torque) {
    const JointConstants &joint = kJoints[j], &slaved = kJoints[kSlaved[column]];
    Eigen::Matrix<Number, 6, 1> of_unit = f[j].col(column).template cast<Number>();
    for (int k = 0; k < joint.nv; ++k) of_unit[free_row(joint.kind, k)] = 0;
    if (kSlaved[column] == j) of_unit[free_row(joint.kind, 0)] = 1;
    if (slaved.source == j) of_unit[free_row(joint.kind, 0)] = -Number(slaved.multiplier);
    force[j] += of_unit * torque;
  }

  // A link without mass passes on what it gets.
  void hand_on(int j, int beyond) {
    force[j] = returned(joints_[beyond].carried, force[beyond].cast<Wide>()).cast<Number>();
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
    const Six<double> none = Six<double>::Zero();
    for (const int j : own.path) {
      const int parent = kJoints[j].parent;
      WideJoint& i = joints_[j];
      const auto& carried = i.roughly_carried;
      i.moved = carried(parent > 0 ? joints_[parent - 1].moved : none) +
                along_joint<double>(j, qdd.data());
      i.stepped = carried(parent > 0 ? joints_[parent - 1].stepped : none) +
                  along_joint<double>(j, step.data());
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

  // The residuals of the process's links.
  void residual(const RefinedProcess& own) {
    for (const int j : own.path) {
      const int parent = kJoints[j].parent;
      WideJoint& i = joints_[j];
      i.a = i.carried(parent > 0 ? joints_[parent - 1].a : ground) +
            along_joint<Wide>(j, qdd.data()) + i.c;
    }
    for (const int link : own.links)
      left_[link] = -times_inertia(link, joints_[link - 1].a) - joints_[link - 1].gyration;
    for (const int j : own.at) {  // also adds to links of other processes; these are not read
      const WideJoint& i = joints_[j];
      left_[j + 1] += i.f;
      left_[kJoints[j].parent] -= returned(i.carried, i.f);
    }
    for (const int link : own.links) rho[link] = left_[link].cast<Real>();
  }

 private:
  void place(int j, const Number* q) {
    auto& [E, r] = joints_[j].carried = carrier_of(j, q);
    joints_[j].roughly_carried = {E.cast<double>(), r.cast<double>()};
  }

  void move(int j, const Number* v) {
    const JointConstants& joint = kJoints[j];
    WideJoint& i = joints_[j];
    Wide6 motion;
    if (joint.source < 0) {
      motion = along_joint<Wide>(j, v);
    } else {
      motion.setZero();
      motion[free_row(joint.kind, 0)] = Wide(joint.multiplier) * Wide(v[kJoints[joint.source].v]);
    }
    i.v = motion;
    if (joint.parent > 0) i.v += i.carried(joints_[joint.parent - 1].v);
    const Wide3 w = angular_of(i.v), turning = angular_of(motion);
    i.c = spatial(crossed(w, turning),
                  sum(crossed(w, linear_of(motion)), crossed(linear_of(i.v), turning)));
  }

  std::array<WideJoint, kJointCount> joints_;
  std::array<Wide6, kLinkCount> left_;
};

}  // namespace
