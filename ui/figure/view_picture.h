// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/file/atomic_file.h"
#include "core/project/project.h"
#include "core/region/window.h"
#include "ui/vtk/offscreen.h"

namespace relievo {

struct ViewPictureFacts {
  int width_px = 0, height_px = 0;
  double mm_per_pixel = 0;
  std::string caption;
};

/// The pixels of what writeViewPicture writes. @throw as that, but for WriteError
RgbImage drawViewPicture(const Surface& surface, const RegionWindow& window, const Project& project,
                         const Task& task = {});

/// Draws exactly the project's region as its `picture` says and writes it as PNG or, if its name
/// ends so, as TIFF with caption and state: what `relievo render` makes, and "Save picture" of the
/// detail view. An older file stays until the new one is whole. [any thread that may use OpenGL]
/// @param window  of the project's region on that surface
/// @throw ArgumentError  only the window can draw that picture  @throw GraphicsError, WriteError,
/// Cancelled
ViewPictureFacts writeViewPicture(const Surface& surface, const RegionWindow& window,
                                  const Project& project, const OutputFile& file,
                                  const Task& task = {});

/// The pictures of the two eyes that the project's stereo mixes, as files of their own: the left
/// eye's, NAME.left.png, and the right eye's; made as writeViewPicture makes its own, all of them
/// members of the file's set. [any thread that may use OpenGL] @throw as writeViewPicture
/// @param file  the picture of both  @pre a set
void writeViewEyes(const Surface& surface, const RegionWindow& window, const Project& project,
                   const OutputFile& file, const Task& task = {});
/// Their names. @param file  the picture of both
std::vector<std::filesystem::path> viewEyeFiles(const std::filesystem::path& file);

}  // namespace relievo
