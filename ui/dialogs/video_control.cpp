// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/video_control.h"

#include <QFileInfo>
#include <QPainter>
#include <utility>

#include "core/base/error.h"
#include "ui/figure/figure.h"
#include "ui/language/error_text.h"
#include "ui/message/message_text.h"
#include "ui/style/text.h"
#include "ui/video/live_video.h"
#include "ui/video/video.h"
#include "ui/video/video_sound.h"
#include "ui/work/file_names.h"
#include "ui/work/file_path.h"

namespace relievo {
namespace {

constexpr int kEndMs = 50;

/// Videos need even sides.
QSize even(const QSize& size) {
  return {size.width() / 2 * 2, size.height() / 2 * 2};
}

QImage together(QImage view, QImage below) {
  view.setDevicePixelRatio(1);
  if (below.isNull()) return view;
  below.setDevicePixelRatio(1);
  below = below.scaledToWidth(view.width(), Qt::SmoothTransformation);
  QImage page(view.width(), view.height() + below.height(), QImage::Format_RGB32);
  QPainter painter(&page);
  painter.drawImage(0, 0, view);
  painter.drawImage(0, view.height(), below);
  return page;
}

/// At the video's size; a picture of another one is fitted into it.
RgbaImage rgbaOf(const QImage& picture, const QSize& size) {
  QImage page(size, QImage::Format_RGBA8888);
  page.fill(Qt::black);
  QPainter painter(&page);
  const QSize fitted = picture.size().boundedTo(size) == picture.size()
                           ? picture.size()
                           : picture.size().scaled(size, Qt::KeepAspectRatio);
  painter.drawImage(QRect(QPoint(0, 0), fitted), picture);
  painter.end();
  RgbaImage image{size.width(), size.height(), {}};
  const uchar* const bytes = page.constBits();
  image.rgba.assign(bytes, bytes + page.sizeInBytes());
  return image;
}

}  // namespace

VideoControl::VideoControl(QObject* parent) : QObject(parent) {
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(static_cast<int>(1000 / kLiveFps));
  end_timer_.setInterval(kEndMs);
  connect(&timer_, &QTimer::timeout, this, &VideoControl::takeView);
  below_timer_.setSingleShot(true);
  below_timer_.setInterval(0);
  connect(&below_timer_, &QTimer::timeout, this, &VideoControl::takeBelow);
  connect(&end_timer_, &QTimer::timeout, this, &VideoControl::watchEnd);
  connect(&worker_, &LatestWorker::busyChanged, this, &VideoControl::busyChanged);
  connect(&worker_, &LatestWorker::progressed, this, &VideoControl::progressed);
}

VideoControl::~VideoControl() = default;

void VideoControl::write(const Order& order) {
  struct Outcome {
    VideoFacts facts;
    QString error;
    QString no_sound;  // Why.
  };
  auto outcome = std::make_shared<Outcome>();
  worker_.start(
      [order, outcome](const Task& task) {
        try {
          const std::filesystem::path file = pathOf(order.file);
          const std::filesystem::path folder = file.parent_path();
          InputFile recording;
          if (order.recording && !order.recording_file.isEmpty()) {
            recording = inputFile(pathOf(order.recording_file), folder, task);
          }
          const VideoSound sound = soundOf(order.request, order.recording.get(), order.sound);
          if (sound.missing) outcome->no_sound = shownError(*sound.missing);
          outcome->facts = writeVideo(
              *order.surface, order.recording.get(), order.request,
              [&](const VideoRequest& one) { return videoState(order.provenance, one, recording); },
              VideoFiles{.video = file,
                         .both_eyes = order.both_eyes,
                         .sound = sound.track ? &*sound.track : nullptr},
              task);
        } catch (const Cancelled&) {
          return;
        } catch (const Error& error) {
          outcome->error = shownError(error);
        }
      },
      [this, outcome, name = shownName(order.file)] {
        if (!outcome->error.isEmpty()) {
          Q_EMIT said(tr("The video has ended early"));
          Q_EMIT failed(outcome->error);
          Q_EMIT ended(false);
          return;
        }
        Q_EMIT said(tr("Video saved: %1 s, %2 frames in %3")
                        .arg(numberText(outcome->facts.seconds, 1))
                        .arg(outcome->facts.frames)
                        .arg(name));
        if (!outcome->no_sound.isEmpty()) {
          Q_EMIT failed(tr("The video has no sound.") + QLatin1Char(' ') + outcome->no_sound);
        }
        Q_EMIT ended(true);
      });
}

void VideoControl::cancel() {
  if (worker_.cancel()) Q_EMIT said(tr("Cancelled. No video was kept."));
}

bool VideoControl::startLive(const QString& file, VideoProfile profile, const std::string& state,
                             LiveSource source) {
  if (live()) return false;
  source.pixels = even(source.pixels);
  try {
    live_ = std::make_unique<LiveVideo>(
        pathOf(file), VideoFormat{.profile = profile,
                                  .width_px = source.pixels.width(),
                                  .height_px = source.pixels.height(),
                                  .fps = kLiveFps,
                                  .state = state,
                                  .title = wholeName(stemOf(file, {})).toStdString()});
  } catch (const Error& error) {
    Q_EMIT failed(shownError(error));
    return false;
  }
  live_file_ = file;
  source_ = std::move(source);
  taken_ = false;
  view_ = {};
  timer_.start();  // Not at once: the window now draws that a video is made.
  return true;
}

double VideoControl::liveS() const {
  return live() && taken_ ? 1e-3 * static_cast<double>(clock_.elapsed()) : 0;
}

void VideoControl::takeView() {
  if (!live() || !view_.isNull()) return;  // The part below the one before is still to come.
  if (!taken_) clock_.start();
  view_t_s_ = taken_ ? 1e-9 * static_cast<double>(clock_.nsecsElapsed()) : 0;
  taken_ = true;
  view_ = source_.view();
  below_timer_.start();
}

void VideoControl::takeBelow() {
  if (!live() || view_.isNull()) return;
  live_->offer([view = std::exchange(view_, QImage()), below = source_.below(),
                size = source_.pixels] { return rgbaOf(together(view, below), size); },
               view_t_s_);
  if (live_->report().ended) stopLive();  // A full disk, or the encoder.
}

void VideoControl::stopLive() {
  if (!live() || end_timer_.isActive()) return;
  timer_.stop();
  end_timer_.start();
  if (!taken_) takeView();  // However short, a video has a picture.
  takeBelow();
  live_->finish();
}

void VideoControl::watchEnd() {
  const LiveVideo::Report report = live_->report();
  if (!report.ended) return;
  end_timer_.stop();
  live_.reset();
  source_ = {};
  Q_EMIT liveEnded();
  if (!report.error.empty()) {
    Q_EMIT said(tr("The video has ended early"));  // Nothing older stays in the status bar.
    const QString words =
        report.message ? messageText(*report.message) : QString::fromStdString(report.error);
    Q_EMIT failed(shownError(words, QString::fromStdString(report.code)));
    Q_EMIT ended(false);
    return;
  }
  Q_EMIT said(tr("Video saved: %1 s, %2 pictures dropped, in %3")
                  .arg(numberText(static_cast<double>(report.frames) / kLiveFps, 1))
                  .arg(report.dropped)
                  .arg(live_file_));
  Q_EMIT ended(true);
}

}  // namespace relievo
