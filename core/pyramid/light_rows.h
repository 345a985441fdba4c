// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/depth/colours/linear_light.h"

namespace relievo {

/// Rows of colours as numbers that may be averaged, and back: per channel light times weight, and
/// last the weight. One plane a channel, in the order of the stored bytes; alpha's is the weight.
/// For pixels of 4 bytes (colours) and of 2 (intensities).
template <std::size_t Size>
class LightOfRows {
 public:
  using Pixel = std::array<std::uint8_t, Size>;

  /// @param finest  of the map itself: what is interpolated there weighs next to nothing, and so
  ///                decides only alone; else alpha is the share that comes from the scan
  LightOfRows(const Transfer& transfer, bool finest);

  /// @param planes  Size of them, `cols` values each, one after the other
  void split(const Pixel* pixels, std::size_t cols, float* planes) const;
  /// @param planes  Size of them; a weight of 0 gives no colour
  void join(const std::array<const float*, Size>& planes, std::size_t cols, Pixel* pixels) const;

 private:
  const Transfer* transfer_;
  std::array<float, 256> light_{}, weights_{};
};

extern template class LightOfRows<4>;
extern template class LightOfRows<2>;

/// Of colours, of intensities.
template <std::size_t Size>
const Transfer& transferOf() {
  return Size == 4 ? sRgb() : proportional();
}

}  // namespace relievo
