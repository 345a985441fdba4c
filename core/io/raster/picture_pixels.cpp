// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/raster/picture_pixels.h"

#include <array>
#include <cstddef>

#include "core/io/raster/gdal_session.h"
#include "core/io/raster/tiff_head.h"
#include "core/io/worker/reader_guard.h"

namespace relievo {
namespace {

constexpr int kMostSide = 1 << 20;
constexpr std::uint64_t kMostBytes = 1'000'000'000;  // Less than an answer may have.

/// Red, green and blue of 8 bits each, and perhaps alpha.
bool isPlain(GDALDataset& picture) {
  const int channels = picture.GetRasterCount();
  if (channels != 3 && channels != 4) return false;
  constexpr std::array<GDALColorInterp, 3> kColours{GCI_RedBand, GCI_GreenBand, GCI_BlueBand};
  for (int i = 0; i < channels; ++i) {
    GDALRasterBand& band = *picture.GetRasterBand(i + 1);
    if (band.GetRasterDataType() != GDT_Byte) return false;
    if (i < 3 && band.GetColorInterpretation() != kColours.at(static_cast<std::size_t>(i))) {
      return false;
    }
  }
  const int width = picture.GetRasterXSize(), height = picture.GetRasterYSize();
  const auto bytes = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
                     static_cast<std::uint64_t>(channels);
  return width > 0 && height > 0 && width <= kMostSide && height <= kMostSide &&
         bytes <= kMostBytes;
}

}  // namespace

std::optional<StoredPixels> readPixelsHere(const std::filesystem::path& file) {
  requireReadersAllowed("readPixelsHere");
  registerRasterDrivers();
  const GdalErrors errors;
  if (largestTiffMetadata(file) > kMostTiffMetadata) return std::nullopt;
  constexpr std::array<const char*, 3> kDrivers{"PNG", "GTiff", nullptr};
  constexpr std::array<const char*, 1> kNoSiblings{nullptr};
  const Dataset picture(
      static_cast<GDALDataset*>(GDALOpenEx(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY,
                                           kDrivers.data(), nullptr, kNoSiblings.data())));
  if (!picture || !isPlain(*picture)) return std::nullopt;
  StoredPixels pixels{.width = picture->GetRasterXSize(),
                      .height = picture->GetRasterYSize(),
                      .channels = picture->GetRasterCount(),
                      .bytes = {}};
  const auto columns = static_cast<std::size_t>(pixels.width);
  const auto channels = static_cast<std::size_t>(pixels.channels);
  pixels.bytes.resize(columns * static_cast<std::size_t>(pixels.height) * channels);
  for (int row = 0; row < pixels.height; ++row) {
    std::uint8_t* const to =
        pixels.bytes.data() + static_cast<std::size_t>(row) * columns * channels;
    const CPLErr read = picture->RasterIO(GF_Read, 0, row, pixels.width, 1, to, pixels.width, 1,
                                          GDT_Byte, pixels.channels, nullptr, pixels.channels,
                                          pixels.channels * GSpacing{pixels.width}, 1, nullptr);
    if (read != CE_None || errors.any()) return std::nullopt;
  }
  return pixels;
}

}  // namespace relievo
