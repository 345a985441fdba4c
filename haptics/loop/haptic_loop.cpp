// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/haptic_loop.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <optional>
#include <thread>
#include <utility>

#include "core/base/failure.h"
#include "haptics/loop/device_limits.h"
#include "haptics/loop/watchdog.h"

namespace relievo {

namespace {
/// The first deadline after `now` on the grid of the last one: periods that were missed are gone.
std::int64_t nextDeadline(std::int64_t deadline, std::int64_t now,
                          std::int64_t period) RELIEVO_REALTIME {
  const std::int64_t missed = std::max<std::int64_t>(0, (now - deadline) / period);
  return deadline + (missed + 1) * period;
}
}  // namespace

struct HapticLoop::Impl {
  Impl(std::unique_ptr<Device> d, LoopOptions o)
      : device(std::move(d)), loop_options(o), core(o.chain) {}

  std::unique_ptr<Device> device;
  LoopOptions loop_options;
  RealtimeGrant grant;
  std::thread thread;
  std::optional<Watchdog> watchdog;  // Lives while the thread runs.
  std::atomic<bool> stopping{false};

  SceneBuffer<HapticSpace> spaces;
  TripleBuffer<HapticOptions> options;
  TripleBuffer<GuidePath> paths;
  TripleBuffer<HapticSample> latest;
  TripleBuffer<LoopStats> stats;
  SampleRing samples;
  ButtonRing buttons;
  HeardRing heard;
  std::atomic<bool> listened{false};
  std::atomic<bool> resting{false};
  SnapshotRing snapshots;
  std::atomic<bool> snapshot_wanted{false};
  std::atomic<std::int64_t> alive_ns{0};

  HapticCore core;  // [haptic loop], as all that follows.
  LoopMeter meter;
  std::uint32_t last_buttons = 0;

