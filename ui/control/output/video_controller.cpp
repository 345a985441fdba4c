// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/output/video_controller.h"

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
#include "core/provenance/provenance.h"
#include "ui/dialogs/video_dialog.h"
#include "ui/language/error_text.h"
#include "ui/panels/replay_control.h"
#include "ui/panels/replay_panel.h"
#include "ui/plots/time_plot.h"
#include "ui/style/text.h"
#include "ui/video/video.h"
#include "ui/video/video_file.h"
#include "ui/views/detail_view.h"
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

VideoController::VideoController(const ControllerParts& parts, DetailView& detail, TimePlot& plot,
                                 ReplayControl& replay)
    : Controller(parts), detail_(detail), plot_(plot), replay_(replay) {
  makeCommands();
  connect(&video_, &VideoControl::said, &messages_, &WindowMessages::announce);
  connect(&video_, &VideoControl::failed, &messages_,
          [this](const QString& text) { messages_.show(text); });
  messages_.follow(video_);
  connect(&video_, &VideoControl::busyChanged, this, &VideoController::enable);
  connect(&messages_, &WindowMessages::cancelAsked, &video_, &VideoControl::cancel);
  connect(&video_, &VideoControl::liveEnded, this, [this] {
    commands_[Command::video_live].setChecked(false);
    enable();
  });
  connect(&replay_, &ReplayControl::shownChanged, this, &VideoController::enable);
  connect(&preview_, &PathPreview::viewChanged, this, &VideoController::showPathView);
  connect(&preview_, &PathPreview::ended, this, [this] {
    document_.region().revert();
    document_.setTurn(azimuth_before_deg_, elevation_before_deg_);
    announce(tr("End of the camera path"));
  });
}

void VideoController::makeCommands() {
  commands_.on(Command::video, this, [this] { choose(); });
  commands_.onToggled(Command::video_live, this, [this](bool on) { setLive(on); });
  commands_.on(Command::key_view, this, [this] { addKeyView(); });
  commands_.on(Command::path_play, this, [this] { previewPath(); });
  commands_.on(Command::path_clear, this, [this] {
    document_.amend([](Project& p) { p.paths.clear(); });
    enable();
    announce(tr("The camera path is empty"));
  });
}

bool VideoController::hasPath() const {
  return !document_.project().paths.empty() && document_.project().paths.front().keys.size() >= 2;
}

void VideoController::enable() {
  const bool is_open = document_.isOpen();
  commands_[Command::video].setEnabled(is_open && !video_.writing() &&
                                       (replay_.showing() || hasPath()));
  commands_[Command::video_live].setEnabled(is_open);
  commands_[Command::key_view].setEnabled(is_open);
  commands_[Command::path_play].setEnabled(is_open && hasPath());
  commands_[Command::path_clear].setEnabled(!document_.project().paths.empty());
}

void VideoController::choose() {
  const bool can_pack = haveFfmpeg();
  if (!can_pack) {
    announce(tr("The program ffmpeg is not installed: a folder of pictures can be made."));
  }
  VideoDialog::Start start;
  start.view_px = detail_.size() * window_.devicePixelRatioF();
  start.can_pack = can_pack;
  start.recording = replay_.showing();
  start.can_sound = static_cast<bool>(sound_);
  start.duration_s =
      start.recording ? replay_.player().durationS() : document_.project().paths.front().endS();
  if (start.recording) start.request.speed = replay_.player().speed();
  if (hasPath()) start.request.path = document_.project().paths.front();
  const StereoOptions& stereo = document_.project().stereo;
  start.request.eye_angle_deg = stereo.eye_angle_deg;
  start.request.swap_eyes = stereo.swap_eyes;
  auto* dialog = new VideoDialog(start, &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this,
          [this, dialog] { chooseFile(dialog->request(), dialog->bothEyes()); });
  dialog->open();
}

void VideoController::chooseFile(const VideoRequest& chosen, bool both_eyes) {
  auto* dialog = new QFileDialog(&window_, tr("Video"), videoFolder());
  dialog->setObjectName(QStringLiteral("video_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  const bool folder = chosen.profile == VideoProfile::images;
  dialog->setNameFilter(folder ? tr("A folder of pictures (*)") : tr("Videos (*.mp4)"));
  dialog->selectFile(
      stemOf(replay_.showing() ? replay_.file() : document_.file(), QStringLiteral(".mp4.json")));
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, chosen, folder, both_eyes](const QString& file) {
            const bool whole = folder || file.endsWith(QLatin1String(".mp4"));
            write(chosen, whole ? file : file + QLatin1String(".mp4"), both_eyes);
          });
  dialog->open();
}

