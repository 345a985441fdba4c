// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace relievo {

/// One happening, as an HDF5 log has it; the text is cut to what fits.
struct EventRow {
  double time_s = 0;
  double tick = 0;
  std::array<char, 256> text{};

  void take(std::string_view words) {
    std::size_t bytes = std::min(words.size(), text.size() - 1);
    const auto goes_on = [&] {
      return (static_cast<unsigned char>(words[bytes]) & 0xC0U) == 0x80U;
    };
    while (bytes > 0 && bytes < words.size() && goes_on()) --bytes;  // Whole characters.
    words.copy(text.data(), bytes);
  }
};

}  // namespace relievo
