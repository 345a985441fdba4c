// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/points/scatter.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "core/base/threads.h"
#include "core/depth/rules/grid_points.h"
#include "core/depth/rules/rule_choice.h"
#include "core/tiles/tile_rows.h"

namespace relievo {
namespace {

/// From file coordinates to the tile; the arithmetic of GridFromPoint in core/depth for points that
/// were never rounded to float.
class TileFromPoint {
 public:
  TileFromPoint(const ViewFromFile& view_from_file, const GridFrame& frame,
                const FrontSurface* front)
      : view_from_file_(view_from_file), frame_(frame), layout_{frame.size}, front_(front) {}

  /// @return  false if the point is not on the grid, or not on the front
  bool operator()(const FilePoint& p, TilePoint& out, LeftOut& left_out) const noexcept {
    const ViewMm v = view_from_file_(p);
    if (front_ != nullptr && !isFront(v, left_out)) return false;
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
  /// The grid's first sample and the lowest point are the front's corner.
  bool isFront(const ViewMm& v, LeftOut& left_out) const noexcept {
    if (!isFinite(v)) return false;
    const FrontSurface::Side side =
        front_->sideOf({v.x - frame_.first_x_mm, v.y - frame_.first_y_mm, v.z});
    left_out.hidden += side == FrontSurface::Side::hidden ? 1 : 0;
    left_out.strays += side == FrontSurface::Side::stray ? 1 : 0;
    left_out.on_front += side == FrontSurface::Side::front ? 1 : 0;
    return side == FrontSurface::Side::front;
  }

  ViewFromFile view_from_file_;
  GridFrame frame_;
  TileLayout layout_;
  const FrontSurface* front_;
};

/// What one thread makes of its share of the points.
struct TilePart {
  std::vector<TilePoint> points;
  LeftOut left_out;
};

TilePart readPart(const PointSource& source, const TileFromPoint& tile_from_point,
                  std::uint64_t first, std::uint64_t end) {
  TilePart part;
  part.points.reserve(end - first);
  forEachBlock(source, first, end, [&](std::span<const FilePoint> block) {
    for (const FilePoint& p : block) {
      TilePoint point;
      if (tile_from_point(p, point, part.left_out)) part.points.push_back(point);
    }
  });
  return part;
}

using Points = std::vector<CellPoint>;

/// Half a cell, less what float's rounding could carry across a cell's border on such a grid.
float insideOfCell(GridSize size) {
  constexpr float kWidest = 0.4999F;
  const float rounding = 2 * std::numeric_limits<float>::epsilon() *
                         static_cast<float>(std::max(size.cols, size.rows));
  return std::min(kWidest, 0.5F - rounding);
}

/// Adds a tile's points to a scan whose file frame is a grid in mm, the tile's cell (0, 0) at
/// `corner` of it; points outside the grid, or in rows not wanted, are left out.
template <class Wanted>
void placeTile(const Points& points, GridSize tile, Cell corner, const GridFrame& frame, Scan& scan,
               const Wanted& is_wanted) {
  const float inside = insideOfCell(frame.size);
  for (const CellPoint& p : points) {
    const Cell cell{.col = corner.col + p.cell % tile.cols, .row = corner.row + p.cell / tile.cols};
    if (!frame.size.contains(cell) || !is_wanted(cell.row)) continue;
    const auto x = static_cast<double>(std::clamp(p.du, -inside, inside)) + cell.col;
    const auto y = static_cast<double>(std::clamp(p.dv, -inside, inside)) + cell.row;
    scan.points.push_back(
        {static_cast<float>(x * frame.spacing_mm), static_cast<float>(y * frame.spacing_mm), p.z});
  }
}

/// The points at the edges of three rows of tiles, which is what a tile has to know of its
/// neighbours.
class TileEdges {
 public:
  explicit TileEdges(const TileStore& store) : store_(store) {}

