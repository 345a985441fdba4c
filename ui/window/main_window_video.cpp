// SPDX-License-Identifier: BSD-3-Clause
// Videos and camera paths: commands of the window.
#include <algorithm>
#include <array>
#include <QAction>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>

#include "core/base/error.h"
#include "core/base/replaceable.h"
#include "ui/dialogs/video_control.h"
#include "ui/dialogs/video_dialog.h"
#include "ui/frame/message_strip.h"
#include "ui/frame/status_fields.h"
#include "ui/language/spoken_error.h"
#include "ui/panels/replay_panel.h"
#include "ui/plots/time_plot.h"
#include "ui/style/text.h"
#include "ui/video/video_file.h"
#include "ui/views/detail_view.h"
#include "ui/views/path_preview.h"
#include "ui/window/main_window.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr double kKeyStepS = 3;  // From one key view to the next.

/// The folder that a video goes to if nobody chose one.
QString videoFolder() {
  const QString movies = QStandardPaths::writableLocation(QStandardPaths::MoviesLocation);
  const QDir folder((movies.isEmpty() ? QDir::homePath() : movies) + QLatin1String("/relievo"));
  folder.mkpath(QStringLiteral("."));
  return folder.path();
}

}  // namespace

void MainWindow::makeVideoCommands() {
  make({"video",
        tr("Save &video\u2026"),
        {QKeySequence("Ctrl+Alt+V")},
        tr("A video of the replay, or of the camera path, frame by frame"),
        [this] { chooseVideo(); },
        {}});
  auto* live = make({"video_live",
                     tr("Video of the vie&w"),
                     {QKeySequence("Ctrl+Alt+R")},
                     tr("Start or stop a video of what the detail view and the plots show"),
                     {},
                     {},
                     true});
  connect(live, &QAction::toggled, this, &MainWindow::setLiveVideo);
  make({"key_view",
        tr("Add &key view"),
        {QKeySequence("Ctrl+Alt+K")},
        tr("Let the camera path pass this view, three seconds after the one before"),
        [this] { addKeyView(); },
        {}});
  make({"path_play",
        tr("Show camera pa&th"),
        {QKeySequence("Ctrl+Alt+P")},
        tr("Run along the key views once, or stop"),
        [this] { previewPath(); },
        {}});
  make({"path_clear",
        tr("&Forget key views"),
        {},
        tr("Begin a new camera path"),
        [this] {
          document_.amend([](Project& p) { p.paths.clear(); });
          enableVideo();
          announce(tr("The camera path is empty"));
        },
        {}});
}

void MainWindow::connectVideo() {
  connect(video_, &VideoControl::said, this, &MainWindow::announce);
  connect(video_, &VideoControl::failed, this, &MainWindow::showMessage);
  connect(video_, &VideoControl::busyChanged, this, &MainWindow::showBusy);
  connect(video_, &VideoControl::busyChanged, this, [this](bool) { enableVideo(); });
  connect(video_, &VideoControl::ended, this, &MainWindow::closeIfAwaited);
  connect(video_, &VideoControl::progressed, status_, &StatusFields::showWork);
  connect(status_, &StatusFields::cancelAsked, this, [this] {
    stayOpen();
    video_->cancel();
  });
  connect(video_, &VideoControl::liveEnded, this, [this] {
    command("video_live")->setChecked(false);
    enableVideo();
  });
  connect(replay_, &ReplayControl::shownChanged, this, [this](bool) { enableVideo(); });
  connect(path_preview_, &PathPreview::viewChanged, this, &MainWindow::showPathView);
  connect(path_preview_, &PathPreview::ended, this, [this] {
    document_.revert();
    detail_->straighten();
    announce(tr("End of the camera path"));
  });
}

bool MainWindow::hasPath() const {
  return !document_.project().paths.empty() && document_.project().paths.front().keys.size() >= 2;
}

void MainWindow::enableVideo() {
  const bool is_open = document_.isOpen();
  command("video")->setEnabled(is_open && !video_->writing() && (replay_->showing() || hasPath()));
  command("video_live")->setEnabled(is_open);
  command("key_view")->setEnabled(is_open);
  command("path_play")->setEnabled(is_open && hasPath());
  command("path_clear")->setEnabled(!document_.project().paths.empty());
}

void MainWindow::chooseVideo() {
  const bool can_pack = haveFfmpeg();
  if (!can_pack) {
    announce(tr("The program ffmpeg is not installed: a folder of pictures can be made."));
  }
  VideoDialog::Start start;
  start.view_px = detail_->size() * devicePixelRatioF();
  start.can_pack = can_pack;
  start.recording = replay_->showing();
  start.duration_s =
      start.recording ? replay_->player().durationS() : document_.project().paths.front().endS();
  if (start.recording) start.request.speed = replay_->player().speed();
  if (hasPath()) start.request.path = document_.project().paths.front();
  const StereoOptions& stereo = document_.project().stereo;
  start.request.eye_angle_deg = stereo.eye_angle_deg;
  start.request.swap_eyes = stereo.swap_eyes;
  auto* dialog = new VideoDialog(start, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { chooseVideoFile(dialog->request()); });
  dialog->open();
}

