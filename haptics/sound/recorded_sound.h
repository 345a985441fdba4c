// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "core/base/task.h"
#include "core/replay/touch_recording.h"
#include "haptics/sound/heard_row.h"
#include "haptics/sound/synth.h"

namespace relievo::sound {

struct SoundRequest {
  std::optional<double> from_s, to_s;  ///< Since the recording's start; nothing: all of it.
  /// Seconds of the recording per second of sound, 0.01 .. 100. What is heard comes at its time and
  /// is no deeper or higher for it: a click is as short, a tone as high.
  double speed = 1;
  std::optional<ToneHeights> heights;  ///< Nothing: those that were touched.
  SynthOptions synth;
};

/// The sound of a recording, which depends on it and the request alone. Every row sounds at its own
/// time, at the request's speed: what happens in it begins with the frame nearest to that. [worker]
class RecordedSound {
 public:
  /// The recording outlives this.
  /// @throw FileError  no row, or it does not tell where the hand was
  /// @throw ArgumentError  nothing lies between the times
  RecordedSound(const TouchRecording& recording, const SoundRequest& request);

  std::uint64_t frames() const { return frames_; }
  double fromS() const { return from_s_; }
  double seconds() const { return static_cast<double>(frames_) / kSampleRateHz; }
  const ToneHeights& heights() const { return heights_; }

  /// What was heard, by earcon, and the largest sample.
  struct Summary {
    std::array<std::uint64_t, kEarcons> struck{};
    double peak = 0;
  };
  /// Gives away all frames, part by part. @throw Cancelled
  Summary render(const std::function<void(std::span<const Frame>)>& take,
                 const Task& task = {}) const;

 private:
  TouchSample sampleOf(const TouchRow& row, const TouchedWindow* window) const;

  const TouchRecording& recording_;
  SoundRequest request_;
  ToneHeights heights_;
  double left_mm_ = 0, right_mm_ = 0;  // What was touched.
  double from_s_ = 0, to_s_ = 0;       // On the rows' clock, less the first row's time.
  bool tells_hand_ = true;
  std::uint64_t frames_ = 0;
};

}  // namespace relievo::sound
