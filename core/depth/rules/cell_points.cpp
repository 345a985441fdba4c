// SPDX-License-Identifier: BSD-3-Clause
// Compiled with -O3 and without contraction to fused multiply-add: the same bits in every build.
#include "core/depth/rules/cell_points.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/bands.h"
#include "core/base/large_pages.h"
#include "core/base/wide_vectors.h"
#include "core/depth/rules/grid_points.h"

namespace relievo {
namespace {

constexpr int kBucketRows = 8;
constexpr std::size_t kBlock = 512;  // Points that are turned into grid units together.
constexpr std::size_t kCheckEvery = 128 * kBlock;

/// Some points in grid units.
struct Block {
  std::array<double, kBlock> u, v, z;  // Without initial values: made only to be overwritten.
};

RELIEVO_WIDE_VECTORS
void toGrid(const GridFromPoint& from, const std::array<float, 3>* __restrict points,
            std::size_t count, double* __restrict u, double* __restrict v, double* __restrict z) {
  const GridFromPoint grid_from_point = from;
  for (std::size_t i = 0; i < count; ++i) {
    const GridPoint p = grid_from_point(points[i]);
    u[i] = p.u;
    v[i] = p.v;
    z[i] = p.z;
  }
}

std::size_t bucketOf(int row) {
  return static_cast<std::size_t>(row / kBucketRows);
}

std::vector<bool> wantedBuckets(GridSize size, std::span<const RowRange> ranges) {
  std::vector<bool> wanted(bucketOf(size.rows - 1) + 1, false);
  for (const RowRange& range : ranges) {
    const int end = std::min(range.end, size.rows);
    for (int row = std::max(range.first, 0); row < end; row += kBucketRows) {
      wanted[bucketOf(row)] = true;
    }
    if (end > std::max(range.first, 0)) wanted[bucketOf(end - 1)] = true;
  }
  return wanted;
}

}  // namespace

CellPoints::CellPoints(const DepthRequest& request, std::span<const RowRange> ranges,
                       const Task& task, CellPoints* used_up)
    : size_(request.frame.size) {
  const auto& points = request.scan.points;
  const std::vector<bool> wanted = wantedBuckets(size_, ranges);
  const std::size_t buckets = wanted.size();
  const GridFromPoint grid_from_point(request);
  const int threads = threadsFor(points.size(), request.threads);
  const auto parts = static_cast<std::size_t>(threads);
  std::vector<std::vector<std::size_t>> next(parts, std::vector<std::size_t>(buckets, 0));

  // visit(part, bucket, row, col, point) for every point in a wanted row.
  const auto for_points = [&](auto&& visit) {
    parallelFor(threads, threads, [&](int first_part, int) {
      const auto part = static_cast<std::size_t>(first_part);
      const std::size_t begin = points.size() * part / parts;
      const std::size_t end = points.size() * (part + 1) / parts;
      Block block;
      for (std::size_t first = begin; first < end; first += kBlock) {
        if ((first - begin) % kCheckEvery == 0) task.check();
        const std::size_t count = std::min(kBlock, end - first);
        toGrid(grid_from_point, &points[first], count, block.u.data(), block.v.data(),
               block.z.data());
        for (std::size_t i = 0; i < count; ++i) {
          const int row = nearestIndex(block.v[i], size_.rows);
          if (row < 0 || !wanted[bucketOf(row)]) continue;
          const int col = nearestIndex(block.u[i], size_.cols);
          if (col < 0) continue;
          visit(part, bucketOf(row), row, col,
                GridPoint{.u = block.u[i], .v = block.v[i], .z = block.z[i]});
        }
      }
    });
  };
  for_points([&](std::size_t part, std::size_t bucket, int, int, const GridPoint&) {
    ++next[part][bucket];
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
  if (used_up != nullptr) {
    records_ = std::move(used_up->records_);
    capacity_ = std::exchange(used_up->capacity_, 0);
  }
  if (total > capacity_) {
    records_.reset();
    // A little more, so that the next part of a large scan fits too; costs nothing until written.
    capacity_ = total + total / 8;
    records_ = std::make_unique_for_overwrite<Record[]>(capacity_);
    wishLargePages(records_.get(), capacity_ * sizeof(Record));
  }
  for_points([&](std::size_t part, std::size_t bucket, int row, int col, const GridPoint& p) {
    const auto first_row = static_cast<int>(bucket) * kBucketRows;
    records_[next[part][bucket]++] = {
        .cell = static_cast<std::uint32_t>((row - first_row) * size_.cols + col),
        .point = {.du = static_cast<float>(p.u - col),
                  .dv = static_cast<float>(p.v - row),
                  .z = static_cast<float>(p.z)}};
  });
}

void CellPoints::rows(int first_row, int end_row, RowPoints& out) const {
  out.first_row = std::max(first_row, 0);
  out.end_row = std::min(end_row, size_.rows);
  out.cols = size_.cols;
  const auto cols = static_cast<std::uint32_t>(size_.cols);
  const std::size_t cells = static_cast<std::size_t>(out.end_row - out.first_row) * cols;
  out.starts.assign(cells + 1, 0);
  // visit(cell of `out`, record) for the records of these rows.
  const auto for_records = [&](auto&& visit) {
    for (std::size_t bucket = bucketOf(out.first_row); bucket <= bucketOf(out.end_row - 1);
         ++bucket) {
      const auto bucket_row = static_cast<int>(bucket) * kBucketRows;
      const auto before = static_cast<std::int64_t>(bucket_row - out.first_row) * cols;
      for (std::size_t k = starts_[bucket]; k < starts_[bucket + 1]; ++k) {
        const auto cell = static_cast<std::size_t>(before + records_[k].cell);
        if (cell < cells) visit(cell, records_[k]);  // Cells before the first are huge here.
      }
    }
  };
  for_records([&](std::size_t cell, const Record&) { ++out.starts[cell + 1]; });
  for (std::size_t i = 1; i <= cells; ++i) out.starts[i] += out.starts[i - 1];
  out.points.resize(out.starts[cells]);
  // starts[cell] moves to the cell's end while the points come in, and is then the next one's
  // start: shifting the list back by one cell restores it.
  for_records([&](std::size_t cell, const Record& record) {
    out.points[out.starts[cell]++] = record.point;
  });
  for (std::size_t i = cells; i > 0; --i) out.starts[i] = out.starts[i - 1];
  out.starts[0] = 0;
}

}  // namespace relievo
