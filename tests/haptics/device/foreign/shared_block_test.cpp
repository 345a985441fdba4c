// SPDX-License-Identifier: BSD-3-Clause
// What two processes that do not trust each other share.
#include "haptics/device/foreign/shared_block.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <thread>

#include "haptics/device/foreign/device_page.h"

namespace relievo::foreign {
namespace {

struct Value {
  std::array<std::uint64_t, 12> words{};
};

TEST(SharedBlock, HasNothingUntilItIsWritten) {
  const SharedBlock<Value> block;
  Value value;
  value.words[3] = 7;
  EXPECT_FALSE(block.read(value));
  EXPECT_EQ(value.words[3], 7U) << "it stays";
}

TEST(SharedBlock, GivesTheNewestWhole) {
  SharedBlock<Value> block;
  std::atomic<bool> done{false};
  std::thread writer([&] {
    constexpr std::uint64_t kWrites = 200'000;
    for (std::uint64_t i = 1; i <= kWrites; ++i) {
      Value value;
      value.words.fill(i);
      block.write(value);
    }
    done.store(true);
  });
  std::uint64_t last = 0;
  while (!done.load()) {
    Value value;
    if (!block.read(value)) continue;
    for (const std::uint64_t word : value.words) ASSERT_EQ(word, value.words[0]) << "torn";
    ASSERT_GE(value.words[0], last);
    last = value.words[0];
  }
  writer.join();
  Value value;
  ASSERT_TRUE(block.read(value));
  EXPECT_EQ(value.words[11], 200'000U);
}

/// The other process may write anything into it.
TEST(SharedBlock, WhoeverWritesIntoItCannotMakeAnybodyWait) {
  SharedBlock<Value> block;
  Value value;
  value.words.fill(5);
  block.write(value);
  const std::uint64_t odd = 9;
  std::memcpy(static_cast<void*>(&block), &odd, sizeof(odd));  // The sequence, as if being written.
  Value read;
  EXPECT_FALSE(block.read(read));
  block.write(value);
  EXPECT_TRUE(block.read(read)) << "its own writer mends it";
  EXPECT_EQ(read.words[0], 5U);
}

TEST(DevicePage, TextsEndInTheirPlaceAndAreNoCommands) {
  HostReport report;
  report.text.fill('x');  // No zero at its end.
  EXPECT_EQ(textOf(report).size(), report.text.size());
  putText(std::string(1000, 'y'), report);
  EXPECT_EQ(textOf(report).size(), report.text.size() - 1);
  putText("a\x1b[2Jb\nc", report);
  EXPECT_EQ(textOf(report), "a [2Jb c");
}

TEST(DevicePage, LimitsThatNoDeviceHasAreImpossible) {
  const ForeignLimits good{.half_extent_mm = {40, 40, 40}, .max_force_n = 5};
  EXPECT_TRUE(arePossible(good));
  const auto with = [&](const auto& change) {
    ForeignLimits limits = good;
    change(limits);
    return arePossible(limits);
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(with([](auto& l) { l.half_extent_mm[1] = 0; }));
  EXPECT_FALSE(with([](auto& l) { l.half_extent_mm[2] = kNan; }));
  EXPECT_FALSE(with([](auto& l) { l.max_force_n = -1; }));
  EXPECT_FALSE(with([](auto& l) { l.max_stiffness_n_per_mm = kNan; }));
  EXPECT_FALSE(with([](auto& l) { l.position_step_mm = 100; }));
  EXPECT_FALSE(with([](auto& l) { l.force_delay_ms = -1; }));
  EXPECT_FALSE(with([](auto& l) { l.rate_hz = 100; }));
  EXPECT_FALSE(with([](auto& l) { l.rate_hz = 1e9; }));
}

TEST(DevicePage, NobodyCanMakeItSmaller) {
  MappedPage page;
  ASSERT_TRUE(page.create());
  EXPECT_NE(::ftruncate(page.fd(), 0), 0);
  EXPECT_NE(::ftruncate(page.fd(), 1 << 20), 0);
}

TEST(DevicePage, AnotherFileIsNone) {
  MappedPage page;
  EXPECT_FALSE(page.open(-1));
  EXPECT_FALSE(MappedPage().open(::open("/dev/null", O_RDWR | O_CLOEXEC)));
}

}  // namespace
}  // namespace relievo::foreign
