// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include "ui/vtk/relief_scene.h"

namespace relievo {

/// The relief as quads with per-vertex normals. Vertices are kept relative to the grid's middle, so
/// that their float coordinates are as fine on a site of kilometres as on a coin; `middle` puts
/// them back. A ring of vertices half a spacing beyond the outermost samples, as high as they are,
/// lets the picture fill the rectangle that a grid covers. Cells whose four corners are outside are
/// left out; of those with some outside, the scene draws the half next to the corners inside, so
/// that an outline lies half a spacing beyond the last samples there, too.
class SurfaceMesh {
 public:
  SurfaceMesh();

  /// Heights that are not finite count as outside. Vertices, cells and normals are rebuilt only as
  /// far as they changed: a window that moves keeps its cells.
  void update(const SurfaceGrid& grid);

  /// With half as many cells each way, whose corners are every second vertex; the rest stays.
  /// @return whether it was not so before
  bool setCoarse(bool coarse);

  vtkPolyData* poly() { return poly_; }
  ViewMm middle() const { return middle_; }
  double minMm() const { return min_mm_; }
  double maxMm() const { return max_mm_; }
  const GridFrame& frame() const { return frame_; }

  /// Name of the three per-vertex shares: interpolated, base plane, outside.
  static constexpr const char* kOriginArray = "reliefOrigin";

 private:
  void classify(const SurfaceGrid& grid);
  void rebuildCells();
  void rebuildVertices(const std::vector<float>& heights);
  void rebuildNormals(const std::vector<float>& heights);
  void shadeRimCells();
  void rebuildOrigins(const SurfaceGrid& grid);
  void rebuildColours(const SurfaceGrid& grid);

  vtkNew<vtkPolyData> poly_;
  vtkNew<vtkFloatArray> vertices_, normals_, origins_;
  GridFrame frame_;
  ViewMm middle_;
  double min_mm_ = 0, max_mm_ = 0;
  std::vector<std::uint8_t> inside_, inside_of_cells_;
  GridSize size_of_cells_;
  bool all_inside_ = false, origins_are_zero_ = false;
  bool is_coarse_ = false;
};

}  // namespace relievo
