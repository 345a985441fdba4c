// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace relievo::test {

inline constexpr std::uint32_t kMadeEntry = 0x3F8000;

/// A boot stream of the right form, with made-up contents: nobody's firmware.
/// @param padded_to  zeros are appended up to this size (a file that then is no good stream)
inline std::vector<std::uint8_t> madeImage(const std::vector<std::uint16_t>& blocks,
                                           std::size_t padded_to = 0) {
  std::vector<std::uint8_t> bytes;
  const auto word = [&bytes](std::uint32_t value) {
    bytes.push_back(static_cast<std::uint8_t>(value & 0xFFU));
    bytes.push_back(static_cast<std::uint8_t>((value >> 8U) & 0xFFU));
  };
  word(0x08aa);
  for (int i = 0; i < 8; ++i) word(0);
  word(kMadeEntry >> 16U);
  word(kMadeEntry & 0xFFFFU);
  std::uint32_t address = kMadeEntry;
  std::uint32_t content = 1;
  for (const std::uint16_t words : blocks) {
    word(words);
    word(address >> 16U);
    word(address & 0xFFFFU);
    for (int i = 0; i < words; ++i) {
      content = content * 1664525U + 1013904223U;  // Every byte value occurs, '<' and '>' too.
      word(content >> 16U);
    }
    address += words;
  }
  word(0);
  while (bytes.size() < padded_to) bytes.push_back(0);
  return bytes;
}

/// As large as the images that exist.
inline std::vector<std::uint8_t> madeImage() {
  return madeImage({3000, 500, 700, 4, 1});
}

}  // namespace relievo::test
