// Messages between threads of one program: adagen/channel_threads.hpp.
#include <chrono>
#include <cstddef>
#include <memory>
#include <thread>

#include "adagen/channel_threads.hpp"
#include "doctest/doctest.h"

using namespace std::chrono_literals;

TEST_CASE("thousands of messages there and back arrive whole and in order") {
  const auto slots = std::make_unique<Slots>();
  constexpr int kRounds = 20000;
  std::thread other([&slots] {
    Channel channel;
    channel.open(1, *slots, 20s);
    for (int round = 0; round < kRounds; ++round) {
      int status = kFine;
      const Number* const got = channel.receive(0, status);
      double sum = 0;
      for (int k = 0; k < kMessages[0].size; ++k) sum += got[k];
      Number* const to = channel.outgoing(1, status);
      for (int k = 0; k < kMessages[1].size; ++k) to[k] = sum + k;
      channel.send(1, status);
    }
  });
  Channel channel;
  channel.open(0, *slots, 20s);
  int wrong = 0;
  for (int round = 0; round < kRounds; ++round) {
    int status = kFine;
    Number* const to = channel.outgoing(0, status);
    double sum = 0;
    for (int k = 0; k < kMessages[0].size; ++k) sum += to[k] = round + k;
    channel.send(0, status);
    const Number* const got = channel.receive(1, status);
    for (int k = 0; k < kMessages[1].size; ++k) wrong += got[k] != sum + k;
    wrong += status != kFine;
  }
  other.join();
  CHECK(wrong == 0);
  CHECK(!channel.broken());
}

TEST_CASE("failures travel with messages; the first one is told") {
  const auto slots = std::make_unique<Slots>();
  Channel from, to;
  from.open(0, *slots, 1s), to.open(1, *slots, 1s);
  int status = failure(kOverflow, 2);
  from.outgoing(0, status);
  from.send(0, status);
  int found = kFine;
  to.receive(0, found);
  CHECK(found == failure(kOverflow, 2));
  from.outgoing(0, status);
  from.send(0, status);
  found = failure(kNotFinite, 1);
  to.receive(0, found);
  CHECK(found == failure(kNotFinite, 1));
}

TEST_CASE("who waits for nobody is told who did not answer, and waits no second time") {
  const auto slots = std::make_unique<Slots>();
  Channel channel;
  channel.open(0, *slots, 30ms);
  int status = kFine;
  channel.receive(1, status);
  CHECK(status == failure(kNoAnswer, kMessages[1].source));
  CHECK(channel.broken());
  const auto start = std::chrono::steady_clock::now();
  channel.receive(3, status);
  CHECK(std::chrono::steady_clock::now() - start < 30ms);
}
