// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/relief_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include "core/base/failure.h"
#include "ui/vtk/drawing/kept_surface.h"
#include "ui/vtk/probe_actors.h"
#include "ui/vtk/relief_actor.h"
#include "ui/vtk/scene_view.h"
#include "ui/vtk/screen_marks.h"

namespace relievo {
namespace {

constexpr double kHatchPeriodPx = 14;

// Anaglyph for red (left) and cyan (right) glasses, VTK's channel masks. Saturation 0.65 keeps the
// blue proxy and the red HIP recognisable; the grey relief has no colour to lose.
constexpr std::array<int, 2> kRedCyanMask{4, 3};
constexpr float kAnaglyphSaturation = 0.65F;

/// A surface that was given, kept for a copy.
class HeldGrid {
 public:
  void hold(const SurfaceGrid& grid) {
    heights_ = *grid.heights_mm;
    origins_ = grid.origins ? *grid.origins : std::vector<CellStatus>{};
    colours_ = grid.colours ? *grid.colours : std::vector<std::uint8_t>{};
    grid_ = {grid.frame, &heights_, grid.origins ? &origins_ : nullptr,
             grid.colours ? &colours_ : nullptr, grid.lit};
  }
  const SurfaceGrid& grid() const { return grid_; }

 private:
  SurfaceGrid grid_;
  std::vector<float> heights_;
  std::vector<CellStatus> origins_;
  std::vector<std::uint8_t> colours_;
};

/// Lights stay with the relief when the camera turns, as a lamp beside an exhibit does. The fill
/// comes from the other side, higher, and only opens the shadows.
class ExhibitLights {
 public:
  ExhibitLights() {
    key_->SetLightTypeToSceneLight();
    fill_->SetLightTypeToSceneLight();
  }
  void addTo(vtkRenderer* renderer) {
    renderer->AutomaticLightCreationOff();
    renderer->AddLight(key_);
    renderer->AddLight(fill_);
  }
  void place(const LightOptions& light) {
    put(key_, light.azimuth_deg, light.elevation_deg);
    key_->SetIntensity(0.88);
    key_->SetColor(1.0, 0.99, 0.97);
    put(fill_, light.azimuth_deg + 160, 60);
    fill_->SetIntensity(0.20);
    fill_->SetColor(0.93, 0.96, 1.0);
  }

 private:
  static void put(vtkLight* lamp, double azimuth_deg, double elevation_deg) {
    const double a = azimuth_deg * std::numbers::pi / 180;
    const double e = elevation_deg * std::numbers::pi / 180;
    lamp->SetFocalPoint(0, 0, 0);
    lamp->SetPosition(std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e));
    lamp->PositionalOff();
  }

  vtkNew<vtkLight> key_, fill_;
};

/// What was asked for; ReliefScene::copy() repeats it.
struct SceneContent {
  HeldGrid surface;
  bool has_surface = false;
  ReliefCamera camera;
  StereoOptions stereo;
  LightOptions light;
  std::array<double, 3> background{0.155, 0.16, 0.17};
  bool transparent = false;
  double eye_turn_deg = 0;
  double mark_scale = 1;
  InterpolatedMark interpolated = InterpolatedMark::hatch;
  std::optional<RectMm> pink;
  bool pink_handles = false;
  std::optional<Probe> probe;
  double ball_radius_mm = 1;
  bool colourless = false;
  std::vector<std::vector<ViewMm>> lines, curves;
  bool scale_bar = false;
  char decimal_mark = '.';
};

}  // namespace

struct ReliefScene::Impl {
  SceneContent asked;

  // What draws it. Layer 0: surface; 1: proxy, line, arrow; 2: HIP, pink window, scale bar.
  vtkNew<KeptSurface> lowest;
  std::array<vtkSmartPointer<vtkRenderer>, 3> layers{lowest, vtkSmartPointer<vtkRenderer>::New(),
                                                     vtkSmartPointer<vtkRenderer>::New()};
  vtkNew<vtkCamera> vtk_camera;
  ExhibitLights lights;
  ReliefActor relief;
  ProbeActors probe_actors;
  ScreenMarks marks;
  vtkSmartPointer<vtkRenderWindow> window;
  double changes = 0;  ///< Of what the surface's picture depends on beside the camera.

