// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace relievo {

/// Stored colour bytes and quantities that may be averaged. Files store colours for the screen
/// (sRGB, IEC 61966-2-1); light adds up linearly, so means of colours are taken in linear light of
/// 12 bits: black and white make 188, not 128. Every byte comes back as itself.
struct Transfer {
  static constexpr std::uint32_t kMost = 4095;

  std::array<std::uint16_t, 256> light{};        ///< Of a stored byte, 0 ... kMost.
  std::array<std::uint8_t, kMost + 1> stored{};  ///< Of light, to the nearest byte.

  /// For a mean with a fraction, 0 ... kMost. Beyond is held at the ends.
  std::uint8_t storedOf(float mean) const noexcept {
    constexpr auto kHighest = static_cast<float>(kMost);
    if (!(mean > 0)) return stored.front();
    return mean < kHighest ? stored[static_cast<std::size_t>(mean + 0.5F)] : stored.back();
  }
};

/// Of colours. [any thread]
const Transfer& sRgb();
/// Of intensities: a stored byte stands for a quantity that is linear itself. [any thread]
const Transfer& proportional();

}  // namespace relievo
