// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/large/memory_guard.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/error.h"
#include "tests/core/io/temporary_folder.h"

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

/// A made /proc and /sys: what a machine of 8 GB with 6 free says.
class Groups : public ::testing::Test {
 protected:
  Groups() { put("proc/meminfo", "MemTotal: 8000000 kB\nMemAvailable: 6000000 kB\n"); }
  void put(const std::string& name, const std::string& text) {
    const std::filesystem::path file = root_.path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
  }
  std::optional<std::uint64_t> available() const { return availableBytes(root_.path()); }
  static constexpr std::uint64_t kMachine = 6'144'000'000;

 private:
  test::TemporaryFolder root_;
};

TEST_F(Groups, WithoutALimitTheMachineCounts) {
  EXPECT_EQ(available(), kMachine);
  put("proc/self/cgroup", "0::/user.slice/me.scope\n");
  put("sys/fs/cgroup/user.slice/memory.max", "max\n");
  put("sys/fs/cgroup/user.slice/memory.current", "700\n");
  EXPECT_EQ(available(), kMachine);
}

TEST_F(Groups, AGroupsLimitLessItsUseCounts) {
  put("proc/self/cgroup", "0::/user.slice/me.scope\n");
  put("sys/fs/cgroup/user.slice/me.scope/memory.max", "2000000000\n");
  put("sys/fs/cgroup/user.slice/me.scope/memory.current", "1500000000\n");
  EXPECT_EQ(available(), 500'000'000U);
  // What only makes reading faster is given back when asked for.
  put("sys/fs/cgroup/user.slice/me.scope/memory.stat",
      "anon 1100000000\nactive_file 100000000\ninactive_file 300000000\n");
  EXPECT_EQ(available(), 800'000'000U);
  // A group above may leave less.
  put("sys/fs/cgroup/user.slice/memory.max", "3000000000\n");
  put("sys/fs/cgroup/user.slice/memory.current", "2900000000\n");
  EXPECT_EQ(available(), 100'000'000U);
  put("sys/fs/cgroup/user.slice/memory.current", "3100000000\n");
  EXPECT_EQ(available(), 0U) << "above its limit for a moment";
}

TEST_F(Groups, InAContainerTheMountItselfIsTheGroup) {
  put("proc/self/cgroup", "0::/\n");
  put("sys/fs/cgroup/memory.max", "1000000000\n");
  put("sys/fs/cgroup/memory.current", "250000000\n");
  EXPECT_EQ(available(), 750'000'000U);
  put("proc/self/cgroup", "0::/../../seen/from/outside\n");
  EXPECT_EQ(available(), 750'000'000U);
}

TEST_F(Groups, TheOlderVersionCountsToo) {
  put("proc/self/cgroup", "9:cpu,cpuacct:/job\n5:memory:/job\n1:name=systemd:/job\n");
  put("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  put("sys/fs/cgroup/memory/memory.usage_in_bytes", "5000000000\n");
  EXPECT_EQ(available(), kMachine);
  put("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "1000000000\n");
  put("sys/fs/cgroup/memory/job/memory.usage_in_bytes", "900000000\n");
  put("sys/fs/cgroup/memory/job/memory.stat", "inactive_file 1\ntotal_inactive_file 50000000\n");
  EXPECT_EQ(available(), 150'000'000U);
}

}  // namespace
}  // namespace relievo
