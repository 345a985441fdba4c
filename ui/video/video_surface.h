// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/depth/colours/colours.h"
#include "core/relief/look.h"
#include "core/session/surface.h"
#include "ui/vtk/relief_scene.h"

namespace relievo {

/// Which part of a surface a video's scene holds; gives the scene another one only where it must.
/// [one thread]
class VideoSurface {
 public:
  VideoSurface(const Surface& surface, const ReliefLook& look) : surface_(surface), look_(look) {}

  /// The 200 x 200 samples of a window: what was under the hand, as the detail view shows it.
  /// @throw ArgumentError  also: the look shows colours that the surface has not; FileError (tiles)
  void showWindow(ReliefScene& scene, const Region& region, double gain);
  /// The map within a rectangle, at the coarsest level that is fine enough for a picture of it.
  void showPart(ReliefScene& scene, const RectMm& rect, double gain);
  double midHeightMm() const { return mid_height_mm_; }

 private:
  void show(ReliefScene& scene, const DepthMap& map, const GridColours& own);

  const Surface& surface_;
  const ReliefLook& look_;
  std::optional<Region> window_;
  std::optional<RectMm> part_;
  int part_level_ = -1;
  double gain_ = 0;
  double mid_height_mm_ = 0;
};

}  // namespace relievo
