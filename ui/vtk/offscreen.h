// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "ui/vtk/relief_scene.h"

namespace relievo {

/// 8-bit RGB, row 0 at the top.
struct RgbImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Can an X display be opened? Must be asked before any VTK window is made: without one VTK aborts.
bool haveDisplay();

/// Starts a private Xvfb for this process if there is no display, and stops it in the destructor.
class DisplayGuard {
 public:
  /// @throw GraphicsError  no display and Xvfb is missing or does not start
  DisplayGuard();
  ~DisplayGuard();
  DisplayGuard(const DisplayGuard&) = delete;
  DisplayGuard& operator=(const DisplayGuard&) = delete;

 private:
  int pid_ = -1;
};

/// Renders a scene into memory, independent of any window on screen. @throw GraphicsError  no
/// display, size above the driver's limit, or a black (failed) image
RgbImage renderOffscreen(ReliefScene& scene, int width, int height);

/// PNG with text entries (Title, Software, relievo:state, ...). @throw WriteError
void writePng(const std::filesystem::path& file, const RgbImage& image,
              const std::vector<std::pair<std::string, std::string>>& text = {});

}  // namespace relievo
