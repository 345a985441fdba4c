// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/label_actor.h"

#include <mutex>

namespace relievo {
namespace {

std::mutex& glyphs() {
  static std::mutex turn;
  return turn;
}

}  // namespace

LabelActor* LabelActor::New() {
  const std::lock_guard turn(glyphs());  // The first one makes the cache.
  auto* const label = new LabelActor;
  label->InitializeObjectBase();
  return label;
}

// The only place where the base class, whose font does not follow its box, asks for glyphs.
int LabelActor::UpdateRectangle(vtkViewport* viewport) {
  const std::lock_guard turn(glyphs());
  return vtkTextActor::UpdateRectangle(viewport);
}

}  // namespace relievo
