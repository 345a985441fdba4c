// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/large/ready_rows.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

/// Do two views differ by a shift alone?
bool haveOneRotation(const ViewFromFile& a, const ViewFromFile& b) {
  constexpr double kRounding = 1e-9;
  for (const std::size_t i : {0U, 1U, 2U, 4U, 5U, 6U, 8U, 9U, 10U}) {
    if (std::abs(a.m[i] - b.m[i]) > kRounding * (1 + std::abs(a.m[i]))) return false;
  }
  return true;
}

int cellAt(double mm, double first_mm, double spacing_mm, int count) {
  return std::clamp(static_cast<int>(std::lround((mm - first_mm) / spacing_mm)), 0, count - 1);
}

}  // namespace

ReadyRows::ReadyRows(const GridFrame& whole, int most_cells)
    : whole_cols_(whole.size.cols),
      step_((std::max(whole.size.cols, whole.size.rows) + most_cells - 1) / most_cells) {
  GridFrame& frame = ready_.map.frame;
  frame = whole;
  frame.size = {.cols = (whole.size.cols - 1) / step_ + 1,
                .rows = (whole.size.rows - 1) / step_ + 1};
  frame.spacing_mm = step_ * whole.spacing_mm;
  ready_.map.heights_mm.assign(frame.size.count(), 0);
  ready_.map.origins.assign(frame.size.count(), CellStatus::outside);
  ready_.whole = whole.size;
}

void ReadyRows::beginWith(const Surface& sample, const ViewFromFile& view, double lowest_mm) {
  const ViewFromFile& seen = sample.view_from_file;
  if (!haveOneRotation(seen, view)) return;
  constexpr std::size_t kX = 3, kY = 7, kZ = 11;  // Shifts of a 3 x 4 matrix.
  const double to_x = seen.m[kX] - view.m[kX], to_y = seen.m[kY] - view.m[kY];
  const auto above_lowest = static_cast<float>(-seen.m[kZ] - lowest_mm);
  const GridFrame& from = sample.map.frame;
  const GridFrame& to = ready_.map.frame;
  for (int row = 0; row < to.size.rows; ++row) {
    const double y_mm = to.first_y_mm + row * to.spacing_mm + to_y;
    const int from_row = cellAt(y_mm, from.first_y_mm, from.spacing_mm, from.size.rows);
    for (int col = 0; col < to.size.cols; ++col) {
      const double x_mm = to.first_x_mm + col * to.spacing_mm + to_x;
      const Cell cell{cellAt(x_mm, from.first_x_mm, from.spacing_mm, from.size.cols), from_row};
      const std::size_t i = to.size.index({col, row});
      ready_.map.origins[i] = sample.map.origin(cell);
      ready_.map.heights_mm[i] = sample.map.heightMm(cell) + above_lowest;
    }
  }
}

void ReadyRows::add(const DepthRows& rows) {
  DepthMap& map = ready_.map;
  for (int row = (rows.first_row + step_ - 1) / step_; row * step_ < rows.first_row + rows.rows;
       ++row) {
    const auto line = static_cast<std::size_t>(row * step_ - rows.first_row) *
                      static_cast<std::size_t>(whole_cols_);
    for (int col = 0; col < map.frame.size.cols; ++col) {
      const float depth = rows.front[line + static_cast<std::size_t>(col * step_)];
      const std::size_t i = map.frame.size.index({col, row});
      map.origins[i] = std::isnan(depth) ? CellStatus::outside : CellStatus::measured;
      map.heights_mm[i] = std::isnan(depth) ? 0 : depth;
    }
  }
  ready_.rows += rows.rows;
}

}  // namespace relievo
