// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "core/region/probe.h"
#include "ui/vtk/scene_view.h"

namespace relievo {

/// Length of the force arrow, in ball radii per newton.
inline constexpr double kArrowRadiiPerN = 2.5;

/// Proxy, HIP, line and force arrow. Two renderers above the surface: the ball, line and arrow in
/// one, the HIP's ring in a second, so that the ball never hides it.
class ProbeActors {
 public:
  ProbeActors();
  void addTo(vtkRenderer* middle_layer, vtkRenderer* top_layer);
  void set(const std::optional<Probe>& probe, double ball_radius_mm);
  /// Where no colour will be left, the HIP is a white ring with a cross in it, the proxy a ball.
  void setColourless(bool colourless);
  /// The ring faces the viewer. To be called before each render.
  void face(const SceneView& view);

  /// Largest distance from the proxy to anything drawn; 0 if nothing is.
  double reachMm() const { return reach_mm_; }
  ViewMm proxy() const { return proxy_; }

 private:
  void setArrow(const Probe& probe);

  vtkNew<vtkActor> ball_, line_, shaft_, head_, ring_rim_, ring_, centre_;
  vtkNew<vtkLineSource> segment_;
  // The HIP's ring and its rim; without a cross, and with one.
  vtkNew<vtkAppendPolyData> plain_, plain_rim_, crossed_, crossed_rim_;
  bool visible_ = false, colourless_ = false;
  ViewMm proxy_, hip_;
  double radius_mm_ = 1, reach_mm_ = 0;
};

}  // namespace relievo
