// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "haptics/proxy/first_hit.h"
#include "haptics/proxy/friction.h"
#include "haptics/proxy/proxy.h"
#include "haptics/proxy/slide.h"

namespace relievo {

/// The exact god-object on any surface of patches: brought down from the last proxy monotonically,
/// patch by patch over creases and freely, one cell at a time, where the surface is smooth.
template <class Surface>
class Follower {
  using Patch = typename Surface::Patch;

 public:
  Follower(const Surface& surface, ProxyState state, const ProxyOptions& options) RELIEVO_REALTIME
      : surface_(surface),
        state_(state),
        options_(options) {}

  /// Follows the hand to `hip`, in steps of one cell; of three where it jumps and the
  /// proxy is on smooth ground. @return where the proxy is then
  ProxyState to(GridPoint hip) RELIEVO_REALTIME {
    const GridPoint from = state_.hip, way = hip - from;
    const double length = norm(way);
    int spent = 0;
    if (length > 1) {
      const bool jumps = length > kJumpCells;
      const double sub_steps = std::min(std::ceil(length), kMostSubSteps);
      last_step_ = jumps ? kJumpingStepCells : kPassingStepCells;
      for (double i = 1; i < sub_steps && spent < kMostPerTick; ++i) {
        if (jumps && surface_.isSmooth(state_.position.x, state_.position.y)) i += 2;
        if (i < sub_steps) spent += settle(from + (i / sub_steps) * way);
      }
    }
    last_step_ = kLastStepCells;
    settle(hip);
    return state_;
  }

 private:
  static constexpr int kMostIterations = 256;   // Of one sub-step.
  static constexpr int kMostPerTick = 4096;     // Of all sub-steps: bounds the work of a tick.
  static constexpr double kMostSubSteps = 256;  // One cell each, unless the hand jumped farther.
  /// On the way to a far hand it is enough to end so near: Newton's next step were its square.
  static constexpr double kPassingStepCells = 0.02;
  /// No hand goes so far in a millisecond: it was put there. Where nothing breaks longer steps
  /// find the same place (tests/haptics/proxy/sharp_scenes_test.cpp).
  static constexpr double kJumpCells = 8, kJumpingStepCells = 0.3;
  enum class Step : std::uint8_t { go_on, at_rest };

  const Surface& surface_;
  ProxyState state_;
  const ProxyOptions& options_;
  Patch patch_;  // Around state_.position, if have_patch_.
  bool have_patch_ = false;
  double last_step_ = kLastStepCells;  // A trusted Newton step shorter than this is the last one.

  /// @return iterations spent
  int settle(GridPoint hip) RELIEVO_REALTIME {
    state_.hip = hip;
    if (!state_.contact) {
      const Hit hit = firstHit(surface_, state_.position, hip);
      state_.position = hit.point;
      state_.contact = hit.found;
      state_.slides = true;
      state_.still = 0;
      state_.trail_x = state_.trail_y = 0;
      have_patch_ = false;
    }
    const bool rubs = state_.contact && options_.static_friction > 0;
    if (rubs && sticks(surface_, state_, options_)) return 1;
    const GridPoint before = state_.position;
    int iterations = 0;
    while (state_.contact && iterations < kMostIterations) {
      ++iterations;
      if (step() == Step::at_rest) break;
    }
    if (rubs && state_.contact) {
      state_.position = heldBack(surface_, before, state_, options_, surface_.deviceMmPerCell());
      have_patch_ = false;
    }
    return iterations;
  }

  bool inside(const CellBox& box) const RELIEVO_REALTIME {
    const GridPoint p = state_.position;
    return p.x > box.x_low && p.x < box.x_high && p.y > box.y_low && p.y < box.y_high;
  }

  Step step() RELIEVO_REALTIME {
    const GridPoint p = state_.position;
    if (!have_patch_ || !inside(patch_.box)) {
      const Sides sides = sidesAt(surface_, p.x, p.y);
      if (sides.count > 1) return stepOnLine(sides);
      patch_ = surface_.patch(p.x, p.y, 1, 1);
      have_patch_ = true;
    }
    const GridPoint e = p - state_.hip;
    const Jet jet = patch_.jet(p.x, p.y);
    if (isFree(jet, e)) return leave();
    const Slope slope = slopeOf(jet, e);
    const Descent way = newton(slope);
    const double length = std::abs(way.dx) + std::abs(way.dy);
    if (length <= kConvergedCells) return Step::at_rest;
    if (runs(way, length)) {
      return way.trusted && length < last_step_ ? Step::at_rest : Step::go_on;
    }
    const Descent down = steepest(patch_.box, p, slope);
    if (down.rate <= kConvergedCells + 1e-14 * norm(e)) return Step::at_rest;
    return takeInside(patch_, state_.position, state_.hip, down) ? Step::go_on : Step::at_rest;
  }

