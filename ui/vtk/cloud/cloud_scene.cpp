// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/cloud/cloud_scene.h"

#include <algorithm>
#include <cmath>

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkShaderProperty.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

namespace relievo {
namespace {

constexpr double kPointsOverlap = 1.8;  // So that a surface is closed.
constexpr double kLeastPointPx = 2.5, kMostPointPx = 8;
constexpr int kArrowSides = 24;
constexpr std::array<double, 3> kArrowColour{1.0, 0.31, 0.64};  // As the window in the overview.

/// Somebody else's list of threes as VTK's array; VTK only reads it.
template <class Array, class T>
vtkSmartPointer<Array> borrowed(const std::vector<std::array<T, 3>>& list) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(3);
  if (list.empty()) return array;
  array->SetArray(const_cast<T*>(list.front().data()), static_cast<vtkIdType>(3 * list.size()), 1);
  return array;
}

/// Either side of a surface is lit: which one is outside is not known of a scan.
void lightBothSides(vtkActor* actor) {
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Normal::Impl", true,
      "//VTK::Normal::Impl\n"
      // A point without a normal has none of length 1: VTK's normalize() made NaN of it.
      "  if (!(dot(normalVCVSOutput, normalVCVSOutput) > 0.25)) normalVCVSOutput = vec3(0, 0, 1);\n"
      "  if (normalVCVSOutput.z < 0.0) normalVCVSOutput = -normalVCVSOutput;\n",
      false);
}

}  // namespace

struct CloudScene::Impl {
  std::shared_ptr<const CloudPoints> drawn;
  std::optional<CloudBox> box;
  std::optional<CloudArrow> arrow;
  std::size_t one_in = 1;
  CloudCamera camera;
  double reach = 1;  ///< Of all that is drawn from `origin`, file units.
  FilePoint origin;

  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkCamera> vtk_camera;
  vtkNew<vtkPolyData> cloud, lines;
  vtkNew<vtkActor> cloud_actor, box_actor, arrow_actor;
  vtkSmartPointer<vtkRenderWindow> window;

  Impl();
  void placeCells();
  void placeBox();
  void placeArrow();
  void measure();
};

CloudScene::Impl::Impl() {
  vtkNew<vtkOpenGLPolyDataMapper> mapper, line_mapper;
  mapper->SetInputData(cloud);
  mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  cloud_actor->SetMapper(mapper);
  cloud_actor->GetProperty()->SetAmbient(0.25);
  cloud_actor->GetProperty()->SetDiffuse(0.75);
  cloud_actor->GetProperty()->SetSpecular(0);
  line_mapper->SetInputData(lines);
  box_actor->SetMapper(line_mapper);
  box_actor->GetProperty()->LightingOff();
  vtkNew<vtkArrowSource> arrow_source;  // Along x, of length 1.
  arrow_source->SetShaftResolution(kArrowSides);
  arrow_source->SetTipResolution(kArrowSides);
  vtkNew<vtkOpenGLPolyDataMapper> arrow_mapper;
  arrow_mapper->SetInputConnection(arrow_source->GetOutputPort());
  arrow_actor->SetMapper(arrow_mapper);
  arrow_actor->GetProperty()->SetColor(kArrowColour[0], kArrowColour[1], kArrowColour[2]);
  arrow_actor->GetProperty()->SetAmbient(0.4);
  arrow_actor->GetProperty()->SetDiffuse(0.6);
  for (vtkActor* actor : {cloud_actor.Get(), box_actor.Get(), arrow_actor.Get()}) {
    actor->VisibilityOff();
    renderer->AddActor(actor);
  }
  renderer->SetActiveCamera(vtk_camera);
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToCameraLight();
  lamp->SetPosition(-0.35, 0.45, 1);
  lamp->SetFocalPoint(0, 0, 0);
  lamp->PositionalOff();
  renderer->AddLight(lamp);
  vtk_camera->ParallelProjectionOn();
}

