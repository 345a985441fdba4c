// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/tile_rows.h"

#include <algorithm>
#include <numeric>

#include "core/depth/rules/rule_choice.h"
#include "core/tiles/points/scatter.h"

namespace relievo {
namespace {

/// Where the part that begins at `first` may end next after `end`.
int nextEnd(int end, const RowCuts& cuts, int rows) {
  int next = end < cuts.first_step
                 ? cuts.first_step
                 : cuts.first_step + ((end - cuts.first_step) / cuts.step + 1) * cuts.step;
  return std::min(next, rows);
}

/// Points in rows before each, and all.
std::vector<std::size_t> sumsOf(const std::vector<std::size_t>& points) {
  std::vector<std::size_t> sums(points.size() + 1, 0);
  std::partial_sum(points.begin(), points.end(), sums.begin() + 1);
  return sums;
}

std::size_t lookedAt(const std::vector<std::size_t>& sums, RowRange rows, int reach) {
  const int last = static_cast<int>(sums.size()) - 1;
  return sums[static_cast<std::size_t>(std::min(rows.end + reach, last))] -
         sums[static_cast<std::size_t>(std::max(rows.first - reach, 0))];
}

}  // namespace

std::vector<std::size_t> pointsOfRows(const TileStore& store, int tile) {
  const GridSize size = store.layout().sizeOf(tile);
  std::vector<std::size_t> rows(static_cast<std::size_t>(size.rows), 0);
  store.forEachPiece(tile, [&](std::span<const CellPoint> piece) {
    for (const CellPoint& p : piece) ++rows[static_cast<std::size_t>(p.cell / size.cols)];
  });
  return rows;
}

std::size_t pointsInRows(const TileStore& store, RowRange rows) {
  const TileLayout& layout = store.layout();
  std::size_t points = 0;
  for (int y = rows.first / kTileSide; y <= (rows.end - 1) / kTileSide; ++y) {
    const int first = y * kTileSide;
    for (int tile = y * layout.across(); tile < (y + 1) * layout.across(); ++tile) {
      const GridSize size = layout.sizeOf(tile);
      const int low = std::max(rows.first - first, 0);
      const int end = std::min(rows.end - first, size.rows);
      if (low == 0 && end == size.rows) {
        points += store.pointsIn(tile);
        continue;
      }
      const std::vector<std::size_t> of_rows = pointsOfRows(store, tile);
      points = std::accumulate(of_rows.begin() + low, of_rows.begin() + end, points);
    }
  }
  return points;
}

std::vector<RowRange> rowsWithin(const std::vector<std::size_t>& points, const RowCuts& cuts,
                                 std::size_t most) {
  const std::vector<std::size_t> sums = sumsOf(points);
  const int rows = static_cast<int>(points.size());
  std::vector<RowRange> parts;
  for (int first = 0; first < rows;) {
    int end = nextEnd(first, cuts, rows);
    for (int next = nextEnd(end, cuts, rows);
         end < rows && lookedAt(sums, {.first = first, .end = next}, cuts.reach) <= most;
         next = nextEnd(end, cuts, rows)) {
      end = next;
    }
    parts.push_back({.first = first, .end = end});
    first = end;
  }
  return parts;
}

std::size_t leastAtOnce(const std::vector<std::size_t>& points, const RowCuts& cuts) {
  const std::vector<std::size_t> sums = sumsOf(points);
  std::size_t most = 0;
  for (const RowRange& part : rowsWithin(points, cuts, 0)) {
    most = std::max(most, lookedAt(sums, part, cuts.reach));
  }
  return most;
}

bool looksAround(PointRule rule) noexcept {
  return rule == PointRule::quadratic || rule == PointRule::splat;
}

CellRange withAround(const TileLayout& layout, int tile) noexcept {
  const Cell first = layout.firstCell(tile);
  const GridSize size = layout.sizeOf(tile);
  return {.first = {.col = std::max(first.col - kRuleReach, 0),
                    .row = std::max(first.row - kRuleReach, 0)},
          .end = {.col = std::min(first.col + size.cols + kRuleReach, layout.map.cols),
                  .row = std::min(first.row + size.rows + kRuleReach, layout.map.rows)}};
}

RowCuts cutsOf(const TileLayout& layout, int tile, PointRule rule) {
  if (!looksAround(rule)) return {.reach = kRuleReach};
  const CellRange around = withAround(layout, tile);
  const int step = rowsAtOnce(
      {.cols = around.end.col - around.first.col, .rows = around.end.row - around.first.row});
  const int below = layout.firstCell(tile).row - around.first.row;
  return {.reach = kRuleReach, .step = step, .first_step = step - below % step};
}

std::size_t samplePoints(const TileStore& store) {
  const int rows = store.layout().map.rows;
  std::size_t most = 0;
  for (const RowRange& range : rowsOfSamples(store.layout().map)) {
    most = std::max(most, pointsInRows(store, {.first = std::max(range.first, 0),
                                               .end = std::min(range.end, rows)}));
  }
  return most;
}

GriddingNeeds griddingNeeds(const TileStore& store, PointRule rule, std::size_t ample) {
  const TileLayout& layout = store.layout();
  GriddingNeeds needs;
  std::vector<std::size_t> edges(static_cast<std::size_t>(layout.down()), 0);
  const auto edge_points = [&](int x, int y) {
    const bool is_there = x >= 0 && y >= 0 && x < layout.across() && y < layout.down();
    return is_there ? store.edgePointsIn(y * layout.across() + x) : 0;
  };
  for (int tile = 0; tile < layout.count(); ++tile) {
    const int x = tile % layout.across(), y = tile / layout.across();
    edges[static_cast<std::size_t>(y)] += edge_points(x, y);
    std::size_t around = 0;
    for (int i = 0; i < 9; ++i) around += i == 4 ? 0 : edge_points(x - 1 + i % 3, y - 1 + i / 3);
    needs.around = std::max(needs.around, around / 4);  // Each has four edges.
    const std::size_t points = store.pointsIn(tile);
    needs.at_once = std::max(needs.at_once, points);
    if (points <= needs.least_at_once) continue;
    needs.least_at_once = std::max(
        needs.least_at_once,
        points <= ample ? points
                        : leastAtOnce(pointsOfRows(store, tile), cutsOf(layout, tile, rule)));
  }
  for (std::size_t y = 0; y < edges.size(); ++y) {
    const auto first = edges.begin() + static_cast<std::ptrdiff_t>(y > 0 ? y - 1 : 0);
    const auto end = edges.begin() + static_cast<std::ptrdiff_t>(std::min(y + 2, edges.size()));
    needs.edge_points = std::max(needs.edge_points, std::accumulate(first, end, std::size_t{0}));
  }
  if (rule == PointRule::quadratic) needs.sample_points = samplePoints(store);
  return needs;
}

}  // namespace relievo
