// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "sizes.hpp"

namespace {

// Bytes of the machine's widest registers.
#if defined(__AVX512F__)
constexpr std::size_t kRegisterBytes = 64;
#elif defined(__AVX__)
constexpr std::size_t kRegisterBytes = 32;
#else
constexpr std::size_t kRegisterBytes = 16;
#endif
#if defined(ADAGEN_BATCH) && !defined(ADAGEN_STATE_BY_STATE)
constexpr std::size_t kLaneBytes = kRegisterBytes;  // one state in each lane
#else
constexpr std::size_t kLaneBytes = 64;  // as the plan has it; narrower machines take them in parts
#endif

// Numbers side by side.
[[maybe_unused]] constexpr int kLanes = static_cast<int>(kLaneBytes / sizeof(Real));
typedef Real Lanes __attribute__((vector_size(kLaneBytes)));

#if defined(ADAGEN_BATCH) && !defined(ADAGEN_STATE_BY_STATE)
using Value = Lanes;  // what is computed with
#else
using Value = Real;  // what is computed with
#endif

}  // namespace
