// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/replay_player.h"

#include <algorithm>
#include <cstddef>
#include <vector>

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

void ReplayPlayer::stepRows(int count) {
  const std::vector<TouchRow>& rows = recording_->rows;
  const auto now = static_cast<std::ptrdiff_t>(&row() - rows.data());
  const auto last = static_cast<std::ptrdiff_t>(rows.size()) - 1;
  const auto to = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(now + count, 0, last));
  setTime(rows[to].t_s - recording_->startS());
}

const TouchEvent* ReplayPlayer::goToEvent(int direction) {
  if (!recording_) return nullptr;
  const double now = recording_->startS() + time_s_;
  const TouchEvent* event =
      direction > 0 ? eventAfter(*recording_, now) : eventBefore(*recording_, now);
  if (event == nullptr) return nullptr;
  pause();
  setTime(event->t_s - recording_->startS());
  return event;
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