  void run(std::promise<RealtimeGrant> started);
  void settle();
  HapticOptions optionsNow(std::int64_t now_ns, bool forces_allowed) RELIEVO_REALTIME;
  bool mayRest() const RELIEVO_REALTIME;
  void tick(std::int64_t deadline_ns, std::int64_t now_ns, bool rested,
            bool forces_allowed) RELIEVO_REALTIME;
  void reportButtons(const HapticSample& sample) RELIEVO_REALTIME;
};

void HapticLoop::Impl::reportButtons(const HapticSample& sample) RELIEVO_REALTIME {
  const std::uint32_t changed = (sample.buttons ^ last_buttons) & ~kHoverBit;
  last_buttons = sample.buttons;
  for (std::uint8_t i = 0; i < 32; ++i) {
    const std::uint32_t bit = std::uint32_t{1} << i;
    if ((changed & bit) != 0) buttons.push({sample.time_ns, i, (sample.buttons & bit) != 0});
  }
}

/// What is asked for, and what the loop overrules: bits of its id say so.
HapticOptions HapticLoop::Impl::optionsNow(std::int64_t now_ns,
                                           bool forces_allowed) RELIEVO_REALTIME {
  options.update();
  HapticOptions now = options.front();
  // A path is there before the options that name it.
  if (now.guide.path != 0 && now.guide.path != paths.front().id) paths.update();
  if (now.guide.path != 0 && now.guide.path != paths.front().id) {
    now.guide = {};
    now.id |= kPathlessBit;
  }
  if (!forces_allowed) {
    now.force.forces_on = false;
    now.id |= kLeavingBit;
  }
  const double silent_s =
      1e-9 * static_cast<double>(now_ns - alive_ns.load(std::memory_order_relaxed));
  if (now.stop.window_silence_s > 0 && silent_s > now.stop.window_silence_s) {
    now.stop.window_silent = true;
    now.id |= kSilentBit;
  }
  return withinDevice(now, device->info());
}

/// A device that pushes is never left alone for longer than a period, nor is who listens: sound
/// keeps time by the ticks.
bool HapticLoop::Impl::mayRest() const RELIEVO_REALTIME {
  return resting.load(std::memory_order_relaxed) && !listened.load(std::memory_order_relaxed) &&
         !(device->info().max_force_n > 0);
}

void HapticLoop::Impl::tick(std::int64_t deadline_ns, std::int64_t now_ns, bool rested,
                            bool forces_allowed) RELIEVO_REALTIME {
  const bool late = meter.wake(deadline_ns, now_ns, loop_options.period_ns, rested);
  if (!core.changing()) spaces.update();  // One change at a time; the newest window waits.
  const HapticOptions now_options = optionsNow(now_ns, forces_allowed);
  if (watchdog->beat(now_ns)) core.resume();
  if (core.pausedUntil(now_ns)) meter.paused();
  DeviceReading reading = device->read(now_ns);
  reading.position = handFromDevice(now_options.grip, reading.position);
  const std::int64_t before_ns = monotonicNs();
  // A device that cannot push back is shown the new surface at once.
  const bool gradual = device->info().max_force_n > 0;
  if (snapshot_wanted.load(std::memory_order_relaxed)) {
    snapshot_wanted.store(false, std::memory_order_relaxed);
    snapshots.push(
        {core.ticks(), core, spaces.front().scene_id, spaces.previous().scene_id, gradual});
  }
  HapticSample sample =
      gradual ? core.tick(spaces.front(), spaces.previous(), now_options, reading, now_ns,
                          &paths.front())
              : core.tick(spaces.front(), now_options, reading, now_ns, &paths.front());
  sample.tick_ns =
      static_cast<std::int32_t>(std::min<std::int64_t>(monotonicNs() - before_ns, 2'000'000'000));
  // Before anything else: what waits now is a hand.
  device->send(deviceFromHand(now_options.grip, sample.force), now_ns);
  meter.computed(sample.tick_ns);
  meter.note(core.audit(), watchdog->cuts());
  sample.late = late;
  sample.rate_hz = meter.stats().rate_hz;
  latest.write(sample);
  meter.faulted(threadPageFaults());
  stats.write(meter.stats());
  samples.push(sample);
  if (listened.load(std::memory_order_relaxed)) heard.push(sample);
  reportButtons(sample);
}

void HapticLoop::Impl::settle() {
  for (int i = 0; i < loop_options.settling_exchanges; ++i) {
    const std::int64_t now = monotonicNs();
    if (device->exchange({}, now).fault == DeviceFault::none) return;
    if (stopping.load(std::memory_order_acquire)) return;
    sleepUntil(now + loop_options.period_ns);
  }
}

void HapticLoop::Impl::run(std::promise<RealtimeGrant> started) {
  const std::array<MemoryRegion, 1> memory{
      {{this, sizeof(*this)}}};  // Buffers and rings lie inside.
  started.set_value(requestRealtime(loop_options.fifo_priority, memory));

  settle();

  const std::int64_t usual = loop_options.period_ns, slow = std::max(usual, kRestPeriodNs);
  std::int64_t period = usual;
  std::int64_t deadline = monotonicNs() + period;
  meter.begin(deadline - period);
  for (bool leaving = false; !leaving;) {
    sleepUntil(deadline);
    const std::int64_t now = monotonicNs();
    leaving = stopping.load(std::memory_order_acquire);  // Then this tick is the last, at zero.
    tick(deadline, now, period != usual, !leaving);
    period = mayRest() ? slow : usual;
    deadline = nextDeadline(deadline, now, period);
  }
  watchdog->rest();
  device->send({}, monotonicNs());
}

HapticLoop::HapticLoop(std::unique_ptr<Device> device, LoopOptions options)
    : impl_(std::make_unique<Impl>(std::move(device), options)) {
  if (!impl_->device) throw failure<MessageId::loop_without_device>();
  if (options.chain == ForceChain::bare && !impl_->device->info().simulated) {
    throw failure<MessageId::loop_bare_spring>();
  }
  if (options.period_ns <= 0) throw failure<MessageId::loop_period>();
}

HapticLoop::~HapticLoop() {
  stop();
}

void HapticLoop::start() {
  if (impl_->thread.joinable()) return;
  impl_->device->open();
  impl_->stopping.store(false, std::memory_order_release);
  sayAlive();
  std::promise<RealtimeGrant> started;
  std::future<RealtimeGrant> granted = started.get_future();
  try {
    impl_->watchdog.emplace(*impl_->device, impl_->loop_options.fifo_priority);
    impl_->thread = std::thread(
        [this, promise = std::move(started)]() mutable { impl_->run(std::move(promise)); });
  } catch (const std::system_error& error) {
    impl_->watchdog.reset();
    impl_->device->close();
    throw Error(std::string("The force loop's thread could not be started: ") + error.what());
  }
  impl_->grant = granted.get();
}

void HapticLoop::stop() noexcept {
  if (!impl_->thread.joinable()) return;
  impl_->stopping.store(true, std::memory_order_release);
  impl_->thread.join();
  impl_->watchdog.reset();
  impl_->device->close();
}

const DeviceInfo& HapticLoop::device() const noexcept {
  return impl_->device->info();
}
const RealtimeGrant& HapticLoop::realtime() const noexcept {
  return impl_->grant;
}
SceneBuffer<HapticSpace>& HapticLoop::spaces() noexcept {
  return impl_->spaces;
}
TripleBuffer<HapticOptions>& HapticLoop::options() noexcept {
  return impl_->options;
}
TripleBuffer<GuidePath>& HapticLoop::paths() noexcept {
  return impl_->paths;
}
TripleBuffer<HapticSample>& HapticLoop::latest() noexcept {
  return impl_->latest;
}
TripleBuffer<LoopStats>& HapticLoop::stats() noexcept {
  return impl_->stats;
}
SampleRing& HapticLoop::samples() noexcept {
  return impl_->samples;
}
ButtonRing& HapticLoop::buttons() noexcept {
  return impl_->buttons;
}
HeardRing& HapticLoop::heard() noexcept {
  return impl_->heard;
}
void HapticLoop::listen(bool on) noexcept {
  impl_->listened.store(on, std::memory_order_relaxed);
}
void HapticLoop::wantSnapshot() noexcept {
  impl_->snapshot_wanted.store(true, std::memory_order_relaxed);
}
void HapticLoop::rest(bool at_rest) noexcept {
  impl_->resting.store(at_rest, std::memory_order_relaxed);
}
SnapshotRing& HapticLoop::snapshots() noexcept {
  return impl_->snapshots;
}
void HapticLoop::sayAlive() noexcept {
  impl_->alive_ns.store(monotonicNs(), std::memory_order_relaxed);
}

}  // namespace relievo
