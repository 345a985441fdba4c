// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "haptics/rt/realtime.h"
#include "haptics/sound/synth.h"
#include "haptics/sound/touch_events.h"

namespace relievo::sound {

/// Turns samples into sound, each at its own frame, for recordings and for a touch that goes on.
/// Where samples are missing for long, mostly 50 ms, the sound ends. Allocates nothing and waits
/// for nothing. [one thread, realtime]
class TouchMixer {
 public:
  static constexpr double kHoldS = 0.05;

  /// @param hold_s  without a sample for so long, the sound ends
  explicit TouchMixer(const SynthOptions& options = {}, double hold_s = kHoldS) RELIEVO_REALTIME
      : synth_(options),
        hold_frames_(static_cast<std::int64_t>(hold_s* kSampleRateHz)) {}

  enum class Happenings : bool { unheard, heard };
  /// Takes the next sample. If its frame is over, it is heard with the next frame; if too many
  /// wait, the oldest is heard early.
  /// @param happenings  unheard: the sample strikes no earcon
  /// @param also  an earcon that is struck with it, beside those of the touch
  /// @return what is heard of the sample
  Heard place(const TouchSample& sample, std::int64_t frame,
              Happenings happenings = Happenings::heard,
              std::optional<Earcon> also = {}) RELIEVO_REALTIME;
  /// Strikes an earcon at once, without a sample.
  void strike(Earcon earcon) RELIEVO_REALTIME { synth_.strike(earcon, 0, 0.5); }
  /// From the next frame on somebody speaks, or does not any more.
  void setSpeech(bool speech) RELIEVO_REALTIME { synth_.setSpeech(speech); }
  /// Ends lasting sounds with the next frame.
  void fallSilent() RELIEVO_REALTIME;
  /// Makes the next frames.
  void render(std::span<Frame> frames) RELIEVO_REALTIME;
  /// The number of the frame that is rendered next.
  std::int64_t frame() const RELIEVO_REALTIME { return frame_; }

 private:
  struct Waiting {
    Heard heard;
    std::optional<Earcon> also;
    std::int64_t frame = 0;
  };
  bool lasts() const RELIEVO_REALTIME { return heard_.contact || heard_.led; }
  void takeDue() RELIEVO_REALTIME;
  void hear(const Waiting& waiting) RELIEVO_REALTIME;

  Synth synth_;
  TouchEvents touch_;
  Heard heard_;
  std::array<Waiting, 128> waiting_{};
  std::size_t first_ = 0, count_ = 0;
  std::int64_t frame_ = 0;
  std::int64_t hold_frames_;
  std::int64_t silent_at_ = 0;  // From here on, unless a sample comes before.
};

}  // namespace relievo::sound
