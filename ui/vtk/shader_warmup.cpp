// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/shader_warmup.h"

#include <cstdint>
#include <vector>

#include <vtkProp.h>
#include <vtkPropCollection.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include "ui/vtk/relief_scene.h"

namespace relievo {
namespace {
constexpr int kSidePx = 64;
}

struct ShaderWarmup::Impl {
  vtkRenderWindow* window = nullptr;
  ReliefScene scene;
  std::vector<float> heights = std::vector<float>(4, 0.0F);
  std::vector<CellStatus> origins = std::vector<CellStatus>(4, CellStatus::measured);
  std::vector<std::uint8_t> colours = std::vector<std::uint8_t>(12, 128);
  std::vector<vtkSmartPointer<vtkProp>> left;  ///< To be drawn alone, the last one first.
  vtkSmartPointer<vtkProp> drawn;
  bool cleared = false, painted = false, mixed = false;

  void fill(bool with_colours) {
    SurfaceGrid grid{{{2, 2}, 1, -0.5, -0.5}, &heights, &origins};
    if (with_colours) grid.colours = &colours;
    scene.setSurface(grid);
  }
  /// Everything that would be drawn is hidden, and kept to be drawn alone.
  void takeApart() {
    scene.prepare(kSidePx, kSidePx);
    vtkRendererCollection* const layers = window->GetRenderers();
    vtkCollectionSimpleIterator at_layer = nullptr;
    layers->InitTraversal(at_layer);
    while (vtkRenderer* layer = layers->GetNextRenderer(at_layer)) {
      vtkPropCollection* const props = layer->GetViewProps();
      vtkCollectionSimpleIterator at = nullptr;
      props->InitTraversal(at);
      while (vtkProp* prop = props->GetNextProp(at)) {
        if (prop->GetVisibility() == 0) continue;
        prop->VisibilityOff();
        left.emplace_back(prop);
      }
    }
  }
};

ShaderWarmup::ShaderWarmup(vtkRenderWindow* window) : impl_(std::make_unique<Impl>()) {
  impl_->window = window;
  window->SetSize(kSidePx, kSidePx);
  impl_->fill(false);
  impl_->scene.setCamera({.rect = {-2, -2, 4, 4}});
  impl_->scene.setPinkWindow(RectMm{-1, -1, 2, 2}, true);
  impl_->scene.setScaleBar(true);
  Probe probe;
  probe.proxy = {0, 0, 0.5};
  probe.force = {0, 0, 1};
  impl_->scene.setProbe(probe, 0.5);
  impl_->scene.attachTo(window);
  impl_->takeApart();
}

ShaderWarmup::~ShaderWarmup() = default;

bool ShaderWarmup::step() {
  Impl& it = *impl_;
  if (it.drawn) it.drawn->VisibilityOff();
  it.drawn = nullptr;
  if (!it.cleared) {
    it.cleared = true;  // The background, and the way from the frame buffer to the window.
  } else if (!it.left.empty()) {
    it.drawn = it.left.back();
    it.left.pop_back();
    it.drawn->VisibilityOn();
  } else if (!it.painted) {
    it.painted = true;
    it.fill(true);  // Colours are one more input of the surface's shader.
  } else if (!it.mixed) {
    it.mixed = true;  // The mixed picture goes back into the window by a shader.
    StereoOptions stereo;
    stereo.mode = StereoMode::anaglyph;
    it.scene.setStereo(stereo);
  } else {
    it.scene.setStereo({});
    return false;
  }
  it.window->Render();
  return true;
}

}  // namespace relievo
