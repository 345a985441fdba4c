// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stop_token>

#include <vtkActor.h>
#include <vtkNew.h>

#include "ui/vtk/drawing/stoppable_mapper.h"
#include "ui/vtk/relief_scene.h"
#include "ui/vtk/surface_mesh.h"

namespace relievo {

/// The relief of a ReliefScene: matt stone, or the colours of the samples, with cells that were not
/// measured marked. [thread of the scene]
class ReliefActor {
 public:
  ReliefActor();

  vtkActor* actor() { return actor_; }
  const SurfaceMesh& mesh() const { return mesh_; }
  /// A painted relief that is not lit keeps its colours whatever the lamps do.
  void show(const SurfaceGrid& grid);
  void hide();
  /// As SurfaceMesh::setCoarse.
  bool setCoarse(bool coarse) { return mesh_.setCoarse(coarse); }
  /// How interpolated cells are marked.
  void mark(InterpolatedMark how);
  void setHatchPeriod(double period_mm);
  void stopBy(const std::stop_token& stop);

 private:
  void setUniform(const char* name, float value);

  vtkNew<vtkActor> actor_;
  vtkNew<StoppableMapper> mapper_;
  SurfaceMesh mesh_;
};

}  // namespace relievo
