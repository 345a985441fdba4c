// SPDX-License-Identifier: BSD-3-Clause
#include "ui/replay_player.h"

#include <algorithm>

namespace relievo {

ReplayPlayer::ReplayPlayer(QObject* parent) : QObject(parent) {
  constexpr int kFrameMs = 16;
  timer_.setInterval(kFrameMs);
  connect(&timer_, &QTimer::timeout, this,
          [this] { advance(1e-9 * static_cast<double>(since_.nsecsElapsed())); });
}

void ReplayPlayer::load(std::shared_ptr<const TouchRecording> recording) {
  pause();
  recording_ = std::move(recording);
  time_s_ = 0;
  Q_EMIT moved();
}

void ReplayPlayer::unload() {
  pause();
  recording_.reset();
  time_s_ = 0;
}

double ReplayPlayer::durationS() const {
  return recording_ ? recording_->endS() - recording_->startS() : 0;
}

const TouchRow& ReplayPlayer::row() const {
  return rowAt(*recording_, recording_->startS() + time_s_);
}

void ReplayPlayer::setTime(double time_s) {
  const double time = std::clamp(time_s, 0.0, durationS());
  if (time == time_s_) return;
  time_s_ = time;
  Q_EMIT moved();
}

void ReplayPlayer::setSpeed(double factor) {
  speed_ = factor;
}

void ReplayPlayer::play() {
  if (!recording_ || playing()) return;
  if (time_s_ >= durationS()) setTime(0);
  since_.start();
  timer_.start();
  Q_EMIT playingChanged(true);
}

void ReplayPlayer::pause() {
  if (!playing()) return;
  timer_.stop();
  Q_EMIT playingChanged(false);
}

void ReplayPlayer::advance(double real_s) {
  since_.start();
  setTime(time_s_ + speed_ * real_s);
  if (time_s_ >= durationS()) pause();
}

}  // namespace relievo
