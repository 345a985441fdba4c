// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/foreign_device.h"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/base/failure.h"
#include "haptics/device/foreign/host_answers.h"
#include "haptics/device/foreign/plugin_settings.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo::foreign {

namespace {
constexpr int kLookMs = 10;
}  // namespace

ForeignDevice::ForeignDevice(std::filesystem::path file, std::string own_id, std::string id,
                             std::string name, Patience patience)
    : file_(std::move(file)), own_id_(std::move(own_id)), patience_(patience) {
  info_.id = std::move(id);
  info_.name = std::move(name);
  // Until it says itself: the least that any device with motors has.
  takeLimits({.half_extent_mm = {40, 40, 40}, .max_force_n = kMostForceWithoutWatchdogN}, info_);
}

ForeignDevice::ForeignDevice(PluginImage image, std::string own_id, std::string id,
                             std::string name, Patience patience)
    : ForeignDevice(image.file, std::move(own_id), std::move(id), std::move(name), patience) {
  image_ = std::move(image);
}

ForeignDevice::~ForeignDevice() {
  close();
}

void ForeignDevice::open() {
  if (watching_.joinable()) return;
  try {
    if (!image_) image_ = readPlugin(file_);
  } catch (const FileError& error) {
    const Message why = said<MessageId::device_plugin_not_loaded>(englishText(messageOf(error)));
    throw failure<MessageId::device_not_opened>(info_.name, why);
  }
  page_ = std::make_unique<MappedPage>();
  if (!page_->create()) {
    const int reason = errno;
    page_.reset();
    throw failure<MessageId::device_host_not_started>(std::strerror(reason));
  }
  host_.start({.arguments = {"drive", file_.string(), own_id_},
               .variables = variablesFor(file_),
               .shared_fd = page_->fd(),
               .plugin_fd = image_->bytes.get()});
  host_pid_ = host_.pid();
  lost_.store(DeviceFault::none);
  try {
    takeLimits(waitUntilOpen().limits, info_);
    page_end_ = PageEnd(info_.workspace.half_extent, patience_.stale_place_ns);
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
    if (!ended && given_up_.load()) refuse(said<MessageId::device_host_ended>());
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
  DeviceReading reading = page_end_.read(**page_, now_ns);
  const DeviceFault lost = lost_.load(std::memory_order_acquire);
  if (lost != DeviceFault::none) reading.fault = lost;
  return reading;
}

void ForeignDevice::send(DeviceN force, std::int64_t now_ns) RELIEVO_REALTIME {
  page_end_.send(**page_, force, now_ns);
}

std::optional<HeatReport> ForeignDevice::heat() const {
  return page_ ? heatOf(**page_, info_.max_force_n) : std::nullopt;
}

void ForeignDevice::cutForce() noexcept {
  (*page_)->cuts.fetch_add(1, std::memory_order_acq_rel);
}

}  // namespace relievo::foreign
