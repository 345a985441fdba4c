// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/e57/crc32c.h"

#include <array>

#include "core/io/formats/scalar.h"

namespace relievo {
namespace {

constexpr std::uint32_t kPolynomial = 0x82F63B78;  // Reflected.
using Table = std::array<std::array<std::uint32_t, 256>, 8>;

/// table[k][b]: what byte b becomes after k further zero bytes; eight bytes go in one step.
constexpr Table makeTable() {
  Table table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? kPolynomial : 0U);
    table[0][byte] = crc;
  }
  for (std::size_t byte = 0; byte < 256; ++byte) {
    for (std::size_t k = 1; k < 8; ++k) {
      const std::uint32_t before = table[k - 1][byte];
      table[k][byte] = (before >> 8) ^ table[0][before & 0xFFU];
    }
  }
  return table;
}

constexpr Table kTable = makeTable();

}  // namespace

std::uint32_t crc32c(std::string_view bytes) noexcept {
  std::uint32_t crc = ~0U;
  for (; bytes.size() >= 8; bytes.remove_prefix(8)) {
    const std::uint32_t low = loadAs<std::uint32_t>(bytes.data(), ByteOrder::little) ^ crc;
    const auto high = loadAs<std::uint32_t>(bytes.data() + 4, ByteOrder::little);
    crc = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      crc ^= kTable[7 - i][(low >> (8 * i)) & 0xFFU] ^ kTable[3 - i][(high >> (8 * i)) & 0xFFU];
    }
  }
  for (const char byte : bytes) {
    crc = (crc >> 8) ^ kTable[0][(crc ^ static_cast<unsigned char>(byte)) & 0xFFU];
  }
  return ~crc;
}

}  // namespace relievo
