// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <thread>

#include "common.hpp"
#include "constants.hpp"
#include "relax.hpp"
#include "sample/messages.hpp"
#include "shared_lines.hpp"
#include "sizes.hpp"
#include "stamp.hpp"
#include "status.hpp"
#include "waited.hpp"

#define ADAGEN_CHANNEL  // there is one

namespace {

// Exchange between threads of one process: a message is a slot that its source fills and then
// numbers (release), and that its target reads once it sees the number (acquire). A message has two
// slots, used in turn: when one is written again, two evaluations later, its target has answered
// in the one between.
template <std::size_t numbers>
struct alignas(kCacheLine) Slot {
  std::atomic<std::uint64_t> number{0};
  alignas(kCacheLine) std::array<Number, numbers> content{};  // the status, then the message
};

constexpr std::size_t most_numbers() {
  int most = 0;
  for (const MessageInfo& info : kMessages) most = std::max(most, info.size);
  return static_cast<std::size_t>(most) + 1;
}
using Slots = std::array<std::array<Slot<most_numbers()>, 2>, kMessages.size()>;

class Channel {
 public:
  void open(int rank, Slots& slots, std::chrono::nanoseconds time_limit) {
    rank_ = rank, slots_ = &slots, time_limit_ = time_limit;
  }

  // Where to write message k.
  Number* outgoing(int k, int&) { return slot(k, counts_[at(k)] + 1).content.data() + 1; }

  void send(int k, int& status) {
    const std::uint64_t number = ++counts_[at(k)];
    auto& [place, content] = slot(k, number);
    content[0] = static_cast<Number>(status);
    place.store(number, std::memory_order_release);
    const std::size_t bytes = static_cast<std::size_t>(kMessages[at(k)].size + 1) * sizeof(Number);
    hand_over(&place, sizeof place), hand_over(content.data(), bytes);
    take_back(slot(k, number + 1).content.data(), bytes);
  }

  // Waits for message k and returns its content; what its source knows of failures joins the
  // status.
  const Number* receive(int k, int& status) {
    const std::uint64_t number = ++counts_[at(k)];
    auto& [place, content] = slot(k, number);
    if (!wait_for(place, number, kMessages[at(k)].source)) fail(status, no_answer());
    if (failure_kind(status) != kNoAnswer) fail(status, static_cast<int>(content[0]));
    return content.data() + 1;
  }

  // Waits until a number is reached: spins briefly, then yields, so that more threads than cores
  // still finish. Whether it was in time.
  bool wait_for(const std::atomic<std::uint64_t>& place, std::uint64_t number, int process) {
    for (int k = 0; k < 4000; ++k) {
      if (place.load(std::memory_order_acquire) >= number) return true;
      relax();
    }
    if (broken()) return false;  // a thread is late already: do not wait for it once more
    Waited waited(time_limit_);
    while (place.load(std::memory_order_acquire) < number) {
      std::this_thread::yield();
      if (waited.too_long()) return lost_ = process, false;
    }
    return true;
  }

  static void fail(int& status, int failure) {
    if (status == kFine) status = failure;
  }

  int rank() const { return rank_; }
  // Whether a thread did not answer in time, now or before, and the failure that this is.
  bool broken() const { return lost_ >= 0; }
  int no_answer() const { return failure(kNoAnswer, lost_); }
  static constexpr bool windowed() { return false; }
  static constexpr const char* name() { return "threads"; }

 private:
  static constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }
  Slot<most_numbers()>& slot(int k, std::uint64_t number) { return (*slots_)[at(k)][number & 1]; }

  int rank_ = 0;
  Slots* slots_ = nullptr;
  std::chrono::nanoseconds time_limit_{};
  int lost_ = -1;  // the process of the first thread that did not answer in time
  std::array<std::uint64_t, kMessages.size()> counts_{};
};

}  // namespace
