// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/probe_actors.h"

#include <array>
#include <cmath>

#include <vtkConeSource.h>
#include <vtkCylinderSource.h>
#include <vtkDiskSource.h>
#include <vtkMatrix4x4.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

namespace relievo {
namespace {

using Colour = std::array<double, 3>;
constexpr Colour kProxyBlue{0.12, 0.38, 0.95};
constexpr Colour kHipRed{0.93, 0.11, 0.14};
constexpr Colour kForceAmber{1.0, 0.76, 0.15};
constexpr Colour kLineLight{0.95, 0.95, 0.95};
constexpr Colour kRingWhite{0.97, 0.97, 0.97};
constexpr Colour kRimDark{0.09, 0.07, 0.08};

void dress(vtkActor* actor, vtkAlgorithm* source, const Colour& colour, bool lit) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  actor->SetMapper(mapper);
  actor->PickableOff();
  vtkProperty* const p = actor->GetProperty();
  p->SetColor(colour[0], colour[1], colour[2]);
  p->SetLighting(lit);
  p->SetAmbient(lit ? 0.45 : 1.0);
  p->SetDiffuse(lit ? 0.75 : 0.0);
  p->SetSpecular(lit ? 0.3 : 0.0);
  p->SetSpecularPower(30);
}

vtkNew<vtkDiskSource> annulus(double inner, double outer) {
  vtkNew<vtkDiskSource> disk;
  disk->SetInnerRadius(inner);
  disk->SetOuterRadius(outer);
  disk->SetCircumferentialResolution(48);
  return disk;
}

/// A bar through the middle, in the ring's plane, its middle line from -(x, y) to (x, y).
vtkNew<vtkPlaneSource> bar(double x, double y, double half_width) {
  const double across = half_width / std::hypot(x, y);
  const double side_x = -y * across, side_y = x * across;
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-x - side_x, -y - side_y, 0);
  plane->SetPoint1(x - side_x, y - side_y, 0);
  plane->SetPoint2(-x + side_x, -y + side_y, 0);
  return plane;
}

/// A ring, in ball radii; `bar_half_width` > 0: and two bars crosswise in it.
void compose(vtkAppendPolyData* shape, double inner, double outer, double bar_half_width) {
  shape->AddInputConnection(annulus(inner, outer)->GetOutputPort());
  if (bar_half_width <= 0) return;
  const double end = 0.5 * (inner + outer) / std::sqrt(2.0);
  shape->AddInputConnection(bar(end, end, bar_half_width)->GetOutputPort());
  shape->AddInputConnection(bar(end, -end, bar_half_width)->GetOutputPort());
}

/// Unit object (axes x, y, z) to view: columns are the images of the axes.
vtkNew<vtkMatrix4x4> placement(ViewMm x, ViewMm y, ViewMm z, ViewMm at) {
  vtkNew<vtkMatrix4x4> m;
  const std::array<ViewMm, 4> columns{x, y, z, at};
  for (int c = 0; c < 4; ++c) {
    const ViewMm& v = columns[static_cast<std::size_t>(c)];
    m->SetElement(0, c, v.x);
    m->SetElement(1, c, v.y);
    m->SetElement(2, c, v.z);
  }
  return m;
}

