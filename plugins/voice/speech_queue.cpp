// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/voice/speech_queue.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/message/catalogue.h"

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
  if (felt_.empty()) rests_since_s_ = now_s;
  felt_.push_back({position, now_s});
  while (felt_.size() > 2 && now_s - felt_[1].s >= kSpanS) felt_.pop_front();
  const DeviceMm by = position - felt_.front().at;
  const double mm = std::hypot(by.x, by.y, by.z);
  const double span_s = std::max(now_s - felt_.front().s, kSpanS);
  // Where it was found to move, it did so at some time within the span.
  if (mm > kRestMmPerS * span_s) rests_since_s_ = now_s - kSpanS;
}

std::optional<Speech> SpeechQueue::take(double now_s, bool speaking) {
  std::optional<Speech>* next = nullptr;
  if (asked_) {
    next = &asked_;
  } else if (noticed_ && !speaking && (felt_.empty() || now_s - rests_since_s_ >= kRestS)) {
    next = &noticed_;
  }
  if (next == nullptr) return std::nullopt;
  std::optional<Speech> speech = std::exchange(*next, std::nullopt);
  // Whoever makes it louder to hear something again does not mean the volume.
  const bool is_volume =
      speech->sentences.size() == 1 && speech->sentences.front().id == MessageId::voice_volume;
  if (!is_volume || !last_) last_ = speech;
  return speech;
}

}  // namespace relievo
