// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QTimer>

#include "core/project/project.h"
#include "core/replay/sound_track.h"
#include "core/replay/video_request.h"
#include "ui/work/latest_worker.h"

namespace relievo {

class LiveVideo;

/// Makes videos for the window: of a recording or camera path in the worker, frame by frame; or of
/// what the window shows, live, without ever holding it up. [GUI thread]
class VideoControl : public QObject {
  Q_OBJECT
 public:
  explicit VideoControl(QObject* parent = nullptr);
  ~VideoControl() override;

  /// What a video in the worker needs; shared values, so that the window may go on.
  struct Order {
    std::shared_ptr<const Surface> surface;
    std::shared_ptr<const TouchRecording> recording;  ///< Null: the request's path alone.
    QString recording_file;
    Provenance provenance;
    VideoRequest request;
    QString file;
    bool both_eyes = false;   ///< Each eye's video, too (VideoFiles).
    SoundTrackOf sound = {};  ///< Where the request asks for it; empty: none can be made.
  };
  void write(const Order& order);
  bool writing() const { return worker_.busy(); }
  void cancel();

  static constexpr double kLiveFps = 15;
  /// What a video of the view shows. The two parts are asked for in rounds of their own, so that
  /// neither holds the window up for longer than it must; a worker puts them together.
  struct LiveSource {
    QSize pixels;                   ///< Of the whole; later pictures are fitted into it.
    std::function<QImage()> view;   ///< Above.
    std::function<QImage()> below;  ///< The plots, at any width; null: none.
  };
  /// Asks for pictures 15 times a second until stopLive().
  /// @return false: it cannot be written; failed() says why
  bool startLive(const QString& file, VideoProfile profile, const std::string& state,
                 LiveSource source);
  void stopLive();
  bool live() const { return live_ != nullptr; }
  double liveS() const;

 Q_SIGNALS:
  void said(const QString& text);
  void failed(const QString& message);
  void liveEnded();
  void ended(bool saved);  ///< A video is written, or was not; after what was said of it.
  void busyChanged(bool busy);
  void progressed(const QString& step, double fraction);

 private:
  void takeView();
  void takeBelow();
  void watchEnd();

  QString live_file_;
  LiveSource source_;
  QImage view_;  ///< Until the part below it is there.
  double view_t_s_ = 0;
  bool taken_ = false;  ///< The first picture; it stands for the very beginning.
  QTimer below_timer_;
  std::unique_ptr<LiveVideo> live_;
  QElapsedTimer clock_;
  QTimer timer_, end_timer_;
  LatestWorker worker_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
