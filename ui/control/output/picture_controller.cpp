// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/output/picture_controller.h"

#include <memory>
#include <optional>
#include <QFileInfo>
#include <QStandardPaths>

#include "core/base/error.h"
#include "ui/control/foreign_files.h"
#include "ui/control/replay_controller.h"
#include "ui/dialogs/figure/figure_dialog.h"
#include "ui/dialogs/image_dialog.h"
#include "ui/language/error_text.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

std::optional<DrawnHand> handOf(const SceneState& scene) {
  if (!scene.probe) return std::nullopt;
  const Probe& probe = *scene.probe;
  return DrawnHand{.proxy = probe.proxy,
                   .hip = probe.hip,
                   .force = probe.force,
                   .force_limit_n = probe.force_limit_n,
                   .touching = probe.touching,
                   .forces_on = probe.forces_on,
                   .ball_radius_mm = scene.ball_radius_mm};
}

/// NAME-1.png, NAME-2.png, ... in the pictures folder: the first that is free.
QString freeFigureName(const QString& model) {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation) +
                         QLatin1String("/relievo/");
  for (int n = 1;; ++n) {
    QString file = QStringLiteral("%1%2-figure-%3.png").arg(folder, model).arg(n);
    if (!QFileInfo::exists(file)) return file;
  }
}

}  // namespace

PictureController::PictureController(const ControllerParts& parts, DetailView& detail,
                                     ReferenceView& reference, const ForeignFiles& foreign)
    : Controller(parts), detail_(detail), reference_(reference), foreign_(foreign) {
  commands_.on(Command::image, this, [this] { chooseImage(); });
  commands_.on(Command::figure, this, [this] { chooseFigure(); });
  connect(&work_, &WorkQueue::busyChanged, &messages_, &WindowMessages::showBusy);
  connect(&messages_, &WindowMessages::cancelAsked, this, [this] {
    if (work_.cancel()) announce(tr("Cancelled. No picture was saved."));
  });
}

void PictureController::begin(bool restored_look) {
  figure_view_.reset();
  if (restored_look) figure_view_ = document_.project().look;
}

void PictureController::chooseImage() {
  auto* dialog = new ImageDialog(stemOf(document_.file(), QStringLiteral("-reference-9999.png")),
                                 detail_.size(), &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &ImageDialog::chosen, this, [this](const ImageChoice& choice) {
    save(choice.source, choice.pixels, choice.file, choice.both_eyes);
  });
  dialog->open();
}

void PictureController::save(ImageSource source, const QSize& pixels, const QString& file,
                             bool both_eyes) {
  const auto error = std::make_shared<QString>();
  PictureOrder order = this->order(source, pixels, file);
  order.both_eyes = both_eyes && source == ImageSource::detail;
  work_.add(
      [order = std::move(order), error](const Task& task) {
        try {
          writePicture(order, task);
        } catch (const Cancelled&) {  // Its end is not told.
        } catch (const std::exception& failure) {
          *error = shownError(failure);
        }
      },
      [this, file, error] {
        if (error->isEmpty()) {
          noteFigure(file);
          announce(tr("%1 is saved").arg(shownName(file)));
        } else {
          messages_.show(*error);
        }
        Q_EMIT ended(error->isEmpty());
      });
}

PictureOrder PictureController::order(ImageSource source, const QSize& pixels,
                                      const QString& file) {
  const SceneState& detail = detail_.sceneState();
  PictureOrder made{.project = document_.stored(),
                    .surface = document_.surface(),
                    .window = document_.window(),
                    .reference = {},
                    .grabbed = {},
                    .description = recordingHeader(document_, file).toStdString(),
                    .file = file};
  // What is on its way from the web is not in the picture yet.
  if (made.window) made.project.region.level = made.window->region.level;
  PictureChoice picture{
      .width_px = pixels.width(), .height_px = pixels.height(), .scale_bar = true};
  switch (source) {
    case ImageSource::detail:
      picture.background = detail.background.name().toStdString();
      // The ends that the view shows come from the whole object.
      if (!made.project.look.range) made.project.look.range = detail_.shownRange();
      picture.lines = detail.lines;
      picture.hand = handOf(detail);
      break;
    case ImageSource::reference:
      picture.source = "reference view";
      made.reference = reference_.plainState();
      break;
    case ImageSource::window:
      picture.source = "whole window";
      reference_.appear();
      detail_.appear();
      made.grabbed = window_.grab().toImage();
      break;
  }
  made.project.picture = picture;
  made.project.figures.clear();  // They belong to the work, not to what one of them shows.
  return made;
}

void PictureController::chooseFigure() {
  if (!document_.isOpen() || document_.loader().busy()) return;
  Project now = document_.stored();
  const std::string plotted = foreign_.isWithheld(now.figure.recording) ? now.figure.recording : "";
  if (!plotted.empty()) now.figure.recording.clear();
  // A figure starts as the view is painted and lit; a look that was chosen for it stays until the
  // view's changes.
  if (figure_view_ != now.look) now.figure.look = now.look;
  now.figures.clear();  // They belong to the work, not to what one of them shows.
  auto* dialog = new FigureDialog(
      document_.surface(), now,
      freeFigureName(stemOf(document_.file(), QStringLiteral("-figure-9999-heights.tif"))),
      &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setModal(true);  // The state must not change below a preview of it.
  connect(dialog, &FigureDialog::requestChanged, this,
          [this, plotted](const FigureRequest& request) {
            document_.amend([&](Project& p) {
              p.figure = request;
              if (request.recording.empty()) p.figure.recording = plotted;  // Not lost.
            });
            figure_view_ = document_.project().look;
          });
  connect(dialog, &FigureDialog::refused, this, [this](const QString& why) { announce(why); });
  connect(dialog, &FigureDialog::written, this, [this](const QString& file) {
    noteFigure(file);
    const QFileInfo saved(file);
    announce(tr("%1 is saved in %2").arg(shownName(file), shownPath(saved.absolutePath())));
  });
  dialog->show();
}

void PictureController::noteFigure(const QString& file) {
  const std::string path = bytesOfPath(QFileInfo(file).absoluteFilePath());
  document_.amend([&](Project& p) {
    std::erase(p.figures, path);
    p.figures.push_back(path);
  });
}

}  // namespace relievo
