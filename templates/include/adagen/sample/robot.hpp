// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER)

#include <array>

#include "../constants.hpp"
#include "../sizes.hpp"

namespace {

constexpr std::array<double, kParameterCount> kParameters{0.0, 0.0, -9.81, 1.0};
constexpr int kGravityEntry = 0;
constexpr std::array<SettableLink, 1> kSettableLinks{{{2, 3, -1, {1, 0, 0, 0, 1, 0, 0, 0, 1}}}};

constexpr std::array<LinkConstants, kLinkCount> kLinks{{
    {"ground", 0, {}, {}, {}},
    {"body", 9, {0, 0, 0.1}, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {1, 0, 0, 0, 1, 0, 0, 0, 1}},
    {"arm", 1, {0.2, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {1, 0, 0, 0, 1, 0, 0, 0, 1}},
    {"hand", 1, {0.1, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {1, 0, 0, 0, 1, 0, 0, 0, 1}},
    {"ball", 1, {0, 0, 0.1}, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {1, 0, 0, 0, 1, 0, 0, 0, 1}},
}};
constexpr std::array<JointConstants, kJointCount> kJoints{{
    {"base", JointKind::kFloating, 0, 0, 7, 0, 6, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {}, -1, 0, 0, {}},
    {"elbow", JointKind::kRevolute, 1, 7, 1, 6, 1, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {}, -1, 0, 0, {}},
    {"wrist", JointKind::kRevolute, 2, 8, 1, 7, 1, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {}, 1, 2, 0, {}},
    {"neck", JointKind::kSpherical, 1, 9, 4, 8, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {}, -1, 0, 0, {}},
}};
constexpr std::array<OuterForce, kOuterCount> kOuterForces{
    {{"push", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {}}}};
constexpr int kLoopCount = 1;
constexpr std::array<const char*, 1> kLoopNames{"loop"};

}  // namespace

#endif
