// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/scatter.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <utility>
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

using Points = std::vector<CellPoint>;

/// Adds a tile's points to a scan whose file frame is a grid in mm, the tile's cell (0, 0) at
/// `corner` of it; points outside the grid are left out.
void placeTile(const Points& points, GridSize tile, Cell corner, const GridFrame& frame,
               Scan& scan) {
  // So far from the cell's border that float cannot carry a point across it.
  constexpr float kInside = 0.4999F;
  for (const CellPoint& p : points) {
    const Cell cell{.col = corner.col + p.cell % tile.cols, .row = corner.row + p.cell / tile.cols};
    if (!frame.size.contains(cell)) continue;
    const auto x = static_cast<double>(std::clamp(p.du, -kInside, kInside)) + cell.col;
    const auto y = static_cast<double>(std::clamp(p.dv, -kInside, kInside)) + cell.row;
    scan.points.push_back(
        {static_cast<float>(x * frame.spacing_mm), static_cast<float>(y * frame.spacing_mm), p.z});
  }
}

/// The points of three rows of tiles, so that each tile is sorted once.
class SortedTiles {
 public:
  explicit SortedTiles(const TileStore& store) : store_(store) {}

  /// Loads a row of tiles and its neighbours, drops the others.
  void centre(int tile_row) {
    const TileLayout& layout = store_.layout();
    std::erase_if(rows_, [&](const auto& row) { return std::abs(row.first - tile_row) > 1; });
    const int last = std::min(tile_row + 1, layout.down() - 1);
    for (int row = std::max(tile_row - 1, 0); row <= last; ++row) {
      if (rows_.contains(row)) continue;
      std::vector<Points>& tiles = rows_[row];
      tiles.resize(static_cast<std::size_t>(layout.across()));
      inParts(0, tiles.size(), store_.threads(), [&](int, std::uint64_t first, std::uint64_t end) {
        for (std::uint64_t x = first; x < end; ++x) {
          tiles[x] = store_.points(row * layout.across() + static_cast<int>(x));
        }
      });
    }
  }
  const Points& at(int x, int y) const { return rows_.at(y)[static_cast<std::size_t>(x)]; }

 private:
  const TileStore& store_;
  std::map<int, std::vector<Points>> rows_;
};

/// One tile with kRuleReach cells around it as a request to core/depth.
FrontDepths depthsByRule(const SortedTiles& sorted, const TileLayout& layout, int tile,
                         PointRule rule, double spacing_mm) {
  const Cell first = layout.firstCell(tile);
  const GridSize size = layout.sizeOf(tile);
  const Cell low{.col = std::max(first.col - kRuleReach, 0),
                 .row = std::max(first.row - kRuleReach, 0)};
  const Cell end{.col = std::min(first.col + size.cols + kRuleReach, layout.map.cols),
                 .row = std::min(first.row + size.rows + kRuleReach, layout.map.rows)};
  const GridFrame frame{.size = {.cols = end.col - low.col, .rows = end.row - low.row},
                        .spacing_mm = spacing_mm,
                        .first_x_mm = 0,
                        .first_y_mm = 0};
  Scan scan;
  for (int y = low.row / kTileSide; y <= (end.row - 1) / kTileSide; ++y) {
    for (int x = low.col / kTileSide; x <= (end.col - 1) / kTileSide; ++x) {
      const int other = y * layout.across() + x;
      const Cell corner = layout.firstCell(other);
      placeTile(sorted.at(x, y), layout.sizeOf(other),
                {.col = corner.col - low.col, .row = corner.row - low.row}, frame, scan);
    }
  }
  const FrontDepths around =
      scatterPoints({.scan = scan, .view_from_file = {}, .frame = frame, .rule = rule}).front;
  FrontDepths depths(size.count());
  for (int row = 0; row < size.rows; ++row) {
    const std::size_t from =
        frame.size.index({.col = first.col - low.col, .row = first.row - low.row + row});
    std::copy_n(around.begin() + static_cast<std::ptrdiff_t>(from), size.cols,
                depths.begin() + static_cast<std::ptrdiff_t>(row) * size.cols);
  }
  return depths;
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

RuleProposal proposeRule(const TileStore& store, double spacing_mm, const Task& task) {
  constexpr int kAcross = 4;
  const TileLayout& layout = store.layout();
  Scan scan;
  const GridFrame frame{.size = {.cols = kAcross * kTileSide, .rows = kAcross * kTileSide},
                        .spacing_mm = spacing_mm,
                        .first_x_mm = 0,
                        .first_y_mm = 0};
  // Not in even steps: those could follow the map's columns.
  constexpr double kGoldenRatio = 0.6180339887498949;
  std::set<int> seen;
  double position = 0.5;
  int placed = 0;
  for (int i = 0; i < 8 * kAcross * kAcross && placed < kAcross * kAcross; ++i) {
    task.check();
    const int tile = static_cast<int>(position * layout.count());
    position += kGoldenRatio;
    if (position >= 1) position -= 1;
    if (!seen.insert(tile).second) continue;
    const Points points = store.points(tile);
    if (points.empty()) continue;
    placeTile(points, layout.sizeOf(tile),
              {.col = placed % kAcross * kTileSide, .row = placed / kAcross * kTileSide}, frame,
              scan);
    ++placed;
  }
  return proposeRule({.scan = scan, .view_from_file = {}, .frame = frame}, task);
}

void makeDepths(const TileStore& store, PointRule rule, double spacing_mm, const TakeDepths& take,
                const Task& task) {
  const TileLayout& layout = store.layout();
  SortedTiles sorted(store);
  FrontDepths band;
  for (int y = 0; y < layout.down(); ++y) {
    task.check();
    task.report("Heights of cells", static_cast<double>(y) / layout.down());
    if (!store.merges()) sorted.centre(y);
    const int rows = layout.sizeOf(y * layout.across()).rows;
    const GridSize size{.cols = layout.map.cols, .rows = rows};
    band.resize(size.count());
    inParts(0, static_cast<std::uint64_t>(layout.across()), store.threads(),
            [&](int, std::uint64_t first, std::uint64_t end) {
              for (int x = static_cast<int>(first); x < static_cast<int>(end); ++x) {
                task.check();
                const int tile = y * layout.across() + x;
                const FrontDepths depths =
                    store.merges() ? depthsFromStates(store, tile, rule)
                                   : depthsByRule(sorted, layout, tile, rule, spacing_mm);
                const int cols = layout.sizeOf(tile).cols;
                for (int row = 0; row < rows; ++row) {
                  std::copy_n(depths.begin() + static_cast<std::ptrdiff_t>(row) * cols, cols,
                              &band[size.index({.col = x * kTileSide, .row = row})]);
                }
              }
            });
    take(y * kTileSide, rows, band.data());
  }
}

}  // namespace relievo
