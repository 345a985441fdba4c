// SPDX-License-Identifier: BSD-3-Clause
#include "app/draw/drawing_verbs.h"

#include <filesystem>

#include "core/base/failure.h"
#include "ui/figure/picture_libraries.h"
#include "ui/vtk/depth_capture.h"
#include "ui/vtk/files/picture_file.h"
#include "ui/vtk/offscreen.h"

namespace relievo::batch {

void requirePictureName(const std::string& file) {
  if (pictureFormatOf(file)) return;
  throw failure<MessageId::picture_name>(std::filesystem::path(file).filename().string());
}

Drawing ownDrawing() {
  return {.depth_buffer =
              [](const DepthRequest& request, const Task& task) {
                const DisplayGuard display;
                return captureDepths(request, task);
              },
          .libraries = pictureLibraries,
          .verbs =
              [] {
                return std::vector<Verb>{renderVerb(), figureVerb(), videoVerb()};
              }};
}

}  // namespace relievo::batch
