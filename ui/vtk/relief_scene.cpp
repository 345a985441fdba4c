// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/relief_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataObject.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkShaderProperty.h>
#include <vtkSmartPointer.h>
#include <vtkUniforms.h>

#include "core/base/failure.h"
#include "ui/vtk/probe_actors.h"
#include "ui/vtk/scene_view.h"
#include "ui/vtk/screen_marks.h"
#include "ui/vtk/stoppable_mapper.h"
#include "ui/vtk/surface_mesh.h"

namespace relievo {
namespace {

constexpr std::array<double, 3> kStone{0.80, 0.785, 0.755};
constexpr double kHatchPeriodPx = 14;
constexpr std::array<float, 3> kUnmeasured{
    kUnmeasuredColour[0] / 255.0F, kUnmeasuredColour[1] / 255.0F, kUnmeasuredColour[2] / 255.0F};

// Anaglyph for red (left) and cyan (right) glasses, VTK's channel masks. Saturation 0.65 keeps the
// blue proxy and the red HIP recognisable; the grey relief has no colour to lose.
constexpr std::array<int, 2> kRedCyanMask{4, 3};
constexpr float kAnaglyphSaturation = 0.65F;

void addHatch(vtkActor* actor, vtkPolyDataMapper* mapper) {
  mapper->MapDataArrayToVertexAttribute(SurfaceMesh::kOriginArray, SurfaceMesh::kOriginArray,
                                        vtkDataObject::FIELD_ASSOCIATION_POINTS);
  vtkShaderProperty* const shader = actor->GetShaderProperty();
  shader->AddVertexShaderReplacement("//VTK::PositionVC::Dec", true,
                                     "//VTK::PositionVC::Dec\n"
                                     "in vec3 reliefOrigin;\n"
                                     "out vec3 originVSOutput;\n"
                                     "out vec2 placeVSOutput;\n",
                                     false);
  shader->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
                                     "//VTK::PositionVC::Impl\n"
                                     "  originVSOutput = reliefOrigin;\n"
                                     "  placeVSOutput = vertexMC.xy;\n",
                                     false);
  shader->AddFragmentShaderReplacement(
      "//VTK::Color::Dec", true,
      "//VTK::Color::Dec\n"
      "in vec3 originVSOutput;\n"
      "in vec2 placeVSOutput;\n"
      "float stripe(float s, float soft) {\n"
      "  float d = abs(fract(s) - 0.5);\n"
      "  return 1.0 - smoothstep(0.09 - 0.5 * soft, 0.09 + 0.5 * soft, d);\n"
      "}\n",
      false);
  // A cell with corners outside is drawn up to its middle. Interpolated cells: a diagonal hatch or
  // a colour, if they are marked. Base plane: darker, crossed. Beside every dark line runs a light
  // one, which no shadow darkens: one of the two shows on any ground.
  shader->AddFragmentShaderReplacement(
      "//VTK::Color::Impl", true,
      "//VTK::Color::Impl\n"
      "  if (originVSOutput.z > 0.5) discard;\n"
      "  vec2 lines = vec2(placeVSOutput.x + placeVSOutput.y,\n"
      "                    placeVSOutput.x - placeVSOutput.y) / hatchPeriod;\n"
      "  vec2 soft = clamp(fwidth(lines), 0.02, 0.4);\n"
      "  float hatched = hatchInterpolated * originVSOutput.x;\n"
      "  float coloured = colourInterpolated * originVSOutput.x;\n"
      "  diffuseColor = mix(diffuseColor, unmeasuredColour, 0.8 * coloured);\n"
      "  ambientColor = mix(ambientColor, 0.2 * unmeasuredColour, 0.8 * coloured);\n"
      "  if (hatched + originVSOutput.y > 0.0) {\n"
      "    float single = stripe(lines.x, soft.x);\n"
      "    float crossed = max(single, stripe(lines.y, soft.y));\n"
      "    float singleLight = stripe(lines.x + 0.18, soft.x);\n"
      "    float crossedLight = max(singleLight, stripe(lines.y + 0.18, soft.y));\n"
      "    float ground = 0.05 * hatched + 0.16 * originVSOutput.y;\n"
      "    float lightPart = max(0.5 * hatched * singleLight,\n"
      "                          0.6 * originVSOutput.y * crossedLight);\n"
      "    float darkPart = max(0.5 * hatched * single,\n"
      "                         0.7 * originVSOutput.y * crossed);\n"
      "    diffuseColor = mix(diffuseColor, vec3(0.20, 0.27, 0.38), ground);\n"
      "    diffuseColor = mix(diffuseColor, vec3(0.97, 0.97, 0.95), lightPart);\n"
      "    ambientColor = mix(ambientColor, vec3(0.45), lightPart);\n"
      "    diffuseColor = mix(diffuseColor, vec3(0.10, 0.12, 0.17), darkPart);\n"
      "    ambientColor = mix(ambientColor, vec3(0.02), darkPart);\n"
      "  }\n",
      false);
  // Stone is matt: VTK's own code would compute a highlight for each lamp and multiply it by 0,
  // which costs software OpenGL much.
  shader->AddFragmentShaderReplacement(
      "//VTK::Light::Impl", true,
      "  vec3 light = max(0.0, dot(normalVCVSOutput, -lightDirectionVC0)) * lightColor0\n"
      "             + max(0.0, dot(normalVCVSOutput, -lightDirectionVC1)) * lightColor1;\n"
      "  vec3 lit = ambientColor + light * diffuseColor;\n"
      "  fragOutput0 = vec4(mix(lit, diffuseColor, asPainted), opacity);\n",
      false);
}

}  // namespace

