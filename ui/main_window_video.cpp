// SPDX-License-Identifier: BSD-3-Clause
// Videos and camera paths: commands of the window.
#include <array>
#include <QAction>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QPainter>
#include <QStandardPaths>

#include "core/base/error.h"
#include "ui/detail_view.h"
#include "ui/main_window.h"
#include "ui/message_strip.h"
#include "ui/path_preview.h"
#include "ui/replay_panel.h"
#include "ui/status_fields.h"
#include "ui/text.h"
#include "ui/time_plot.h"
#include "ui/video/video_file.h"
#include "ui/video_control.h"

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
        tr("&Video\u2026"),
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
          project_.paths.clear();
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
  connect(video_, &VideoControl::progressed, status_, &StatusFields::showWork);
  connect(status_, &StatusFields::cancelAsked, video_, &VideoControl::cancel);
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
  return !project_.paths.empty() && project_.paths.front().keys.size() >= 2;
}

void MainWindow::enableVideo() {
  const bool is_open = document_.isOpen();
  command("video")->setEnabled(is_open && !video_->writing() && (replay_->showing() || hasPath()));
  command("video_live")->setEnabled(is_open);
  command("key_view")->setEnabled(is_open);
  command("path_play")->setEnabled(is_open && hasPath());
  command("path_clear")->setEnabled(!project_.paths.empty());
}

void MainWindow::chooseVideo() {
  auto* dialog = new QFileDialog(this, tr("Video"), videoFolder());
  dialog->setObjectName(QStringLiteral("video_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  // In the order of VideoProfile.
  const QStringList filters{
      tr("Talk: plays everywhere (*.mp4)"), tr("Archive: every pixel comes back (*.mp4)"),
      tr("Anaglyph: for red and cyan glasses (*.mp4)"), tr("Images: a folder of pictures (*)")};
  dialog->setNameFilters(filters);
  if (!haveFfmpeg()) {
    dialog->setNameFilters({filters.back()});
    announce(tr("The program ffmpeg is not installed: a folder of pictures can be made."));
  }
  const QString stem =
      QFileInfo(replay_->showing() ? replay_->file() : document_.file()).completeBaseName();
  dialog->selectFile(stem);
  connect(dialog, &QFileDialog::fileSelected, this, [this, dialog, filters](const QString& file) {
    const auto profile = static_cast<VideoProfile>(filters.indexOf(dialog->selectedNameFilter()));
    const bool folder = profile == VideoProfile::images;
    writeVideo(profile, folder || file.endsWith(QLatin1String(".mp4"))
                            ? file
                            : file + QLatin1String(".mp4"));
  });
  dialog->open();
}

void MainWindow::writeVideo(VideoProfile profile, const QString& file) {
  VideoControl::Order order;
  order.surface = document_.surface();
  order.request.profile = profile;
  order.request.look = detail_->sceneState().look;
  order.request.look.light = detail_->sceneState().light;
  if (profile == VideoProfile::anaglyph) order.request.stereo = StereoPrint::grey;
  order.request.eye_angle_deg = detail_->sceneState().stereo.eye_angle_deg;
  if (replay_->showing()) {
    order.recording = replay_->player().shared();
    order.recording_file = replay_->file();
    order.request.speed = replay_->player().speed();
  } else if (hasPath()) {
    order.request.path = project_.paths.front();
    order.request.overview = false;
  }
  order.provenance = provenanceOf(*order.surface, document_.state().options);
  const QFileInfo input(document_.file());
  order.provenance.input = {
      relativePath(QFile::encodeName(input.filePath()).toStdString(),
                   QFile::encodeName(QFileInfo(file).absolutePath()).toStdString()),
      document_.fileSha256().toStdString(), static_cast<std::uint64_t>(input.size())};
  order.file = QFileInfo(file).absoluteFilePath();
  video_->write(order);
}

QImage MainWindow::videoPicture() {
  QImage view = detail_->shot();
  view.setDevicePixelRatio(1);
  QWidget* below = replay_->showing() ? static_cast<QWidget*>(replay_->panel()) : plot_;
  if (!below->isVisible()) return view;
  QImage plots = below->grab().toImage();
  plots.setDevicePixelRatio(1);
  plots = plots.scaledToWidth(view.width(), Qt::SmoothTransformation);
  QImage page(view.width(), view.height() + plots.height(), QImage::Format_RGB32);
  QPainter painter(&page);
  painter.drawImage(0, 0, view);
  painter.drawImage(0, view.height(), plots);
  return page;
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
    if (video_->startLive(file, profile, carriedState(file), [this] { return videoPicture(); })) {
      announce(tr("Video to %1").arg(QDir::toNativeSeparators(file)));
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
  if (project_.paths.empty()) project_.paths.push_back({tr("Camera path").toStdString(), {}});
  std::vector<KeyView>& keys = project_.paths.front().keys;
  const SceneState& scene = detail_->sceneState();
  const DocumentState& state = document_.state();
  keys.push_back({keys.empty() ? 0 : keys.back().t_s + kKeyStepS,
                  {state.region, state.gain, scene.look, scene.stereo, scene.camera.azimuth_deg,
                   scene.camera.elevation_deg}});
  enableVideo();
  announce(tr("Key view %1 at %2 s").arg(keys.size()).arg(numberText(keys.back().t_s, 0)));
}

void MainWindow::previewPath() {
  if (path_preview_->playing()) {
    path_preview_->stop();
    return;
  }
  if (!hasPath() || !document_.isOpen()) return;
  replay_->close();
  try {
    path_preview_->play(project_.paths.front(), document_.surface()->ladder);
  } catch (const Error& error) {
    strip_->show(QString::fromUtf8(error.what()));
  }
}

void MainWindow::showPathView(const ViewState& view) {
  document_.preview(view.region);
  document_.previewGain(view.gain);
  const ReliefCamera& camera = detail_->sceneState().camera;
  detail_->turnBy(view.azimuth_deg - camera.azimuth_deg, view.elevation_deg - camera.elevation_deg);
}

}  // namespace relievo
