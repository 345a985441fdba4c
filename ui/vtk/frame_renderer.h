// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "ui/vtk/offscreen.h"
#include "ui/vtk/relief_scene.h"

namespace relievo {

/// A scene with an off-screen window of its own, for pictures of one size that follow one another.
/// The OpenGL context that was current when it was made is current again once it is gone.
/// [the thread that made it]
class FrameRenderer {
 public:
  /// @throw GraphicsError  no display, or larger than the driver can draw
  FrameRenderer(int width_px, int height_px);
  ~FrameRenderer();
  FrameRenderer(const FrameRenderer&) = delete;
  FrameRenderer& operator=(const FrameRenderer&) = delete;

  ReliefScene& scene();
  /// The scene as it is now. Valid until the next call.
  /// @throw GraphicsError  a black picture; Cancelled
  const RgbaImage& draw(const Task& task = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