/// Triangles where there are some, else one vertex for each point that is drawn.
void CloudScene::Impl::placeCells() {
  if (!drawn) return;
  vtkNew<vtkCellArray> cells, none;
  const auto count = static_cast<vtkIdType>(drawn->points.size());
  const auto step = static_cast<vtkIdType>(std::max<std::size_t>(one_in, 1));
  const bool is_mesh = !drawn->triangles.empty() && step == 1;
  if (is_mesh) {
    for (const auto& t : drawn->triangles) {
      cells->InsertNextCell({static_cast<vtkIdType>(t[0]), static_cast<vtkIdType>(t[1]),
                             static_cast<vtkIdType>(t[2])});
    }
  } else if (count > 0) {
    cells->InsertNextCell(static_cast<int>((count + step - 1) / step));
    for (vtkIdType i = 0; i < count; i += step) cells->InsertCellPoint(i);
  }
  cloud->SetPolys(is_mesh ? cells : none);
  cloud->SetVerts(is_mesh ? none : cells);
  cloud->Modified();
}

void CloudScene::Impl::placeArrow() {
  arrow_actor->SetVisibility(arrow.has_value() ? 1 : 0);
  if (!arrow) return;
  const FilePoint along = arrow->to - arrow->from;
  const double length = std::max(norm(along), 1e-12);
  const FilePoint x = (1 / length) * along;
  // Any two axes across it: the arrow is round.
  const FilePoint aside = std::abs(x.x) < 0.7 ? FilePoint{1, 0, 0} : FilePoint{0, 1, 0};
  FilePoint y = aside - dot(aside, x) * x;
  y = (1 / norm(y)) * y;
  const FilePoint z{x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x};
  const FilePoint at = arrow->from - origin;
  vtkNew<vtkMatrix4x4> placed;
  const std::array<std::array<double, 4>, 3> rows{
      {{x.x, y.x, z.x, at.x}, {x.y, y.y, z.y, at.y}, {x.z, y.z, z.z, at.z}}};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) {
      const double value = rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
      placed->SetElement(r, c, c < 3 ? length * value : value);
    }
  }
  arrow_actor->SetUserMatrix(placed);
}

void CloudScene::Impl::placeBox() {
  box_actor->SetVisibility(box.has_value() ? 1 : 0);
  if (!box) return;
  box_actor->GetProperty()->SetColor(box->colour[0], box->colour[1], box->colour[2]);
  const Rotation& axes = box->axes;
  vtkNew<vtkPoints> corners;
  for (int i = 0; i < 8; ++i) {
    const double a = (i & 1) != 0 ? box->max.x : box->min.x;
    const double b = (i & 2) != 0 ? box->max.y : box->min.y;
    const double c = (i & 4) != 0 ? box->max.z : box->min.z;
    const FilePoint p{axes[0] * a + axes[3] * b + axes[6] * c,
                      axes[1] * a + axes[4] * b + axes[7] * c,
                      axes[2] * a + axes[5] * b + axes[8] * c};
    const FilePoint from = p - origin;
    corners->InsertNextPoint(from.x, from.y, from.z);
  }
  vtkNew<vtkCellArray> edges;
  for (int i = 0; i < 8; ++i) {
    for (int bit = 1; bit < 8; bit *= 2) {
      if ((i & bit) != 0) continue;
      edges->InsertNextCell(2);
      edges->InsertCellPoint(i);
      edges->InsertCellPoint(i | bit);
    }
  }
  lines->SetPoints(corners);
  lines->SetLines(edges);
  lines->Modified();
}

