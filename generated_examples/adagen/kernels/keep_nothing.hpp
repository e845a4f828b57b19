// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "algebra.hpp"
#include "lanes.hpp"
#include "memory.hpp"

namespace {

// Without refinement nothing is kept of joints' forces.
template <class T, class X>
ADAGEN_INLINE void keep_body(Workspace&, const Joints<T>&, const X&) {}
template <bool reversed, class T>
ADAGEN_INLINE void keep_force(Workspace&, const Joints<T>&, const Motion<T>&) {}
template <class T>
ADAGEN_INLINE void keep_load(Workspace&, int, const T&, const T&) {}
[[maybe_unused]] inline void keep_side(Workspace&, std::size_t) {}

}  // namespace
