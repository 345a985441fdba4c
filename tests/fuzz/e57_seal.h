// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "core/io/e57/crc32c.h"

namespace relievo::fuzz {

/// The same file with right checksums: a fuzzer that must guess them would see nothing else.
inline std::string withChecksums(std::string_view bytes) {
  constexpr std::size_t kPage = 1024;
  constexpr std::size_t kPayload = 1020;
  std::string sealed(bytes);
  for (std::size_t at = 0; at + kPage <= sealed.size(); at += kPage) {
    const std::uint32_t sum = crc32c(std::string_view(sealed).substr(at, kPayload));
    for (std::size_t i = 0; i < 4; ++i) {
      sealed[at + kPayload + i] = static_cast<char>(sum >> (24 - 8 * i) & 0xFFU);
    }
  }
  return sealed;
}

}  // namespace relievo::fuzz
