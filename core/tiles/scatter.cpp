// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/scatter.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/depth/grid_points.h"
#include "core/tiles/threads.h"

namespace relievo {
namespace {

/// From file coordinates to the tile; the arithmetic of GridFromPoint in core/depth for points that
/// were never rounded to float.
class TileFromPoint {
 public:
  TileFromPoint(const ViewFromFile& view_from_file, const GridFrame& frame)
      : view_from_file_(view_from_file), frame_(frame), layout_{frame.size} {}

  /// @return  false if the point is not on the grid
  bool operator()(const FilePoint& p, TilePoint& out) const noexcept {
    const ViewMm v = view_from_file_(p);
    const double x = (v.x - frame_.first_x_mm) / frame_.spacing_mm;
    const double y = (v.y - frame_.first_y_mm) / frame_.spacing_mm;
    const int col = nearestIndex(x, frame_.size.cols);
    const int row = nearestIndex(y, frame_.size.rows);
    if (col < 0 || row < 0) return false;
    const int tile = row / kTileSide * layout_.across() + col / kTileSide;
    const int tile_cols = std::min(kTileSide, frame_.size.cols - col / kTileSide * kTileSide);
    out = {.tile = static_cast<std::uint32_t>(tile),
           // -0 becomes 0.
           .point = {
               .z = static_cast<float>(v.z) + 0.0F,
               .du = static_cast<float>(x - col) + 0.0F,
               .dv = static_cast<float>(y - row) + 0.0F,
               .cell = static_cast<std::uint16_t>(row % kTileSide * tile_cols + col % kTileSide)}};
    return true;
  }

 private:
  ViewFromFile view_from_file_;
  GridFrame frame_;
  TileLayout layout_;
};

std::vector<TilePoint> readPart(const PointSource& source, const TileFromPoint& tile_from_point,
                                std::uint64_t first, std::uint64_t end) {
  std::vector<TilePoint> points;
  points.reserve(end - first);
  forEachBlock(source, first, end, [&](std::span<const FilePoint> block) {
    for (const FilePoint& p : block) {
      TilePoint point;
      if (tile_from_point(p, point)) points.push_back(point);
    }
  });
  return points;
}

/// The tile alone as a request to core/depth: a scan whose file frame is the tile's grid in mm.
FrontDepths depthsByRule(const TileStore& store, int tile, PointRule rule, double spacing_mm) {
  const GridSize size = store.layout().sizeOf(tile);
  Scan scan;
  for (const CellPoint& p : store.points(tile)) {
    const int col = p.cell % size.cols;
    const int row = p.cell / size.cols;
    scan.points.push_back(
        {static_cast<float>(col * spacing_mm), static_cast<float>(row * spacing_mm), p.z});
  }
  const GridFrame frame{.size = size, .spacing_mm = spacing_mm, .first_x_mm = 0, .first_y_mm = 0};
  return scatterPoints({.scan = scan, .view_from_file = {}, .frame = frame, .rule = rule});
}

FrontDepths depthsFromStates(const TileStore& store, int tile, PointRule rule) {
  const std::vector<CellState> states = store.states(tile);
  FrontDepths depths(states.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const CellState& state = states[i];
    if (state.count == 0) continue;
    if (rule == PointRule::mean) {
      depths[i] =
          static_cast<float>(static_cast<double>(state.sum) * store.sumUnitMm() / state.count);
    } else {
      const bool by_second = rule == PointRule::second && state.count > 1;
      depths[i] = by_second ? state.second : state.first;
    }
  }
  return depths;
}

}  // namespace

bool isMergeable(PointRule rule) {
  return rule == PointRule::front || rule == PointRule::second || rule == PointRule::mean;
}

void scatterIntoTiles(const PointSource& source, const ViewFromFile& view_from_file,
                      const GridFrame& frame, TileStore& store, const Task& task) {
  const TileFromPoint tile_from_point(view_from_file, frame);
  const std::uint64_t step = store.pointsAtOnce();
  std::vector<std::vector<TilePoint>> parts(static_cast<std::size_t>(store.threads()));
  for (std::uint64_t start = 0; start < source.count; start += step) {
    task.check();
    task.report("Sorting points into tiles",
                static_cast<double>(start) / static_cast<double>(source.count));
    const std::uint64_t end = std::min(start + step, source.count);
    for (auto& part : parts) part.clear();
    inParts(start, end, store.threads(), [&](int part, std::uint64_t first, std::uint64_t last) {
      parts[static_cast<std::size_t>(part)] = readPart(source, tile_from_point, first, last);
    });
    for (const auto& part : parts) store.add(part);
  }
}

FrontDepths tileDepths(const TileStore& store, int tile, PointRule rule, double spacing_mm) {
  return store.merges() ? depthsFromStates(store, tile, rule)
                        : depthsByRule(store, tile, rule, spacing_mm);
}

}  // namespace relievo
