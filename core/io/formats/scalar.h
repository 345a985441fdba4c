// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace relievo {

/// Number types of binary scan files.
enum class ScalarType : std::uint8_t { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

inline constexpr std::size_t byteSize(ScalarType type) noexcept {
  constexpr std::array<std::size_t, 10> kSizes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}
inline constexpr bool isWhole(ScalarType type) noexcept {
  return type < ScalarType::f32;
}

enum class ByteOrder : std::uint8_t { little, big };

/// `T` from unaligned bytes of the given order.
template <class T>
T loadAs(const char* at, ByteOrder order) noexcept {
  std::array<char, sizeof(T)> bytes{};
  std::memcpy(bytes.data(), at, sizeof(T));
  constexpr bool kLittleHost = std::endian::native == std::endian::little;
  if ((order == ByteOrder::little) != kLittleHost) {
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
  }
  return std::bit_cast<T>(bytes);
}

/// A stored number as double (64-bit whole numbers lose what double cannot hold).
inline double loadDouble(const char* at, ScalarType type, ByteOrder order) noexcept {
  switch (type) {
    case ScalarType::i8:
      return loadAs<std::int8_t>(at, order);
    case ScalarType::u8:
      return loadAs<std::uint8_t>(at, order);
    case ScalarType::i16:
      return loadAs<std::int16_t>(at, order);
    case ScalarType::u16:
      return loadAs<std::uint16_t>(at, order);
    case ScalarType::i32:
      return loadAs<std::int32_t>(at, order);
    case ScalarType::u32:
      return loadAs<std::uint32_t>(at, order);
    case ScalarType::i64:
      return static_cast<double>(loadAs<std::int64_t>(at, order));
    case ScalarType::u64:
      return static_cast<double>(loadAs<std::uint64_t>(at, order));
    case ScalarType::f32:
      return static_cast<double>(loadAs<float>(at, order));
    case ScalarType::f64:
      return loadAs<double>(at, order);
  }
  return 0;
}

}  // namespace relievo
