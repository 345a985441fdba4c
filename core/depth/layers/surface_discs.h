// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/task.h"

namespace relievo {

/// A piece of surface around a point: an oriented disc, cut where the surface around the point
/// ends. Coordinates are those of the points it was made from.
struct SurfaceDisc {
  std::array<float, 3> centre;
  std::array<float, 3> normal;     ///< Unit; toward the viewer (z >= 0).
  std::array<float, 3> right, up;  ///< Unit, in the plane of the disc.
  float radius = 0;
  /// How far the disc reaches along right, -right, up, -up, and the diagonals between right and up,
  /// and right and -up, to both sides: no farther than half a spacing beyond the last neighbour.
  std::array<float, 8> reach{};
  float spacing = 0;  ///< Mean distance of neighbouring points here.
};

struct SurfaceDiscs {
  std::vector<SurfaceDisc> discs;
  double spacing = 0;      ///< Median of the discs'.
  double roughness = 0;    ///< Median distance of the points from the planes of their neighbours,
                           ///< rms, in units of the neighbourhood's own width; noise of the points.
  std::size_t strays = 0;  ///< Points that stand alone in space; they have no disc.
};

/// Discs of a surface that is known by points: plane through the 12 nearest neighbours in 3-D
/// (FLANN), as large as 8 neighbours make it, facing the viewer where the neighbours lie in no
/// plane. Points far off all others, or off the plane of their neighbours, are strays. The same for
/// any number of threads. [worker]
/// @throw Cancelled
SurfaceDiscs surfaceDiscs(std::span<const std::array<float, 3>> points, const Task& task);

}  // namespace relievo