  Impl();
  const SurfaceMesh& mesh() const { return relief.mesh(); }
  double zeroPlane() const { return asked.stereo.zero_plane_mm.value_or(markPlane()); }
  double markPlane() const {
    return asked.has_surface ? 0.5 * (mesh().minMm() + mesh().maxMm()) : 0.0;
  }
  SceneView view(int width, int height) const {
    SceneView v(asked.camera, zeroPlane(), width, height);
    v.slantSight(asked.eye_turn_deg);
    return v;
  }
  double reachMm(const SceneView& view) const;
  void placeCamera(const SceneView& view, const PictureTile& tile);
  KeptSurface::Sight sight(const SceneView& view, const PictureTile& tile) const;
  void applyStereo();
  void applyColourless() {
    probe_actors.setColourless(asked.colourless || asked.stereo.mode == StereoMode::anaglyph);
  }
};

ReliefScene::Impl::Impl() {
  asked.camera.rect = {-50, -50, 100, 100};
  for (int i = 0; i < 3; ++i) {
    vtkRenderer* const layer = layers[static_cast<std::size_t>(i)];
    layer->SetLayer(i);
    layer->SetActiveCamera(vtk_camera);
    lights.addTo(layer);
    layer->SetBackground(asked.background.data());
  }
  layers[0]->AddActor(relief.actor());
  probe_actors.addTo(layers[1], layers[2]);
  marks.addTo(layers[2]);
  vtk_camera->ParallelProjectionOn();
  lights.place(asked.light);
}

/// Half depth of what has to lie between the clipping planes.
double ReliefScene::Impl::reachMm(const SceneView& v) const {
  double reach = v.mm_per_pixel;
  if (asked.has_surface) {
    const SurfaceMesh& m = mesh();
    const GridFrame& f = m.frame();
    const ViewMm half{0.5 * f.size.cols * f.spacing_mm, 0.5 * f.size.rows * f.spacing_mm,
                      0.5 * (m.maxMm() - m.minMm()) + 1e-3 * f.spacing_mm};
    const ViewMm t = v.towards_viewer, middle = m.middle() - v.focal;
    reach = std::abs(dot(middle, t)) + std::abs(half.x * t.x) + std::abs(half.y * t.y) +
            std::abs(half.z * t.z);
    if (m.minMm() > 0) reach += m.minMm();  // Rim cells reach down to the base plane.
  }
  if (probe_actors.reachMm() > 0) {
    const double along = std::abs(dot(probe_actors.proxy() - v.focal, v.towards_viewer));
    reach = std::max(reach, along + probe_actors.reachMm());
  }
  return 1.01 * reach;
}

void ReliefScene::Impl::placeCamera(const SceneView& v, const PictureTile& tile) {
  const double reach = reachMm(v);
  const double distance = 2 * reach;
  const double right = tile.x + 0.5 * tile.width - 0.5 * v.width_px;
  const double up = tile.y + 0.5 * tile.height - 0.5 * v.height_px;
  const ViewMm middle = v.focal + (right * v.mm_per_pixel) * v.right + (up * v.mm_per_pixel) * v.up;
  const ViewMm at = middle + distance * v.towards_viewer;
  vtk_camera->SetFocalPoint(middle.x, middle.y, middle.z);
  vtk_camera->SetPosition(at.x, at.y, at.z);
  vtk_camera->SetViewUp(v.up.x, v.up.y, v.up.z);
  vtk_camera->SetParallelScale(0.5 * tile.height * v.mm_per_pixel);
  vtk_camera->SetClippingRange(distance - reach, distance + reach);
  vtk_camera->SetEyeAngle(asked.stereo.eye_angle_deg);
  vtk_camera->SetViewShear(v.slant, 0, 1);  // About the focal point's distance.
  // VTK keeps the last mono matrix for the left eye unless the camera itself changed.
  vtk_camera->Modified();
}