struct ReliefScene::Impl {
  // What was asked for; copy() repeats it.
  SurfaceGrid grid;
  std::vector<float> heights;
  std::vector<CellStatus> origins;
  std::vector<std::uint8_t> colours;
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
  std::vector<std::vector<ViewMm>> lines, curves;
  bool scale_bar = false;
  char decimal_mark = '.';

  // What draws it. Layer 0: surface; 1: proxy, line, arrow; 2: HIP, pink window, scale bar.
  std::array<vtkNew<vtkRenderer>, 3> layers;
  vtkNew<vtkCamera> vtk_camera;
  vtkNew<vtkLight> key, fill;
  vtkNew<vtkActor> surface;
  vtkNew<StoppableMapper> mapper;
  SurfaceMesh mesh;
  ProbeActors probe_actors;
  ScreenMarks marks;
  vtkSmartPointer<vtkRenderWindow> window;

  Impl();
  double zeroPlane() const {
    if (stereo.zero_plane_mm) return *stereo.zero_plane_mm;
    return has_surface ? 0.5 * (mesh.minMm() + mesh.maxMm()) : 0.0;
  }
  double markPlane() const { return has_surface ? 0.5 * (mesh.minMm() + mesh.maxMm()) : 0.0; }
  SceneView view(int width, int height) const {
    SceneView v(camera, zeroPlane(), width, height);
    v.slantSight(eye_turn_deg);
    return v;
  }
  void setShaderUniform(const char* name, float value) {
    surface->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformf(name, value);
  }
  void paint();
  void markInterpolated();
  void placeLights();
  void placeCamera(const SceneView& view, const PictureTile& tile);
  void applyStereo();
};

ReliefScene::Impl::Impl() {
  camera.rect = {-50, -50, 100, 100};
  mapper->SetInputData(mesh.poly());
  mapper->ScalarVisibilityOff();
  mapper->StaticOn();
  // Vertices are near 0 already; the hatch wants them in millimetres.
  mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  surface->SetMapper(mapper);
  surface->VisibilityOff();
  vtkProperty* const stone = surface->GetProperty();
  stone->SetColor(kStone[0], kStone[1], kStone[2]);
  stone->SetAmbient(0.16);
  stone->SetDiffuse(0.92);
  stone->SetSpecular(0);
  stone->SetInterpolationToPhong();
  addHatch(surface, mapper);
  setShaderUniform("hatchPeriod", 1);  // A window may draw itself before the first prepare().
  surface->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniform3f("unmeasuredColour",
                                                                          kUnmeasured.data());
  markInterpolated();
  for (int i = 0; i < 3; ++i) {
    vtkRenderer* const layer = layers[static_cast<std::size_t>(i)];
    layer->SetLayer(i);
    layer->SetActiveCamera(vtk_camera);
    layer->AutomaticLightCreationOff();
    layer->AddLight(key);
    layer->AddLight(fill);
    layer->SetBackground(background.data());
  }
  layers[0]->AddActor(surface);
  probe_actors.addTo(layers[1], layers[2]);
  marks.addTo(layers[2]);
  vtk_camera->ParallelProjectionOn();
  key->SetLightTypeToSceneLight();
  fill->SetLightTypeToSceneLight();
  placeLights();
}

