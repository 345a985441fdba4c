// SPDX-License-Identifier: BSD-3-Clause
// No member of what a replay starts from is without a name. All structs are laid out here without
// padding, so that their size is the sum of their members; nothing else of them is used, and no
// library is linked, which knows them with padding.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#pragma pack(push, 1)
#include "haptics/record/log/named_fields.h"
#pragma pack(pop)

namespace relievo {
namespace {

/// Bytes of all numbers below a value.
template <class T>
std::size_t namedBytes(T& value) {
  if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
    return sizeof(T);
  } else if constexpr (requires { value.x; }) {
    return sizeof(value.x) + sizeof(value.y) + sizeof(value.z);
  } else if constexpr (requires { value.size(); }) {
    return value.size() * namedBytes(value[0]);
  } else {
    std::size_t bytes = 0;
    const auto add = [&bytes](const char*, auto& member) { bytes += namedBytes(member); };
    NamedFields::visit(add, value);
    return bytes;
  }
}

TEST(NamedFields, LeaveNoMemberOfOptionsOrStateWithoutAName) {
  alignas(64) static HapticOptions options;
  alignas(64) static CoreSnapshot snapshot;
  EXPECT_EQ(namedBytes(options), sizeof(HapticOptions));
  EXPECT_EQ(namedBytes(snapshot), sizeof(CoreSnapshot));
}

}  // namespace
}  // namespace relievo
