// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/sound/synth.h"

#include <algorithm>
#include <cmath>

namespace relievo::sound {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

std::int64_t framesOf(double s) RELIEVO_REALTIME {
  return std::llround(s * kSampleRateHz);
}

/// How much of the way to a new value is gone with each frame.
double stepOf(double time_s) RELIEVO_REALTIME {
  return 1 - std::exp(-1 / (time_s * kSampleRateHz));
}

constexpr double kFrictionS = 0.005, kToneOnS = 0.005, kGlideS = 0.0025, kPlaceS = 0.005;
constexpr double kReleaseS = 0.05;  // Of the limiter.
constexpr double kSoftEndS = 0.003;

/// Of white noise between -1 and 1 behind the band pass: so that frictionRms() is the rms.
double bandPassRms(double hz) RELIEVO_REALTIME {
  const double noise_rms = 1 / std::sqrt(3.0);
  // The band's width, pi / 2 times what lies between its half powers, of all that there is.
  const double share = std::numbers::pi / 2 * (hz / kFrictionQ) / (0.5 * kSampleRateHz);
  return noise_rms * std::sqrt(std::min(share, 1.0));
}

}  // namespace

Synth::Synth(const SynthOptions& options) RELIEVO_REALTIME : options_(options),
                                                             friction_step_(stepOf(kFrictionS)),
                                                             tone_step_(stepOf(kToneOnS)),
                                                             glide_step_(stepOf(kGlideS)),
                                                             place_step_(stepOf(kPlaceS)),
                                                             release_step_(stepOf(kReleaseS)) {
  options_.ceiling = std::clamp(options_.ceiling, 0.0, 1.0);
}

void Synth::take(const Heard& heard) RELIEVO_REALTIME {
  const bool touches = heard.contact && !heard_.contact;
  const bool begins = (heard.contact || heard.led) && !heard_.contact && !heard_.led;
  heard_ = heard;
  if (touches && tone_until_ < 0) tone_until_ = frame_ + framesOf(options_.tone_for_s);
  // A hand that lands elsewhere does not glide there.
  if (begins) {
    tone_log_hz_ = std::log2(heightHz(heard.height));
    place_ = heard.place;
  }
  for (std::size_t i = 0; i < heard.count; ++i) {
    strike(heard.struck[i].earcon, heard.struck[i].approach_mm_per_s, heard.place);
  }
}

void Synth::strike(Earcon earcon, double approach_mm_per_s, double place) RELIEVO_REALTIME {
  const Sides sides = sidesOf(place);
  if (earcon == Earcon::contact) {
    const double peak = clickPeak(approach_mm_per_s);
    constexpr double kHeardDecays = 8;  // Then it is below a thousandth.
    for (const Partial& partial : kClick) {
      begin(partial.hz, peak * partial.share, 0, kHeardDecays * partial.decay_s, partial.decay_s,
            sides);
    }
    return;
  }
  const Notes notes = notesOf(earcon);
  for (int i = 0; i < notes.count; ++i) {
    const auto& note = notes.list[static_cast<std::size_t>(i)];
    begin(note.hz, kNoteLevel * note.level, note.begins_s, note.lasts_s, note.decay_s, sides);
  }
}

void Synth::begin(double hz, double level, double waits_s, double lasts_s, double decay_s,
                  Sides sides) RELIEVO_REALTIME {
  // All taken: the one that ends first gives way.
  auto voice = std::min_element(voices_.begin(), voices_.end(), [](const Voice& a, const Voice& b) {
    return a.waits + a.left < b.waits + b.left;
  });
  *voice = {.step = kTurn * hz / kSampleRateHz,
            .level = level,
            .fade = decay_s > 0 ? std::exp(-1 / (decay_s * kSampleRateHz)) : 1,
            .waits = framesOf(waits_s),
            .left = framesOf(lasts_s),
            .lasts = framesOf(lasts_s),
            .has_soft_ends = decay_s <= 0,
            .sides = sides};
}

