// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/sound/touch_mixer.h"

#include <algorithm>
#include <cmath>

namespace relievo::sound {

Heard TouchMixer::place(const TouchSample& sample, std::int64_t frame, Happenings happenings,
                        std::optional<Earcon> also) RELIEVO_REALTIME {
  Heard heard = touch_.next(sample);
  if (happenings == Happenings::unheard) heard.count = 0;
  const Waiting now{heard, also, frame};
  if (count_ == 0 && frame <= frame_) {
    hear(now);
    return heard;
  }
  if (count_ == waiting_.size()) {
    hear(waiting_[first_]);
    first_ = (first_ + 1) % waiting_.size();
    --count_;
  }
  waiting_[(first_ + count_++) % waiting_.size()] = now;
  return heard;
}

void TouchMixer::hear(const Waiting& waiting) RELIEVO_REALTIME {
  heard_ = waiting.heard;
  silent_at_ = waiting.frame + hold_frames_;
  synth_.take(waiting.heard);
  if (waiting.also) strike(*waiting.also);
}

void TouchMixer::takeDue() RELIEVO_REALTIME {
  for (; count_ > 0 && waiting_[first_].frame <= frame_; --count_) {
    hear(waiting_[first_]);
    first_ = (first_ + 1) % waiting_.size();
  }
}

void TouchMixer::fallSilent() RELIEVO_REALTIME {
  heard_.contact = heard_.led = false;
  heard_.count = 0;
  synth_.take(heard_);
}

void TouchMixer::render(std::span<Frame> frames) RELIEVO_REALTIME {
  while (!frames.empty()) {
    takeDue();
    if (lasts() && frame_ >= silent_at_) fallSilent();
    auto next = static_cast<std::int64_t>(frames.size());
    if (count_ > 0) next = std::min(next, waiting_[first_].frame - frame_);
    if (lasts()) next = std::min(next, silent_at_ - frame_);
    const auto part = static_cast<std::size_t>(next);
    synth_.render(frames.first(part));
    frames = frames.subspan(part);
    frame_ += next;
  }
}

}  // namespace relievo::sound
