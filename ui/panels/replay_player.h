// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "core/replay/touch_recording.h"

namespace relievo {

/// The clock of a replay: where in the recording it is, and how fast it runs. It shows nothing and
/// drives no device. [GUI thread]
class ReplayPlayer : public QObject {
  Q_OBJECT
 public:
  explicit ReplayPlayer(QObject* parent = nullptr);

  void load(std::shared_ptr<const TouchRecording> recording);  ///< At its start, paused.
  void unload();
  const TouchRecording* recording() const { return recording_.get(); }  ///< Null: none.
  std::shared_ptr<const TouchRecording> shared() const { return recording_; }

  double timeS() const { return time_s_; }  ///< Since the recording's first row.
  double durationS() const;
  const TouchRow& row() const;  ///< At this time. Precondition: loaded.

  void setTime(double time_s);  ///< Clamped. What was playing goes on from there.
  void stepRows(int count);     ///< On by so many samples, or back. Precondition: loaded.
  /// To the next event or, below 0, the one before; pauses. @return null: there is none
  const TouchEvent* goToEvent(int direction);
  void setSpeed(double factor);
  double speed() const { return speed_; }
  bool playing() const { return timer_.isActive(); }
  void play();  ///< From the start again if it is at the end.
  void pause();
  void toggle() { playing() ? pause() : play(); }
  /// Goes on by so much real time; pauses at the end.
  void advance(double real_s);

 Q_SIGNALS:
  void moved();
  void playingChanged(bool playing);

 private:
  std::shared_ptr<const TouchRecording> recording_;
  double time_s_ = 0, speed_ = 1;
  QTimer timer_;
  QElapsedTimer since_;
};

}  // namespace relievo
