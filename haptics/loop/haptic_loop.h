// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include "haptics/device/device.h"
#include "haptics/loop/core_snapshot.h"
#include "haptics/loop/haptic_core.h"
#include "haptics/loop/loop_meter.h"
#include "haptics/loop/scene_buffer.h"
#include "haptics/rt/realtime_thread.h"
#include "haptics/rt/spsc_ring.h"
#include "haptics/rt/triple_buffer.h"

namespace relievo {

struct LoopOptions {
  std::int64_t period_ns = 1'000'000;
  int fifo_priority = 80;  ///< 0: normal scheduling.
  /// Exchanges at zero force before the first tick, until one tells where the hand is. A core whose
  /// first reading is a fault keeps zero until the forces are switched off and on.
  int settling_exchanges = 0;
  ForceChain chain = ForceChain::whole;  ///< `bare` for a simulated device alone.
};

/// A button edge. Its own queue: a press shorter than a GUI frame must not be lost.
struct ButtonEvent {
  std::int64_t time_ns = 0;
  std::uint8_t button = 0;
  bool down = false;
};

using SampleRing = SpscRing<HapticSample, 8192>;  ///< About 8 s at 1 kHz.
using ButtonRing = SpscRing<ButtonEvent, 64>;
using HeardRing = SpscRing<HapticSample, 256>;  ///< A quarter of a second for who listens.

/// The dedicated thread: read the newest surface and the hand, compute, send, publish.
/// A late tick is one tick: the proxy solves the hand's way since the last one; missed periods are
/// skipped and never made up for. After a pause of more than 20 ms, or a cut by the watchdog, the
/// first force is zero and the force rises anew.
class HapticLoop {
 public:
  /// @throw ArgumentError  no device, no period, or the bare spring for a device that a person
  /// holds
  explicit HapticLoop(std::unique_ptr<Device> device, LoopOptions options = {});
  ~HapticLoop();  ///< stop().
  HapticLoop(const HapticLoop&) = delete;
  HapticLoop& operator=(const HapticLoop&) = delete;

  void start();          ///< [owner] Opens the device. @throw DeviceError, Error (no thread)
  void stop() noexcept;  ///< [owner] One tick of zero force, joins, closes. Idempotent.

  const DeviceInfo& device() const noexcept;
  /// What the system granted to the running thread; valid after start(). [owner]
  const RealtimeGrant& realtime() const noexcept;

  SceneBuffer<HapticSpace>& spaces() noexcept;      ///< [one worker writes]
  TripleBuffer<HapticOptions>& options() noexcept;  ///< [GUI thread writes]
  /// [GUI thread writes] What options name that are written afterwards (GuideOptions::path).
  TripleBuffer<GuidePath>& paths() noexcept;
  TripleBuffer<HapticSample>& latest() noexcept;  ///< [GUI thread reads]
  TripleBuffer<LoopStats>& stats() noexcept;      ///< [GUI thread reads]
  SampleRing& samples() noexcept;                 ///< [drain thread reads]
  ButtonRing& buttons() noexcept;                 ///< [GUI thread reads]
  HeardRing& heard() noexcept;                    ///< [audio thread reads] Fills while listened to.
  /// [any thread] Somebody takes what is heard() as it comes.
  void listen(bool on) noexcept;
  /// [any thread] Asks for a snapshot before one of the next ticks; it is there before its sample.
  void wantSnapshot() noexcept;
  SnapshotRing& snapshots() noexcept;  ///< [drain thread reads]
  /// [any thread] Nobody moves the hand, and nothing is felt or recorded: the next ticks may be
  /// kRestPeriodNs apart. Only of a device that cannot push, and while nobody listen()s; else the
  /// loop ticks on as before. The end of a rest waits for the next tick, at most kRestPeriodNs.
  void rest(bool at_rest) noexcept;
  static constexpr std::int64_t kRestPeriodNs = 4'000'000;  ///< Far below any pause or stall.
  /// [any thread] The window lives; see ForceStopOptions::window_silence_s. start() says it, too.
  void sayAlive() noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
