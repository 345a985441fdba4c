// SPDX-License-Identifier: BSD-3-Clause
// Values between two threads: never torn, never out of order. Also run under the thread sanitizer.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <thread>

#include "haptics/rt/spsc_ring.h"
#include "haptics/rt/triple_buffer.h"

namespace relievo {
namespace {

struct Wide {
  std::array<std::uint64_t, 64> words{};
};

bool isWhole(const Wide& value) {
  for (const std::uint64_t word : value.words) {
    if (word != value.words[0]) return false;
  }
  return true;
}

/// The wrong way to do it, for the test to catch: one slot, written while it is read.
struct OneSlot {
  std::array<std::atomic<std::uint64_t>, 64> words{};
  void write(const Wide& value) {
    for (std::size_t i = 0; i < words.size(); ++i) words[i].store(value.words[i]);
  }
  Wide read() const {
    Wide value;
    for (std::size_t i = 0; i < words.size(); ++i) value.words[i] = words[i].load();
    return value;
  }
};

constexpr std::uint64_t kValues = 200'000;

TEST(TripleBuffer, ShowsWholeValuesInOrderAndTheLastOne) {
  TripleBuffer<Wide> buffer;
  std::thread writer([&] {
    for (std::uint64_t i = 1; i <= kValues; ++i) {
      Wide& slot = buffer.back();
      for (std::uint64_t& word : slot.words) word = i;
      buffer.publish();
    }
  });
  std::uint64_t last = 0, torn = 0, backward = 0;
  while (last < kValues) {
    if (!buffer.update()) {
      std::this_thread::yield();
      continue;
    }
    const Wide& value = buffer.front();
    torn += isWhole(value) ? 0 : 1;
    backward += value.words[0] <= last ? 1 : 0;
    last = value.words[0];
  }
  writer.join();
  EXPECT_EQ(torn, 0U);
  EXPECT_EQ(backward, 0U);
  EXPECT_FALSE(buffer.update()) << "nothing newer than the last";
}

TEST(TripleBuffer, AWrongExchangeWouldBeSeen) {
  OneSlot slot;
  std::atomic<bool> stop{false};
  std::thread writer([&] {
    Wide value;
    for (std::uint64_t i = 1; !stop.load(); ++i) {
      value.words.fill(i);
      slot.write(value);
    }
  });
  bool torn = false;
  for (int i = 0; i < 50'000'000 && !torn; ++i) torn = !isWhole(slot.read());
  stop.store(true);
  writer.join();
  EXPECT_TRUE(torn);
}

TEST(SpscRing, DeliversEveryItemOnceAndInOrder) {
  SpscRing<std::uint64_t, 64> ring;
  std::thread producer([&] {
    for (std::uint64_t i = 1; i <= kValues; ++i) {
      while (!ring.push(i)) std::this_thread::yield();
    }
  });
  std::uint64_t expected = 1, wrong = 0, item = 0;
  while (expected <= kValues) {
    if (!ring.pop(item)) {
      std::this_thread::yield();
      continue;
    }
    wrong += item == expected ? 0 : 1;
    ++expected;
  }
  producer.join();
  EXPECT_EQ(wrong, 0U);
  EXPECT_FALSE(ring.pop(item));
}

TEST(SpscRing, DropsTheNewestWhenFullAndCountsIt) {
  SpscRing<int, 4> ring;
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(ring.push(i));
  EXPECT_FALSE(ring.push(4));
  EXPECT_FALSE(ring.push(5));
  EXPECT_EQ(ring.dropped(), 2U);
  int item = -1;
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(ring.pop(item));
    EXPECT_EQ(item, i);
  }
  EXPECT_FALSE(ring.pop(item));
  EXPECT_TRUE(ring.push(6));
}

}  // namespace
}  // namespace relievo