double Synth::sampleOf(Voice& voice) RELIEVO_REALTIME {
  double level = voice.level;
  if (voice.has_soft_ends) {
    const std::int64_t to_end = std::min(voice.left, voice.lasts - voice.left);
    level *= std::min(1.0, static_cast<double>(to_end) / (kSoftEndS * kSampleRateHz));
  }
  // A cosine: a click begins with its first sample.
  const double sample =
      level * (voice.has_soft_ends ? std::sin(voice.phase) : std::cos(voice.phase));
  voice.phase += voice.step;
  if (voice.phase > kTurn) voice.phase -= kTurn;
  voice.level *= voice.fade;
  --voice.left;
  return sample;
}

double Synth::noise() RELIEVO_REALTIME {
  // xorshift64: the same with every run.
  noise_state_ ^= noise_state_ << 13;
  noise_state_ ^= noise_state_ >> 7;
  noise_state_ ^= noise_state_ << 17;
  return static_cast<double>(static_cast<std::int64_t>(noise_state_)) * 0x1p-63;
}

void Synth::tuneFriction() RELIEVO_REALTIME {
  const double slide = heard_.contact ? heard_.slide_mm_per_s : 0;
  const double hz = frictionHz(slide);
  const double w = kTurn * hz / kSampleRateHz;
  const double alpha = std::sin(w) / (2 * kFrictionQ);
  b0_ = alpha / (1 + alpha);
  a1_ = -2 * std::cos(w) / (1 + alpha);
  a2_ = (1 - alpha) / (1 + alpha);
  friction_.rms = heard_.contact ? frictionRms(heard_.force_n, slide) / bandPassRms(hz) : 0;
}

Frame Synth::mixed() RELIEVO_REALTIME {
  double left = 0, right = 0;
  for (Voice& voice : voices_) {
    if (voice.left <= 0) continue;
    if (voice.waits > 0) {
      --voice.waits;
      continue;
    }
    const double sample = sampleOf(voice);
    left += sample * voice.sides.left;
    right += sample * voice.sides.right;
  }
  const double x = noise();
  const double y = b0_ * (x - x2_) - a1_ * y1_ - a2_ * y2_;
  x2_ = x1_;
  x1_ = x;
  y2_ = y1_;
  y1_ = y;
  friction_.gain += friction_step_ * (friction_.rms - friction_.gain);
  const double rustle = std::clamp(friction_.gain * y, -kMostFriction, kMostFriction);
  const bool has_tone = heard_.led || (heard_.contact && frame_ < tone_until_);
  tone_gain_ += tone_step_ * ((has_tone ? kToneLevel : 0) - tone_gain_);
  tone_log_hz_ += glide_step_ * (std::log2(heightHz(heard_.height)) - tone_log_hz_);
  tone_phase_ += kTurn * std::exp2(tone_log_hz_) / kSampleRateHz;
  if (tone_phase_ > kTurn) tone_phase_ -= kTurn;
  place_ += place_step_ * (heard_.place - place_);
  const double lasting = speech_.beside * (rustle + tone_gain_ * std::sin(tone_phase_));
  const Sides sides = sidesOf(place_);
  ++frame_;
  constexpr double kFade = 1 / (kFadeS * kSampleRateHz), kStruckLeft = 0.5;
  speech_.beside =
      speech_.on ? std::max(0.0, speech_.beside - kFade) : std::min(1.0, speech_.beside + kFade);
  const double struck = kStruckLeft + (1 - kStruckLeft) * speech_.beside;
  left *= struck;
  right *= struck;
  return limited(left + lasting * sides.left, right + lasting * sides.right);
}

Frame Synth::limited(double left, double right) RELIEVO_REALTIME {
  const double largest = std::max(std::abs(left), std::abs(right));
  limiter_gain_ += release_step_ * (1 - limiter_gain_);
  if (limiter_gain_ * largest > options_.ceiling) limiter_gain_ = options_.ceiling / largest;
  return {static_cast<float>(limiter_gain_ * left), static_cast<float>(limiter_gain_ * right)};
}

void Synth::render(std::span<Frame> frames) RELIEVO_REALTIME {
  for (Frame& frame : frames) {
    if (frame_ % kFramesPerTuning == 0) tuneFriction();
    frame = mixed();
  }
}

}  // namespace relievo::sound
