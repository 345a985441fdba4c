// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/files/read_picture.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "ui/vtk/files/picture_file.h"

namespace relievo {
namespace {

constexpr int kOpaque = 255;

std::size_t bytesOf(const StoredPixels& p) {
  return static_cast<std::size_t>(p.width) * static_cast<std::size_t>(p.height) *
         static_cast<std::size_t>(p.channels);
}

}  // namespace

StoredPixels storedPixels(const RgbaImage& image) {
  StoredPixels pixels{
      .width = image.width, .height = image.height, .channels = 4, .bytes = storedBytes(image)};
  if (pixels.bytes.size() < bytesOf(pixels)) pixels.channels = 3;
  return pixels;
}

StoredPixels storedPixels(const RgbImage& image) {
  return {.width = image.width, .height = image.height, .channels = 3, .bytes = image.rgb};
}

PixelDifference differenceOf(const StoredPixels& a, const StoredPixels& b) {
  const auto channel = [](const StoredPixels& p, std::size_t pixel, int c) -> int {
    if (c >= p.channels) return kOpaque;
    return p.bytes[pixel * static_cast<std::size_t>(p.channels) + static_cast<std::size_t>(c)];
  };
  PixelDifference difference;
  const std::size_t count = static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height);
  for (std::size_t i = 0; i < count; ++i) {
    int most = 0;
    for (int c = 0; c < 4; ++c)
      most = std::max(most, std::abs(channel(a, i, c) - channel(b, i, c)));
    if (most > 0) ++difference.pixels;
    difference.largest = std::max(difference.largest, most);
  }
  return difference;
}

}  // namespace relievo
