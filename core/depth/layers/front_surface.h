// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/base/vec3.h"
#include "core/depth/depth_request.h"
#include "core/depth/layers/disc_raster.h"
#include "core/depth/layers/surface_discs.h"
#include "core/depth/rules/even_points.h"

namespace relievo {

/// Where the front of a closed object is, seen along -z, known from its points in 3-D before any
/// cell of a map gets a height: discs around the points are drawn into a raster, the nearest to the
/// viewer in front; a point counts if it lies on what is in front there.
/// Coordinates are millimetres of the view, from the lower corner of the box it was made with.
class FrontSurface {
 public:
  enum class Side {
    front,   ///< On the surface that is seen.
    hidden,  ///< Behind it.
    stray,   ///< Before it, or where no surface is.
  };

  /// Discs of at most `kMostDiscs` points, drawn on all cores; the same bytes for any number of
  /// them. [worker] @throw Cancelled
  FrontSurface(const ViewBlocks& points, const ViewBox& box, std::uint64_t count, const Task& task);

  /// [any thread]
  Side sideOf(const ViewMm& from_corner) const noexcept;

  /// Height of the surface in front at a place, NaN where there is none. [any thread]
  float depthAt(double x_mm, double y_mm) const noexcept;

  /// Shares of the covered area behind which something lies hidden.
  struct Behind {
    double hidden = 0;
    double in_layers = 0;  ///< Of it, where that does not lie in one layer.
  };
  const Behind& behind() const noexcept { return behind_; }

  std::size_t bytes() const noexcept { return pieces_.capacity() * sizeof(FrontPiece); }
  double spacingMm() const noexcept { return spacing_mm_; }  ///< Median of the discs.
  /// How far the surface may be off along the view: standard deviation of its discs' middles about
  /// it, from the median.
  double noiseMm() const noexcept { return noise_mm_; }
  double coveredMm2() const noexcept;  ///< Of the view, by the surface.

  static constexpr std::size_t kMostDiscs = 200'000;

 private:
  void measureNoise(const std::vector<SurfaceDisc>& discs);
  void lookBehind(const std::vector<SurfaceDisc>& discs);
  const FrontPiece* pieceAt(double x_mm, double y_mm) const noexcept;

  GridSize size_;
  double pixel_mm_ = 0;
  double spacing_mm_ = 0;
  double noise_mm_ = 0;
  Behind behind_;
  std::vector<FrontPiece> pieces_;
};

}  // namespace relievo
