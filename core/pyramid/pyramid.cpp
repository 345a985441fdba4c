// SPDX-License-Identifier: BSD-3-Clause
#include "core/pyramid/pyramid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "core/base/bands.h"
#include "core/base/failure.h"
#include "core/pyramid/halve.h"
#include "core/pyramid/kernel.h"
#include "core/pyramid/row_reducer.h"

namespace relievo {
namespace {

constexpr double kMostCellsInAll = 536'870'912;  // Twice the largest map: 4 GiB with the shares.

/// The paper's equation (sec. 5) for any M.
LargeArray<float> reducedBy(const PyramidOptions& options, std::span<const float> in, GridSize size,
                            GridSize out_size, const Task& task) {
  LargeArray<float> out(out_size.count());
  parallelFor(out_size.rows, threadsFor(size.count(), options.threads), [&](int first, int last) {
    RowReducer reducer(size, options.factor);
    const auto row_at = [&](int row) { return &in[size.index({.col = 0, .row = row})]; };
    for (int j = first; j < last; ++j) {
      if (j % 16 == 0) task.check();
      reducer.reduce(j, row_at, &out[out_size.index({.col = 0, .row = j})]);
    }
  });
  return out;
}

LargeArray<float> reduced(const PyramidOptions& options, std::span<const float> in, GridSize size,
                          GridSize out_size, const Task& task) {
  if (options.factor == 2) return halved(in, size, out_size, options.threads, task);
  return reducedBy(options, in, size, out_size, task);
}

bool isCoarsest(GridSize size, const PyramidOptions& options) {
  return size.cols <= options.coarsest_samples && size.rows <= options.coarsest_samples;
}

/// @throw ArgumentError
void requireFactor(GridSize size, const PyramidOptions& options) {
  if (!(options.factor >= kLeastFactor) || !(options.factor <= kMostFactor)) {
    throw failure<MessageId::pyramid_factor>();
  }
  auto cells = static_cast<double>(size.count());
  for (; !isCoarsest(size, options); cells += static_cast<double>(size.count())) {
    size = reducedSize(size, options.factor);
    if (cells > kMostCellsInAll) {
      throw failure<MessageId::pyramid_factor_near_one>();
    }
  }
}

PyramidLevel baseLevel(const DepthMap& map, const PyramidOptions& options, const Task& task) {
  const GridSize size = map.frame.size;
  PyramidLevel level{.frame = map.frame, .heights_mm = {}, .measured = {}};
  level.heights_mm.resize(size.count());
  parallelFor(size.rows, threadsFor(size.count(), options.threads), [&](int first, int last) {
    for (int row = first; row < last; ++row) {
      if (row % 64 == 0) task.check();
      const std::size_t at = size.index({.col = 0, .row = row});
      const float* const heights = &map.heights_mm[at];
      const CellStatus* const origins = &map.origins[at];
      float* const out = &level.heights_mm[at];
      for (int i = 0; i < size.cols; ++i) out[i] = heightForLevels(origins[i], heights[i]);
    }
  });
  return level;
}

LargeArray<float> firstShares(const DepthMap& map, const PyramidOptions& options, GridSize out_size,
                              const Task& task) {
  const GridSize size = map.frame.size;
  if (options.factor == 2) {
    return halvedShares(map.origins, size, out_size, options.threads, task);
  }
  LargeArray<float> measured(map.origins.size());
  std::transform(map.origins.begin(), map.origins.end(), measured.begin(), measuredForLevels);
  return reducedBy(options, measured, size, out_size, task);
}

}  // namespace

GridSize reducedSize(GridSize size, double factor) {
  return {.cols = reducedCount(size.cols, factor), .rows = reducedCount(size.rows, factor)};
}

std::vector<GridFrame> levelFrames(const GridFrame& map, const PyramidOptions& options) {
  std::vector<GridFrame> frames{map};
  while (!isCoarsest(frames.back().size, options)) {
    GridFrame coarse = frames.back();
    coarse.size = reducedSize(coarse.size, options.factor);
    coarse.spacing_mm =
        map.spacing_mm * std::pow(options.factor, static_cast<double>(frames.size()));
    frames.push_back(coarse);
  }
  return frames;
}

Pyramid buildPyramid(const DepthMap& map, const PyramidOptions& options, const Task& task) {
  requireFactor(map.frame.size, options);
  Pyramid pyramid{.factor = options.factor, .levels = {}};
  pyramid.levels.push_back(baseLevel(map, options, task));
  const std::vector<GridFrame> frames = levelFrames(map.frame, options);
  while (pyramid.levels.size() < frames.size()) {
    const GridFrame& frame = frames[pyramid.levels.size()];
    const PyramidLevel& fine = pyramid.levels.back();
    const GridSize size = fine.frame.size;
    PyramidLevel coarse;
    coarse.frame = frame;
    coarse.heights_mm = reduced(options, fine.heights_mm, size, frame.size, task);
    coarse.measured = pyramid.levels.size() == 1
                          ? firstShares(map, options, frame.size, task)
                          : reduced(options, fine.measured, size, frame.size, task);
    pyramid.levels.push_back(std::move(coarse));
  }
  return pyramid;
}

}  // namespace relievo
