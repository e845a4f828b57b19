// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <cstddef>

#include "common.hpp"

namespace {

// Messages through shared memory go from one core's cache to another's. A reader finds them soonest
// in the cache that both cores share, and a writer is done soonest where it has its lines to itself
// already. Only the first lines of a long message: more than a core fetches at once would stop it.
constexpr std::size_t kHandedOver = 64 * kCacheLine, kTakenBack = 24 * kCacheLine;

// What has been written goes to the shared cache (CLDEMOTE, which processors without it ignore).
inline void hand_over([[maybe_unused]] const void* first, [[maybe_unused]] std::size_t bytes) {
#if defined(__x86_64__)
  const char* const line = static_cast<const char*>(first);
  for (std::size_t at = 0; at < std::min(bytes, kHandedOver); at += kCacheLine)
    // No builtin is known to all compilers. NOLINTNEXTLINE(portability-no-assembler)
    asm volatile(".byte 0x0f, 0x1c, 0x00" : : "a"(line + at) : "memory");
#endif
}

// What will be written comes back from where it was read.
inline void take_back(void* first, std::size_t bytes) {
  char* const line = static_cast<char*>(first);
  for (std::size_t at = 0; at < std::min(bytes, kTakenBack); at += kCacheLine)
    __builtin_prefetch(line + at, 1, 3);
}

}  // namespace