// Lights stay with the relief when the camera turns, as a lamp beside an exhibit does. The fill
// comes from the other side, higher, and only opens the shadows.
void ReliefScene::Impl::placeLights() {
  const auto place = [](vtkLight* lamp, double azimuth_deg, double elevation_deg) {
    const double a = azimuth_deg * std::numbers::pi / 180;
    const double e = elevation_deg * std::numbers::pi / 180;
    lamp->SetFocalPoint(0, 0, 0);
    lamp->SetPosition(std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e));
    lamp->PositionalOff();
  };
  place(key, light.azimuth_deg, light.elevation_deg);
  key->SetIntensity(0.88);
  key->SetColor(1.0, 0.99, 0.97);
  place(fill, light.azimuth_deg + 160, 60);
  fill->SetIntensity(0.20);
  fill->SetColor(0.93, 0.96, 1.0);
}

// Stone, or colours of the samples; a painted relief keeps its colours whatever the lamps do.
void ReliefScene::Impl::paint() {
  const bool painted = grid.colours != nullptr;
  mapper->SetScalarVisibility(painted ? 1 : 0);
  setShaderUniform("asPainted", painted && !grid.lit ? 1.0F : 0.0F);
  surface->GetProperty()->SetDiffuse(painted && !grid.lit ? 1.0 : 0.92);
}

void ReliefScene::Impl::markInterpolated() {
  setShaderUniform("hatchInterpolated", interpolated == InterpolatedMark::hatch ? 1.0F : 0.0F);
  setShaderUniform("colourInterpolated", interpolated == InterpolatedMark::colour ? 1.0F : 0.0F);
}

void ReliefScene::Impl::placeCamera(const SceneView& v, const PictureTile& tile) {
  // Half depth of what has to lie between the clipping planes.
  double reach = v.mm_per_pixel;
  if (has_surface) {
    const GridFrame& f = mesh.frame();
    const ViewMm half{0.5 * f.size.cols * f.spacing_mm, 0.5 * f.size.rows * f.spacing_mm,
                      0.5 * (mesh.maxMm() - mesh.minMm()) + 1e-3 * f.spacing_mm};
    const ViewMm t = v.towards_viewer, m = mesh.middle() - v.focal;
    reach = std::abs(dot(m, t)) + std::abs(half.x * t.x) + std::abs(half.y * t.y) +
            std::abs(half.z * t.z);
    if (mesh.minMm() > 0) reach += mesh.minMm();  // Rim cells reach down to the base plane.
  }
  if (probe_actors.reachMm() > 0) {
    const double along = std::abs(dot(probe_actors.proxy() - v.focal, v.towards_viewer));
    reach = std::max(reach, along + probe_actors.reachMm());
  }
  reach *= 1.01;
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
  vtk_camera->SetEyeAngle(stereo.eye_angle_deg);
  vtk_camera->SetViewShear(v.slant, 0, 1);  // About the focal point's distance.
  // VTK keeps the last mono matrix for the left eye unless the camera itself changed.
  vtk_camera->Modified();
}

