// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

class vtkRenderWindow;

namespace relievo {

/// Draws a speck of everything a ReliefScene can show, one thing a step, into a window that shows
/// nothing yet. A driver compiles a shader when it draws with it for the first time; software
/// OpenGL takes some tens of milliseconds for each, a third of a second for a whole scene. The
/// scene that is attached afterwards finds them compiled. [the thread of the render window]
class ShaderWarmup {
 public:
  /// @param window  which outlives this and has an OpenGL context
  explicit ShaderWarmup(vtkRenderWindow* window);
  ~ShaderWarmup();
  ShaderWarmup(const ShaderWarmup&) = delete;
  ShaderWarmup& operator=(const ShaderWarmup&) = delete;

  /// @return false: everything was drawn
  bool step();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
