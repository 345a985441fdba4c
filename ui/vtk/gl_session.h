// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <GL/glx.h>

#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include "ui/vtk/display_connection.h"

namespace relievo {

/// Remembers the OpenGL context that is current on this thread and makes it current again at the
/// end, so that drawing off screen does not disturb a window.
class KeepGlContext {
 public:
  KeepGlContext()
      : display_(glXGetCurrentDisplay()),
        drawable_(glXGetCurrentDrawable()),
        context_(glXGetCurrentContext()) {}
  ~KeepGlContext() {
    if (display_ && context_) glXMakeCurrent(display_, drawable_, context_);
  }
  KeepGlContext(const KeepGlContext&) = delete;
  KeepGlContext& operator=(const KeepGlContext&) = delete;

 private:
  Display* display_;
  GLXDrawable drawable_;
  GLXContext context_;
};

/// An off-screen OpenGL window of its own. @throw GraphicsError  no display
class OffscreenWindow {
 public:
  OffscreenWindow();
  vtkRenderWindow* get() { return window_; }
  /// Largest side of a picture the driver can draw, pixels; more gives silently black images.
  int sizeLimitPx();

 private:
  // In this order: the window goes first, then the context is restored, then the server let go.
  DisplayConnection connection_;
  KeepGlContext keep_;
  vtkNew<vtkRenderWindow> window_;
};

}  // namespace relievo
