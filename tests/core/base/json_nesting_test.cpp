// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/json_nesting.h"

#include <gtest/gtest.h>

#include <string>

namespace relievo {
namespace {

TEST(JsonNesting, CountsListsAndObjectsAlike) {
  EXPECT_FALSE(isNestedDeeper("", 1));
  EXPECT_FALSE(isNestedDeeper("7", 0));
  EXPECT_TRUE(isNestedDeeper("[]", 0));
  EXPECT_FALSE(isNestedDeeper(R"({"a": 1})", 1));
  EXPECT_FALSE(isNestedDeeper(R"([[1], {"a": [2]}, [3]])", 3));
  EXPECT_TRUE(isNestedDeeper(R"([[1], {"a": [2]}, [3]])", 2));
  EXPECT_TRUE(isNestedDeeper(std::string(100'000, '['), 64));
}

TEST(JsonNesting, BracketsInTextsAreNone) {
  EXPECT_FALSE(isNestedDeeper(R"(["[[[{{{"])", 1));
  EXPECT_FALSE(isNestedDeeper(R"(["a\"[[", "\\", "\\\"[["])", 1));
  EXPECT_TRUE(isNestedDeeper(R"(["\\", []])", 1));
  EXPECT_FALSE(isNestedDeeper(R"("\)", 0));
}

}  // namespace
}  // namespace relievo
