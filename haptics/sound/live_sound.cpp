// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/sound/live_sound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "haptics/record/sample_log.h"

namespace relievo::sound {

namespace {

constexpr std::int64_t kMostLead = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kLeastLead = std::numeric_limits<std::int64_t>::min();
constexpr double kGainS = 0.005;
// Clocks are compared over a second. Earlier than needed costs a delay, later costs evenness.
constexpr std::int64_t kWatchFrames = kSampleRateHz;
constexpr std::int64_t kTooEarlyFrames = 96, kTooLateFrames = 256;
constexpr std::int64_t kStalledFrames = kSampleRateHz / 10;

bool isAProblem(DeviceFault fault) RELIEVO_REALTIME {
  switch (fault) {
    case DeviceFault::timeout:
    case DeviceFault::disconnected:
    case DeviceFault::protocol:
    case DeviceFault::overheated:
    case DeviceFault::not_finite:
    case DeviceFault::not_ready:
      return true;
    default:
      return false;
  }
}

}  // namespace

bool beginsAProblem(const HapticSample& before, const HapticSample& now) RELIEVO_REALTIME {
  if (now.fault != before.fault && isAProblem(now.fault)) return true;
  if (now.stopped != before.stopped && now.stopped == StopReason::window_silent) return true;
  if (now.slow.rate_hz > 0 && !(before.slow.rate_hz > 0)) return true;
  return now.softened > before.softened;
}

double volumeGain(int percent) noexcept {
  const double share = std::clamp(percent, 0, 100) / 100.0;
  return share * share;
}

LiveSound::LiveSound(HeardRing& samples, const SynthOptions& options)
    : ring_(samples),
      mixer_(options),
      least_lead_(kMostLead),
      most_lead_(kLeastLead),
      gain_step_(1 - std::exp(-1 / (kGainS * kSampleRateHz))) {}

void LiveSound::setSpeech(bool speech) noexcept {
  speech_.store(speech, std::memory_order_relaxed);
}

void LiveSound::setWindow(const HeardWindow& window) {
  windows_.write(window);
}

void LiveSound::setVolume(int percent) noexcept {
  requested_gain_.store(static_cast<float>(volumeGain(percent)), std::memory_order_relaxed);
}

void LiveSound::strike(Earcon earcon) {
  struck_.push(earcon);
}

/// The window that a sample was taken in: after a change, samples of the one before still arrive.
const HeardWindow* LiveSound::windowOf(std::uint64_t id) RELIEVO_REALTIME {
  if (window_.id != id && windows_.update()) {
    window_before_ = window_;
    window_ = windows_.front();
  }
  for (const HeardWindow* window : {&window_, &window_before_}) {
    if (window->id == id && id != 0 && window->region.side_mm > 0) return window;
  }
  return nullptr;
}

void LiveSound::take(const HapticSample& sample) RELIEVO_REALTIME {
  const double t_s = 1e-9 * static_cast<double>(sample.time_ns - zero_ns_);
  newest_ = std::llround(t_s * kSampleRateHz) + shift_;
  // The server took nothing for a while, as some do at their start: the sound goes on from here.
  const std::int64_t lead = newest_ - mixer_.frame();
  if (lead > kStalledFrames) {
    shift_ -= lead;
    newest_ -= lead;
  }
  const HeardWindow* const window = windowOf(sample.window_id);
  HeardPlace place;
  if (window != nullptr) {
    place = {.region = &window->region, .gain = window->gain, .heights = window->heights};
  }
  std::optional<Earcon> also;
  if (sample.guide == GuidePhase::pausing && last_.guide != GuidePhase::pausing) {
    also = Earcon::corner;
  }
  if (beginsAProblem(last_, sample)) also = Earcon::problem;
  TouchSample touch = touchSampleOf(touchRow(sample, t_s), place);
  touch.led = sample.guide != GuidePhase::off;
  mixer_.place(touch, newest_, TouchMixer::Happenings::heard, also);
  last_ = sample;
  taken_.fetch_add(1, std::memory_order_relaxed);
}

void LiveSound::takeSamples(std::int64_t frames) RELIEVO_REALTIME {
  HapticSample sample;
  bool has_news = false;
  if (!has_begun_) {
    // Samples that wait are old. The newest is heard when these frames are over, and every other
    // one as long after its tick.
    while (ring_.pop(sample)) has_news = true;
    if (!has_news) {
      silent_ += frames;
      return;
    }
    has_begun_ = true;
    zero_ns_ = sample.time_ns;
    waits_ = frames;
    silent_ += frames;
    last_ = sample;
    return take(sample);
  }
  while (ring_.pop(sample)) {
    take(sample);
    has_news = true;
  }
  keepTime(frames, has_news);
}

/// @param frames  how many are rendered now
void LiveSound::keepTime(std::int64_t frames, bool has_news) RELIEVO_REALTIME {
  const std::int64_t lead = newest_ - (mixer_.frame() + frames);
  if (has_news) most_lead_ = std::max(most_lead_, lead);
  if (has_news) least_lead_ = std::min(least_lead_, lead);
  watched_ += frames;
  if (watched_ < kWatchFrames) return;
  if (most_lead_ != kLeastLead) {
    if (least_lead_ > kTooEarlyFrames) shift_ -= least_lead_;
    if (most_lead_ < -kTooLateFrames) shift_ -= most_lead_;
  }
  watched_ = 0;
  most_lead_ = kLeastLead;
  least_lead_ = kMostLead;
}

void LiveSound::setLoudness(std::span<Frame> frames) RELIEVO_REALTIME {
  const double requested = requested_gain_.load(std::memory_order_relaxed);
  if (gain_ < 0) gain_ = requested;
  for (Frame& frame : frames) {
    gain_ += gain_step_ * (requested - gain_);
    frame.left = static_cast<float>(gain_ * frame.left);
    frame.right = static_cast<float>(gain_ * frame.right);
  }
}

void LiveSound::render(std::span<Frame> frames) RELIEVO_REALTIME {
  takeSamples(static_cast<std::int64_t>(frames.size()));
  std::size_t silent = frames.size();
  if (has_begun_) {
    silent = std::min(silent, static_cast<std::size_t>(waits_));
    waits_ -= static_cast<std::int64_t>(silent);
    Earcon earcon{};
    while (struck_.pop(earcon)) mixer_.strike(earcon);
  }
  std::fill_n(frames.begin(), silent, Frame{});
  mixer_.setSpeech(speech_.load(std::memory_order_relaxed));
  mixer_.render(frames.subspan(silent));
  setLoudness(frames);
}

}  // namespace relievo::sound
