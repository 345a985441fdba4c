// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/pyramid_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/failure.h"

namespace relievo {
namespace {

/// The newest rows of one level.
class Ring {
 public:
  Ring(int rows, int cols)
      : rows_(rows),
        cols_(static_cast<std::size_t>(cols)),
        values_(static_cast<std::size_t>(rows) * cols_) {}
  void put(int row, const float* values) { std::copy_n(values, cols_, at(row)); }
  float* at(int row) { return &values_[static_cast<std::size_t>(row % rows_) * cols_]; }

 private:
  int rows_;
  std::size_t cols_;
  std::vector<float> values_;
};

}  // namespace

struct PyramidRows::Step {
  Step(GridSize fine, double factor)
      : reducer(fine, factor),
        heights(reducer.mostRows(), fine.cols),
        measured(reducer.mostRows(), fine.cols),
        out_heights(static_cast<std::size_t>(reducer.coarseSize().cols)),
        out_measured(out_heights.size()) {}

  RowReducer reducer;
  Ring heights, measured;
  std::vector<float> out_heights, out_measured;
};

std::vector<GridFrame> PyramidRows::frames(const GridFrame& map, const PyramidOptions& options) {
  if (!(options.factor >= kLeastFactor) || !(options.factor <= kMostFactor)) {
    throw failure<MessageId::tiles_pyramid_factor>();
  }
  return levelFrames(map, options);
}

PyramidRows::PyramidRows(const GridFrame& map, const PyramidOptions& options, TakeRow take)
    : frames_(frames(map, options)),
      factor_(options.factor),
      take_(std::move(take)),
      next_row_(frames_.size()),
      next_origin_row_(frames_.size()),
      origins_(frames_.size()),
      heights_(static_cast<std::size_t>(map.size.cols)),
      measured_(heights_.size()) {
  for (std::size_t level = 0; level + 1 < frames_.size(); ++level) {
    steps_.push_back(std::make_unique<Step>(frames_[level].size, factor_));
  }
}

PyramidRows::~PyramidRows() = default;

void PyramidRows::keepOrigins(const CellStatus* origins) {
  for (std::size_t level = 0; level < frames_.size(); ++level) {
    const GridSize size = frames_[level].size;
    const double step = frames_[level].spacing_mm / frames_[0].spacing_mm;
    const auto nearest = [&](int node, int count) {
      return std::min(static_cast<int>(std::lround(node * step)), count - 1);
    };
    int& next = next_origin_row_[level];
    while (next < size.rows && nearest(next, frames_[0].size.rows) == rows_added_) {
      std::vector<CellStatus> row(static_cast<std::size_t>(size.cols));
      for (int col = 0; col < size.cols; ++col) {
        row[static_cast<std::size_t>(col)] = origins[nearest(col, frames_[0].size.cols)];
      }
      origins_[level].push_back(std::move(row));
      ++next;
    }
  }
}

void PyramidRows::give(std::size_t level, const float* heights, const float* measured) {
  const int row = next_row_[level]++;
  take_({.level = {static_cast<int>(level)},
         .row = row,
         .heights_mm = heights,
         .measured = measured,
         .origins = origins_[level].front().data()});
  origins_[level].pop_front();
  if (level == steps_.size()) return;
  Step& step = *steps_[level];
  step.heights.put(row, heights);
  step.measured.put(row, measured);
  const int coarse_rows = step.reducer.coarseSize().rows;
  while (next_row_[level + 1] < coarse_rows &&
         step.reducer.rowsFor(next_row_[level + 1]).end <= row + 1) {
    const int coarse_row = next_row_[level + 1];
    step.reducer.reduce(
        coarse_row, [&](int r) { return step.heights.at(r); }, step.out_heights.data());
    step.reducer.reduce(
        coarse_row, [&](int r) { return step.measured.at(r); }, step.out_measured.data());
    give(level + 1, step.out_heights.data(), step.out_measured.data());
  }
}

void PyramidRows::add(const float* heights_mm, const CellStatus* origins) {
  keepOrigins(origins);
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    measured_[i] = measuredForLevels(origins[i]);
    heights_[i] = heightForLevels(origins[i], heights_mm[i]);
  }
  ++rows_added_;
  give(0, heights_.data(), measured_.data());
}

}  // namespace relievo