  /// Loads a row of tiles and its neighbours, drops the others.
  void centre(int tile_row, int workers) {
    const TileLayout& layout = store_.layout();
    std::erase_if(rows_, [&](const auto& row) { return std::abs(row.first - tile_row) > 1; });
    const int last = std::min(tile_row + 1, layout.down() - 1);
    for (int row = std::max(tile_row - 1, 0); row <= last; ++row) {
      if (rows_.contains(row)) continue;
      std::vector<Points>& tiles = rows_[row];
      tiles.resize(static_cast<std::size_t>(layout.across()));
      inParts(0, tiles.size(), workers, [&](int, std::uint64_t first, std::uint64_t end) {
        for (std::uint64_t x = first; x < end; ++x) {
          tiles[x] = store_.edgePoints(row * layout.across() + static_cast<int>(x));
        }
      });
    }
  }
  const Points& at(int x, int y) const { return rows_.at(y)[static_cast<std::size_t>(x)]; }

 private:
  const TileStore& store_;
  std::map<int, std::vector<Points>> rows_;
};

/// What all tiles have in common.
struct Gridding {
  const TileStore& store;
  const TileLayout& layout;
  PointRule rule;
  double spacing_mm;
  double noise_mm;
  std::size_t points_at_once;
};

/// What is summed over the tiles of a row.
struct TileLosses {
  HiddenSurface hidden;
  std::size_t outliers = 0;
};

/// One tile with kRuleReach cells around it.
struct TileAround {
  TileAround(const TileLayout& layout, int tile_number, double spacing_mm)
      : tile(tile_number), first(layout.firstCell(tile)), size(layout.sizeOf(tile)) {
    const CellRange around = withAround(layout, tile);
    low = around.first;
    end = around.end;
    frame = {.size = {.cols = end.col - low.col, .rows = end.row - low.row},
             .spacing_mm = spacing_mm,
             .first_x_mm = 0,
             .first_y_mm = 0};
    own = {.col = first.col - low.col, .row = first.row - low.row};
  }

