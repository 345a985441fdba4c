// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <span>

#include "core/region/region.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/rt/spsc_ring.h"
#include "haptics/rt/triple_buffer.h"
#include "haptics/sound/heard_row.h"
#include "haptics/sound/touch_mixer.h"

namespace relievo::sound {

/// The part of a window under the hand that the sound depends on.
struct HeardWindow {
  std::uint64_t id = 0;
  Region region;
  double gain = 1;
  ToneHeights heights;  ///< Of the object, as long as it is under the hand.
};

/// Whether a fault begins with this sample, by the same rule that makes it sound as a problem in a
/// recording.
bool beginsAProblem(const HapticSample& before, const HapticSample& now) RELIEVO_REALTIME;

/// How loud a volume is: half of it is a quarter, so that steps sound alike.
/// @param percent  0 .. 100
double volumeGain(int percent) noexcept;

/// The sound of a touch that goes on (docs/adr/0211): what a loop's samples sound like, each as
/// long after its tick as every other, by the same TouchMixer as the sound of a recording. Whoever
/// plays it asks for frames.
class LiveSound {
 public:
  /// @param samples  the loop's, which outlives this; nobody else takes them
  explicit LiveSound(HeardRing& samples, const SynthOptions& options = {});

  // [one thread]
  void setWindow(const HeardWindow& window);  ///< It lies under the hand, or soon will.
  void setVolume(int percent) noexcept;       ///< 0 .. 100; it glides there.
  void strike(Earcon earcon);                 ///< The sign of a command.
  void setSpeech(bool speech) noexcept;       ///< Somebody speaks now.

  /// Makes the next frames. Allocates nothing and waits for nothing. [audio thread]
  void render(std::span<Frame> frames) RELIEVO_REALTIME;
  /// Frames that were heard before the first sample: a recording that begins with it sounds the
  /// same from there on. [audio thread]
  std::int64_t silentFrames() const RELIEVO_REALTIME { return silent_; }
  /// Samples that were heard. [any thread]
  std::uint64_t samples() const noexcept { return taken_.load(std::memory_order_relaxed); }

 private:
  void takeSamples(std::int64_t frames) RELIEVO_REALTIME;
  void take(const HapticSample& sample) RELIEVO_REALTIME;
  const HeardWindow* windowOf(std::uint64_t id) RELIEVO_REALTIME;
  void keepTime(std::int64_t frames, bool has_news) RELIEVO_REALTIME;
  void setLoudness(std::span<Frame> frames) RELIEVO_REALTIME;

  HeardRing& ring_;
  TripleBuffer<HeardWindow> windows_;
  SpscRing<Earcon, 16> struck_;
  std::atomic<float> requested_gain_{1};
  std::atomic<bool> speech_{false};
  std::atomic<std::uint64_t> taken_{0};

  // [audio thread]
  TouchMixer mixer_;
  HeardWindow window_, window_before_;
  HapticSample last_;
  bool has_begun_ = false;
  std::int64_t zero_ns_ = 0;  // The first sample's time; it is the mixer's frame 0.
  std::int64_t waits_ = 0;    // Frames until the mixer begins.
  std::int64_t silent_ = 0;
  // Samples are placed by so many frames later than their time, because the clocks of loop and
  // sound differ.
  std::int64_t shift_ = 0;
  std::int64_t newest_ = 0;              // Where the newest sample was placed.
  std::int64_t least_lead_, most_lead_;  // Of the newest sample to the last frame.
  std::int64_t watched_ = 0;             // Frames since these were forgotten.
  double gain_ = -1;                     // -1: nothing was rendered yet.
  double gain_step_;
};

}  // namespace relievo::sound
