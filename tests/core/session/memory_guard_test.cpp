// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/memory_guard.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace relievo {
namespace {

constexpr GridFrame kMap{
    .size = {.cols = 10000, .rows = 10000}, .spacing_mm = 0.1, .first_x_mm = 0, .first_y_mm = 0};

TEST(MemoryGuard, AMapThatFitsIsLetThroughAndAnUnknownMemoryToo) {
  EXPECT_NO_THROW(requireMemory(kMap, surfaceBytes(kMap.size)));
  EXPECT_NO_THROW(requireMemory(kMap, std::nullopt));
}

TEST(MemoryGuard, AMapThatDoesNotFitIsRefusedWithASpacingThatDoes) {
  const std::uint64_t free_bytes = surfaceBytes(kMap.size) / 6;
  try {
    requireMemory(kMap, free_bytes);
    FAIL() << "nothing was refused";
  } catch (const ArgumentError& error) {
    EXPECT_EQ(error.code, "E102");
    // A sixth of the memory, two thirds of it used: nine times fewer cells, three times wider.
    EXPECT_NE(std::string(error.what()).find("at least 0.3 mm"), std::string::npos) << error.what();
  }
}

TEST(MemoryGuard, TheSystemSaysHowMuchIsFree) {
  const auto free_bytes = availableBytes();
  ASSERT_TRUE(free_bytes);
  EXPECT_GT(*free_bytes, 1U << 20U);
}

}  // namespace
}  // namespace relievo
