// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/base/transform.h"
#include "core/cloud/scan.h"

namespace relievo {

/// Which height a cell gets from the points in it.
enum class PointRule {
  front,     ///< The front-most; noise lifts it.
  second,    ///< The second from the front: one flyer is not it.
  top_mean,  ///< The mean of the layer nearest the viewer; keeps front and back apart.
  median,    ///< Not moved by flyers; for surfaces of one layer.
  mean,      ///< All points; for one layer without flyers.
};

/// What both depth engines are asked for: the surface nearest the viewer at the samples of a grid.
struct DepthRequest {
  const Scan& scan;
  ViewFromFile view_from_file;  ///< z not yet shifted to the base plane.
  GridFrame frame;
  PointRule rule = PointRule::front;  ///< For clouds; the OpenGL engine knows front only.
};

/// View z in millimetres of the front-most surface at every sample, NaN where nothing was hit.
/// Row-major, row 0 at the lowest y. Meshes as triangles, evaluated at the sample; clouds as
/// points, each counting for its nearest sample; `rule` says which height those of a sample give.
using FrontDepths = std::vector<float>;

/// A depth engine: the CPU rasterizer (core/depth/rasterize.h) or the OpenGL depth buffer
/// (ui/vtk/depth_capture.h). @throw Cancelled, GraphicsError
using DepthEngine = std::function<FrontDepths(const DepthRequest&, const Task&)>;

}  // namespace relievo
