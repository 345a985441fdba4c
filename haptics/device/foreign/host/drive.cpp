// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/host/drive.h"

#include <poll.h>
#include <pthread.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <functional>
#include <thread>

#include "haptics/device/foreign/host/device_round.h"
#include "haptics/device/foreign/host/loaded_plugin.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo::foreign {

namespace {
constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kOverdueNs = 5 * kMs;  // A step may wait for its device so long.
constexpr std::int64_t kEndNs = 900 * kMs;    // From the wish to end until the process goes.
constexpr int kHungLooks = 20;                // The same, of a step that hung at the wish already.
constexpr int kDevicePriority = 75, kGuardPriority = 76;
constexpr int kOverdueExit = 3;

/// Blocked, so that a plug-in is never ended between two calls; looked at by the guard.
OwnedFd endSignals() {
  sigset_t set;
  ::sigemptyset(&set);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) ::sigaddset(&set, signal);
  ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
  return OwnedFd(::signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK));
}

/// What main, guard and device thread share.
struct Drive {
  MappedPage page;
  OwnedFd signals;
  std::atomic<bool> ending{false};  // Zero, close, go.
  std::atomic<bool> over{false};    // All is closed: the guard may go.
  std::atomic<bool> cut_by_guard{false};
  std::atomic<bool> guarded{false};              // The guard looks.
  std::atomic<relievo_device*> device{nullptr};  // Created; the guard may cut its force.
  std::atomic<std::int64_t> step_since_ns{0};    // When the step that runs began; 0: none runs.
};

void cut(const Drive& drive) {
  relievo_device* const device = drive.device.load(std::memory_order_acquire);
  if (device == nullptr) return;
  called(relievo_status{RELIEVO_INTERNAL}, device->cut_force, device->self);
}

/// relievo is gone or lets go, or a signal asks for an end.
bool endIsWanted(const Drive& drive) {
  std::array<pollfd, 2> ends{pollfd{kLifeFd, POLLIN, 0}, pollfd{drive.signals.get(), POLLIN, 0}};
  return ::poll(ends.data(), ends.size(), 0) > 0;
}

/// Sees to zero force where the device's own thread cannot: an overdue step, a cut by relievo's
/// watchdog, and an end of relievo while a step hangs. [guard thread]
void guard(Drive& drive) {
  requestRealtime(kGuardPriority, {});
  ::pthread_setname_np(::pthread_self(), "guard");
  drive.guarded.store(true, std::memory_order_release);
  drive.guarded.notify_one();
  std::uint32_t cuts = drive.page->cuts.load(std::memory_order_acquire);
  std::int64_t cut_for_ns = 0;  // The step that it was cut for: once each.
  std::int64_t ending_since_ns = 0;
  std::int64_t ended_in_ns = 0;  // The step that the wish to end came into; 0: none.
  int looks_since_end = 0;
  for (std::int64_t look_ns = monotonicNs(); !drive.over.load(std::memory_order_acquire);) {
    look_ns = std::max(look_ns, monotonicNs()) + kMs;
    sleepUntil(look_ns);
    const std::int64_t now_ns = monotonicNs();
    const std::int64_t since_ns = drive.step_since_ns.load(std::memory_order_acquire);
    if (since_ns != 0 && since_ns != cut_for_ns && now_ns - since_ns > kOverdueNs) {
      cut_for_ns = since_ns;
      drive.cut_by_guard.store(true, std::memory_order_release);
      cut(drive);
    }
    const std::uint32_t cuts_now = drive.page->cuts.load(std::memory_order_acquire);
    if (cuts_now != cuts) {
      cuts = cuts_now;
      cut(drive);
    }
    if (ending_since_ns == 0 && endIsWanted(drive)) {
      ending_since_ns = now_ns;
      ended_in_ns = since_ns;
      drive.ending.store(true, std::memory_order_release);
      if (since_ns != 0) cut(drive);  // Else the next round sends zero, a millisecond later.
    }
    // By looks, not by the clock: a process that stood still as a whole gets its time. The force
    // was cut at the wish, and a device whose step hangs cannot be closed.
    const bool hangs = ended_in_ns != 0 && since_ns == ended_in_ns;
    if (hangs && ++looks_since_end > kHungLooks) ::_exit(kOverdueExit);
    if (ending_since_ns != 0 && now_ns - ending_since_ns > kEndNs) {
      cut(drive);
      ::_exit(kOverdueExit);
    }
  }
}

