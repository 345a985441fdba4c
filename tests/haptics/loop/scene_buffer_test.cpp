// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/scene_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace relievo {
namespace {

struct Wide {
  std::array<std::uint64_t, 512> words{};
};

bool isWhole(const Wide& value) {
  return std::all_of(value.words.begin(), value.words.end(),
                     [&](std::uint64_t w) { return w == value.words[0]; });
}

TEST(SceneBuffer, KeepsTheValueBefore) {
  SceneBuffer<int> buffer;
  EXPECT_FALSE(buffer.update());
  buffer.write(1);
  ASSERT_TRUE(buffer.update());
  EXPECT_EQ(buffer.front(), 1);
  for (int i = 2; i < 10; ++i) {
    buffer.write(100 + i);
    buffer.write(i);
    ASSERT_TRUE(buffer.update());
    EXPECT_EQ(buffer.front(), i) << "the newest";
    EXPECT_EQ(buffer.previous(), i - 1) << "what was shown before, not what was skipped";
    EXPECT_FALSE(buffer.update());
  }
}

TEST(SceneBuffer, NeitherValueIsEverTorn) {
  constexpr std::uint64_t kValues = 60'000;
  SceneBuffer<Wide> buffer;
  std::thread writer([&] {
    for (std::uint64_t i = 1; i <= kValues; ++i) {
      buffer.back().words.fill(i);
      buffer.publish();
    }
  });
  std::uint64_t torn = 0, wrong = 0, last = 0;
  while (last < kValues) {
    if (!buffer.update()) {
      std::this_thread::yield();
      torn += isWhole(buffer.previous()) ? 0 : 1;
      continue;
    }
    torn += isWhole(buffer.front()) && isWhole(buffer.previous()) ? 0 : 1;
    wrong += buffer.previous().words[0] == last && buffer.front().words[0] > last ? 0 : 1;
    last = buffer.front().words[0];
  }
  writer.join();
  EXPECT_EQ(torn, 0U);
  EXPECT_EQ(wrong, 0U);
}

}  // namespace
}  // namespace relievo
