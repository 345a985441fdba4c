// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/proxy/first_hit.h"

#include <algorithm>
#include <cmath>

#include "haptics/proxy/crossing.h"

namespace relievo {

namespace {
/// Parameter at which the segment leaves a box along one axis.
double leaves(double from, double step, double low, double high) RELIEVO_REALTIME {
  if (step > 0) return (high - from) / step;
  if (step < 0) return (low - from) / step;
  return kNever;
}

/// A segment, how far along it the walk has come, and the cell that it enters there. Every place is
/// computed from the segment and the line of cells it lies on, never from the place before, so that
/// a walk that skips cells comes to the same bits.
struct Walk {
  GridPoint from, to, step;
  int col, row;
  double t = 0;
  GridPoint at;

  Walk(GridPoint start, GridPoint end) RELIEVO_REALTIME : from(start),
                                                          to(end),
                                                          step(end - start),
                                                          col(cellOf(start.x, step.x)),
                                                          row(cellOf(start.y, step.y)),
                                                          at(start) {}

  double leavesX(CellBox box) const RELIEVO_REALTIME {
    return leaves(from.x, step.x, box.x_low, box.x_high);
  }
  double leavesY(CellBox box) const RELIEVO_REALTIME {
    return leaves(from.y, step.y, box.y_low, box.y_high);
  }
  /// Where the segment leaves a box, exactly on its border, so that both cells agree where it is.
  GridPoint exitOf(CellBox box, double tx, double ty) const RELIEVO_REALTIME {
    const double exit_t = std::min(tx, ty);
    if (exit_t >= 1) return to;
    GridPoint exit = from + exit_t * step;
    if (tx <= ty) exit.x = step.x > 0 ? box.x_high : box.x_low;
    if (ty <= tx) exit.y = step.y > 0 ? box.y_high : box.y_low;
    return exit;
  }
  /// Enters the next cell. @return false: the segment ends before
  bool turn(CellBox box) RELIEVO_REALTIME {
    const double tx = leavesX(box), ty = leavesY(box);
    at = exitOf(box, tx, ty);
    t = std::min(tx, ty);
    if (t >= 1) return false;
    if (tx <= ty) col += step.x > 0 ? 1 : -1;
    if (ty <= tx) row += step.y > 0 ? 1 : -1;
    return true;
  }
  bool inside() const RELIEVO_REALTIME {
    return col >= 0 && row >= 0 && col < kLastCell && row < kLastCell;
  }
  bool outOfReach() const RELIEVO_REALTIME {
    return col < kFirstCell || row < kFirstCell || col > kLastCell || row > kLastCell;
  }
  bool passBlock(const HapticSpace& space) RELIEVO_REALTIME;
};

/// Cell line that the segment has reached along one axis once all lines up to parameter t are
/// passed.
int lineAt(double from, double step, double t, int cell) RELIEVO_REALTIME {
  if (step > 0) {
    while ((cell + 1 - from) / step <= t) ++cell;
  } else if (step < 0) {
    while ((cell - from) / step <= t) --cell;
  }
  return cell;
}

/// If the line over which the cell was entered is crossed exactly at t, the place lies on it.
double snapped(double at, double from, double step, double t, int cell) RELIEVO_REALTIME {
  const int line = step > 0 ? cell : cell + 1;
  return step != 0 && (line - from) / step == t ? line : at;
}

/// Passes the largest block around the cell that lies below the segment. @return false: none does
bool Walk::passBlock(const HapticSpace& space) RELIEVO_REALTIME {
  for (std::size_t level = 0; level < BlockTops::kShift.size(); ++level) {
    const int shift = BlockTops::kShift[level];
    const int low_col = (col >> shift) << shift, low_row = (row >> shift) << shift;
    const int size = 1 << shift;
    const CellBox box{
        static_cast<double>(low_col), static_cast<double>(std::min(low_col + size, kLastCell)),
        static_cast<double>(low_row), static_cast<double>(std::min(low_row + size, kLastCell))};
    const double tx = leavesX(box), ty = leavesY(box);
    const GridPoint exit = exitOf(box, tx, ty);
    if (std::min(at.z, exit.z) <= static_cast<double>(space.block_tops.at(level, col, row)))
      continue;
    t = std::min(tx, ty);
    at = exit;
    if (t >= 1) return true;
    // The axis that is not left at the border may have crossed several lines on the way.
    col = lineAt(from.x, step.x, t, col);
    row = lineAt(from.y, step.y, t, row);
    at.x = snapped(at.x, from.x, step.x, t, col);
    at.y = snapped(at.y, from.y, step.y, t, row);
    return true;
  }
  return false;
}

template <class Surface>
Hit walkCells(const Surface& surface, GridPoint from, GridPoint to, RayWalk kind) RELIEVO_REALTIME {
  const HapticSpace& space = surface.space();
  Walk walk(from, to);
  constexpr double kFewCells = 4;  // A block's test costs more than that many cells.
  const bool far = std::abs(walk.step.x) + std::abs(walk.step.y) > kFewCells;
  const bool use_blocks = far && kind == RayWalk::blocks;
  constexpr int kMostCells = 2 * (kLastCell - kFirstCell + 2);
  for (int visited = 0; visited < kMostCells; ++visited) {
    const bool inside = walk.inside();
    if (use_blocks && inside && walk.passBlock(space)) {
      if (walk.t >= 1) return {false, to};
      continue;
    }
    const CellBox box = cellBox(walk.col, walk.row);
    const GridPoint entry = walk.at;
    const GridPoint exit = walk.exitOf(box, walk.leavesX(box), walk.leavesY(box));
    const bool above =
        inside && std::min(entry.z, exit.z) >
                      static_cast<double>(space.cell_tops[HapticSpace::index(walk.col, walk.row)]);
    if (!above) {
      const auto cell = surface.cell(walk.col, walk.row);
      const double part = crossing(cell, entry, exit);
      if (part <= 1) {
        const GridPoint p = entry + part * (exit - entry);
        return {true, {p.x, p.y, cell.height(p.x, p.y)}};
      }
    }
    if (!walk.turn(box)) return {false, to};
    if (walk.outOfReach()) break;
  }
  const GridPoint p = walk.at;
  return {true, {p.x, p.y, surface.patch(p.x, p.y, 0, 0).height(p.x, p.y)}};
}
}  // namespace

Hit firstHit(const BilinearSurface& surface, GridPoint from, GridPoint to,
             RayWalk walk) RELIEVO_REALTIME {
  return walkCells(surface, from, to, walk);
}
Hit firstHit(const SplineSurface& surface, GridPoint from, GridPoint to,
             RayWalk walk) RELIEVO_REALTIME {
  return walkCells(surface, from, to, walk);
}
Hit firstHit(const HapticSpace& space, GridPoint from, GridPoint to,
             RayWalk walk) RELIEVO_REALTIME {
  return onSurface(space, [&](const auto& s) { return walkCells(s, from, to, walk); });
}

}  // namespace relievo