/// The guard calls the plug-in, which may hang there, too: once relievo is gone, a thread that
/// never calls it ends the process.
void endAfterRelievo() {
  std::thread([] {
    pollfd life{.fd = kLifeFd, .events = POLLIN, .revents = 0};
    while (::poll(&life, 1, -1) < 0) {
    }
    sleepUntil(monotonicNs() + kEndNs + 300 * kMs);
    ::_exit(kOverdueExit);
  }).detach();
}

/// [device thread]
void runRounds(Drive& drive, DeviceRound& round, const ForeignLimits& limits) {
  requestRealtime(kDevicePriority, {});
  const auto period_ns = static_cast<std::int64_t>(1e9 / limits.rate_hz);
  std::int64_t deadline_ns = monotonicNs();
  for (bool leaving = false; !leaving;) {
    const std::int64_t now_ns = monotonicNs();
    // The beat is that of steps that came back: one that hangs is none.
    drive.page->beat_ns.store(now_ns, std::memory_order_release);
    leaving =
        drive.ending.load(std::memory_order_acquire);  // Then this round is the last, at zero.
    if (drive.cut_by_guard.exchange(false, std::memory_order_acq_rel)) round.wasCut(now_ns);
    round.go(now_ns, leaving);
    // A late round is one round; what was missed is not made up for.
    deadline_ns = std::max(deadline_ns + period_ns, monotonicNs());
    sleepUntil(deadline_ns);
  }
}

void tell(Drive& drive, HostReport report, const Trouble& trouble) {
  report.stage = trouble.what == HostTrouble::none ? HostStage::ready : HostStage::failed;
  report.trouble = trouble.what;
  report.number = trouble.number;
  putText(trouble.text, report);
  drive.page->report.write(report);
}

Trouble openDevice(Drive& drive, const LoadedPlugin& plugin, const std::string& id,
                   ForeignLimits& limits) {
  relievo_device* const device = plugin.create(id);
  if (device == nullptr) return {HostTrouble::no_device, 0, {}};
  if (!isWhole(device)) return {HostTrouble::incomplete, 0, {}};
  drive.device.store(device, std::memory_order_release);
  const relievo_status status =
      called(relievo_status{RELIEVO_INTERNAL}, device->open, device->self);
  if (status < 0) return {HostTrouble::refuses, status, lastError(device)};
  return askLimits(device, limits);
}

/// Returns with the device closed, if it was ever opened.
void runDevice(Drive& drive, LoadedPlugin& plugin, const std::string& file, const std::string& id) {
  ForeignLimits limits;
  Trouble trouble = plugin.load(file);
  if (trouble.what == HostTrouble::none) trouble = plugin.begin();
  if (trouble.what == HostTrouble::none) trouble = openDevice(drive, plugin, id, limits);
  HostReport report;
  report.limits = limits;
  tell(drive, report, trouble);
  relievo_device* const device = drive.device.load(std::memory_order_relaxed);
  if (device == nullptr) return;
  if (trouble.what == HostTrouble::none) {
    DeviceRound round(*device, *drive.page, limits, drive.step_since_ns);
    std::thread(runRounds, std::ref(drive), std::ref(round), limits).join();
  }
  try {
    device->close(device->self);
  } catch (...) {
    cut(drive);
  }
}
}  // namespace

int drive(const std::string& file, const std::string& id) {
  Drive drive;
  if (!drive.page.open(kPageFd)) return 2;
  drive.signals = endSignals();
  LoadedPlugin plugin;
  endAfterRelievo();
  std::thread guarding(guard, std::ref(drive));
  // To ask for its priority may take a second: until it looks, nothing is loaded that could push.
  drive.guarded.wait(false, std::memory_order_acquire);
  runDevice(drive, plugin, file, id);
  // Only now: the guard may cut the force of a device that is being closed.
  drive.over.store(true, std::memory_order_release);
  guarding.join();
  ::alarm(1);  // Nobody watches what is left, and no host outlives relievo.
  relievo_device* const device = drive.device.load(std::memory_order_relaxed);
  if (device != nullptr) plugin.destroy(device);
  plugin.end();
  return 0;
}

}  // namespace relievo::foreign
