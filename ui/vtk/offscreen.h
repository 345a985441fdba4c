// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/task.h"
#include "core/file/atomic_file.h"
#include "ui/vtk/relief_scene.h"

namespace relievo {

/// 8-bit RGB, row 0 at the top.
struct RgbImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Can an X display be opened? Must be asked before any VTK window is made: without one VTK aborts.
bool haveDisplay();

/// Starts a private Xvfb for this process if there is no display, and stops it in the destructor;
/// meanwhile the environment's DISPLAY names it. It also ends if the thread that started it does.
/// To be made before other threads read the environment. [main thread]
class DisplayGuard {
 public:
  /// @throw GraphicsError  no display and Xvfb is missing or does not start
  DisplayGuard();
  ~DisplayGuard();
  DisplayGuard(const DisplayGuard&) = delete;
  DisplayGuard& operator=(const DisplayGuard&) = delete;

 private:
  int pid_ = -1;
  std::optional<std::string> display_before_;
};

/// Renders a copy of a scene into memory, independent of any window on screen; the OpenGL context
/// that was current stays so. Pictures above 512 pixels, or the driver's limit if that is less,
/// are drawn in tiles; no seam shows. [the scene's thread] @throw GraphicsError  no display, a
/// picture beyond 2^29 pixels, or an image that the driver failed to draw; Cancelled
RgbImage renderOffscreen(const ReliefScene& scene, int width, int height, const Task& task = {});

/// 8 bits a channel, row 0 at the top; colours are multiplied by alpha already.
struct RgbaImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// As files store it: three bytes a pixel if all are opaque, else four, colours not multiplied.
std::vector<std::uint8_t> storedBytes(const RgbaImage& image);

struct PictureOptions {
  int width = 0, height = 0;  ///< Pixels.
  bool transparent = false;   ///< Alpha 0 where there is no relief; without stereo.
  int tile_px = 512;          ///< Longest side of a tile.
};
/// The same with alpha. [the scene's thread] @throw GraphicsError, ArgumentError, Cancelled
RgbaImage renderPicture(const ReliefScene& scene, const PictureOptions& options,
                        const Task& task = {});

/// False if every byte is 0: what a driver gives back when it silently failed to draw. Black that
/// was drawn has an alpha.
bool anythingDrawn(std::span<const std::uint8_t> rgba);

/// PNG with text entries (Title, Software, relievo:state, ...). @throw WriteError
void writePng(const OutputFile& file, const RgbImage& image,
              const std::vector<std::pair<std::string, std::string>>& text = {});

}  // namespace relievo