ViewMm cross(ViewMm a, ViewMm b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace

ProbeActors::ProbeActors() {
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  dress(ball_, sphere, kProxyBlue, true);
  dress(centre_, sphere, kHipRed, false);
  dress(line_, segment_, kLineLight, false);
  line_->GetProperty()->SetLineWidth(2.5);
  vtkNew<vtkCylinderSource> cylinder;  // Along y, from -0.5 to 0.5.
  cylinder->SetRadius(1);
  cylinder->SetResolution(24);
  dress(shaft_, cylinder, kForceAmber, true);
  vtkNew<vtkConeSource> cone;  // Along x, from -0.5 to 0.5.
  cone->SetRadius(1);
  cone->SetResolution(24);
  dress(head_, cone, kForceAmber, true);
  compose(plain_rim_, 1.12, 1.68, 0);
  compose(plain_, 1.2, 1.6, 0);
  compose(crossed_rim_, 1.12, 1.68, 0.3);
  compose(crossed_, 1.2, 1.6, 0.18);
  dress(ring_rim_, plain_rim_, kRimDark, false);
  dress(ring_, plain_, kHipRed, false);
  set(std::nullopt, 1);
}

void ProbeActors::addTo(vtkRenderer* middle_layer, vtkRenderer* top_layer) {
  for (vtkActor* actor : {ball_.Get(), line_.Get(), shaft_.Get(), head_.Get()}) {
    middle_layer->AddActor(actor);
  }
  for (vtkActor* actor : {ring_rim_.Get(), ring_.Get(), centre_.Get()}) top_layer->AddActor(actor);
}

void ProbeActors::set(const std::optional<Probe>& probe, double ball_radius_mm) {
  const bool visible =
      probe && isFinite(probe->proxy) && isFinite(probe->hip) && ball_radius_mm > 0;
  for (vtkActor* actor :
       {ball_.Get(), line_.Get(), shaft_.Get(), head_.Get(), ring_rim_.Get(), ring_.Get()}) {
    actor->SetVisibility(visible);
  }
  visible_ = visible;
  centre_->SetVisibility(visible && !colourless_);
  reach_mm_ = 0;
  if (!visible) return;
  radius_mm_ = ball_radius_mm;
  proxy_ = probe->proxy;
  hip_ = probe->hip;
  const double r = radius_mm_;
  ball_->SetUserMatrix(placement({r, 0, 0}, {0, r, 0}, {0, 0, r}, proxy_));
  const double c = 0.3 * r;
  centre_->SetUserMatrix(placement({c, 0, 0}, {0, c, 0}, {0, 0, c}, hip_));
  // Relative to the proxy, so that float coordinates are fine far from the origin.
  const ViewMm to_hip = hip_ - proxy_;
  segment_->SetPoint1(0, 0, 0);
  segment_->SetPoint2(to_hip.x, to_hip.y, to_hip.z);
  line_->SetPosition(proxy_.x, proxy_.y, proxy_.z);
  reach_mm_ = norm(to_hip) + 2 * r;
  setArrow(*probe);
}

void ProbeActors::setColourless(bool colourless) {
  if (colourless == colourless_) return;
  colourless_ = colourless;
  vtkAppendPolyData* const rim = colourless ? crossed_rim_ : plain_rim_;
  vtkAppendPolyData* const ring = colourless ? crossed_ : plain_;
  ring_rim_->GetMapper()->SetInputConnection(rim->GetOutputPort());
  ring_->GetMapper()->SetInputConnection(ring->GetOutputPort());
  const Colour& colour = colourless ? kRingWhite : kHipRed;
  ring_->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  centre_->SetVisibility(visible_ && !colourless);
}

void ProbeActors::setArrow(const Probe& probe) {
  const ViewMm force{probe.force.x, probe.force.y, probe.force.z};
  const double newtons = norm(force);
  const bool shown = std::isfinite(newtons) && newtons > 1e-3;
  shaft_->SetVisibility(shown);
  head_->SetVisibility(shown);
  if (!shown) return;
  const double r = radius_mm_;
  const double length = kArrowRadiiPerN * newtons * r;
  const ViewMm along = (1 / newtons) * force;
  const ViewMm helper = std::abs(along.z) < 0.9 ? ViewMm{0, 0, 1} : ViewMm{1, 0, 0};
  ViewMm side = cross(helper, along);
  side = (1 / norm(side)) * side;
  const ViewMm other = cross(along, side);
  // The arrow leaves the ball's surface, so that its whole length shows the force.
  const double head = std::min(0.45 * length, 1.6 * r), shaft = length - head;
  const double shaft_radius = 0.22 * r, head_radius = 0.55 * r;
  shaft_->SetUserMatrix(placement(shaft_radius * other, shaft * along, shaft_radius * side,
                                  proxy_ + (r + 0.5 * shaft) * along));
  head_->SetUserMatrix(placement(head * along, head_radius * side, head_radius * other,
                                 proxy_ + (r + shaft + 0.5 * head) * along));
  reach_mm_ = std::max(reach_mm_, 2 * r + length);
}

void ProbeActors::face(const SceneView& view) {
  const double r = radius_mm_;
  const ViewMm x = r * view.right, y = r * view.up, z = r * view.towards_viewer;
  ring_rim_->SetUserMatrix(placement(x, y, z, hip_));
  ring_->SetUserMatrix(placement(x, y, z, hip_ + 0.02 * z));
}

}  // namespace relievo
