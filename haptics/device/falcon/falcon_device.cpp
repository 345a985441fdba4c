// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/falcon_device.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include "core/base/failure.h"
#include "haptics/rt/realtime_thread.h"
#include "haptics/rt/signal_stack.h"

namespace relievo::falcon {

namespace {
constexpr int kPriority = 75;  // Below the loop and its watchdog: this thread calls libusb.

std::uint32_t withPlusAndMinusSwapped(std::uint32_t buttons) RELIEVO_REALTIME {
  return (buttons & 0b0110U) | (buttons & 1U) << 3U | (buttons >> 3U & 1U);
}
}  // namespace

FalconDevice::FalconDevice(std::unique_ptr<Bus> bus, FirmwareSource firmware,
                           FalconSettings settings, LinkLimits limits)
    : settings_(std::move(settings)),
      bus_(std::move(bus)),
      chosen_(bus_->choice()),
      firmware_(std::move(firmware)),
      limits_(limits) {
  giveSignalStack();  // The owner's thread, too, sends last words when its stack overflows.
  info_.id = idOf(chosen_);
  info_.name = nameOf(chosen_);
  // Reachable all round at every height in it (falcon geometry: 50 mm at z = 160).
  info_.workspace.half_extent = {40, 40, 35};
  info_.max_force_n = limits.max_force_n;
  info_.max_stiffness_n_per_mm = 1.5;
  info_.max_damping_n_s_per_mm = 0.006;  // Its encoders are too coarse for more at 1 kHz.
  info_.max_slew_n_per_s = 200;
  info_.position_step_mm = 0.048;  // Sideways in the middle; 0.028 in and out.
  info_.force_delay_ticks = 2;     // Up to one until it is sent, one until the motors show it.
  // Novint's firmware drives the motors as it is told and nothing more
  // (docs/dev/falcon-unknowns.md).
  info_.holds_its_grip = false;
  info_.grip_weight_n = std::clamp(settings_.grip_weight_n, 0.0, kMostGripN);
  setGain(settings_.counts_per_n_mm);
}

FalconDevice::~FalconDevice() {
  close();
}

void FalconDevice::open() {
  if (thread_.joinable()) return;
  Opening opening = bus_->open();
  if (opening.presence != Presence::present) {
    const LinkStatus status = statusOf(opening);
    mailbox_.status.write(status);
    throw OpeningError(opening.presence, describe(status));
  }
  setName({opening.which.serial, opening.which.port});
  start(std::move(opening));
}

void FalconDevice::openWhenPlugged() {
  if (!thread_.joinable()) start({});
}

/// The whole name says which one it was, in recordings and reports; the id is what names it again.
void FalconDevice::setName(const FalconChoice& which) {
  const std::string name = nameOf(which);
  if (name == info_.name) return;
  info_.name = name;
  if (chosen_.any() && !which.any()) {
    const SeenFalcon only{.serial = which.serial, .port = which.port};
    info_.id = idOf(shortestChoice(only, {&only, 1}));
  }
}

void FalconDevice::start(Opening opening) {
  try {
    thread_ = std::jthread([this, o = std::move(opening)](const std::stop_token& stop) mutable {
      // Refused like the loop's own, which says so: an answer that waits for a drawing thread is a
      // force that comes late.
      [[maybe_unused]] const RealtimeGrant grant = requestRealtime(kPriority, {});
      Link(*bus_, mailbox_, firmware_, limits_).run(stop, std::move(o));
    });
  } catch (const std::system_error& error) {
    throw failure<MessageId::falcon_thread_not_started>(error.what());
  }
}

void FalconDevice::close() noexcept {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

void FalconDevice::send(DeviceN force, std::int64_t now_ns) RELIEVO_REALTIME {
  mailbox_.orders.write(loop_end_.order(force, now_ns));
}

DeviceReading FalconDevice::read(std::int64_t /*now_ns*/) RELIEVO_REALTIME {
  const std::uint32_t cuts = mailbox_.cuts.load();  // Before the reading: see LoopEnd.
  mailbox_.readings.update();
  DeviceReading reading = loop_end_.take(cuts, mailbox_.readings.front());
  if (settings_.left_handed) reading.buttons = withPlusAndMinusSwapped(reading.buttons);
  return reading;
}

const LinkStatus& FalconDevice::status() {
  mailbox_.status.update();
  const LinkStatus& now = mailbox_.status.front();
  if (now.port[0] != '\0' || now.serial[0] != '\0') setName({now.serial.data(), now.port.data()});
  return now;
}

void FalconDevice::retry() {
  ++command_.retries;
  mailbox_.commands.write(command_);
}

void FalconDevice::measureTimesAnew() {
  ++command_.measurements;
  mailbox_.commands.write(command_);
}

void FalconDevice::setGain(double counts_per_n_mm) {
  const double gain = std::isfinite(counts_per_n_mm) ? counts_per_n_mm : kNominalCountsPerNmm / 2;
  command_.counts_per_n_mm = std::clamp(gain, kLeastCountsPerNmm, kMostCountsPerNmm);
  mailbox_.commands.write(command_);
}

void FalconDevice::showLights(std::uint8_t lights) {
  command_.show_lights = true;
  command_.lights = lights;
  mailbox_.commands.write(command_);
}

void FalconDevice::showStateLights() {
  command_.show_lights = false;
  mailbox_.commands.write(command_);
}

}  // namespace relievo::falcon
