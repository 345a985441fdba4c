// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/drawing/kept_surface.h"

#include <vtk_glew.h>
#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

namespace relievo {

vtkStandardNewMacro(KeptSurface);

/// Null where pictures are not kept: nobody asked for it, or pixels have several samples each,
/// which cannot be copied back.
vtkOpenGLRenderWindow* KeptSurface::keepingWindow() {
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(GetVTKWindow());
  return keep_ && window != nullptr && window->GetMultiSamples() == 0 ? window : nullptr;
}

KeptSurface::Picture& KeptSurface::ofThisEye() {
  const bool is_right =
      RenderWindow->GetStereoRender() != 0 && GetActiveCamera()->GetLeftEye() == 0;
  return eyes_[is_right ? 1 : 0];
}

bool KeptSurface::has(const Picture& picture, vtkOpenGLRenderWindow& window) const {
  if (!picture.is_there || picture.sight != sight_) return false;
  const int* const drawn = window.GetRenderFramebuffer()->GetLastSize();
  const int* const kept = picture.pixels->GetLastSize();
  return drawn[0] == kept[0] && drawn[1] == kept[1];
}

void KeptSurface::copy(Picture& picture, vtkOpenGLRenderWindow& window, Way way) {
  vtkOpenGLFramebufferObject* const drawn = window.GetRenderFramebuffer();
  vtkOpenGLFramebufferObject* const kept = picture.pixels;
  vtkOpenGLFramebufferObject* const from = way == Way::to_kept ? drawn : kept;
  vtkOpenGLFramebufferObject* const to = way == Way::to_kept ? kept : drawn;
  const int* const size = drawn->GetLastSize();
  vtkOpenGLState* const state = window.GetState();
  state->PushFramebufferBindings();
  from->Bind(GL_READ_FRAMEBUFFER);
  from->ActivateReadBuffer(0);
  to->Bind(GL_DRAW_FRAMEBUFFER);
  to->ActivateDrawBuffer(0);
  state->vtkglBlitFramebuffer(0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT,
                              GL_NEAREST);
  state->PopFramebufferBindings();
}

bool KeptSurface::makeRoom(Picture& picture, vtkOpenGLRenderWindow& window) {
  const int* const size = window.GetRenderFramebuffer()->GetLastSize();
  vtkOpenGLState* const state = window.GetState();
  state->PushFramebufferBindings();
  picture.pixels->SetContext(&window);
  bool has_room = picture.pixels->GetFBOIndex() != 0;
  if (has_room) {
    picture.pixels->Resize(size[0], size[1]);
  } else {
    constexpr int kColours = 1, kNoDepthBits = 0, kNoSamples = 0;
    has_room = picture.pixels->PopulateFramebuffer(
        size[0], size[1], true, kColours, VTK_UNSIGNED_CHAR, false, kNoDepthBits, kNoSamples);
  }
  state->PopFramebufferBindings();
  return has_room;
}

// All of what would be cleared is copied over.
void KeptSurface::Clear() {
  vtkOpenGLRenderWindow* const window = keepingWindow();
  if (window == nullptr || !has(ofThisEye(), *window)) vtkOpenGLRenderer::Clear();
}

int KeptSurface::UpdateGeometry(vtkFrameBufferObjectBase* fbo) {
  vtkOpenGLRenderWindow* const window = keepingWindow();
  if (window == nullptr) return vtkOpenGLRenderer::UpdateGeometry(fbo);
  Picture& picture = ofThisEye();
  if (has(picture, *window)) {
    copy(picture, *window, Way::from_kept);
    return NumberOfPropsRendered;
  }
  const int count = vtkOpenGLRenderer::UpdateGeometry(fbo);
  picture.is_there = makeRoom(picture, *window);
  if (picture.is_there) copy(picture, *window, Way::to_kept);
  picture.sight = sight_;
  return count;
}

void KeptSurface::ReleaseGraphicsResources(vtkWindow* window) {
  for (Picture& picture : eyes_) {
    picture.pixels->ReleaseGraphicsResources(window);
    picture.is_there = false;
  }
  vtkOpenGLRenderer::ReleaseGraphicsResources(window);
}

}  // namespace relievo
