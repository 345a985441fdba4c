// SPDX-License-Identifier: BSD-3-Clause
// LZF: a byte below 32 is a run of that many bytes and one more, as they are. Any other is a copy:
// its upper three bits are the length less 2 (7: a byte follows that is added), its lower five and
// the next byte how far back it begins, less 1.
#include "core/io/formats/lzf.h"

#include <cstdint>
#include <cstring>

namespace relievo {

std::vector<char> unpackLzf(std::string_view packed, std::size_t size) {
  std::vector<char> bytes(size);
  std::size_t at = 0, to = 0;
  const auto byte = [&packed](std::size_t i) { return static_cast<std::uint8_t>(packed[i]); };
  while (at < packed.size()) {
    const std::size_t control = byte(at++);
    if (control < 32) {
      const std::size_t length = control + 1;
      if (length > packed.size() - at || length > size - to) return {};
      std::memcpy(bytes.data() + to, packed.data() + at, length);
      at += length;
      to += length;
      continue;
    }
    std::size_t length = control >> 5U;
    if (length == 7) {
      if (at >= packed.size()) return {};
      length += byte(at++);
    }
    length += 2;
    if (at >= packed.size()) return {};
    const std::size_t back = ((control & 0x1FU) << 8U) + byte(at++) + 1;
    if (back > to || length > size - to) return {};
    // Byte by byte: a copy may overlap itself, which repeats what it begins with.
    for (std::size_t i = 0; i < length; ++i, ++to) bytes[to] = bytes[to - back];
  }
  if (to != size) return {};
  return bytes;
}

}  // namespace relievo
