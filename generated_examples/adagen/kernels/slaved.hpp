// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "../constants.hpp"
#include "../sample/channel.hpp"
#include "../sample/keep.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../slave.hpp"
#include "../value.hpp"
#include "blocks.hpp"
#include "memory.hpp"

namespace {

// Slaved joints. Each is coupled by a torque between it and its source. The same sweeps
// find the effect of a unit of that torque, with no other force acting, not even springs.
inline void pull(Workspace& w, int slaved) {
  const JointConstants& joint = kJoints[static_cast<std::size_t>(slaved)];
  Value *const v = w.v.data(), *const tau = w.tau.data();
  std::fill_n(v, kNv, Value{}), std::fill_n(tau, kNtau, Value{});
  tau[joint.v] = 1;
  tau[kJoints[static_cast<std::size_t>(joint.source)].v] -= Value(joint.multiplier);
  for (Block& block : w.blocks)
    for (int k = kTorque; k < kEntries; ++k) std::fill_n(block.entries[k], kPerBlock, Value{});
}

inline void find_responses(Workspace& w, Channel& channel, void (*sweep)(Workspace&, Channel&)) {
  const auto answer = w.answer;
  w.again = true;
  std::size_t c = 0;
  for (int j = 0; j < kJointCount; ++j) {
    if (kJoints[static_cast<std::size_t>(j)].source < 0) continue;
    pull(w, j);
    keep_side(w, c + 1);
    sweep(w, channel);
    w.responses[c++] = w.answer;
  }
  keep_side(w, 0);
  w.again = false;
  w.answer = answer;
  w.v = given(w.v), w.tau = given(w.tau);
  slave(kJoints, w.q.data(), w.v.data());
}

// An acceleration as it would be without these torques, and what a unit of each adds to it.
using Responses = std::array<Real, kSlavedCount + 1>;
inline Responses responses_of(const Workspace& w, std::size_t v) {
  Responses result{w.answer[v]};
  for (std::size_t c = 0; c < kSlavedCount; ++c) result[c + 1] = w.responses[c][v];
  return result;
}
[[maybe_unused]] inline const Number* get_responses(const Number* from, Workspace& w,
                                                    std::size_t v) {
  w.answer[v] = Real(*from++);
  for (auto& response : w.responses) response[v] = Real(*from++);
  return from;
}

// Applies the torques, to accelerations first .. first + count - 1.
inline void apply_coupling(Workspace& w, std::size_t first, std::size_t count) {
  for (std::size_t c = 0; c < kSlavedCount; ++c)
    for (std::size_t k = first; k < first + count; ++k)
      w.answer[k] += w.responses[c][k] * w.coupling[c];
}

}  // namespace
