// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>

#include "constants.hpp"
#include "description.hpp"
#include "sample/messages.hpp"
#include "sample/robot.hpp"
#include "sizes.hpp"

namespace {

// The model, in the form that the program reads.
adagen::Joint<Number> described(const JointConstants& joint) {
  const Passive& own = joint.passive;
  const auto kind = static_cast<adagen::JointKind>(joint.kind);
  return {joint.name,       kind,         joint.parent,   joint.q,           joint.nq,
          joint.v,          joint.nv,     joint.rotation, joint.translation, joint.source,
          joint.multiplier, joint.offset, own.damping,    own.friction,      own.friction_speed,
          own.stiffness,    own.rest,     own.rotor,      own.prescribed,    joint.given};
}
adagen::Link<Number> described(const LinkConstants& link) {
  return {link.mass, link.com, link.tensor};
}
[[maybe_unused]] adagen::OuterForce<Number> described(const OuterForce& outer) {
  return {outer.name, outer.link, outer.rotation, outer.translation};
}
[[maybe_unused]] adagen::Message described(const MessageInfo& message) {
  return {message.source, message.target, message.size};
}
[[maybe_unused]] adagen::Stage described(const StageInfo& stage) {
  return {stage.what, stage.joint, stage.message};
}

// All of a table, as long as the program runs.
template <const auto& all>
auto table() {
  using Described = decltype(described(all[0]));
  static std::array<Described, all.size()> items{};
  for (std::size_t k = 0; k < all.size(); ++k) items[k] = described(all[k]);
  return adagen::Table<Described>{items.data(), static_cast<int>(all.size())};
}

[[maybe_unused]] adagen::Hop described(const double (&hop)[3]) { return {hop[0], hop[1], hop[2]}; }

// What a solver's description has from its settings and tables: all but loops, outputs and outer
// forces. stages: a table for each process.
adagen::Description<Number> plain_description(const adagen::Table<adagen::Stage>* stages) {
  adagen::Description<Number> about{};
  about.robot = Settings::kRobot, about.channel = Settings::kChannel;
  about.floating = Settings::kFloating, about.at_rest = Settings::kAtRest;
#if defined(ADAGEN_THREADS)
  about.processes = 1, about.threads = kAlone ? 1 : kProcesses;
#else
  about.processes = kProcesses, about.threads = 1;
#endif
#if defined(ADAGEN_SETS_GRAVITY)
  about.sets_gravity = true;
#endif
  about.nq = kNq, about.nv = kNv, about.ntau = kNtau, about.nqdd = kNqdd;
  about.refine = kRefine, about.alone = kAlone, about.batch = kBatch, about.certified = kCertified;
  about.tolerance = kTolerance, about.gravity = kGravity.data();
  about.joints = table<kJoints>(), about.links = table<kLinks>();
  about.messages = table<kMessages>();
  about.stages = stages;
  about.window_hop = described(Settings::kHops.window);
  about.message_hop = described(Settings::kHops.message);
  return about;
}

// Shapes that join no runs of joints as one are never near gimbal lock.
template <class S>
auto near_lock_of(const S& solver, int) -> decltype(solver.w.near_lock) {
  return solver.w.near_lock;
}
template <class S>
int near_lock_of(const S&, long) {
  return 0;
}

}  // namespace
