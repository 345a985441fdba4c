// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/origin.h"
#include "core/depth/colours/colours.h"
#include "core/depth/colours/linear_light.h"

namespace relievo {

// How the points of a cell make its colour: what maps in memory and maps by tiles share.

template <std::size_t Channels>
using Light = std::array<std::uint16_t, Channels>;

/// Do points give this cell a colour at all?
inline bool takesColours(CellStatus origin) noexcept {
  return origin == CellStatus::measured || origin == CellStatus::steep;
}

/// Does the cell have its height from about there? @param z  of the point, above the base plane
inline bool isOfLayer(float z, float height_mm, double spacing_mm) noexcept {
  return std::abs(static_cast<double>(z) - static_cast<double>(height_mm)) <=
         kColourDepthCells * spacing_mm;
}

/// ColourRule::layer. Whole numbers: the same sum in any order, and for any number of threads.
template <std::size_t Channels>
struct MeanCell {
  std::array<std::uint32_t, Channels> sums{};
  std::uint32_t points = 0;

  void add(const Light<Channels>& light, float /*z*/) noexcept {
    constexpr std::uint32_t kMostPoints = 1U << 20U;  // Sums of 12 bits fit into 32.
    if (points == kMostPoints) return;
    for (std::size_t k = 0; k < Channels; ++k) sums[k] += light[k];
    ++points;
  }
  bool any() const noexcept { return points > 0; }
  std::uint32_t light(std::size_t k) const noexcept { return (sums[k] + points / 2) / points; }
};

/// ColourRule::winner. Of points at the same height the lighter one counts, so that their order
/// does not.
template <std::size_t Channels>
struct FrontCell {
  float z_mm = -std::numeric_limits<float>::infinity();
  Light<Channels> front{};

  void add(const Light<Channels>& light, float z) noexcept {
    if (z < z_mm || (z == z_mm && !(light > front))) return;
    z_mm = z;
    front = light;
  }
  bool any() const noexcept { return z_mm > -std::numeric_limits<float>::infinity(); }
  std::uint32_t light(std::size_t k) const noexcept { return front[k]; }
};

/// What is seen of a cell.
template <std::size_t Channels, class CellSums>
std::array<std::uint8_t, Channels + 1> pixelOf(const CellSums& cell, const Transfer& transfer) {
  std::array<std::uint8_t, Channels + 1> pixel{};
  if (!cell.any()) return pixel;
  for (std::size_t k = 0; k < Channels; ++k) pixel[k] = transfer.stored[cell.light(k)];
  pixel[Channels] = kStoredAlpha;
  return pixel;
}

/// How many points have each of the 65536 intensities.
using IntensityCounts = std::vector<std::uint64_t>;

/// Which intensities are shown as black and as white: the middle 96 % of the scan's.
class IntensityStretch {
 public:
  explicit IntensityStretch(const IntensityCounts& counts);

  std::uint16_t light(std::uint16_t intensity) const noexcept { return light_[intensity]; }
  /// As numbers of the file. @param stored  ScanInfo::intensity
  IntensityRange shown(const std::optional<IntensityRange>& stored) const noexcept;

 private:
  std::uint32_t low_ = 0, high_ = 65535;
  std::vector<std::uint16_t> light_;
};

}  // namespace relievo