KeptSurface::Sight ReliefScene::Impl::sight(const SceneView& v, const PictureTile& tile) const {
  const ReliefCamera& c = asked.camera;
  return {changes,
          c.rect.x_mm,
          c.rect.y_mm,
          c.rect.width_mm,
          c.rect.height_mm,
          c.azimuth_deg,
          c.elevation_deg,
          zeroPlane(),
          asked.eye_turn_deg,
          asked.mark_scale,
          static_cast<double>(v.width_px),
          static_cast<double>(v.height_px),
          static_cast<double>(tile.x),
          static_cast<double>(tile.y),
          static_cast<double>(tile.width),
          static_cast<double>(tile.height)};
}

void ReliefScene::Impl::applyStereo() {
  if (!window) return;
  if (asked.stereo.mode == StereoMode::off) {
    window->StereoRenderOff();
    return;
  }
  // The window of the views and renderOffscreen mix by themselves (core/relief/stereo.h).
  window->SetAnaglyphColorMask(kRedCyanMask[0], kRedCyanMask[1]);
  window->SetAnaglyphColorSaturation(kAnaglyphSaturation);
  window->SetStereoType(VTK_STEREO_ANAGLYPH);  // Before StereoRenderOn: some builds warn otherwise.
  window->StereoRenderOn();
}

ReliefScene::ReliefScene() : impl_(std::make_unique<Impl>()) {}

ReliefScene::~ReliefScene() {
  if (!impl_->window) return;
  for (auto& layer : impl_->layers) impl_->window->RemoveRenderer(layer);
}

void ReliefScene::setSurface(const SurfaceGrid& grid) {
  impl_->relief.show(grid);
  impl_->asked.surface.hold(grid);
  impl_->asked.has_surface = true;
  ++impl_->changes;
}

void ReliefScene::clearSurface() {
  impl_->relief.hide();
  impl_->asked.has_surface = false;
  ++impl_->changes;
}

void ReliefScene::setCamera(const ReliefCamera& camera) {
  if (!(camera.rect.width_mm > 0) || !(camera.rect.height_mm > 0)) {
    throw failure<MessageId::camera_without_size>();
  }
  impl_->asked.camera = camera;
}

const StereoOptions& ReliefScene::stereo() const {
  return impl_->asked.stereo;
}

void ReliefScene::setStereo(const StereoOptions& stereo) {
  impl_->asked.stereo = stereo;
  impl_->applyStereo();
  impl_->applyColourless();
  ++impl_->changes;
}

void ReliefScene::setLight(const LightOptions& light) {
  impl_->asked.light = light;
  impl_->lights.place(light);
  ++impl_->changes;
}

void ReliefScene::setBackground(double red, double green, double blue) {
  impl_->asked.background = {red, green, blue};
  impl_->layers[0]->SetBackground(red, green, blue);
  ++impl_->changes;
}

void ReliefScene::setTransparent(bool transparent) {
  impl_->asked.transparent = transparent;
  if (transparent) impl_->layers[0]->SetBackground(0, 0, 0);
  ++impl_->changes;
}

void ReliefScene::setEyeTurn(double turn_deg) {
  impl_->asked.eye_turn_deg = turn_deg;
}

void ReliefScene::setInterpolated(InterpolatedMark mark) {
  impl_->asked.interpolated = mark;
  impl_->relief.mark(mark);
  ++impl_->changes;
}

void ReliefScene::setMarkScale(double pixels) {
  impl_->asked.mark_scale = pixels;
}

void ReliefScene::setPinkWindow(const std::optional<RectMm>& rect, bool with_handles) {
  impl_->asked.pink = rect;
  impl_->asked.pink_handles = with_handles;
}

void ReliefScene::setProbe(const std::optional<Probe>& probe, double ball_radius_mm) {
  impl_->asked.probe = probe;
  impl_->asked.ball_radius_mm = ball_radius_mm;
  impl_->probe_actors.set(probe, ball_radius_mm);
}

void ReliefScene::setColourless(bool colourless) {
  impl_->asked.colourless = colourless;
  impl_->applyColourless();
}

void ReliefScene::setLines(const std::vector<std::vector<ViewMm>>& lines,
                           const std::vector<std::vector<ViewMm>>& curves) {
  impl_->asked.lines = lines;
  impl_->asked.curves = curves;
}

