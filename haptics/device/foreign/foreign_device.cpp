// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/foreign_device.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/base/failure.h"
#include "haptics/device/foreign/ask_host.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo::foreign {

namespace {
constexpr int kLookMs = 20;
constexpr std::uint32_t kAllButtons = 0b1111;

/// A spring of this device stays passive: K <= b / (T/2 + delay), with the damping of a hand.
double passiveStiffness(const ForeignLimits& limits) {
  constexpr double kDampingNsPerMm = 0.0015, kTickS = 0.001, kOrderWaitsS = 0.001;
  const double delay_s = kOrderWaitsS + 1e-3 * limits.force_delay_ms;
  return kDampingNsPerMm / (kTickS / 2 + delay_s);
}
}  // namespace

ForeignDevice::ForeignDevice(std::filesystem::path file, std::string own_id, std::string id,
                             std::string name, Patience patience)
    : file_(std::move(file)), own_id_(std::move(own_id)), patience_(patience) {
  info_.id = std::move(id);
  info_.name = std::move(name);
  // Until it says itself: the least that any device with motors has.
  takeLimits({.half_extent_mm = {40, 40, 40}, .max_force_n = kMostForceWithoutWatchdogN});
}

ForeignDevice::~ForeignDevice() {
  close();
}

void ForeignDevice::takeLimits(const ForeignLimits& limits) {
  constexpr double kUnknownStiffness = 0.4;
  const double stated =
      limits.max_stiffness_n_per_mm > 0 ? limits.max_stiffness_n_per_mm : kUnknownStiffness;
  info_.workspace.half_extent = {limits.half_extent_mm[0], limits.half_extent_mm[1],
                                 limits.half_extent_mm[2]};
  info_.max_force_n = rulesOf(limits).max_force_n;
  info_.max_stiffness_n_per_mm =
      limits.force_delay_ms > 1 ? std::min(stated, passiveStiffness(limits)) : stated;
  // As the Falcon's, until somebody has measured another.
  info_.max_damping_n_s_per_mm = 0.006;
  info_.max_slew_n_per_s = 200;
  info_.position_step_mm = limits.position_step_mm;
  info_.force_delay_ticks = 2;  // Up to one until the host takes it, one until the motors show it.
  info_.rate_hz = limits.rate_hz;
}

void ForeignDevice::open() {
  if (watching_.joinable()) return;
  page_ = std::make_unique<MappedPage>();
  if (!page_->create()) {
    const int reason = errno;
    page_.reset();
    throw failure<MessageId::device_host_not_started>(std::strerror(reason));
  }
  host_.start({.arguments = {"drive", file_.string(), own_id_}, .shared_fd = page_->fd()});
  host_pid_ = host_.pid();
  lost_.store(DeviceFault::none);
  newest_ = {};
  loop_end_ = {};
  try {
    takeLimits(waitUntilOpen().limits);
    watching_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
  } catch (const std::system_error& error) {
    host_.kill();
    throw failure<MessageId::device_host_not_started>(error.what());
  } catch (const DeviceError&) {
    host_.letGo();
    if (!host_.ended(patience_.close_ms)) host_.kill();
    throw;
  }
}

HostReport ForeignDevice::waitUntilOpen() {
  const auto refuse = [this](const Message& why) {
    throw failure<MessageId::device_not_opened>(info_.name, why);
  };
  HostReport report;
  for (int waited_ms = 0; waited_ms < 1000 * patience_.open_s; waited_ms += kLookMs) {
    const bool ended = host_.ended(kLookMs);
    (*page_)->report.read(report);
    if (report.stage == HostStage::ready && !ended) {
      if (!arePossible(report.limits)) refuse(said<MessageId::device_plugin_limits>());
      return report;
    }
    if (report.stage == HostStage::failed) {
      refuse(messageOf(report.trouble, report.number, textOf(report)));
    }
    if (!ended) continue;
    refuse(host_.crashed() ? said<MessageId::device_host_crashed>(host_.signal())
                           : said<MessageId::device_host_ended>());
  }
  refuse(said<MessageId::device_host_slow>(patience_.open_s));
  return report;
}

/// Until it is closed, or the host is no more. [device thread]
void ForeignDevice::watch(const std::stop_token& stop) {
  std::int64_t beat_ns = 0;
  int silent_ms = 0;
  while (!stop.stop_requested()) {
    if (host_.ended(kLookMs)) return lost_.store(DeviceFault::disconnected);
    const std::int64_t now_beat_ns = (*page_)->beat_ns.load(std::memory_order_acquire);
    // By looks, not by the clock: after a sleep of the computer the host gets its time, too.
    silent_ms = now_beat_ns == beat_ns ? silent_ms + kLookMs : 0;
    beat_ns = now_beat_ns;
    // Before its first round it asks for its priority, which may take a second.
    if (silent_ms <= (now_beat_ns == 0 ? 1000 * patience_.open_s : patience_.silence_ms)) continue;
    lost_.store(DeviceFault::timeout);
    // One that was only held up sends zero when it sees this; killed at once it could not.
    host_.letGo();
    if (!host_.ended(patience_.close_ms)) host_.kill();
    return;
  }
}

void ForeignDevice::close() noexcept {
  if (!watching_.joinable()) return;
  watching_.request_stop();
  watching_.join();
  watching_ = {};
  host_.letGo();
  if (!host_.ended(patience_.close_ms)) host_.kill();
  page_.reset();
}

DeviceReading ForeignDevice::read(std::int64_t now_ns) RELIEVO_REALTIME {
  const std::uint32_t cuts = (*page_)->cuts.load(std::memory_order_acquire);  // First: see LoopEnd.
  LinkReading told;
  if ((*page_)->reading.read(told)) {
    const DeviceMm& reach = info_.workspace.half_extent;
    const bool possible =
        isFinite(told.position) && std::abs(told.position.x) <= 2 * reach.x &&
        std::abs(told.position.y) <= 2 * reach.y && std::abs(told.position.z) <= 2 * reach.z &&
        told.fault <= DeviceFault::not_ready && told.interruption <= DeviceFault::not_ready;
    if (possible) {
      newest_ = told;
    } else {
      newest_.fault = DeviceFault::protocol;
    }
  }
  DeviceReading reading = loop_end_.take(cuts, newest_);
  reading.buttons &= kAllButtons;
  // It was measured before this tick, or between its begin and now.
  reading.time_ns = std::min(reading.time_ns, now_ns);
  if (reading.fault == DeviceFault::none && reading.time_ns < now_ns - patience_.stale_place_ns) {
    reading.fault = DeviceFault::timeout;
  }
  const DeviceFault lost = lost_.load(std::memory_order_acquire);
  if (lost != DeviceFault::none) reading.fault = lost;
  return reading;
}

void ForeignDevice::send(DeviceN force, std::int64_t now_ns) RELIEVO_REALTIME {
  (*page_)->order.write(loop_end_.order(force, now_ns));
}

void ForeignDevice::cutForce() noexcept {
  (*page_)->cuts.fetch_add(1, std::memory_order_acq_rel);
}

}  // namespace relievo::foreign
