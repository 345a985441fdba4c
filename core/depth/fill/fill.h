// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/depth/depth_map.h"
#include "core/depth/depth_request.h"
#include "core/depth/fill/mask.h"
#include "core/message/message.h"

namespace relievo {

enum class HoleRule {
  base,         ///< Enclosed holes rest on the base plane (the paper's rule).
  interpolate,  ///< Holes up to max_area_mm2 are filled with averages of their rim (push-pull).
  membrane,     ///< Holes up to max_area_mm2 get a membrane that leaves the rim without a crease.
  none,         ///< Holes are left open: outside, NaN in files.
};
struct HoleChoice {
  HoleRule rule = HoleRule::base;
  double max_area_mm2 = 0;  ///< For interpolate and membrane; larger holes rest on the base plane.
};

/// One enclosed hole of the map, after sampling gaps were closed.
struct Hole {
  std::size_t cells = 0;
  double area_mm2 = 0;
  double centre_x_mm = 0, centre_y_mm = 0;  ///< View.
  bool filled = false;                      ///< Interpolated on request.
};

/// What the cells of a hole become.
CellStatus originOfHole(const Hole& hole, HoleRule rule);

/// Does the choice ask for this hole to be filled?
bool isToBeFilled(const Hole& hole, const HoleChoice& choice);

/// Marks cells from which the surface rises to one side and falls to the other by more than
/// `kSteepRise`: walls that a cloud's points stand on one by one. Looks at the four neighbours.
/// @param steep  what the engine saw to be steep stays so
void markSteepCells(const float* depths, GridSize size, double spacing_mm, Mask& steep);

/// With gaps that are known: cells that are measured, and those with a height between the points.
Mask withBetween(Mask measured, std::span<const float> between);
inline constexpr int kCrackRadius = 1;  ///< Closing radius there, cells.

/// E202: "2 of 3 holes filled. ..." if the choice asked for filling and a hole was left; else
/// nothing.
std::optional<Message> holesLeft(const std::vector<Hole>& holes, const HoleChoice& choice);

struct FilledMap {
  DepthMap map;             ///< Heights above the base plane.
  double base_z_mm = 0;     ///< View z of the base plane, to be subtracted from view_from_file.
  std::vector<Hole> holes;  ///< Largest first.
  QualityMap quality;       ///< As captured.
  std::size_t seen_through = 0;  ///< Cells that showed the back through gaps of the front ...
  std::size_t seen_through_points = 0;  ///< ... and the points in them, if the engine counted.
};

/// What the depths come from.
struct FillSource {
  bool has_sampling_gaps = true;  ///< Points leave empty cells between them; triangles do not.
  double base_quantile = 0.001;   ///< Of the measured cells: the base plane. 0 is the lowest.
  std::optional<double> base_z_mm = std::nullopt;  ///< View z of it, where somebody said so.
  /// `between` has the surface wherever a gap is: nothing shows through, and no others are closed
  /// but cracks of one cell.
  bool gaps_are_known = false;
};

/// From raw front depths to a depth map: sampling gaps (empty cells smaller than the data's own
/// spacing) are interpolated, enclosed holes treated as chosen, the rest is outside. [worker]
/// @param depths  used up, for their memory
/// @throw ArgumentError  no cell was hit
FilledMap fillDepths(CapturedDepths&& depths, const GridFrame& frame, const FillSource& source,
                     const HoleChoice& choice, const Task& task = {});

}  // namespace relievo
