// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QImage>
#include <QSize>
#include <QString>
#include <string>

#include "core/base/task.h"
#include "core/project/project.h"
#include "core/region/window.h"
#include "ui/views/scene_state.h"

namespace relievo {

enum class ImageSource { reference, detail, window };

/// A picture to be saved; shared values, so that the window may go on. `project.picture` says which
/// one: the detail view's is made of surface and window, as `relievo render` does.
struct PictureOrder {
  Project project;
  std::shared_ptr<const Surface> surface;
  std::shared_ptr<const RegionWindow> window;
  SceneState reference;     ///< Drawn anew at the size. Its grid is plain; the look paints it.
  QImage grabbed;           ///< Of the whole window: pixels from the screen, scaled to the size.
  std::string description;  ///< Of reference view and whole window.
  QString file;
  bool both_eyes = false;  ///< Of the detail: each eye's picture beside it (writeViewEyes).
};

/// Draws a picture and writes it as PNG; older files stay until all new ones are whole.
/// @throw WriteError, GraphicsError, Cancelled [any thread that may use OpenGL]
void writePicture(const PictureOrder& order, const Task& task = {});

}  // namespace relievo