  /// Does the way to the HIP rise off the surface?
  static bool isFree(const Jet& jet, GridPoint e) RELIEVO_REALTIME {
    const double rise = jet.fx * e.x + jet.fy * e.y - e.z;  // Of the way -e.
    return rise > 0 && rise > 1e-12 * norm(e);
  }

  Step leave() RELIEVO_REALTIME {
    const Hit hit = firstHit(surface_, state_.position, state_.hip);
    have_patch_ = false;
    const GridPoint moved = hit.point - state_.position;
    if (!hit.found) {
      state_.position = state_.hip;
      state_.contact = false;
      return Step::at_rest;
    }
    if (norm(moved) <= 1e-12)
      return stepOnLine(sidesAt(surface_, state_.position.x, state_.position.y));
    state_.position = hit.point;
    return Step::go_on;
  }

  /// Takes a Newton step of at most one cell, over the cell's border where nothing is broken there.
  /// @return false: phi does not fall that way
  bool runs(Descent way, double length) RELIEVO_REALTIME {
    const GridPoint p = state_.position;
    if (length > 1) {
      way.dx /= length;
      way.dy /= length;
    }
    GridPoint next{p.x + way.dx, p.y + way.dy, 0};
    const CellBox& box = patch_.box;
    if (next.x > box.x_low && next.x < box.x_high && next.y > box.y_low && next.y < box.y_high) {
      next.z = patch_.height(next.x, next.y);
      // Of a tiny step only rounding could say that phi does not fall.
      if ((way.trusted && length < kLastStepCells) || change(p, next, state_.hip) < 0) {
        state_.position = next;
        return true;
      }
    } else if (surface_.runsOn(patch_, next.x, next.y)) {
      const Patch beyond = surface_.patch(next.x, next.y, 1, 1);
      next.z = beyond.height(next.x, next.y);
      if (change(p, next, state_.hip) < 0) {
        state_.position = next;
        patch_ = beyond;
        return true;
      }
    }
    return takeInside(patch_, state_.position, state_.hip, way);
  }

  /// One step from a line between cells, or a corner: into or along the cell that falls most.
  Step stepOnLine(const Sides& sides) RELIEVO_REALTIME {
    const GridPoint p = state_.position, e = p - state_.hip;
    have_patch_ = false;
    const Jet ahead = surface_.patch(p.x, p.y, -e.x, -e.y).jet(p.x, p.y);
    if (sides.count > 1 && isFree(ahead, e)) {
      const Hit hit = firstHit(surface_, p, state_.hip);
      if (!hit.found) {
        state_.position = state_.hip;
        state_.contact = false;
        return Step::at_rest;
      }
      if (norm(hit.point - p) > 1e-12) {
        state_.position = hit.point;
        return Step::go_on;
      }
    }
    Patch best_cell;
    Slope best_slope;
    Descent best;
    for (std::size_t i = 0; i < static_cast<std::size_t>(sides.count); ++i) {
      const Patch cell = surface_.patch(p.x, p.y, sides.dx[i], sides.dy[i]);
      const Slope slope = slopeOf(cell.jet(p.x, p.y), e);
      const Descent down = steepest(cell.box, p, slope);
      if (down.rate > best.rate) {
        best_cell = cell;
        best_slope = slope;
        best = down;
      }
    }
    if (best.rate <= kConvergedCells + 1e-14 * norm(e)) return Step::at_rest;
    const bool along_edge = best.dx == 0 || best.dy == 0;
    if (!along_edge) {
      const Descent way = newton(best_slope);
      if (staysInside(best_cell.box, p, way.dx, way.dy) &&
          takeInside(best_cell, state_.position, state_.hip, way)) {
        return Step::go_on;
      }
    }
    return takeInside(best_cell, state_.position, state_.hip, best) ? Step::go_on : Step::at_rest;
  }
};

}  // namespace relievo
