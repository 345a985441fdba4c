// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/formats/texture_file.h"

#include <gdal_frmts.h>

#include <array>
#include <mutex>
#include <vector>

#include "core/io/file_check.h"
#include "core/io/raster/gdal_session.h"
#include "core/io/raster/tiff_head.h"
#include "core/io/worker/reader_guard.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr int kMostSide = 16384;

void registerPictureDrivers() {
  static std::once_flag once;
  registerRasterDrivers();
  std::call_once(once, [] { GDALRegister_JPEG(); });
}

/// One band as bytes: of 16 bits the upper eight.
bool readBand(GDALRasterBand& band, std::size_t channel, Texture& texture) {
  const auto cols = static_cast<int>(texture.cols);
  std::vector<std::uint16_t> row(texture.cols);
  const bool words = band.GetRasterDataType() != GDT_Byte;
  for (int y = 0; y < static_cast<int>(texture.rows); ++y) {
    if (band.RasterIO(GF_Read, 0, y, cols, 1, row.data(), cols, 1, GDT_UInt16, 0, 0, nullptr) !=
        CE_None) {
      return false;
    }
    Rgba* const to = texture.texels.data() + static_cast<std::size_t>(y) * texture.cols;
    for (std::size_t x = 0; x < texture.cols; ++x) {
      to[x][channel] = static_cast<std::uint8_t>(words ? row[x] >> 8U : row[x]);
    }
  }
  return true;
}

void applyPalette(const GDALColorTable& table, Texture& texture) {
  for (Rgba& texel : texture.texels) {
    const GDALColorEntry* const entry = table.GetColorEntry(texel[0]);
    if (entry == nullptr) continue;
    texel = {static_cast<std::uint8_t>(entry->c1), static_cast<std::uint8_t>(entry->c2),
             static_cast<std::uint8_t>(entry->c3), texel[3]};
  }
}

bool readTexels(GDALDataset& dataset, Texture& texture) {
  texture.texels.assign(std::size_t{texture.cols} * texture.rows, Rgba{0, 0, 0, 255});
  const int bands = dataset.GetRasterCount();
  const bool grey = bands < 3;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const int band = grey ? 1 : static_cast<int>(channel) + 1;
    if (!readBand(*dataset.GetRasterBand(band), channel, texture)) return false;
  }
  const GDALColorTable* const palette = dataset.GetRasterBand(1)->GetColorTable();
  if (grey && palette != nullptr) applyPalette(*palette, texture);
  return true;
}

}  // namespace

std::optional<Texture> readTexture(const std::filesystem::path& file, std::uint64_t most_texels,
                                   std::optional<Message>& reason) {
  requireReadersAllowed("readTexture");
  registerPictureDrivers();
  const GdalErrors errors;
  if (largestTiffMetadata(file) > kMostTiffMetadata) {
    reason = said<MessageId::picture_metadata>();
    return std::nullopt;
  }
  constexpr std::array<const char*, 4> kDrivers{"PNG", "JPEG", "GTiff", nullptr};
  constexpr std::array<const char*, 1> kNoSiblings{nullptr};
  const Dataset dataset(
      static_cast<GDALDataset*>(GDALOpenEx(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY,
                                           kDrivers.data(), nullptr, kNoSiblings.data())));
  if (!dataset || dataset->GetRasterCount() < 1) {
    reason = said<MessageId::picture_other_format>();
    return std::nullopt;
  }
  const int cols = dataset->GetRasterXSize(), rows = dataset->GetRasterYSize();
  if (cols < 1 || rows < 1 || cols > kMostSide || rows > kMostSide ||
      static_cast<std::uint64_t>(cols) * static_cast<std::uint64_t>(rows) > most_texels) {
    reason = said<MessageId::texture_too_large>(cols, rows);
    return std::nullopt;
  }
  const GDALDataType type = dataset->GetRasterBand(1)->GetRasterDataType();
  if (type != GDT_Byte && type != GDT_UInt16) {
    reason = said<MessageId::picture_other_depth>();
    return std::nullopt;
  }
  Texture texture;
  texture.cols = static_cast<std::uint32_t>(cols);
  texture.rows = static_cast<std::uint32_t>(rows);
  if (!readTexels(*dataset, texture) || errors.any()) {
    reason = said<MessageId::picture_not_decoded>(printable(errors.first()));
    return std::nullopt;
  }
  return texture;
}

}  // namespace relievo
