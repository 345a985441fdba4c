// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "core/base/task.h"
#include "core/base/transform.h"
#include "core/cloud/scan.h"
#include "core/cloud/stray_limits.h"

namespace relievo {

class Exchange;  // core/base/exchange.h

/// Points that can be had block by block, by their number, on any thread: PointStream of core/io,
/// or points in memory.
struct PointSource {
  std::uint64_t count = 0;
  /// Fills the block with the points from `first` on; coordinates that are not finite mark points
  /// that do not count. @return  points given
  std::function<std::size_t(std::uint64_t first, std::span<FilePoint> block)> read;
};

/// What the scan says of a point beside its place.
struct PointValue {
  Rgba colour{};  ///< Alpha 0: none.
  std::uint16_t intensity = 0;
};

/// Points with it, as PointSource.
struct ValueSource {
  std::uint64_t count = 0;
  std::function<std::size_t(std::uint64_t first, std::span<FilePoint> block,
                            std::span<PointValue> values)>
      read;
};

/// Calls take(block) for all points of first ... end - 1 in blocks of at most 16384.
void forEachBlock(const PointSource& source, std::uint64_t first, std::uint64_t end,
                  const std::function<void(std::span<const FilePoint>)>& take);

struct SourceBounds {
  std::uint64_t finite_points = 0;
  ViewMm min, max;  ///< After view_from_file; meaningful if there are finite points.
  FileBounds file;  ///< In file coordinates, likewise.
};

/// Reads everything once, each of several processes a part. [worker]
/// @param threads  0: as many as there are usable cores
/// @param processes  that ask for the same; null: this one alone
/// @throw Cancelled, FileError
SourceBounds boundsOf(const PointSource& source, const ViewFromFile& view_from_file, int threads,
                      const Task& task, Exchange* processes = nullptr);

/// The same, and how the points lie in the cubes of `grid`, which is meant in view coordinates. One
/// look at the file for both. [worker] @throw Cancelled, FileError
struct BoundsAndCounts {
  SourceBounds bounds;
  StrayCounts counts;
};
BoundsAndCounts boundsAndCountsOf(const PointSource& source, const ViewFromFile& view_from_file,
                                  const StrayGrid& grid, int threads, const Task& task,
                                  Exchange* processes = nullptr);

/// The source with points that `keeps` says no to made not finite.
PointSource filtered(PointSource source, std::function<bool(const FilePoint&)> keeps);

}  // namespace relievo
