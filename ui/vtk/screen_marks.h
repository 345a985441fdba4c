// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include "ui/vtk/label_actor.h"
#include "ui/vtk/scale_length.h"
#include "ui/vtk/scene_view.h"

namespace relievo {

/// What is drawn flat on the picture, in whole pixels, over everything else: the pink window and
/// the scale bar.
class ScreenMarks {
 public:
  ScreenMarks();
  void addTo(vtkRenderer* top_layer);

  struct Marks {
    std::vector<ViewMm> corners;  ///< Of the pink window, in order; empty: none.
    bool handles = false, scale_bar = false;
    char decimal_mark = '.';                         ///< Of the bar's number.
    std::vector<std::vector<ViewMm>> lines, curves;  ///< Lines have a dot at each point.
    double scale = 1;                                ///< Pixels of a line of width 1.
    int dpi = 72;       ///< Of the render window: VTK enlarges text by it.
    PixelPlace origin;  ///< Of the part of the picture that is drawn.
  };
  /// Draws anew for a picture.
  void draw(const SceneView& view, const Marks& marks);

 private:
  using Colour = std::array<std::uint8_t, 4>;
  void quad(const std::array<PixelPlace, 4>& corners, const Colour& colour);
  void box(double x0, double y0, double x1, double y1, const Colour& colour);
  void edge(PixelPlace a, PixelPlace b, double half_width, const Colour& colour);
  void pinkWindow(const SceneView& view, const std::vector<ViewMm>& corners, bool handles);
  void scaleBar(const SceneView& view, char decimal_mark);
  void line(const SceneView& view, const std::vector<ViewMm>& points, bool dots);

  vtkNew<vtkPolyData> poly_;
  vtkNew<vtkActor2D> shapes_;
  vtkNew<LabelActor> label_;
  double scale_ = 1, text_scale_ = 1;
  PixelPlace origin_;
};

}  // namespace relievo
