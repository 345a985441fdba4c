// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/firmness.h"

#include <algorithm>
#include <cmath>

#include "core/base/failure.h"
#include "core/io/import.h"
#include "core/io/raster/raster.h"
#include "core/region/window.h"

namespace relievo {

namespace {
std::filesystem::path nameOf(const FirmnessMap& firmness) {
  return std::filesystem::path(firmness.file).filename();
}

NumberArgument shortNumber(double value) {
  return {.value = value, .digits = 6, .form = NumberArgument::Form::significant};
}

/// A raster with as many cells as the map has samples may be laid edge to edge or sample to sample:
/// one cell is no mistake.
void requireFit(const FirmnessMap& firmness, const DetailLadder& map) {
  const GridSize size = firmness.size;
  const double rows_for_square = size.cols * map.height_mm / map.width_mm;
  const double cols_for_square = size.rows * map.width_mm / map.height_mm;
  if (std::abs(size.rows - rows_for_square) <= 1 || std::abs(size.cols - cols_for_square) <= 1) {
    return;
  }
  throw failure<MessageId::firmness_of_another_size>(nameOf(firmness), size.cols, size.rows,
                                                     shortNumber(map.width_mm),
                                                     shortNumber(map.height_mm));
}
}  // namespace

FirmnessMap readFirmness(const std::filesystem::path& file, const Task& task) {
  RasterMap raster = importRaster(file, {}, task);
  FirmnessMap firmness{file.string(), {}, raster.size, std::move(raster.values)};
  for (std::size_t i = 0; i < firmness.parts.size(); ++i) {
    float& part = firmness.parts[i];
    if (!raster.valid[i]) part = 0;
    if (part >= 0 && part <= 1) continue;
    throw failure<MessageId::firmness_out_of_range>(nameOf(firmness), shortNumber(part));
  }
  return firmness;
}

std::vector<float> firmnessUnder(const FirmnessMap& firmness, const DetailLadder& map,
                                 const Region& region) {
  requireFit(firmness, map);
  const auto place = [](double at, double first, double length, int count) {
    const double cell = std::floor((at - first) / length * count);
    return static_cast<int>(std::clamp(cell, 0.0, count - 1.0));
  };
  const double spacing_mm = region.side_mm / kWindowSamples;
  std::vector<float> parts(kWindowCount);
  std::size_t sample = 0;
  for (int row = 0; row < kWindowSamples; ++row) {
    const double y = region.y_mm + (row + 0.5) * spacing_mm;
    const int from_row = place(y, map.bottom_mm, map.height_mm, firmness.size.rows);
    for (int col = 0; col < kWindowSamples; ++col) {
      const double x = region.x_mm + (col + 0.5) * spacing_mm;
      const Cell cell{place(x, map.left_mm, map.width_mm, firmness.size.cols), from_row};
      parts[sample++] = firmness.parts[firmness.size.index(cell)];
    }
  }
  return parts;
}

}  // namespace relievo
