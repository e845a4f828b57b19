// adagen's runtime, the same for all robots.
#pragma once

#include "sizes.hpp"

namespace {

enum class JointKind { kRevolute, kPrismatic, kSpherical, kPlanar, kFloating };

// What a joint does by itself: of its torque, damping qd + friction tanh(qd / friction_speed)
// + stiffness (q - rest) + rotor qdd do not reach the links. Where its acceleration is prescribed,
// tau holds that.
struct Passive {
  Number damping = 0, friction = 0, friction_speed = 1, stiffness = 0, rest = 0, rotor = 0;
  bool prescribed = false;
};

// A joint's frame is turned so that its axis is z (a planar joint's normal, too); the child link
// has the joint's frame at q = 0.
struct JointConstants {
  const char* name;
  JointKind kind;
  int parent;             // parent link; the child link has the joint's number plus one
  int q, nq, v, nv;       // where its configuration and velocity are
  Number rotation[9];     // joint frame to parent link's frame, row by row
  Number translation[3];  // origin of the joint frame in the parent link's frame, m
  int source = -1;        // joint that it is slaved to, or -1: q = multiplier q_source + offset
  double multiplier = 0, offset = 0;
  Passive passive{};
  bool given = true;  // whether its acceleration is wanted and found
};

// An outer force that is an input, expressed in the frame of the link that has its name.
struct OuterForce {
  const char* name;
  int link;               // that feels it
  Number rotation[9];     // from that frame to the link's, row by row
  Number translation[3];  // its origin in the link's frame, m
};

struct LinkConstants {
  const char* name;
  Number mass;                    // kg
  Number com[3];                  // centre of mass, m
  Number tensor[9] = {};          // rotational inertia about it, kg m^2
  Number tensor_inverse[9] = {};  // J, its inverse
};

// A link whose mass or centre is set at run time: where those are among all that is, -1 if they are
// constant, and the rotation from the axes they are given in to the link's, row by row.
struct SettableLink {
  int link, mass, center;
  double axes[9];
};

// Entries first .. first + count - 1 of a vector.
struct Range {
  int first, count;
};
struct Ranges {
  int count;
  const Range* ranges;
};

// What a process does between two time stamps (--trace).
struct StageInfo {
  const char* what;
  int joint, message;  // that it ends or begins with; sent or received; -1 for none
};
struct Stages {
  int count;
  const StageInfo* stages;
};

// What a process reads of q and v, the entries of v whose qdd is its own, those whose tau it reads;
// what it does.
struct ProcessInfo {
  Ranges q, v, own, tau;
  Stages stages{0, nullptr};

  // Whether it computes anything. Where few accelerations are wanted, it may do so and have none.
  constexpr bool takes_part() const { return q.count + v.count + own.count + tau.count > 0; }
};

// What a process runs that has nothing to do.
[[maybe_unused]] constexpr auto kNothing = [](auto&, auto&) {};

// What goes from one process to another once in an evaluation.
struct MessageInfo {
  int source, target, size;  // size in Number, the status not counted
};

}  // namespace
