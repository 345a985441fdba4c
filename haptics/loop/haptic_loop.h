// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "haptics/device/device.h"
#include "haptics/loop/haptic_core.h"
#include "haptics/rt/realtime_thread.h"
#include "haptics/rt/spsc_ring.h"
#include "haptics/rt/triple_buffer.h"

namespace relievo {

struct LoopOptions {
  std::int64_t period_ns = 1'000'000;
  int fifo_priority = 80;  ///< 0: normal scheduling.
};

/// How evenly the loop runs. Since start(), but for rate_hz.
struct LoopStats {
  /// Upper edges of the histogram of wake-up delays, in ns; the last bin takes the rest.
  static constexpr std::array<std::int64_t, 9> kDelayEdgesNs{
      20'000, 50'000, 100'000, 200'000, 500'000, 1'000'000, 5'000'000, 20'000'000, 100'000'000};

  std::uint64_t ticks = 0;
  std::uint64_t late_ticks = 0;                ///< Woke more than half a period late.
  double rate_hz = 0;                          ///< Over the last quarter second or so.
  double mean_tick_us = 0, worst_tick_us = 0;  ///< Time spent computing, without the device.
  double worst_period_ms = 0;                  ///< Longest time from tick to tick.
  std::array<std::uint64_t, kDelayEdgesNs.size() + 1> delays{};
};
static_assert(std::is_trivially_copyable_v<LoopStats>);

/// A button edge. Its own queue: a press shorter than a GUI frame must not be lost.
struct ButtonEvent {
  std::int64_t time_ns = 0;
  std::uint8_t button = 0;
  bool down = false;
};

using SampleRing = SpscRing<HapticSample, 8192>;  ///< About 8 s at 1 kHz.
using ButtonRing = SpscRing<ButtonEvent, 64>;

/// The dedicated thread: read the newest surface, talk to the device, tick, publish.
/// A late tick is one tick: the proxy solves the hand's way since the last one; missed periods are
/// skipped and never made up for.
class HapticLoop {
 public:
  explicit HapticLoop(std::unique_ptr<Device> device, LoopOptions options = {});
  ~HapticLoop();  ///< stop().
  HapticLoop(const HapticLoop&) = delete;
  HapticLoop& operator=(const HapticLoop&) = delete;

  void start();          ///< [owner] Opens the device. @throw DeviceError, Error (no thread)
  void stop() noexcept;  ///< [owner] Fades to zero force, joins, closes. Idempotent.

  const DeviceInfo& device() const noexcept;
  /// What the system granted to the running thread; valid after start(). [owner]
  const RealtimeGrant& realtime() const noexcept;

  TripleBuffer<HapticSpace>& spaces() noexcept;     ///< [one worker writes]
  TripleBuffer<HapticOptions>& options() noexcept;  ///< [GUI thread writes]
  TripleBuffer<HapticSample>& latest() noexcept;    ///< [GUI thread reads]
  TripleBuffer<LoopStats>& stats() noexcept;        ///< [GUI thread reads]
  SampleRing& samples() noexcept;                   ///< [drain thread reads]
  ButtonRing& buttons() noexcept;                   ///< [GUI thread reads]

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