void ReliefScene::Impl::applyStereo() {
  if (!window) return;
  if (stereo.mode == StereoMode::off) {
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
  impl_->mesh.update(grid);
  impl_->heights = *grid.heights_mm;
  impl_->origins = grid.origins ? *grid.origins : std::vector<CellStatus>{};
  impl_->colours = grid.colours ? *grid.colours : std::vector<std::uint8_t>{};
  impl_->grid = {grid.frame, &impl_->heights, grid.origins ? &impl_->origins : nullptr,
                 grid.colours ? &impl_->colours : nullptr, grid.lit};
  impl_->paint();
  const ViewMm m = impl_->mesh.middle();
  impl_->surface->SetPosition(m.x, m.y, m.z);
  impl_->surface->VisibilityOn();
  impl_->has_surface = true;
}

void ReliefScene::clearSurface() {
  impl_->surface->VisibilityOff();
  impl_->has_surface = false;
}

void ReliefScene::setCamera(const ReliefCamera& camera) {
  if (!(camera.rect.width_mm > 0) || !(camera.rect.height_mm > 0)) {
    throw failure<MessageId::camera_without_size>();
  }
  impl_->camera = camera;
}

const StereoOptions& ReliefScene::stereo() const {
  return impl_->stereo;
}

void ReliefScene::setStereo(const StereoOptions& stereo) {
  impl_->stereo = stereo;
  impl_->applyStereo();
}

void ReliefScene::setLight(const LightOptions& light) {
  impl_->light = light;
  impl_->placeLights();
}

void ReliefScene::setBackground(double red, double green, double blue) {
  impl_->background = {red, green, blue};
  impl_->layers[0]->SetBackground(red, green, blue);
}

void ReliefScene::setTransparent(bool transparent) {
  impl_->transparent = transparent;
  if (transparent) impl_->layers[0]->SetBackground(0, 0, 0);
}

void ReliefScene::setEyeTurn(double turn_deg) {
  impl_->eye_turn_deg = turn_deg;
}

void ReliefScene::setInterpolated(InterpolatedMark mark) {
  impl_->interpolated = mark;
  impl_->markInterpolated();
}

void ReliefScene::setMarkScale(double pixels) {
  impl_->mark_scale = pixels;
}

void ReliefScene::setPinkWindow(const std::optional<RectMm>& rect, bool with_handles) {
  impl_->pink = rect;
  impl_->pink_handles = with_handles;
}

void ReliefScene::setProbe(const std::optional<Probe>& probe, double ball_radius_mm) {
  impl_->probe = probe;
  impl_->ball_radius_mm = ball_radius_mm;
  impl_->probe_actors.set(probe, ball_radius_mm);
}

void ReliefScene::setLines(const std::vector<std::vector<ViewMm>>& lines,
                           const std::vector<std::vector<ViewMm>>& curves) {
  impl_->lines = lines;
  impl_->curves = curves;
}

void ReliefScene::setScaleBar(bool visible) {
  impl_->scale_bar = visible;
}

void ReliefScene::setDecimalMark(char mark) {
  impl_->decimal_mark = mark;
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
  impl_->probe_actors.face(view);
  impl_->setShaderUniform(
      "hatchPeriod", static_cast<float>(kHatchPeriodPx * impl_->mark_scale * view.mm_per_pixel));
  std::vector<ViewMm> corners;
  if (impl_->pink) {
    const RectMm& r = *impl_->pink;
    const double z = impl_->markPlane(), x1 = r.x_mm + r.width_mm, y1 = r.y_mm + r.height_mm;
    corners = {{r.x_mm, r.y_mm, z}, {x1, r.y_mm, z}, {x1, y1, z}, {r.x_mm, y1, z}};
  }
  impl_->marks.draw(view, {.corners = corners,
                           .handles = impl_->pink_handles,
                           .scale_bar = impl_->scale_bar,
                           .decimal_mark = impl_->decimal_mark,
                           .lines = impl_->lines,
                           .curves = impl_->curves,
                           .scale = impl_->mark_scale,
                           .dpi = impl_->window ? impl_->window->GetDPI() : 72,
                           .origin = {static_cast<double>(drawn.x), static_cast<double>(drawn.y)}});
}

void ReliefScene::stopBy(const std::stop_token& stop) {
  impl_->mapper->stopBy(stop);
}

vtkRenderer* ReliefScene::renderer() {
  return impl_->layers[0];
}

ViewMm ReliefScene::viewFromPixel(double px, double py, int width_px, int height_px,
                                  double z_mm) const {
  return impl_->view(width_px, height_px).viewOf({px, height_px - py}, z_mm);
}

bool ReliefScene::isEmpty() const {
  return !impl_->has_surface && !impl_->probe && !impl_->pink && !impl_->scale_bar;
}

std::unique_ptr<ReliefScene> ReliefScene::copy() const {
  auto other = std::make_unique<ReliefScene>();
  if (impl_->has_surface) other->setSurface(impl_->grid);
  other->setCamera(impl_->camera);
  other->setStereo(impl_->stereo);
  other->setLight(impl_->light);
  other->setBackground(impl_->background[0], impl_->background[1], impl_->background[2]);
  other->setTransparent(impl_->transparent);
  other->setEyeTurn(impl_->eye_turn_deg);
  other->setMarkScale(impl_->mark_scale);
  other->setInterpolated(impl_->interpolated);
  other->setPinkWindow(impl_->pink, impl_->pink_handles);
  other->setProbe(impl_->probe, impl_->ball_radius_mm);
  other->setLines(impl_->lines, impl_->curves);
  other->setScaleBar(impl_->scale_bar);
  other->setDecimalMark(impl_->decimal_mark);
  return other;
}

}  // namespace relievo
