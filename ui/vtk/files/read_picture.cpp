// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/files/read_picture.h"

#include <png.h>
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#include "ui/vtk/files/picture_file.h"

namespace relievo {
namespace {

constexpr int kOpaque = 255;

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

std::size_t bytesOf(const StoredPixels& p) {
  return static_cast<std::size_t>(p.width) * static_cast<std::size_t>(p.height) *
         static_cast<std::size_t>(p.channels);
}

// libpng's simple interface catches its own errors.
std::optional<StoredPixels> readPng(const std::filesystem::path& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, decltype(&png_image_free)> freed(&image, png_image_free);
  if (png_image_begin_read_from_file(&image, file.c_str()) == 0) return std::nullopt;
  constexpr png_uint_32 kNotPlain =
      PNG_FORMAT_FLAG_LINEAR | PNG_FORMAT_FLAG_COLORMAP;  // 16 bits a channel, a palette.
  if ((image.format & kNotPlain) != 0 || (image.format & PNG_FORMAT_FLAG_COLOR) == 0) {
    return std::nullopt;
  }
  const bool alpha = (image.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  image.format = alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  StoredPixels pixels{.width = static_cast<int>(image.width),
                      .height = static_cast<int>(image.height),
                      .channels = alpha ? 4 : 3,
                      .bytes = {}};
  pixels.bytes.resize(bytesOf(pixels));
  if (png_image_finish_read(&image, nullptr, pixels.bytes.data(), 0, nullptr) == 0) {
    return std::nullopt;
  }
  return pixels;
}

// The caller says what went wrong; libtiff would also print it.
void beQuiet(const char*, const char*, va_list) {}

std::optional<StoredPixels> readTiff(const std::filesystem::path& file) {
  TIFFSetErrorHandler(beQuiet);
  TIFFSetWarningHandler(beQuiet);
  const std::unique_ptr<TIFF, CloseTiff> tiff(TIFFOpen(file.c_str(), "r"));
  if (!tiff) return std::nullopt;
  std::uint32_t width = 0, height = 0;
  std::uint16_t channels = 0, bits = 0, planes = 0, meaning = 0;
  TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, &channels);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_BITSPERSAMPLE, &bits);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_PLANARCONFIG, &planes);
  TIFFGetField(tiff.get(), TIFFTAG_PHOTOMETRIC, &meaning);
  constexpr std::uint32_t kMostSide = 1U << 20U;
  const bool plain = width > 0 && height > 0 && width <= kMostSide && height <= kMostSide &&
                     (channels == 3 || channels == 4) && bits == 8 &&
                     planes == PLANARCONFIG_CONTIG && meaning == PHOTOMETRIC_RGB &&
                     TIFFIsTiled(tiff.get()) == 0;
  if (!plain) return std::nullopt;
  StoredPixels pixels{.width = static_cast<int>(width),
                      .height = static_cast<int>(height),
                      .channels = channels,
                      .bytes = {}};
  const std::size_t row_bytes = std::size_t{width} * channels;
  if (static_cast<std::size_t>(TIFFScanlineSize64(tiff.get())) != row_bytes) return std::nullopt;
  pixels.bytes.resize(bytesOf(pixels));
  for (std::uint32_t row = 0; row < height; ++row) {
    if (TIFFReadScanline(tiff.get(), pixels.bytes.data() + row * row_bytes, row, 0) != 1) {
      return std::nullopt;
    }
  }
  return pixels;
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

std::optional<StoredPixels> readPixels(const std::filesystem::path& file) {
  const auto format = pictureFormatOf(file);
  if (!format) return std::nullopt;
  return *format == PictureFormat::png ? readPng(file) : readTiff(file);
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
