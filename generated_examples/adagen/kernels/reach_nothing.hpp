// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "../value.hpp"
#include "algebra.hpp"
#include "lanes.hpp"
#include "memory.hpp"
#include "weights.hpp"

namespace {

// Without certificates nothing is kept of links' accelerations.
ADAGEN_INLINE Reached<Value> reached_at(const Workspace&, int) { return Reached<Value>{}; }
template <class T>
ADAGEN_INLINE void reach(Workspace&, const Joints<T>&, JointKind, const Motion<T>&, Reached<T>&) {}
ADAGEN_INLINE void reach_back(Workspace&, int, JointKind, const Motion<Value>&, Reached<Value>&) {}
ADAGEN_INLINE void keep_reached(Workspace&, std::size_t, const Reached<Value>&) {}

}  // namespace
