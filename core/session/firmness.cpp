// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/firmness.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/base/error.h"
#include "core/io/import.h"
#include "core/io/raster.h"
#include "core/region/window.h"

namespace relievo {

namespace {
std::string nameOf(const FirmnessMap& firmness) {
  return "'" + std::filesystem::path(firmness.file).filename().string() + "'";
}

std::string shortText(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
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
  throw ArgumentError(nameOf(firmness) + " has " + std::to_string(size.cols) + " x " +
                      std::to_string(size.rows) + " cells, but the map is " +
                      shortText(map.width_mm) + " x " + shortText(map.height_mm) +
                      " mm: it is not a raster of the whole map, and was not used. Cut it to the "
                      "outline of the map.");
}
}  // namespace

FirmnessMap readFirmness(const std::filesystem::path& file, const Task& task) {
  RasterMap raster = importRaster(file, {}, task);
  FirmnessMap firmness{file.string(), {}, raster.size, std::move(raster.values)};
  for (std::size_t i = 0; i < firmness.parts.size(); ++i) {
    float& part = firmness.parts[i];
    if (!raster.valid[i]) part = 0;
    if (part >= 0 && part <= 1) continue;
    throw ArgumentError(nameOf(firmness) + " holds values outside 0 to 1, such as " +
                        shortText(part) +
                        ", and was not used. Scale them: 1 where the ground is firm, 0 where it is "
                        "softest.");
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