  int tile;
  Cell first;  ///< Of the tile, in the map.
  GridSize size;
  Cell low, end;  ///< With what is around it.
  GridFrame frame;
  Cell own;  ///< The tile's first cell in the frame.
};

/// Rows of a tile that are worked on at once: all, if its points have room; else as many as have.
std::vector<RowRange> partsOf(const TileAround& at, const Gridding& gridding) {
  if (gridding.store.pointsIn(at.tile) <= gridding.points_at_once) {
    return {{.first = 0, .end = at.size.rows}};
  }
  return rowsWithin(pointsOfRows(gridding.store, at.tile),
                    cutsOf(gridding.layout, at.tile, gridding.rule), gridding.points_at_once);
}

/// The points that some rows of a tile are made from, on the tile's own grid.
Scan pointsFor(const TileAround& at, RowRange rows, const Gridding& gridding,
               const TileEdges& edges) {
  const TileLayout& layout = gridding.layout;
  const RowRange near =
      widened({.first = at.own.row + rows.first, .end = at.own.row + rows.end}, kRuleReach);
  const auto is_near = [&](int row) { return row >= near.first && row < near.end; };
  const Points points = gridding.store.points(at.tile, widened(rows, kRuleReach));
  const auto for_tiles = [&](const auto& take) {
    for (int y = at.low.row / kTileSide; y <= (at.end.row - 1) / kTileSide; ++y) {
      for (int x = at.low.col / kTileSide; x <= (at.end.col - 1) / kTileSide; ++x) {
        const int other = y * layout.across() + x;
        take(other, other == at.tile ? points : edges.at(x, y));
      }
    }
  };
  std::size_t most = 0;
  for_tiles([&](int, const Points& found) { most += found.size(); });
  Scan scan;
  scan.points.reserve(most);
  for_tiles([&](int other, const Points& found) {
    const Cell corner = layout.firstCell(other);
    placeTile(found, layout.sizeOf(other),
              {.col = corner.col - at.low.col, .row = corner.row - at.low.row}, at.frame, scan,
              is_near);
  });
  return scan;
}

/// Some rows of a tile as a request to core/depth.
TileLosses depthsOfRows(const TileAround& at, RowRange rows, const Gridding& gridding,
                        const TileEdges& edges, DepthRows& out) {
  const Scan scan = pointsFor(at, rows, gridding, edges);
  const Cell first{.col = at.own.col, .row = at.own.row + rows.first};
  const Cell end{.col = at.own.col + at.size.cols, .row = at.own.row + rows.end};
  const CapturedDepths around = scatterPoints({.scan = scan,
                                               .view_from_file = {},
                                               .frame = at.frame,
                                               .rule = gridding.rule,
                                               .threads = 1,
                                               .noise_mm = gridding.noise_mm,
                                               .counted = CellRange{first, end}});
  const GridSize band{.cols = gridding.layout.map.cols, .rows = out.rows};
  const auto copy_row = [&](const auto& from, auto& to, int row) {
    if (from.empty() || to.empty()) return;
    const std::size_t start = at.frame.size.index({.col = at.own.col, .row = at.own.row + row});
    std::copy_n(
        from.begin() + static_cast<std::ptrdiff_t>(start), at.size.cols,
        to.begin() + static_cast<std::ptrdiff_t>(band.index({.col = at.first.col, .row = row})));
  };
  for (int row = rows.first; row < rows.end; ++row) {
    copy_row(around.front, out.front, row);
    copy_row(around.between, out.between, row);
    copy_row(around.steep, out.steep, row);
    copy_row(around.quality.counts, out.points, row);
  }
  return {.hidden = around.hidden.value_or(HiddenSurface{}), .outliers = around.outliers};
}

TileLosses depthsByRule(const Gridding& gridding, const TileEdges& edges, int tile,
                        DepthRows& out) {
  const TileAround at(gridding.layout, tile, gridding.spacing_mm);
  TileLosses losses;
  for (const RowRange rows : partsOf(at, gridding)) {
    const TileLosses some = depthsOfRows(at, rows, gridding, edges, out);
    losses.hidden = losses.hidden + some.hidden;
    losses.outliers += some.outliers;
  }
  return losses;
}

void depthsFromStates(const Gridding& gridding, const TileStore& store, int tile, DepthRows& out) {
  const std::vector<CellState> states = store.states(tile);
  const Cell first = gridding.layout.firstCell(tile);
  const GridSize size = gridding.layout.sizeOf(tile);
  const GridSize band{.cols = gridding.layout.map.cols, .rows = out.rows};
  for (std::size_t i = 0; i < states.size(); ++i) {
    const CellState& state = states[i];
    const int cell = static_cast<int>(i);
    float& depth =
        out.front[band.index({.col = first.col + cell % size.cols, .row = cell / size.cols})];
    if (state.count == 0) {
      depth = std::numeric_limits<float>::quiet_NaN();
    } else if (gridding.rule == PointRule::mean) {
      depth = static_cast<float>(static_cast<double>(state.sum) * store.sumUnitMm() / state.count);
    } else {
      const bool by_second = gridding.rule == PointRule::second && state.count > 1;
      depth = by_second ? state.second : state.first;
    }
  }
}

/// Gives the samples by which core/depth chooses, one after the other.
template <class Take>
void forSamples(const TileStore& store, double spacing_mm, const Task& task, const Take& take) {
  const TileLayout& layout = store.layout();
  const GridFrame frame{
      .size = layout.map, .spacing_mm = spacing_mm, .first_x_mm = 0, .first_y_mm = 0};
  for (const RowRange& range : rowsOfSamples(layout.map)) {
    const RowRange rows{.first = std::max(range.first, 0),
                        .end = std::min(range.end, layout.map.rows)};
    Scan scan;
    scan.points.reserve(pointsInRows(store, rows));
    for (int tile = rows.first / kTileSide * layout.across();
         tile < ((rows.end - 1) / kTileSide + 1) * layout.across(); ++tile) {
      task.check();
      const Cell corner = layout.firstCell(tile);
      const GridSize size = layout.sizeOf(tile);
      const auto is_wanted = [&](int row) { return row >= rows.first && row < rows.end; };
      placeTile(
          store.points(tile, {.first = rows.first - corner.row, .end = rows.end - corner.row}),
          size, corner, frame, scan, is_wanted);
    }
    const DepthRequest request{.scan = scan, .view_from_file = {}, .frame = frame};
    take(sampleOf(CellPoints(request, std::array{range}, task), range, frame));
  }
}

void sum(const std::vector<TileLosses>& tiles, DepthRows& out) {
  out.hidden = HiddenSurface{};
  out.outliers = 0;
  for (const TileLosses& tile : tiles) {
    out.hidden = *out.hidden + tile.hidden;
    out.outliers += tile.outliers;
  }
}

}  // namespace

bool isMergeable(PointRule rule) {
  return rule == PointRule::front || rule == PointRule::second || rule == PointRule::mean;
}

LeftOut scatterIntoTiles(const PointSource& source, const ViewFromFile& view_from_file,
                         const GridFrame& frame, TileStore& store, const Task& task,
                         const FrontSurface* front) {
  const TileFromPoint tile_from_point(view_from_file, frame, front);
  const std::uint64_t step = store.pointsAtOnce();
  std::vector<TilePart> parts(static_cast<std::size_t>(store.threads()));
  LeftOut left_out;
  for (std::uint64_t start = 0; start < source.count; start += step) {
    task.check();
    task.report("Sorting points into tiles",
                static_cast<double>(start) / static_cast<double>(source.count));
    const std::uint64_t end = std::min(start + step, source.count);
    for (TilePart& part : parts) part = {};
    inParts(start, end, store.threads(), [&](int part, std::uint64_t first, std::uint64_t last) {
      parts[static_cast<std::size_t>(part)] = readPart(source, tile_from_point, first, last);
    });
    for (const TilePart& part : parts) {
      store.add(part.points);
      left_out.hidden += part.left_out.hidden;
      left_out.strays += part.left_out.strays;
      left_out.on_front += part.left_out.on_front;
    }
  }
  return left_out;
}

std::vector<TilePoint> placedPoints(const PointSource& source, const ViewFromFile& view_from_file,
                                    const GridFrame& frame, const PointRange& range, int threads,
                                    LeftOut& left_out, const FrontSurface* front) {
  const TileFromPoint tile_from_point(view_from_file, frame, front);
  std::vector<TilePart> parts(static_cast<std::size_t>(threads));
  inParts(range.first, range.first + range.count, threads,
          [&](int part, std::uint64_t first, std::uint64_t last) {
            parts[static_cast<std::size_t>(part)] = readPart(source, tile_from_point, first, last);
          });
  std::vector<TilePoint> placed;
  placed.reserve(range.count);
  for (const TilePart& part : parts) {
    placed.insert(placed.end(), part.points.begin(), part.points.end());
    left_out.hidden += part.left_out.hidden;
    left_out.strays += part.left_out.strays;
    left_out.on_front += part.left_out.on_front;
  }
  return placed;
}

namespace {

/// What one thread makes of its share of points with values.
struct ValuePart {
  std::vector<ValueStore::Placed> points;
  IntensityCounts counts = IntensityCounts(65536);
};

void readValues(const ValueSource& source, const TileFromPoint& tile_from_point,
                std::uint64_t first, std::uint64_t end, ValuePart& part) {
  constexpr std::uint64_t kBlock = 16384;
  part.points.clear();
  part.points.reserve(end - first);
  std::vector<FilePoint> block(std::min(kBlock, end - first));
  std::vector<PointValue> values(block.size());
  while (first < end) {
    const auto wanted = static_cast<std::size_t>(std::min(kBlock, end - first));
    const std::size_t got =
        source.read(first, std::span(block).first(wanted), std::span(values).first(wanted));
    if (got == 0) return;
    for (std::size_t i = 0; i < got; ++i) {
      if (!isFinite(block[i])) continue;
      ++part.counts[values[i].intensity];
      TilePoint placed;
      LeftOut nothing;
      if (!tile_from_point(block[i], placed, nothing)) continue;
      part.points.push_back({.tile = placed.tile,
                             .point = {.z = placed.point.z,
                                       .colour = values[i].colour,
                                       .intensity = values[i].intensity,
                                       .cell = placed.point.cell}});
    }
    first += got;
  }
}

}  // namespace

IntensityCounts scatterValues(const ValueSource& source, const ViewFromFile& view_from_file,
                              const GridFrame& frame, ValueStore& store, const Task& task) {
  const TileFromPoint tile_from_point(view_from_file, frame, nullptr);
  const std::uint64_t step = store.pointsAtOnce();
  std::vector<ValuePart> parts(static_cast<std::size_t>(store.threads()));
  for (std::uint64_t start = 0; start < source.count; start += step) {
    task.check();
    task.report("Sorting colours into tiles",
                static_cast<double>(start) / static_cast<double>(source.count));
    inParts(start, std::min(start + step, source.count), store.threads(),
            [&](int part, std::uint64_t first, std::uint64_t last) {
              ValuePart& mine = parts[static_cast<std::size_t>(part)];
              readValues(source, tile_from_point, first, last, mine);
            });
    for (const ValuePart& part : parts) store.add(part.points);
    for (ValuePart& part : parts) part.points.clear();
  }
  IntensityCounts counts(65536);
  for (const ValuePart& part : parts) {
    std::transform(counts.begin(), counts.end(), part.counts.begin(), counts.begin(),
                   std::plus<>());
  }
  return counts;
}

RuleProposal proposeRule(const TileStore& store, double spacing_mm, const Task& task) {
  SampleCounts found;
  forSamples(store, spacing_mm, task,
             [&](const RowSample& sample) { found.add(sample, spacing_mm); });
  return proposeRule(found);
}

double pointNoise(const TileStore& store, double spacing_mm, const Task& task) {
  std::vector<double> noises;
  forSamples(store, spacing_mm, task,
             [&](const RowSample& sample) { noises.push_back(noiseOf(sample, spacing_mm)); });
  return middleNoise(std::move(noises));
}

struct DepthMaker::Impl {
  const TileStore& store;
  Gridding gridding;
  int workers;
  TileEdges edges;
  DepthRows band;
  std::vector<TileLosses> losses;
};

DepthMaker::DepthMaker(const TileStore& store, PointRule rule, double spacing_mm,
                       const GriddingRoom& room, const Task& task)
    : impl_(new Impl{
          .store = store,
          .gridding = {.store = store,
                       .layout = store.layout(),
                       .rule = rule,
                       .spacing_mm = spacing_mm,
                       .noise_mm =
                           rule == PointRule::quadratic ? pointNoise(store, spacing_mm, task) : 0,
                       .points_at_once = room.points_at_once},
          .workers = room.workers > 0 ? room.workers : store.threads(),
          .edges = TileEdges(store),
          .band = {},
          .losses = std::vector<TileLosses>(static_cast<std::size_t>(store.layout().across()))}) {}

DepthMaker::~DepthMaker() = default;

const DepthRows& DepthMaker::row(int y, const Task& task) {
  const TileStore& store = impl_->store;
  const TileLayout& layout = store.layout();
  DepthRows& band = impl_->band;
  task.check();
  task.report("Heights of cells", static_cast<double>(y) / layout.down());
  if (!store.merges()) impl_->edges.centre(y, impl_->workers);
  band.first_row = y * kTileSide;
  band.rows = layout.sizeOf(y * layout.across()).rows;
  const GridSize size{.cols = layout.map.cols, .rows = band.rows};
  band.front.resize(size.count());
  if (looksAround(impl_->gridding.rule)) band.between.resize(size.count());
  if (!store.merges()) {
    band.steep.resize(size.count());
    band.points.resize(size.count());
  }
  inParts(0, static_cast<std::uint64_t>(layout.across()), impl_->workers,
          [&](int, std::uint64_t first, std::uint64_t end) {
            for (int x = static_cast<int>(first); x < static_cast<int>(end); ++x) {
              task.check();
              const int tile = y * layout.across() + x;
              if (store.merges()) {
                depthsFromStates(impl_->gridding, store, tile, band);
              } else {
                impl_->losses[static_cast<std::size_t>(x)] =
                    depthsByRule(impl_->gridding, impl_->edges, tile, band);
              }
            }
          });
  if (!store.merges()) sum(impl_->losses, band);
  return band;
}

void makeDepths(const TileStore& store, PointRule rule, double spacing_mm, const TakeDepths& take,
                const Task& task, const GriddingRoom& room) {
  DepthMaker maker(store, rule, spacing_mm, room, task);
  for (int y = 0; y < store.layout().down(); ++y) take(maker.row(y, task));
}

}  // namespace relievo