void VideoController::write(const VideoRequest& chosen, const QString& file, bool both_eyes) {
  try {
    for (const auto& name : namesOf(VideoFiles{QFile::encodeName(file).toStdString(), both_eyes})) {
      requireNotAnInput(
          name,
          {{.file = QFile::encodeName(document_.file()).toStdString()},
           {.file = QFile::encodeName(replay_.showing() ? replay_.file() : QString()).toStdString(),
            .what = "the recording that is shown"}});
    }
  } catch (const Error& error) {
    messages_.show(shownError(error));
    return;
  }
  VideoControl::Order order;
  order.surface = document_.surface();
  order.request = chosen;
  order.request.look = document_.project().look;
  if (replay_.showing()) {
    order.recording = replay_.player().shared();
    order.recording_file = replay_.file();
  } else if (hasPath()) {
    order.request.path = document_.project().paths.front();
    order.request.overview = false;
  }
  order.provenance = document_.provenanceIn(file);
  order.provenance.view.reset();  // The video goes its own way.
  order.both_eyes = both_eyes;
  order.sound = sound_;
  order.file = QFileInfo(file).absoluteFilePath();
  video_.write(order);
}

VideoControl::LiveSource VideoController::liveSource() {
  const auto below = [this]() -> QWidget* {
    QWidget* shown = replay_.showing() ? static_cast<QWidget*>(replay_.panel()) : &plot_;
    return shown->isVisible() ? shown : nullptr;
  };
  QSize pixels = detail_.shotSize();
  if (const QWidget* plots = below()) {
    pixels.rheight() += pixels.width() * plots->height() / std::max(1, plots->width());
  }
  return {.pixels = pixels,
          .view = [this] { return detail_.shot(); },
          .below =
              [below] {
                QWidget* plots = below();
                return plots != nullptr ? plots->grab().toImage() : QImage();
              }};
}

void VideoController::setLive(bool on) {
  if (!on) {
    video_.stopLive();
    return;
  }
  if (video_.live()) return;
  const QString stem = videoFolder() + QLatin1String("/view-") +
                       QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd-HHmmss"));
  const auto start = [this](const QString& file, VideoProfile profile) {
    if (video_.startLive(file, profile, toJson(document_.provenanceIn(file), -1), liveSource())) {
      announce(tr("Video to %1").arg(shownPath(file)));
    } else {
      commands_[Command::video_live].setChecked(false);
    }
  };
  if (haveFfmpeg()) {
    start(stem + QLatin1String(".mp4"), VideoProfile::talk);
    return;
  }
  commands_[Command::video_live].setChecked(false);
  messages_.show(tr("The program ffmpeg, which packs videos, is not installed. Nothing was made. "
                    "Install the package ffmpeg, or keep a folder of pictures."),
                 {{tr("&Keep pictures"), [this, start, stem] {
                     const QSignalBlocker quiet(&commands_[Command::video_live]);
                     commands_[Command::video_live].setChecked(true);
                     start(stem, VideoProfile::images);
                   }}});
}

void VideoController::addKeyView() {
  const ViewState view = viewOf(document_.project());
  double at_s = 0;
  document_.amend([&](Project& p) {
    if (p.paths.empty()) p.paths.push_back({tr("Camera path").toStdString(), {}});
    std::vector<KeyView>& keys = p.paths.front().keys;
    if (!keys.empty()) at_s = keys.back().t_s + kKeyStepS;
    keys.push_back({at_s, view});
  });
  enable();
  announce(tr("Key view %1 at %2 s")
               .arg(document_.project().paths.front().keys.size())
               .arg(numberText(at_s, 0)));
}

void VideoController::previewPath() {
  if (preview_.playing()) {
    preview_.stop();
    return;
  }
  if (!hasPath() || !document_.isOpen()) return;
  replay_.close();
  azimuth_before_deg_ = document_.project().azimuth_deg;
  elevation_before_deg_ = document_.project().elevation_deg;
  try {
    preview_.play(document_.project().paths.front(), document_.surface()->ladder);
  } catch (const Error& error) {
    messages_.show(shownError(error));
  }
}

void VideoController::showPathView(const ViewState& view) {
  document_.region().preview(view.region);
  document_.region().previewGain(view.gain);
  document_.setTurn(view.azimuth_deg, view.elevation_deg);
}

}  // namespace relievo
