// SPDX-License-Identifier: BSD-3-Clause
// Every test has one label that says of which kind it is (docs/dev/testing.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

namespace {

std::string listOfTests() {
  const std::string command =
      "'" RELIEVO_CTEST "' --test-dir '" RELIEVO_BINARY_DIR "' --show-only=json-v1";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(::popen(command.c_str(), "r"),
                                                            &::pclose);
  std::string text;
  std::array<char, 65536> piece{};
  while (const std::size_t read = std::fread(piece.data(), 1, piece.size(), out.get())) {
    text.append(piece.data(), read);
  }
  return text;
}

TEST(Labels, SayOfWhichKindEveryTestIs) {
  const auto list = nlohmann::json::parse(listOfTests(), nullptr, false);
  ASSERT_FALSE(list.is_discarded());
  ASSERT_GT(list["tests"].size(), 100U);
  constexpr std::array<const char*, 4> kKinds{"fast", "gui", "e2e", "device"};
  for (const auto& test : list["tests"]) {
    int kinds = 0;
    for (const auto& property : test["properties"]) {
      if (property["name"] != "LABELS") continue;
      kinds += static_cast<int>(std::count_if(kKinds.begin(), kKinds.end(), [&](const char* kind) {
        const auto& labels = property["value"];
        return std::find(labels.begin(), labels.end(), kind) != labels.end();
      }));
    }
    EXPECT_EQ(kinds, 1) << test["name"];
  }
}

}  // namespace
