// SPDX-License-Identifier: BSD-3-Clause
// Options and states by name: each number comes back to the last bit.
#include "haptics/record/log/named_json.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "haptics/record/log/named_fields.h"

namespace relievo {
namespace {

/// Visits every number below a value, and hands it on.
template <class Take>
struct Leaves {
  Take take;
  template <class T>
  void operator()(const char* name, T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      take(name, value);
    } else if constexpr (requires { value.x; }) {
      for (double* axis : {&value.x, &value.y, &value.z}) take(name, *axis);
    } else if constexpr (requires { value.size(); }) {
      for (auto& one : value) (*this)(name, one);
    } else {
      NamedFields::visit(*this, value);
    }
  }
};
template <class T, class Take>
void forEachLeaf(T& value, const Take& take) {
  Leaves<Take>{take}("", value);
}

/// The bytes of all numbers, without padding.
template <class T>
std::string bytesOf(T value) {
  std::string bytes;
  forEachLeaf(value, [&](const char*, const auto& leaf) {
    bytes.append(reinterpret_cast<const char*>(&leaf), sizeof(leaf));
  });
  return bytes;
}

template <class T>
class NamedJson : public testing::Test {};
using Kinds = testing::Types<HapticOptions, CoreSnapshot>;
TYPED_TEST_SUITE(NamedJson, Kinds);

/// That none is forgotten, NamedFields' own test says.
TYPED_TEST(NamedJson, NamesNoMemberTwice) {
  TypeParam value;
  std::set<const void*> places;
  forEachLeaf(value, [&](const char* name, auto& leaf) {
    EXPECT_TRUE(places.insert(&leaf).second) << name;
  });
}

TYPED_TEST(NamedJson, EveryNumberComesBackToTheLastBit) {
  TypeParam value;
  int n = 0;
  forEachLeaf(value, [&](const char*, auto& leaf) {
    using Leaf = std::remove_reference_t<decltype(leaf)>;
    ++n;
    if constexpr (std::is_same_v<Leaf, double>) {
      constexpr std::array<double, 5> kSpecial{-0.0, 5e-324, 1.7976931348623157e308,
                                               std::numeric_limits<double>::infinity(),
                                               -std::numeric_limits<double>::infinity()};
      leaf = n % 3 == 0 ? kSpecial[static_cast<std::size_t>(n) % 5]
                        : std::sqrt(n) * std::pow(-1e7, n % 5);
    } else if constexpr (std::is_same_v<Leaf, bool>) {
      leaf = !leaf;
    } else if constexpr (std::is_enum_v<Leaf>) {
      leaf = static_cast<Leaf>(1);
    } else {
      leaf = n % 2 == 0 ? std::numeric_limits<Leaf>::max() : std::numeric_limits<Leaf>::min();
    }
  });
  TypeParam back;
  const std::string text = toJson(value);
  EXPECT_EQ(text.find_first_of(" \n"), std::string::npos) << "one word of a line";
  ASSERT_TRUE(fromJson(text, back)) << text;
  EXPECT_NE(bytesOf(value), bytesOf(TypeParam{}));
  EXPECT_TRUE(bytesOf(back) == bytesOf(value)) << text;
}

TYPED_TEST(NamedJson, RefusesWhatAMemberCannotBe) {
  const std::string text = toJson(TypeParam{});
  TypeParam value;
  for (std::size_t end = 1; end < text.size(); end += 13) {
    EXPECT_FALSE(fromJson(text.substr(0, end), value)) << "cut";
  }
  for (const char* other : {"", "{", "[]", "7", "null", "\"text\""}) {
    EXPECT_FALSE(fromJson(other, value)) << other;
  }
}

TEST(NamedOptions, RefuseNumbersOutOfRange) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = toJson(HapticOptions{});
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    HapticOptions options;
    return fromJson(text.replace(at, from.size(), to), options);
  };
  EXPECT_TRUE(with("\"kind\":0", "\"kind\":2"));
  EXPECT_FALSE(with("\"kind\":0", "\"kind\":3"));
  EXPECT_FALSE(with("\"kind\":0", "\"kind\":-1"));
  EXPECT_FALSE(with("\"kind\":0", "\"kind\":0.5"));
  EXPECT_FALSE(with("\"updates_per_tick\":100", "\"updates_per_tick\":3000000000"));
  EXPECT_FALSE(with("\"frame\":false", "\"frame\":0"));
  EXPECT_FALSE(with("\"strength\":0.6", "\"strength\":\"much\""));
  EXPECT_FALSE(with("\"detail_stiffness\":[", "\"detail_stiffness\":[1,"));
}

}  // namespace
}  // namespace relievo
