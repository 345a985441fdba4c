// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/link.h"

#include <algorithm>
#include <utility>

namespace relievo::falcon {

namespace {
constexpr std::int64_t kMs = 1'000'000;
constexpr std::size_t kReadBytes = 512;
}  // namespace

Link::Link(Bus& bus, LinkMailbox& mailbox, FirmwareSource firmware, LinkLimits limits)
    : bus_(bus), mailbox_(mailbox), firmware_(std::move(firmware)), limits_(limits) {
  status_.attempts = limits.attempts;
}

void Link::run(const std::stop_token& stop, std::unique_ptr<Port> port) {
  slept_ = bus_.slept();
  while (!stop.stop_requested()) {
    if (!port) port = waitForDevice(stop, true);
    if (!port) break;
    serve(stop, port);
    port_ = nullptr;
    port.reset();
  }
  interrupt(DeviceFault::not_ready, bus_.now());
  setState(LinkState::closed);
}

/// @return null: stopped, or absent and that is not waited for
std::unique_ptr<Port> Link::waitForDevice(const std::stop_token& stop, bool also_absent) {
  while (!stop.stop_requested()) {
    Opening opening = bus_.open();
    switch (opening.presence) {
      case Presence::present:
        return std::move(opening.port);
      case Presence::absent:
        if (!also_absent) return nullptr;
        setState(LinkState::absent);
        break;
      case Presence::forbidden:
        setState(LinkState::forbidden);
        break;
      case Presence::busy:
        setState(LinkState::busy);
        break;
      case Presence::broken:
        setState(LinkState::broken, opening.detail);
        break;
    }
    // An absent one announces itself; the others can change without a sign. Short enough that
    // closing never takes long.
    const std::int64_t give_up = bus_.now() + 1000 * kMs;
    while (!stop.stop_requested() && bus_.now() < give_up) {
      const std::int64_t before = bus_.now();
      bus_.waitForChange(std::min(give_up, before + 100 * kMs));
      if (bus_.now() - before < 99 * kMs) break;  // Something changed.
    }
  }
  return nullptr;
}

void Link::serve(const std::stop_token& stop, std::unique_ptr<Port>& port) {
  port_ = port.get();
  setState(LinkState::checking);
  constexpr int kQuestions = 5;
  bool running = prepareToRun() && answers(kQuestions);
  status_.firmware_was_running = running;
  while (!stop.stop_requested()) {
    if (!running && !start(stop, port)) break;
    const Leave leave = operate(stop);
    if (leave != Leave::silent) break;
    setState(LinkState::checking);
    running = prepareToRun() && answers(kQuestions);
  }
  const bool gone = port_ == nullptr || !stop.stop_requested();
  if (gone) {
    ++status_.unplugged;
    interrupt(DeviceFault::disconnected, bus_.now());
  }
}

bool Link::requestAll(std::initializer_list<BridgeRequest> requests) {
  return std::all_of(requests.begin(), requests.end(), [this](const BridgeRequest& request) {
    return port_->request(request) == PortResult::ok;
  });
}

bool Link::prepareToRun() {
  const bool done = requestAll(
      {kPurge1, kPurge2, latencyTimer(1), kRunBaud, kData8N1, kFlowOff, kPurge1, kPurge2});
  port_->discardInput();
  reader_.reset();
  resting_ = false;
  return done;
}

bool Link::answers(int questions) {
  const Frame neutral = encode({.lights = red});
  for (int i = 0; i < questions; ++i) {
    if (port_->write(neutral) == PortResult::gone) return false;
    const std::int64_t until = bus_.now() + 40 * kMs;
    std::array<std::uint8_t, kReadBytes> bytes{};
    while (bus_.now() < until) {
      const Port::Incoming in = port_->read(bytes, until);
      if (in.result == PortResult::gone) return false;
      for (std::size_t k = 0; k < in.bytes; ++k) {
        if (reader_.take(bytes[k])) return true;
      }
    }
  }
  return false;
}

/// @return false: unplugged or stopped
bool Link::waitForRetry(const std::stop_token& stop, std::int64_t most_ns) {
  std::array<std::uint8_t, kReadBytes> bytes{};
  const std::int64_t began_ns = bus_.now();
  while (!stop.stop_requested()) {
    if (bus_.now() - began_ns >= most_ns) return true;
    // The latency timer at its longest: two packets a second say that it is still plugged in.
    if (port_->request(latencyTimer(255)) == PortResult::gone) return false;
    const std::int64_t until = bus_.now() + 200 * kMs;
    while (bus_.now() < until) {
      if (port_->read(bytes, until).result == PortResult::gone) return false;
    }
    mailbox_.wishes.update();
    if (mailbox_.wishes.front().retries != retries_seen_) {
      retries_seen_ = mailbox_.wishes.front().retries;
      return true;
    }
  }
  return false;
}

void Link::interrupt(DeviceFault fault, std::int64_t now_ns) {
  ++reading_.epoch;
  reading_.interruption = fault;
  reading_.fault = fault;
  reading_.time_ns = now_ns;
  reading_.buttons = 0;
  button_frames_ = {};
  gate_ns_ = now_ns;
  zero_next_ = true;
  mailbox_.readings.write(reading_);
}

void Link::setState(LinkState state, const std::string& detail) {
  if (state == LinkState::homing && status_.state != state) homing_since_ns_ = bus_.now();
  if (state != LinkState::homing) status_.homing_is_long = false;
  status_.state = state;
  status_.detail.fill('\0');
  detail.copy(status_.detail.data(), status_.detail.size() - 1);
  if (state != LinkState::ready && reading_.fault == DeviceFault::none) {
    interrupt(DeviceFault::not_ready, bus_.now());
  }
  publishStatus();
}

void Link::publishStatus() {
  if (port_ != nullptr) {
    const LineErrors errors = port_->lineErrors();
    status_.counts.overruns = errors.overruns;
    status_.counts.framing = errors.framing;
  }
  status_.counts.malformed = reader_.malformed();
  mailbox_.status.write(status_);
}

void Link::publishReading(std::int64_t now_ns) {
  reading_.time_ns = now_ns;
  mailbox_.readings.write(reading_);
}

}  // namespace relievo::falcon
