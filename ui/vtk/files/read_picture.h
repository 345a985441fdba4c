// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "ui/vtk/offscreen.h"

namespace relievo {

/// Pixels as a file stores them.
struct StoredPixels {
  int width = 0, height = 0, channels = 3;  ///< Four: the last is alpha, colours not multiplied.
  std::vector<std::uint8_t> bytes;          ///< Row 0 at the top.
};

/// As writePng and writeTiff store them.
StoredPixels storedPixels(const RgbaImage& image);
StoredPixels storedPixels(const RgbImage& image);

/// Of a PNG or TIFF of 8 bits a channel in red, green and blue, with alpha or without; nothing: the
/// file is none, or it is damaged. [worker]
std::optional<StoredPixels> readPixels(const std::filesystem::path& file);

/// How far two pictures of one size are from each other; without alpha all is opaque.
struct PixelDifference {
  std::size_t pixels = 0;  ///< That differ in any channel.
  int largest = 0;         ///< Of one channel, of 255.
};
/// @pre of one size
PixelDifference differenceOf(const StoredPixels& a, const StoredPixels& b);

}  // namespace relievo
