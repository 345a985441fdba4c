// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/relief_actor.h"

#include <array>

#include <vtkDataObject.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

namespace relievo {
namespace {

constexpr std::array<double, 3> kStone{0.80, 0.785, 0.755};
constexpr double kDiffuse = 0.92;
constexpr std::array<float, 3> kUnmeasured{
    kUnmeasuredColour[0] / 255.0F, kUnmeasuredColour[1] / 255.0F, kUnmeasuredColour[2] / 255.0F};

/// Carries what a cell is, and where it lies in millimetres, to its pixels.
void carryCells(vtkShaderProperty* shader) {
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
}

/// What hatches and stripes are painted by.
void declareStripes(vtkShaderProperty* shader) {
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
}

/// Colours of cells that were not measured.
void paintCells(vtkShaderProperty* shader) {
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
}

void lightStone(vtkShaderProperty* shader) {
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

ReliefActor::ReliefActor() {
  mapper_->SetInputData(mesh_.poly());
  mapper_->ScalarVisibilityOff();
  mapper_->StaticOn();
  // Vertices are near 0 already; the hatch wants them in millimetres.
  mapper_->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  mapper_->MapDataArrayToVertexAttribute(SurfaceMesh::kOriginArray, SurfaceMesh::kOriginArray,
                                         vtkDataObject::FIELD_ASSOCIATION_POINTS);
  actor_->SetMapper(mapper_);
  actor_->VisibilityOff();
  vtkProperty* const stone = actor_->GetProperty();
  stone->SetColor(kStone[0], kStone[1], kStone[2]);
  stone->SetAmbient(0.16);
  stone->SetDiffuse(kDiffuse);
  stone->SetSpecular(0);
  stone->SetInterpolationToPhong();
  vtkShaderProperty* const shader = actor_->GetShaderProperty();
  carryCells(shader);
  declareStripes(shader);
  paintCells(shader);
  lightStone(shader);
  setHatchPeriod(1);  // A window may draw itself before the first prepare().
  shader->GetFragmentCustomUniforms()->SetUniform3f("unmeasuredColour", kUnmeasured.data());
  mark(InterpolatedMark::hatch);
}

void ReliefActor::setUniform(const char* name, float value) {
  actor_->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformf(name, value);
}

void ReliefActor::show(const SurfaceGrid& grid) {
  mesh_.update(grid);
  const bool keeps_colours = grid.colours != nullptr && !grid.lit;
  mapper_->SetScalarVisibility(grid.colours != nullptr ? 1 : 0);
  setUniform("asPainted", keeps_colours ? 1.0F : 0.0F);
  actor_->GetProperty()->SetDiffuse(keeps_colours ? 1.0 : kDiffuse);
  const ViewMm m = mesh_.middle();
  actor_->SetPosition(m.x, m.y, m.z);
  actor_->VisibilityOn();
}

void ReliefActor::hide() {
  actor_->VisibilityOff();
}

void ReliefActor::mark(InterpolatedMark how) {
  setUniform("hatchInterpolated", how == InterpolatedMark::hatch ? 1.0F : 0.0F);
  setUniform("colourInterpolated", how == InterpolatedMark::colour ? 1.0F : 0.0F);
}

void ReliefActor::setHatchPeriod(double period_mm) {
  setUniform("hatchPeriod", static_cast<float>(period_mm));
}

void ReliefActor::stopBy(const std::stop_token& stop) {
  mapper_->stopBy(stop);
}

}  // namespace relievo