void ReliefScene::setScaleBar(bool visible) {
  impl_->asked.scale_bar = visible;
}

void ReliefScene::setDecimalMark(char mark) {
  impl_->asked.decimal_mark = mark;
}

void ReliefScene::attachTo(vtkRenderWindow* window, int samples) {
  impl_->window = window;
  window->SetMultiSamples(samples > 1 ? samples : 0);
  window->SetNumberOfLayers(3);
  for (auto& layer : impl_->layers) window->AddRenderer(layer);
  impl_->applyStereo();
}

void ReliefScene::prepare(int width_px, int height_px, const std::optional<PictureTile>& tile) {
  const PictureTile drawn = tile.value_or(PictureTile{0, 0, width_px, height_px});
  const SceneView view = impl_->view(width_px, height_px);
  impl_->placeCamera(view, drawn);
  impl_->lowest->show(impl_->sight(view, drawn));
  impl_->probe_actors.face(view);
  const SceneContent& asked = impl_->asked;
  impl_->relief.setHatchPeriod(kHatchPeriodPx * asked.mark_scale * view.mm_per_pixel);
  std::vector<ViewMm> corners;
  if (asked.pink) {
    const RectMm& r = *asked.pink;
    const double z = impl_->markPlane(), x1 = r.x_mm + r.width_mm, y1 = r.y_mm + r.height_mm;
    corners = {{r.x_mm, r.y_mm, z}, {x1, r.y_mm, z}, {x1, y1, z}, {r.x_mm, y1, z}};
  }
  impl_->marks.draw(view, {.corners = corners,
                           .handles = asked.pink_handles,
                           .scale_bar = asked.scale_bar,
                           .decimal_mark = asked.decimal_mark,
                           .lines = asked.lines,
                           .curves = asked.curves,
                           .scale = asked.mark_scale,
                           .dpi = impl_->window ? impl_->window->GetDPI() : 72,
                           .origin = {static_cast<double>(drawn.x), static_cast<double>(drawn.y)}});
}

// On screen nothing is transparent: whoever shows the picture need not see to that.
void ReliefScene::keepSurface(bool keep) {
  impl_->lowest->keep(keep);
  impl_->lowest->SetBackgroundAlpha(keep ? 1 : 0);
  ++impl_->changes;
}

void ReliefScene::setCoarse(bool coarse) {
  if (impl_->relief.setCoarse(coarse)) ++impl_->changes;
}

void ReliefScene::stopBy(const std::stop_token& stop) {
  impl_->relief.stopBy(stop);
}

vtkRenderer* ReliefScene::renderer() {
  return impl_->layers[0];
}

ViewMm ReliefScene::viewFromPixel(double px, double py, int width_px, int height_px,
                                  double z_mm) const {
  return impl_->view(width_px, height_px).viewOf({px, height_px - py}, z_mm);
}

bool ReliefScene::isEmpty() const {
  return !impl_->asked.has_surface && !impl_->asked.probe && !impl_->asked.pink &&
         !impl_->asked.scale_bar;
}

std::unique_ptr<ReliefScene> ReliefScene::copy() const {
  const SceneContent& asked = impl_->asked;
  auto other = std::make_unique<ReliefScene>();
  if (asked.has_surface) other->setSurface(asked.surface.grid());
  other->setCamera(asked.camera);
  other->setStereo(asked.stereo);
  other->setLight(asked.light);
  other->setBackground(asked.background[0], asked.background[1], asked.background[2]);
  other->setTransparent(asked.transparent);
  other->setEyeTurn(asked.eye_turn_deg);
  other->setMarkScale(asked.mark_scale);
  other->setInterpolated(asked.interpolated);
  other->setPinkWindow(asked.pink, asked.pink_handles);
  other->setProbe(asked.probe, asked.ball_radius_mm);
  other->setColourless(asked.colourless);
  other->setLines(asked.lines, asked.curves);
  other->setScaleBar(asked.scale_bar);
  other->setDecimalMark(asked.decimal_mark);
  return other;
}

}  // namespace relievo
