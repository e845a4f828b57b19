// adagen's runtime, the same for all robots.
#pragma once

#include "memory.hpp"
#include "refine.hpp"
#include "sample/joints.hpp"

namespace {

// A correction: the ground does not accelerate.
inline void begin_answer(Workspace& w) { w.ground = ground(w); }
inline void begin_correction(Workspace& w, const RefinedProcess&) { w.ground.setZero(); }

}  // namespace
