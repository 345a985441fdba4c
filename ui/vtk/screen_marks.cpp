// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/screen_marks.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include "ui/vtk/window_pink.h"

namespace relievo {
namespace {

constexpr double kFarPx = 20000;  // Beyond any picture; keeps coordinates of a far zoom finite.

PixelPlace clamped(PixelPlace p) {
  return {std::clamp(p.x, -kFarPx, kFarPx), std::clamp(p.y, -kFarPx, kFarPx)};
}

}  // namespace

ScreenMarks::ScreenMarks() {
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(poly_);
  mapper->SetScalarModeToUseCellData();
  shapes_->SetMapper(mapper);
  shapes_->GetProperty()->SetDisplayLocationToForeground();
  shapes_->PickableOff();
  label_->PickableOff();
  label_->VisibilityOff();
  vtkTextProperty* const text = label_->GetTextProperty();
  text->SetFontFamilyToArial();
  text->SetColor(0.96, 0.96, 0.96);
  text->SetJustificationToCentered();
  text->SetVerticalJustificationToBottom();
}

void ScreenMarks::addTo(vtkRenderer* top_layer) {
  top_layer->AddActor2D(shapes_);
  top_layer->AddActor2D(label_);
}

void ScreenMarks::draw(const SceneView& view, const Marks& marks) {
  scale_ = marks.scale;
  text_scale_ = 72.0 / std::max(marks.dpi, 1);
  origin_ = marks.origin;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(4);
  poly_->SetPoints(points);
  poly_->SetPolys(cells);
  poly_->GetCellData()->SetScalars(colours);
  if (marks.corners.size() == 4) pinkWindow(view, marks.corners, marks.handles);
  for (const auto& course : marks.curves) line(view, course, false);
  for (const auto& course : marks.lines) line(view, course, true);
  label_->SetVisibility(marks.scale_bar);
  if (marks.scale_bar) scaleBar(view, marks.decimal_mark);
  poly_->Modified();
}

void ScreenMarks::quad(const std::array<PixelPlace, 4>& corners, const Colour& colour) {
  std::array<vtkIdType, 4> ids{};
  for (std::size_t i = 0; i < 4; ++i) {
    ids[i] =
        poly_->GetPoints()->InsertNextPoint(corners[i].x - origin_.x, corners[i].y - origin_.y, 0);
  }
  poly_->GetPolys()->InsertNextCell(4, ids.data());
  vtkUnsignedCharArray::SafeDownCast(poly_->GetCellData()->GetScalars())
      ->InsertNextTypedTuple(colour.data());
}

void ScreenMarks::box(double x0, double y0, double x1, double y1, const Colour& colour) {
  quad({{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}}, colour);
}

void ScreenMarks::edge(PixelPlace a, PixelPlace b, double half_width, const Colour& colour) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (length == 0) return;
  const double ux = half_width * (b.x - a.x) / length, uy = half_width * (b.y - a.y) / length;
  quad({{{a.x - ux + uy, a.y - uy - ux},
         {b.x + ux + uy, b.y + uy - ux},
         {b.x + ux - uy, b.y + uy + ux},
         {a.x - ux - uy, a.y - uy + ux}}},
       colour);
}

// Two pixels of pink between one pixel of dark on either side: seen on any surface.
void ScreenMarks::pinkWindow(const SceneView& view, const std::vector<ViewMm>& corners,
                             bool handles) {
  const Colour pink{kPink[0], kPink[1], kPink[2], 255}, dark{40, 12, 26, 255};
  std::array<PixelPlace, 4> p;
  for (std::size_t i = 0; i < 4; ++i) {
    p[i] = clamped(view.pixelOf(corners[i]));
    if (view.isUntilted()) p[i] = {std::round(p[i].x), std::round(p[i].y)};
  }
  const auto each_edge = [&](double half_width, const Colour& colour) {
    for (std::size_t i = 0; i < 4; ++i) edge(p[i], p[(i + 1) % 4], half_width, colour);
  };
  // Whole pixels on either side, so that an upright line is as sharp as the screen.
  const double half = std::max(1.0, std::round(scale_));
  each_edge(2 * half, dark);
  each_edge(half, pink);
  if (!handles) return;
  for (std::size_t i = 0; i < 4; ++i) {
    const PixelPlace a = p[i], b = p[(i + 1) % 4];
    for (const PixelPlace h : {a, PixelPlace{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}}) {
      const double x = std::round(h.x), y = std::round(h.y);
      box(x - 5 * half, y - 5 * half, x + 5 * half, y + 5 * half, dark);
      box(x - 4 * half, y - 4 * half, x + 4 * half, y + 4 * half, pink);
    }
  }
}

// Dark with a light core, and a square dot at each point: seen on any surface.
void ScreenMarks::line(const SceneView& view, const std::vector<ViewMm>& points, bool dots) {
  const Colour dark{16, 16, 20, 255}, light{255, 226, 92, 255};
  for (const auto& [half_width, dot, colour] :
       {std::tuple{2.0 * scale_, 5.0 * scale_, dark}, std::tuple{scale_, 3.5 * scale_, light}}) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const PixelPlace p = clamped(view.pixelOf(points[i]));
      if (i > 0) edge(clamped(view.pixelOf(points[i - 1])), p, half_width, colour);
      if (dots) box(p.x - dot, p.y - dot, p.x + dot, p.y + dot, colour);
    }
  }
}

void ScreenMarks::scaleBar(const SceneView& view, char decimal_mark) {
  const double scale = std::max(scale_, std::min(view.width_px, view.height_px) / 900.0);
  const double u = std::round(scale);  // One line of the drawing, in pixels.
  const int font_px = static_cast<int>(std::lround(14 * scale));
  ScaleLength length = scaleLength(0.25 * view.width_px * view.mm_per_pixel);
  std::replace(length.label.begin(), length.label.end(), '.', decimal_mark);
  const double bar = std::round(length.mm / view.mm_per_pixel);
  const double margin = std::round(14 * scale), pad = std::round(9 * scale);
  const double tick = std::round(4 * scale);
  label_->SetInput(length.label.c_str());
  label_->GetTextProperty()->SetFontSize(
      std::max(1, static_cast<int>(std::lround(text_scale_ * font_px))));
  const double text_px = 0.62 * font_px * static_cast<double>(length.label.size());
  const double plate = std::round(std::max(bar, text_px) + 2 * pad);
  const double plate_height = std::round(2 * pad + tick + 4 * scale + font_px);
  const Colour back{18, 18, 20, 150}, light{245, 245, 245, 255};
  box(margin, margin, margin + plate, margin + plate_height, back);
  const double x0 = std::round(margin + 0.5 * (plate - bar)), x1 = x0 + bar, y = margin + pad;
  box(x0, y, x1, y + 2 * u, light);
  box(x0, y - tick + u, x0 + 2 * u, y + tick + u, light);
  box(x1 - 2 * u, y - tick + u, x1, y + tick + u, light);
  label_->SetPosition(std::round(0.5 * (x0 + x1)) - origin_.x,
                      std::round(y + tick + 4 * scale) - origin_.y);
}

}  // namespace relievo
