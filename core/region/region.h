// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/base/grid.h"
#include "core/base/vec3.h"
#include "core/depth/depth_map.h"
#include "core/pyramid/pyramid.h"
#include "core/region/square.h"

namespace relievo {

/// The steps that finer and coarser go through, and the map they stay on.
/// Detail 1 is the whole map at the coarsest level; Detail k > 1 is a square of 200 cells of
/// level (levels - k), the finest level last.
struct DetailLadder {
  double left_mm = 0, bottom_mm = 0, width_mm = 0, height_mm = 0;  ///< The map, view mm.
  std::vector<double> spacings_mm;                                 ///< Per level, finest first.
  double factor = 2;                                               ///< The paper's M.

  int levels() const noexcept { return static_cast<int>(spacings_mm.size()); }
  /// Side of detail k, 1 <= k <= levels().
  double sideMm(int detail) const noexcept;
  /// "Detail k of n" for a level.
  int detailOf(Level level) const noexcept { return levels() - level.value; }
};
DetailLadder detailLadder(const DepthMap& map, const Pyramid& pyramid);

/// The whole map, widened about its centre to a square, at the coarsest level: Detail 1.
Region wholeRegion(const DetailLadder& ladder);

/// The finest level whose spacing is at least side/200/sqrt(M); the coarsest if there is none.
Level defaultLevel(const DetailLadder& ladder, double side_mm);

/// From a drawn or typed rectangle: a square of side max(width, height) about the same centre.
/// @param level  nothing: defaultLevel
/// @throw ArgumentError  size not finite and > 0, or no such level
struct RectMm {
  double x_mm = 0, y_mm = 0, width_mm = 0, height_mm = 0;
  friend bool operator==(const RectMm&, const RectMm&) = default;
};
Region regionFromRect(const DetailLadder& ladder, const RectMm& rect,
                      std::optional<Level> level = std::nullopt);

/// Where finer and coarser happen.
struct StepAbout {
  double x_mm = 0, y_mm = 0;  ///< The probe (or the window's centre), view mm.
  bool touching = false;      ///< In contact the point keeps its place under the hand.
};

// Pure navigation, shared by mouse, keys and device buttons. Each returns the region to go to, or
// nothing at the limit.
std::optional<Region> finer(const DetailLadder& ladder, const Region& from, const StepAbout& about);
std::optional<Region> coarser(const DetailLadder& ladder, const Region& from,
                              const StepAbout& about);
/// Moves the window by dx, dy in parts of its side (0.25 = the 25 % step), kept on the map.
std::optional<Region> moved(const DetailLadder& ladder, const Region& from, double dx, double dy);
/// Does the square cover a part of the map?
bool onMap(const DetailLadder& ladder, const Region& region) noexcept;
/// Same square at another level.
std::optional<Region> atLevel(const DetailLadder& ladder, const Region& from, Level level);

}  // namespace relievo
