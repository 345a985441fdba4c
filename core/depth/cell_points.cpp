// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/cell_points.h"

#include <algorithm>

#include "core/base/bands.h"
#include "core/depth/grid_points.h"

namespace relievo {
namespace {

constexpr int kBucketRows = 8;
constexpr std::size_t kCheckEvery = 1U << 16U;
constexpr std::uint16_t kOffGrid = 0xFFFF;  // 65535 buckets are 524280 rows, more than any grid.

std::size_t bucketCount(GridSize size) {
  return static_cast<std::size_t>((size.rows + kBucketRows - 1) / kBucketRows);
}

}  // namespace

CellPoints::CellPoints(const DepthRequest& request, const Task& task)
    : request_(request), threads_(threadsFor(request.scan.points.size(), request.threads)) {
  const GridSize size = request.frame.size;
  const auto& points = request.scan.points;
  const std::size_t buckets = bucketCount(size);
  const GridFromPoint grid_from_point(request);
  const auto parts = static_cast<std::size_t>(threads_);
  std::vector<std::uint16_t> bucket_of(points.size());
  std::vector<std::vector<std::size_t>> next(parts, std::vector<std::size_t>(buckets, 0));

  const auto inParts = [&](auto&& work) {
    inBands(threads_, threads_, [&](int first, int) {
      const auto part = static_cast<std::size_t>(first);
      work(part, points.size() * part / parts, points.size() * (part + 1) / parts);
    });
  };
  inParts([&](std::size_t part, std::size_t first, std::size_t end) {
    std::vector<std::size_t>& counts = next[part];
    for (std::size_t i = first; i < end; ++i) {
      if (i % kCheckEvery == 0) task.check();
      const GridPoint p = grid_from_point(points[i]);
      const int row = nearestIndex(p.v, size.rows);
      bucket_of[i] = kOffGrid;
      if (row < 0 || nearestIndex(p.u, size.cols) < 0) continue;
      bucket_of[i] = static_cast<std::uint16_t>(row / kBucketRows);
      ++counts[bucket_of[i]];
    }
  });
  // A bucket's points lie part after part, so in the file's order, however many parts there are.
  std::size_t total = 0;
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    starts_.push_back(total);
    for (std::size_t part = 0; part < parts; ++part) {
      const std::size_t count = next[part][bucket];
      next[part][bucket] = total;
      total += count;
    }
  }
  starts_.push_back(total);
  indices_.resize(total);
  task.report("Depth map", 0.3);
  inParts([&](std::size_t part, std::size_t first, std::size_t end) {
    std::vector<std::size_t>& places = next[part];
    for (std::size_t i = first; i < end; ++i) {
      if (i % kCheckEvery == 0) task.check();
      if (bucket_of[i] != kOffGrid)
        indices_[places[bucket_of[i]]++] = static_cast<std::uint32_t>(i);
    }
  });
}

RowPoints CellPoints::rows(int first_row, int end_row) const {
  const GridSize size = request_.frame.size;
  RowPoints rows;
  rows.first_row = std::max(first_row, 0);
  rows.end_row = std::min(end_row, size.rows);
  rows.cols = size.cols;
  const auto cells =
      static_cast<std::size_t>(rows.end_row - rows.first_row) * static_cast<std::size_t>(size.cols);
  rows.starts.assign(cells + 1, 0);
  const std::size_t first = starts_[static_cast<std::size_t>(rows.first_row / kBucketRows)];
  const std::size_t end =
      starts_[static_cast<std::size_t>((rows.end_row + kBucketRows - 1) / kBucketRows)];

  struct Found {
    std::uint32_t cell = 0;
    PlacedPoint point;
  };
  std::vector<Found> found;
  found.reserve(end - first);
  const GridFromPoint grid_from_point(request_);
  for (std::size_t k = first; k < end; ++k) {
    const GridPoint p = grid_from_point(request_.scan.points[indices_[k]]);
    const int row = nearestIndex(p.v, size.rows);
    if (row < rows.first_row || row >= rows.end_row) continue;
    const int col = nearestIndex(p.u, size.cols);
    const auto cell = static_cast<std::uint32_t>(rows.cell(col, row));
    found.push_back({.cell = cell,
                     .point = {.du = static_cast<float>(p.u - col),
                               .dv = static_cast<float>(p.v - row),
                               .z = static_cast<float>(p.z)}});
    ++rows.starts[cell + 1];
  }
  for (std::size_t i = 1; i <= cells; ++i) rows.starts[i] += rows.starts[i - 1];
  rows.points.resize(found.size());
  // starts[cell] moves to the cell's end while the points come in, and is then the next one's
  // start: shifting the list back by one cell restores it.
  for (const Found& f : found) rows.points[rows.starts[f.cell]++] = f.point;
  for (std::size_t i = cells; i > 0; --i) rows.starts[i] = rows.starts[i - 1];
  rows.starts[0] = 0;
  return rows;
}

}  // namespace relievo
