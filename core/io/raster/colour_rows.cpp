// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/raster/colour_rows.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/io/file_check.h"
#include "core/io/raster/colour_content.h"
#include "core/io/raster/colour_raster.h"
#include "core/io/read_scan.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr double kMostSent = 0xFFFFFF;

std::string_view contentOf(GDALDataset& dataset) {
  const char* const content = dataset.GetMetadataItem(kContentFact);
  return content == nullptr ? std::string_view() : std::string_view(content);
}

}  // namespace

std::optional<RasterEnd> readColourRows(GDALDataset& dataset, RasterHead head,
                                        const RasterSink& sink, const Task& task) {
  const std::string_view content = contentOf(dataset);
  if (content != kColours && content != kIntensities) return std::nullopt;
  const int bands = content == kColours ? 4 : 2;
  const auto refuse = [&](Message reason) {
    throwReadError(head.info.file, std::move(reason), said<MessageId::advice_write_map_again>());
  };
  if (dataset.GetRasterCount() != bands) {
    refuse(said<MessageId::refused_colour_bands>());
  }
  const GridSize size = head.size;
  head.info.format =
      std::string(content == kColours ? kColourRasterFormat : kIntensityRasterFormat);
  const char* const checksum = dataset.GetMetadataItem(kColoursOf);
  head.projection = checksum == nullptr ? "" : checksum;
  const char* const set = dataset.GetMetadataItem(kSetFact);
  head.set = set == nullptr ? "" : set;
  head.size.cols = 2 * size.cols;
  head.info.points = head.info.finite_points = head.size.count();
  head.info.bounds = FileBounds{{0, 0, 0}, {1, 1, kMostSent}};
  sink.begin(head, false);
  const auto cols = static_cast<std::size_t>(size.cols);
  std::vector<std::uint8_t> pixels(cols * static_cast<std::size_t>(bands));
  std::vector<float> row(2 * cols);
  for (int file_row = 0; file_row < size.rows; ++file_row) {
    if (file_row % 16 == 0) task.check();
    if (dataset.RasterIO(GF_Read, 0, file_row, size.cols, 1, pixels.data(), size.cols, 1, GDT_Byte,
                         bands, nullptr, bands, static_cast<GSpacing>(bands) * size.cols, 1,
                         nullptr) != CE_None) {
      refuse(said<MessageId::refused_colour_row>(file_row));
    }
    for (std::size_t i = 0; i < cols; ++i) {
      const std::uint8_t* const p = &pixels[i * static_cast<std::size_t>(bands)];
      row[i] = bands == 4 ? static_cast<float>((p[0] << 16) + (p[1] << 8) + p[2])
                          : static_cast<float>(p[0]);
      row[cols + i] = static_cast<float>(p[bands - 1]);
    }
    sink.row(size.rows - 1 - file_row, row.data(), nullptr);
  }
  return RasterEnd{.head = head, .has_origins = false};
}

}  // namespace relievo