/// How far anything drawn is from the origin, for the clipping planes.
void CloudScene::Impl::measure() {
  double squared = 0;
  if (drawn) {
    for (const auto& p : drawn->points) {
      squared = std::max(squared, static_cast<double>(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
    }
  }
  if (box) {
    for (int i = 0; i < 8; ++i) {
      std::array<double, 3> corner{};
      lines->GetPoints()->GetPoint(i, corner.data());
      squared =
          std::max(squared, corner[0] * corner[0] + corner[1] * corner[1] + corner[2] * corner[2]);
    }
  }
  if (arrow) {
    // The tip's cone is a tenth of the length thick.
    for (const FilePoint& end : {arrow->from - origin, arrow->to - origin}) {
      const double far = norm(end) + 0.1 * norm(arrow->to - arrow->from);
      squared = std::max(squared, far * far);
    }
  }
  reach = std::max(1e-9, 1.01 * std::sqrt(squared));
}

CloudScene::CloudScene() : impl_(std::make_unique<Impl>()) {
  lightBothSides(impl_->cloud_actor);
}

CloudScene::~CloudScene() {
  if (impl_->window) impl_->window->RemoveRenderer(impl_->renderer);
}

void CloudScene::setPoints(std::shared_ptr<const CloudPoints> points) {
  Impl& m = *impl_;
  m.cloud->Initialize();
  m.drawn = std::move(points);
  const bool any = m.drawn && !m.drawn->points.empty();
  m.cloud_actor->SetVisibility(any ? 1 : 0);
  if (any) {
    const CloudPoints& c = *m.drawn;
    m.origin = c.origin;
    vtkNew<vtkPoints> places;
    places->SetData(borrowed<vtkFloatArray>(c.points));
    m.cloud->SetPoints(places);
    m.placeCells();
    const auto colours = borrowed<vtkUnsignedCharArray>(c.colours);
    colours->SetName("colours");
    m.cloud->GetPointData()->SetScalars(colours);
    if (!c.normals.empty()) {
      m.cloud->GetPointData()->SetNormals(borrowed<vtkFloatArray>(c.normals));
    }
    m.cloud_actor->GetProperty()->SetLighting(!c.normals.empty());
  }
  m.placeBox();
  m.placeArrow();
  m.measure();
}

void CloudScene::setBox(const std::optional<CloudBox>& box) {
  impl_->box = box;
  impl_->placeBox();
  impl_->measure();
}

void CloudScene::setArrow(const std::optional<CloudArrow>& arrow) {
  impl_->arrow = arrow;
  impl_->placeArrow();
  impl_->measure();
}

void CloudScene::setCoarseness(std::size_t one_in) {
  if (impl_->one_in == one_in) return;
  impl_->one_in = one_in;
  impl_->placeCells();
}

void CloudScene::setBackground(double red, double green, double blue) {
  impl_->renderer->SetBackground(red, green, blue);
}

void CloudScene::setCamera(const CloudCamera& camera) {
  impl_->camera = camera;
}

void CloudScene::attachTo(vtkRenderWindow* window) {
  impl_->window = window;
  window->AddRenderer(impl_->renderer);
}

void CloudScene::prepare(const PictureSize& size, double mark_scale) {
  Impl& m = *impl_;
  const CloudCamera& c = m.camera;
  const FilePoint focal = c.middle - m.origin;
  const FilePoint toward{c.view[6], c.view[7], c.view[8]};
  // The whole sphere around the origin that anything drawn lies in is between the planes.
  const double along = dot(focal, toward);
  const double distance = m.reach + std::abs(along) + m.reach;
  const FilePoint at = focal + distance * toward;
  m.vtk_camera->SetFocalPoint(focal.x, focal.y, focal.z);
  m.vtk_camera->SetPosition(at.x, at.y, at.z);
  m.vtk_camera->SetViewUp(c.view[3], c.view[4], c.view[5]);
  m.vtk_camera->SetParallelScale(0.5 * c.height);
  const double middle = distance + along;  // From the camera to the origin's plane.
  m.vtk_camera->SetClippingRange(std::max(middle - m.reach, 1e-3 * m.reach), middle + m.reach);
  const double coarser = std::sqrt(static_cast<double>(std::max<std::size_t>(m.one_in, 1)));
  const double px = m.drawn ? coarser * m.drawn->spacing * size.height / c.height : 0;
  m.cloud_actor->GetProperty()->SetPointSize(static_cast<float>(
      std::clamp(kPointsOverlap * px, kLeastPointPx * mark_scale, kMostPointPx * mark_scale)));
  m.box_actor->GetProperty()->SetLineWidth(static_cast<float>(1.5 * mark_scale));
}

}  // namespace relievo
