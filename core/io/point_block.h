// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/base/vec3.h"

namespace relievo {

inline constexpr std::size_t kPointBlock = 1024;  ///< Points: 12 kB, in the nearest memory.

/// Some points that are looked at together, which takes a tenth of the time of one after the other.
using PointBlock = std::array<std::array<float, 3>, kPointBlock>;

struct BlockBox {
  std::array<float, 3> low{}, high{};
  bool is_usable = false;  ///< No coordinate is NaN, infinite or beyond kFarthestCoordinate.
};

/// Of the first `count` points. What lies behind them is written over.
/// @pre 1 <= count <= kPointBlock
BlockBox boxOf(PointBlock& block, std::size_t count);

/// No coordinate is NaN or infinite. Of any number of points.
bool areFinite(std::span<const std::array<float, 3>> points);

/// Each as double less `origin`, to float. @pre as above
void moveTo(const FilePoint& origin, PointBlock& block, std::size_t count);

}  // namespace relievo
