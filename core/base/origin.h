// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace relievo {

/// Where a height comes from. The numbers are those of files and logs (origin masks).
enum class CellStatus : std::uint8_t {
  measured = 0,
  interpolated = 1,  ///< Sampling gap, or a hole filled on request.
  base_plane = 2,    ///< Enclosed hole resting on the base plane (paper, sec. 6).
  steep = 3,         ///< Measured, but too steep to trust.
  outside = 4,       ///< Not part of the object.
};

inline constexpr std::size_t kOriginCount = 5;
inline constexpr std::array<std::string_view, kOriginCount> kOriginNames{
    "measured", "interpolated", "base plane", "steep", "outside"};

inline constexpr std::string_view name(CellStatus o) noexcept {
  return kOriginNames[static_cast<std::size_t>(o)];
}

}  // namespace relievo
