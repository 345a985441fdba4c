// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/io/raster/picture_pixels.h"
#include "ui/vtk/offscreen.h"

namespace relievo {

/// As writePng and writeTiff store them.
StoredPixels storedPixels(const RgbaImage& image);
StoredPixels storedPixels(const RgbImage& image);

/// How far two pictures of one size are from each other; without alpha all is opaque.
struct PixelDifference {
  std::size_t pixels = 0;  ///< That differ in any channel.
  int largest = 0;         ///< Of one channel, of 255.
};
/// @pre of one size
PixelDifference differenceOf(const StoredPixels& a, const StoredPixels& b);

}  // namespace relievo
