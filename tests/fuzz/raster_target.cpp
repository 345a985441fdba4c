// SPDX-License-Identifier: BSD-3-Clause
// The reader of rasters (ours around GDAL's) under libFuzzer.
#include "core/base/error.h"
#include "core/io/raster/raster.h"
#include "tests/fuzz/input_file.h"
#include "tests/fuzz/invariants.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t bytes) {
  using namespace relievo;
  if (bytes > (1U << 16U)) return 0;
  static const fuzz::InputFile kInput(".tif");
  kInput.write({reinterpret_cast<const char*>(data), bytes});
  std::size_t rows = 0;
  GridSize size;
  RasterSink sink;
  sink.begin = [&](const RasterHead& head, bool /*has_origins*/) {
    // A few bytes may stand for 400 000 000 cells, each of them read: right, but slow.
    constexpr std::uint64_t kMostCells = 10'000;
    size = head.size;
    if (size.count() > kMostCells) throw FileError("Cannot read it: too large here.");
  };
  sink.row = [&](int row, const float* heights, const CellStatus* /*origins*/) {
    fuzz::require(row >= 0 && row < size.rows, "rows are of the raster");
    for (int col = 0; col < size.cols; ++col) {
      fuzz::require(!std::isinf(heights[col]), "heights are finite, or none");
    }
    ++rows;
  };
  try {
    const RasterHead raster = readRasterRows(kInput.path(), sink, {}).head;
    fuzz::require(rows == static_cast<std::size_t>(raster.size.rows), "every row comes once");
    fuzz::require(raster.info.finite_points > 0 && raster.info.bounds.has_value(), "some height");
    fuzz::require(std::isfinite(raster.pixel) && raster.pixel > 0, "a pixel's size");
  } catch (const FileError& error) {
    fuzz::checkMessage(error.what());
  }
  return 0;
}