void MainWindow::chooseVideoFile(const VideoRequest& chosen) {
  auto* dialog = new QFileDialog(this, tr("Video"), videoFolder());
  dialog->setObjectName(QStringLiteral("video_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  const bool folder = chosen.profile == VideoProfile::images;
  dialog->setNameFilter(folder ? tr("A folder of pictures (*)") : tr("Videos (*.mp4)"));
  dialog->selectFile(
      stemOf(replay_->showing() ? replay_->file() : document_.file(), QStringLiteral(".mp4.json")));
  connect(dialog, &QFileDialog::fileSelected, this, [this, chosen, folder](const QString& file) {
    const bool whole = folder || file.endsWith(QLatin1String(".mp4"));
    writeVideo(chosen, whole ? file : file + QLatin1String(".mp4"));
  });
  dialog->open();
}

void MainWindow::writeVideo(const VideoRequest& chosen, const QString& file) {
  try {
    requireNotAnInput(
        QFile::encodeName(file).toStdString(),
        {{.file = QFile::encodeName(document_.file()).toStdString()},
         {.file = QFile::encodeName(replay_->showing() ? replay_->file() : QString()).toStdString(),
          .what = "the recording that is shown"}});
  } catch (const Error& error) {
    strip_->show(shownError(error));
    return;
  }
  VideoControl::Order order;
  order.surface = document_.surface();
  order.request = chosen;
  order.request.look = document_.project().look;
  if (replay_->showing()) {
    order.recording = replay_->player().shared();
    order.recording_file = replay_->file();
  } else if (hasPath()) {
    order.request.path = document_.project().paths.front();
    order.request.overview = false;
  }
  order.provenance = document_.provenanceIn(file);
  order.provenance.view.reset();  // The video goes its own way.
  order.file = QFileInfo(file).absoluteFilePath();
  video_->write(order);
}

VideoControl::LiveSource MainWindow::liveSource() {
  const auto below = [this]() -> QWidget* {
    QWidget* shown = replay_->showing() ? static_cast<QWidget*>(replay_->panel()) : plot_;
    return shown->isVisible() ? shown : nullptr;
  };
  QSize pixels = detail_->shotSize();
  if (const QWidget* plots = below()) {
    pixels.rheight() += pixels.width() * plots->height() / std::max(1, plots->width());
  }
  return {.pixels = pixels,
          .view = [this] { return detail_->shot(); },
          .below =
              [below] {
                QWidget* plots = below();
                return plots != nullptr ? plots->grab().toImage() : QImage();
              }};
}

void MainWindow::setLiveVideo(bool on) {
  if (!on) {
    video_->stopLive();
    return;
  }
  if (video_->live()) return;
  const QString stem = videoFolder() + QLatin1String("/view-") +
                       QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd-HHmmss"));
  const auto start = [this](const QString& file, VideoProfile profile) {
    if (video_->startLive(file, profile, carriedState(file), liveSource())) {
      announce(tr("Video to %1").arg(shownPath(file)));
    } else {
      command("video_live")->setChecked(false);
    }
  };
  if (haveFfmpeg()) {
    start(stem + QLatin1String(".mp4"), VideoProfile::talk);
    return;
  }
  command("video_live")->setChecked(false);
  strip_->show(tr("The program ffmpeg, which packs videos, is not installed. Nothing was made. "
                  "Install the package ffmpeg, or keep a folder of pictures."),
               {{tr("&Keep pictures"), [this, start, stem] {
                   const QSignalBlocker quiet(command("video_live"));
                   command("video_live")->setChecked(true);
                   start(stem, VideoProfile::images);
                 }}});
}

void MainWindow::addKeyView() {
  const ViewState view = viewOf(document_.project());
  double at_s = 0;
  document_.amend([&](Project& p) {
    if (p.paths.empty()) p.paths.push_back({tr("Camera path").toStdString(), {}});
    std::vector<KeyView>& keys = p.paths.front().keys;
    if (!keys.empty()) at_s = keys.back().t_s + kKeyStepS;
    keys.push_back({at_s, view});
  });
  enableVideo();
  announce(tr("Key view %1 at %2 s")
               .arg(document_.project().paths.front().keys.size())
               .arg(numberText(at_s, 0)));
}

void MainWindow::previewPath() {
  if (path_preview_->playing()) {
    path_preview_->stop();
    return;
  }
  if (!hasPath() || !document_.isOpen()) return;
  replay_->close();
  try {
    path_preview_->play(document_.project().paths.front(), document_.surface()->ladder);
  } catch (const Error& error) {
    strip_->show(shownError(error));
  }
}

void MainWindow::showPathView(const ViewState& view) {
  document_.preview(view.region);
  document_.previewGain(view.gain);
  document_.setTurn(view.azimuth_deg, view.elevation_deg);
}

}  // namespace relievo
