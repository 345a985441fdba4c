// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/message/message.h"

namespace relievo::falcon {

/// What a stream for TI's C28x serial boot loader holds: 16-bit words, low byte first; the key
/// 0x08aa, eight reserved words, the entry point, then blocks {words, address, contents} up to one
/// of no words, which must end the file. 32-bit numbers have the high word first.
struct BootImage {
  std::uint32_t entry = 0;
  std::size_t blocks = 0;
  std::size_t words = 0;           ///< Of all blocks.
  std::optional<Message> problem;  ///< Why it is none: "it ends in block 3".
  bool good() const noexcept { return !problem; }
};

inline constexpr std::size_t kLeastImageBytes = 2048, kMostImageBytes = 65536;

BootImage inspectBootImage(std::span<const std::uint8_t> bytes);

}  // namespace relievo::falcon
