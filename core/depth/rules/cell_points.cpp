// SPDX-License-Identifier: BSD-3-Clause
// Compiled with -O3 and without contraction to fused multiply-add: the same bits in every build.
#include "core/depth/rules/cell_points.h"

#include <algorithm>
#include <array>
#include <cstdint>
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
constexpr std::size_t kRun = 128;          // Records of a bucket that lie together: 2 kB.
constexpr std::size_t kRoom = 512 * 1024;  // Records that are asked for at once: 8 MB.

RELIEVO_WIDE_VECTORS
void toGrid(const GridFromPoint& from, const std::array<float, 3>* __restrict points,
            std::size_t count, double* __restrict u, double* __restrict v, float* __restrict z) {
  const GridFromPoint grid_from_point = from;
  for (std::size_t i = 0; i < count; ++i) {
    const GridPoint p = grid_from_point(points[i]);
    u[i] = p.u;
    v[i] = p.v;
    z[i] = static_cast<float>(p.z);
  }
}

/// nearestIndex of many, and how far from there, in cells.
RELIEVO_WIDE_VECTORS
void toCells(const double* __restrict u, std::size_t count, int cells,
             std::int32_t* __restrict index, float* __restrict off) {
  const double end = cells + 1.0;
  const double rim = cells - 0.5 + kEdgeTolerance;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = u[i] + 0.5;
    const double inside = at >= 0 ? at : -1;
    const auto found = static_cast<std::int32_t>(inside < end ? inside : -1);
    const std::int32_t last = u[i] <= rim ? cells - 1 : -1;
    const std::int32_t nearest = found == cells ? last : found;
    index[i] = nearest;
    off[i] = static_cast<float>(u[i] - nearest);
  }
}

std::size_t bucketOf(int row) {
  return static_cast<std::size_t>(row / kBucketRows);
}

/// 1 where rows are asked for.
std::vector<std::uint8_t> wantedBuckets(GridSize size, std::span<const RowRange> ranges) {
  std::vector<std::uint8_t> wanted(bucketOf(size.rows - 1) + 1, 0);
  for (const RowRange& range : ranges) {
    const int end = std::min(range.end, size.rows);
    for (int row = std::max(range.first, 0); row < end; row += kBucketRows) {
      wanted[bucketOf(row)] = 1;
    }
    if (end > std::max(range.first, 0)) wanted[bucketOf(end - 1)] = 1;
  }
  return wanted;
}

}  // namespace

/// Some points in the grid.
struct CellPoints::Block {
  // Without initial values: made only to be overwritten.
  std::array<double, kBlock> u, v;
  std::array<float, kBlock> du, dv, z;
  std::array<std::int32_t, kBlock> col, row;

  void fill(const GridFromPoint& grid_from_point, const std::array<float, 3>* points,
            std::size_t count, GridSize size) {
    toGrid(grid_from_point, points, count, u.data(), v.data(), z.data());
    toCells(u.data(), count, size.cols, col.data(), du.data());
    toCells(v.data(), count, size.rows, row.data(), dv.data());
  }
};

/// What one thread places: runs of records for every bucket, each where there is room next.
class CellPoints::Part {
 public:
  Part(std::size_t buckets, std::size_t most_points, std::vector<Room>& rooms)
      : runs_(buckets), open_(buckets), rooms_(rooms) {
    // No more than it can come to: every bucket may end within a run.
    most_left_ = most_points + buckets * kRun;
  }

  void add(std::size_t bucket, const Record& record) {
    Open& open = open_[bucket];
    if (open.at == open.end) start(bucket);
    *open.at++ = record;
  }
  void finish() {
    for (std::size_t bucket = 0; bucket < open_.size(); ++bucket) close(bucket);
  }
  const std::vector<Run>& runs(std::size_t bucket) const { return runs_[bucket]; }

 private:
  struct Open {
    Record *at = nullptr, *end = nullptr;
  };

  void close(std::size_t bucket) {
    const Open& open = open_[bucket];
    if (open.end == nullptr) return;
    const Record* const first = open.end - kRun;
    runs_[bucket].emplace_back(first, static_cast<std::size_t>(open.at - first));
  }
  void start(std::size_t bucket) {
    close(bucket);
    while (room_ < rooms_.size() && rooms_[room_].capacity - used_ < kRun) {
      ++room_;
      used_ = 0;
    }
    if (room_ == rooms_.size()) addRoom();
    Record* const first = rooms_[room_].records.get() + used_;
    used_ += kRun;
    open_[bucket] = {first, first + kRun};
  }
  void addRoom() {
    const std::size_t capacity = std::clamp(most_left_, kRun, kRoom);
    most_left_ -= std::min(most_left_, capacity);
    Room& room = rooms_.emplace_back(
        Room{.records = std::make_unique_for_overwrite<Record[]>(capacity), .capacity = capacity});
    wishLargePages(room.records.get(), capacity * sizeof(Record));
  }

  std::vector<std::vector<Run>> runs_;
  std::vector<Open> open_;
  std::vector<Room>& rooms_;
  std::size_t room_ = 0, used_ = 0, most_left_ = 0;
};

CellPoints::CellPoints(const DepthRequest& request, std::span<const RowRange> ranges,
                       const Task& task, CellPoints* used_up)
    : size_(request.frame.size) {
  const auto& points = request.scan.points;
  const std::vector<std::uint8_t> wanted = wantedBuckets(size_, ranges);
  const GridFromPoint grid_from_point(request);
  const int threads = threadsFor(points.size(), request.threads);
  const auto parts = static_cast<std::size_t>(threads);
  if (used_up != nullptr) rooms_ = std::move(used_up->rooms_);
  rooms_.resize(parts);
  std::vector<Part> placed;
  for (std::size_t part = 0; part < parts; ++part) {
    placed.emplace_back(wanted.size(), points.size() / parts + 1, rooms_[part]);
  }
  parallelFor(threads, threads, [&](int first_part, int) {
    const auto part = static_cast<std::size_t>(first_part);
    Part& mine = placed[part];
    const std::size_t begin = points.size() * part / parts;
    const std::size_t end = points.size() * (part + 1) / parts;
    Block block;
    for (std::size_t first = begin; first < end; first += kBlock) {
      if ((first - begin) % kCheckEvery == 0) task.check();
      const std::size_t count = std::min(kBlock, end - first);
      block.fill(grid_from_point, &points[first], count, size_);
      for (std::size_t i = 0; i < count; ++i) {
        if (block.row[i] < 0 || block.col[i] < 0) continue;
        const std::size_t bucket = bucketOf(block.row[i]);
        if (wanted[bucket] == 0) continue;
        const auto cell = (block.row[i] % kBucketRows) * size_.cols + block.col[i];
        mine.add(bucket, {.cell = static_cast<std::uint32_t>(cell),
                          .point = {.du = block.du[i], .dv = block.dv[i], .z = block.z[i]}});
      }
    }
    mine.finish();
  });
  // A bucket's points lie part after part, so in the file's order, however many parts there are.
  buckets_.resize(wanted.size());
  for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
    for (const Part& part : placed) {
      for (const Run& run : part.runs(bucket)) {
        buckets_[bucket].push_back(run);
        count_ += run.size();
      }
    }
  }
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
      for (const Run& run : buckets_[bucket]) {
        for (const Record& record : run) {
          const auto cell = static_cast<std::size_t>(before + record.cell);
          if (cell < cells) visit(cell, record);  // Cells before the first are huge here.
        }
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
