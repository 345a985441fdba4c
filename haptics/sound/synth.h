// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "haptics/rt/realtime.h"
#include "haptics/sound/sound_laws.h"
#include "haptics/sound/touch_events.h"

namespace relievo::sound {

/// One moment of sound, -1 .. 1 each side.
struct Frame {
  float left = 0, right = 0;
};

struct SynthOptions {
  double ceiling = 0.9;  ///< No sample is larger; 0 .. 1.
  double tone_for_s =
      120;  ///< The tone of heights is heard for so long, from the first contact on.
};

/// Makes sound of what is heard: a pure function of it and of time, which is counted in frames. It
/// allocates nothing and waits for nothing. [one thread, realtime]
class Synth {
 public:
  explicit Synth(const SynthOptions& options = {}) RELIEVO_REALTIME;

  /// From the next frame on. What was struck begins with it.
  void take(const Heard& heard) RELIEVO_REALTIME;
  /// An earcon that no touch has struck: of a command, of a fault.
  void strike(Earcon earcon, double approach_mm_per_s, double place) RELIEVO_REALTIME;
  /// While somebody speaks what lasts is silent, after kFadeS, and what is struck half as loud (EN
  /// 301 549, 5.1.3.10). From the next frame on.
  void setSpeech(bool speech) RELIEVO_REALTIME { speech_.on = speech; }
  static constexpr double kFadeS = 0.03;
  /// The next frames.
  void render(std::span<Frame> frames) RELIEVO_REALTIME;

 private:
  /// A sine that sounds for a while.
  struct Voice {
    double phase = 0, step = 0;        // Radians.
    double level = 0, fade = 1;        // The level is multiplied by fade with each frame.
    std::int64_t waits = 0, left = 0;  // Frames; none left: it is free.
    std::int64_t lasts = 0;
    bool has_soft_ends = false;
    Sides sides;
  };

  void begin(double hz, double level, double waits_s, double lasts_s, double decay_s,
             Sides sides) RELIEVO_REALTIME;
  static double sampleOf(Voice& voice) RELIEVO_REALTIME;
  double noise() RELIEVO_REALTIME;
  void tuneFriction() RELIEVO_REALTIME;
  Frame mixed() RELIEVO_REALTIME;
  Frame limited(double left, double right) RELIEVO_REALTIME;

  static constexpr int kFramesPerTuning = 32;

  SynthOptions options_;
  Heard heard_;
  std::array<Voice, 24> voices_{};
  std::int64_t frame_ = 0;
  std::int64_t tone_until_ = -1;  // -1: nothing was touched yet.
  // Friction: white noise through a band pass (direct form 1).
  std::uint64_t noise_state_ = 0x9E3779B97F4A7C15U;
  double b0_ = 0, a1_ = 0, a2_ = 0, x1_ = 0, x2_ = 0, y1_ = 0, y2_ = 0;
  struct Friction {
    double gain = 0, rms = 0;
  };
  Friction friction_;
  // The tone of heights.
  double tone_phase_ = 0, tone_log_hz_ = 0, tone_gain_ = 0;
  double place_ = 0.5;
  double limiter_gain_ = 1;
  struct Speech {
    bool on = false;
    double beside = 1;  // 1: nobody speaks, 0: somebody does; between them it fades.
  };
  Speech speech_;
  // How much of the way to a new value is gone with each frame.
  double friction_step_, tone_step_, glide_step_, place_step_, release_step_;
};

}  // namespace relievo::sound
