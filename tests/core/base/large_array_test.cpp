// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/large_array.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>
#include <string>

namespace relievo {
namespace {

/// What the system says of the memory an address lies in (proc(5), smaps): "VmFlags: rd wr ...".
std::string flagsOf(const void* address) {
  std::ifstream maps("/proc/self/smaps");
  const auto wanted = reinterpret_cast<std::uintptr_t>(address);
  bool inside = false;
  for (std::string line; std::getline(maps, line);) {
    std::uintptr_t from = 0;
    std::uintptr_t to = 0;
    char dash = 0;
    std::istringstream range(line);
    if (range >> std::hex >> from >> dash >> to && dash == '-') {
      inside = from <= wanted && wanted < to;
    } else if (inside && line.starts_with("VmFlags:")) {
      return line;
    }
  }
  return {};
}

TEST(LargeArray, AsksForLargePages) {
  if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage")) {
    GTEST_SKIP() << "this system has no large pages";
  }
  const LargeArray<float> numbers(4 << 20);
  const std::string flags = flagsOf(&numbers[2 << 20]);
  ASSERT_FALSE(flags.empty());
  EXPECT_NE(flags.find(" hg"), std::string::npos) << flags;
}

TEST(LargeArray, KeepsItsNumbersWhenItGrowsAndIsCopied) {
  LargeArray<float> numbers(1 << 20);
  std::iota(numbers.begin(), numbers.end(), 0.0F);
  numbers.resize(3 << 20);
  numbers.push_back(-1);
  const LargeArray<float> copy = numbers;
  EXPECT_EQ(copy[0], 0);
  EXPECT_EQ(copy[(1 << 20) - 1], (1 << 20) - 1);
  EXPECT_EQ(copy.back(), -1);
  EXPECT_EQ(LargeArray<float>(3, 0.5F), (LargeArray<float>{0.5F, 0.5F, 0.5F}));
}

}  // namespace
}  // namespace relievo
