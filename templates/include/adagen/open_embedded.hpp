// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace {

constexpr char kTooSmall[] = "the memory is too small for a solver";

// A solver in memory that is given.
template <class AnySolver>
AnySolver* opened(void* memory, std::size_t size, std::size_t needed) {
  static_assert(std::is_trivially_destructible_v<AnySolver>);
  if (memory == nullptr || size < needed) return nullptr;
  const std::size_t beyond = reinterpret_cast<std::uintptr_t>(memory) % alignof(AnySolver);
  const std::size_t before = beyond == 0 ? 0 : alignof(AnySolver) - beyond;
  return new (static_cast<unsigned char*>(memory) + before) AnySolver;
}

}  // namespace
