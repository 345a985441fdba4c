// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/base/transform.h"
#include "core/cloud/scan.h"
#include "core/depth/depth_buffer_format.h"
#include "core/depth/quality.h"
#include "core/message/message.h"

namespace relievo {

/// Which height a cell gets from the points in and around it.
enum class PointRule {
  front,      ///< The front-most; noise lifts it.
  second,     ///< The second from the front: one outlier is not it.
  top_mean,   ///< The mean of the layer nearest the viewer; keeps front and back apart.
  median,     ///< Not moved by outliers; for surfaces of one layer.
  mean,       ///< All points; for one layer without outliers.
  splat,      ///< Mean with bilinear weights: a point counts for the four samples around it.
  quadratic,  ///< Local quadratic through the points around the sample; for one layer.
  lowest,     ///< The rear-most: the ground below plants; noise lowers it; for one layer.
};

/// Cells from `first` to before `end`.
struct CellRange {
  Cell first, end;
};
inline bool contains(const CellRange& box, Cell c) noexcept {
  return c.col >= box.first.col && c.row >= box.first.row && c.col < box.end.col &&
         c.row < box.end.row;
}

/// What both depth engines are asked for: the surface nearest the viewer at the samples of a grid.
struct DepthRequest {
  const Scan& scan;
  ViewFromFile view_from_file;  ///< z not yet shifted to the base plane.
  GridFrame frame;
  /// For clouds; nothing: chosen from the data. The OpenGL engine knows front only.
  std::optional<PointRule> rule = PointRule::front;
  int threads = 0;  ///< 0: as many as pay. The bytes are the same for every number.
  /// Noise of the points for PointRule::quadratic; nothing: from the points (pointNoise).
  std::optional<double> noise_mm = std::nullopt;
  /// Cells whose outliers and hidden points are counted, where the grid is a part of a larger one;
  /// nothing: all.
  std::optional<CellRange> counted = std::nullopt;
};

/// View z in millimetres of the front-most surface at every sample, NaN where nothing was hit.
/// Row-major, row 0 at the lowest y. Meshes as triangles, evaluated at the sample; clouds as
/// points, each counting for its nearest sample; `rule` says which height those of a sample give.
using FrontDepths = std::vector<float>;

/// What lies behind the front, in points or, for meshes, in mm^2 of surface.
struct HiddenSurface {
  double hidden = 0, all = 0;       ///< More than `kHiddenCells` behind the front; in all.
  std::size_t cells = 0;            ///< Cells with something hidden ...
  std::size_t cells_in_layers = 0;  ///< ... of these, where it does not lie in one layer.
};
inline constexpr double kHiddenCells = 4;  ///< Sample distances; less is the same surface.

/// Steeper than this the front is no height a single sample could stand for.
inline constexpr double kSteepRise = 5.6712818196177093;  // tan 80 degrees

/// All that an engine finds out while it looks at the scan once.
struct CapturedDepths {
  FrontDepths front;    ///< Measured: a cell without a point of its own is NaN.
  FrontDepths between;  ///< What the rule gives cells without a point (splat, quadratic), NaN where
                        ///< nothing; empty for the other rules.
  QualityMap quality;   ///< Clouds on the processor.
  std::vector<std::uint8_t> steep;      ///< Per cell 1: the surface in it rises by more than
                                        ///< `kSteepRise`; empty if not known.
  std::optional<HiddenSurface> hidden;  ///< If the engine counted it.
  bool one_layer = false;  ///< The rule is one for surfaces without a back: nothing shows through.
  std::optional<Message> rule;  ///< Which rule and why; nothing where there was no choice.
  std::size_t outliers =
      0;  ///< Points far off all their neighbours (core/depth/layers/outliers.h); left out.

  std::optional<DepthBufferFormat> depth_buffer;  ///< If the depths come from one.

  CapturedDepths() = default;
  /// An engine that knows depths only. Implicit, so that it serves as a `DepthEngine`.
  CapturedDepths(FrontDepths depths)  // NOLINT(google-explicit-constructor)
      : front(std::move(depths)) {}
};

/// A depth engine: the CPU rasterizer (core/depth/rules/rasterize.h) or the OpenGL depth buffer
/// (ui/vtk/depth_capture.h). @throw Cancelled, GraphicsError
using DepthEngine = std::function<CapturedDepths(const DepthRequest&, const Task&)>;

}  // namespace relievo
