// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/picture_file.h"

#include <QFile>

#include "core/base/replaceable.h"
#include "core/file/output_set.h"
#include "core/provenance/embedded.h"
#include "core/provenance/name_text.h"
#include "core/provenance/program.h"
#include "ui/figure/view_picture.h"
#include "ui/views/overlays/grid_painter.h"
#include "ui/vtk/offscreen.h"

namespace relievo {
namespace {

RgbImage drawn(SceneState state, const PictureChoice& picture, const Task& task) {
  if (state.grid && GridPainter::canPaint(*state.grid, state.look.kind)) {
    state.grid = GridPainter::paintNow(*state.grid, state.look, task).grid;
  }
  ReliefScene scene;
  state.applyTo(scene);
  return renderOffscreen(scene, picture.width_px, picture.height_px, task);
}

RgbImage scaled(const QImage& grabbed, const PictureChoice& picture) {
  const QImage image = grabbed
                           .scaled(picture.width_px, picture.height_px, Qt::IgnoreAspectRatio,
                                   Qt::SmoothTransformation)
                           .convertToFormat(QImage::Format_RGB888);
  RgbImage out{.width = image.width(), .height = image.height(), .rgb = {}};
  for (int row = 0; row < image.height(); ++row) {
    const uchar* line = image.constScanLine(row);
    out.rgb.insert(out.rgb.end(), line, line + 3 * static_cast<std::ptrdiff_t>(image.width()));
  }
  return out;
}

}  // namespace

void writePicture(const PictureOrder& order, const Task& task) {
  const std::filesystem::path file = QFile::encodeName(order.file).toStdString();
  const Project& project = order.project;
  requireNotAnInput(file, {{.file = project.file}});
  if (project.picture->source == PictureChoice{}.source) {
    OutputSet set;
    if (order.both_eyes) {
      for (const auto& eye : viewEyeFiles(file)) requireNotAnInput(eye, {{.file = project.file}});
      writeViewEyes(*order.surface, *order.window, project, set.file(file), task);
    }
    writeViewPicture(*order.surface, *order.window, project, set.file(file), task);
    task.check();
    set.commit();
    return;
  }
  const RgbImage image = order.grabbed.isNull() ? drawn(order.reference, *project.picture, task)
                                                : scaled(order.grabbed, *project.picture);
  writePng(file, image,
           {{"Title", escapedName(std::filesystem::path(project.file).filename().string())},
            {"Description", order.description},
            {"Software", "relievo " + std::string(programVersion())},
            {std::string(kStateKey), projectJson(relativeTo(project, file))}});
}

}  // namespace relievo
