// SPDX-License-Identifier: BSD-3-Clause
// Pictures of the views and of the window.
#include <memory>
#include <optional>
#include <QFileInfo>

#include "core/base/error.h"
#include "ui/dialogs/image_dialog.h"
#include "ui/frame/message_strip.h"
#include "ui/frame/status_fields.h"
#include "ui/language/spoken_error.h"
#include "ui/views/detail_view.h"
#include "ui/views/picture_file.h"
#include "ui/views/reference_view.h"
#include "ui/window/main_window.h"
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

}  // namespace

void MainWindow::chooseImage() {
  auto* dialog = new ImageDialog(stemOf(document_.file(), QStringLiteral("-reference-9999.png")),
                                 detail_->size(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &ImageDialog::chosen, this, [this](const ImageChoice& choice) {
    saveImage(choice.source, choice.pixels, choice.file);
  });
  dialog->open();
}

void MainWindow::connectImages() {
  connect(&image_work_, &WorkQueue::busyChanged, this, &MainWindow::showBusy);
  connect(status_, &StatusFields::cancelAsked, this, [this] {
    stayOpen();
    if (image_work_.cancel()) announce(tr("Cancelled. No picture was saved."));
  });
}

void MainWindow::saveImage(ImageSource source, const QSize& pixels, const QString& file) {
  const auto error = std::make_shared<QString>();
  image_work_.add(
      [order = pictureOrder(source, pixels, file), error](const Task& task) {
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
          strip_->show(*error);
        }
        closeIfAwaited(error->isEmpty());
      });
}

bool MainWindow::writing() const {
  return savingImage() || packing() || exporting() || video_->writing() || video_->live();
}

bool MainWindow::closesWhenAllIsWritten() {
  if (video_->live()) video_->stopLive();
  closes_when_saved_ = writing();
  if (!closes_when_saved_) return false;
  announce(packing()     ? tr("relievo closes when the package is written")
           : exporting() ? tr("relievo closes when the map is written")
           : video_->writing() || video_->live()
               ? tr("relievo closes when the video is saved; Escape stops both")
               : tr("relievo closes when the picture is saved"));
  return true;
}

void MainWindow::closeIfAwaited(bool written) {
  if (!written) stayOpen();
  if (closes_when_saved_ && !writing()) close();
}

PictureOrder MainWindow::pictureOrder(ImageSource source, const QSize& pixels,
                                      const QString& file) {
  const SceneState& detail = detail_->sceneState();
  PictureOrder order{.project = document_.stored(),
                     .surface = document_.surface(),
                     .window = document_.window(),
                     .reference = {},
                     .grabbed = {},
                     .description = recordingHeader(file).toStdString(),
                     .file = file};
  PictureChoice picture{
      .width_px = pixels.width(), .height_px = pixels.height(), .scale_bar = true};
  switch (source) {
    case ImageSource::detail:
      picture.background = detail.background.name().toStdString();
      // The ends that the view shows come from the whole object.
      if (!order.project.look.range) order.project.look.range = detail_->shownRange();
      picture.lines = detail.lines;
      picture.hand = handOf(detail);
      break;
    case ImageSource::reference:
      picture.source = "reference view";
      order.reference = reference_->plainState();
      break;
    case ImageSource::window:
      picture.source = "whole window";
      reference_->appear();
      detail_->appear();
      order.grabbed = grab().toImage();
      break;
  }
  order.project.picture = picture;
  order.project.figures.clear();  // They belong to the work, not to what one of them shows.
  return order;
}

}  // namespace relievo
