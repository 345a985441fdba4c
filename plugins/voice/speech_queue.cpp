// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/voice/speech_queue.h"

#include <cmath>
#include <utility>

namespace relievo {

void SpeechQueue::say(Speech speech, SaidBecause why) {
  if (why == SaidBecause::noticed) {
    noticed_ = std::move(speech);
    return;
  }
  asked_ = std::move(speech);
  noticed_.reset();
}

void SpeechQueue::hush() {
  asked_.reset();
  noticed_.reset();
}

void SpeechQueue::hand(const DeviceMm& position, double now_s) {
  const double dt_s = now_s - felt_s_;
  felt_s_ = now_s;
  if (rests_at_ && dt_s > 0) {
    const DeviceMm by = position - *rests_at_;
    const double mm = std::hypot(by.x, by.y, by.z);
    if (mm > kRestMmPerS * dt_s) rests_since_s_ = now_s;
  }
  if (!rests_at_) rests_since_s_ = now_s;
  rests_at_ = position;
}

std::optional<Speech> SpeechQueue::take(double now_s, bool speaking) {
  std::optional<Speech>* next = nullptr;
  if (asked_) {
    next = &asked_;
  } else if (noticed_ && !speaking && (!rests_at_ || now_s - rests_since_s_ >= kRestS)) {
    next = &noticed_;
  }
  if (next == nullptr) return std::nullopt;
  last_ = std::exchange(*next, std::nullopt);
  return last_;
}

}  // namespace relievo
