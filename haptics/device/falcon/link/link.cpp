// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/link/link.h"

#include <algorithm>
#include <utility>

namespace relievo::falcon {

namespace {
constexpr std::int64_t kMs = 1'000'000;
constexpr std::size_t kReadBytes = 512;
/// Between openings: whatever fails, and however fast, there are never more than fifty a second; of
/// a connection that goes on failing, one in ten seconds.
constexpr std::int64_t kLeastPauseNs = 20 * kMs, kLongestPauseNs = 10'000 * kMs;
}  // namespace

Link::Link(Bus& bus, LinkMailbox& mailbox, FirmwareSource firmware, LinkLimits limits)
    : bus_(bus),
      mailbox_(mailbox),
      firmware_(std::move(firmware)),
      limits_(limits),
      force_ramp_(limits) {
  status_.attempts = limits.attempts;
}

void Link::run(const std::stop_token& stop, Opening opening) {
  slept_ = bus_.slept();
  if (opening.port) take(opening, status_);
  std::unique_ptr<Port> port = std::move(opening.port);
  known_present_ = port != nullptr;
  while (!stop.stop_requested()) {
    if (!port) port = waitForDevice(stop, true);
    if (!port) break;
    serve(stop, port);
    close(port, stop.stop_requested());
    if (!stop.stop_requested()) waitAfterFailure(stop);
  }
  interrupt(DeviceFault::not_ready, bus_.now());
  setState(LinkState::closed);
}

/// @return null: stopped, or absent and that is not waited for
std::unique_ptr<Port> Link::waitForDevice(const std::stop_token& stop, bool also_absent) {
  while (!stop.stop_requested()) {
    Opening opening = bus_.open();
    take(opening, status_);
    switch (opening.presence) {
      case Presence::present:
        known_present_ = true;
        return std::move(opening.port);
      case Presence::absent:
      case Presence::several:  // Of the same serial number: which one it was is not known.
        if (std::exchange(known_present_, false)) {
          ++status_.unplugged;
          interrupt(DeviceFault::disconnected, bus_.now());
        }
        if (!also_absent) return nullptr;
        setState(opening.presence == Presence::absent ? LinkState::absent : LinkState::several);
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
    // An absent one announces itself; the others can change without a sign.
    pause(stop, 1000 * kMs);
  }
  return nullptr;
}

/// Ends early when something was plugged or pulled, or another try was asked for.
/// @return false: stopped
bool Link::pause(const std::stop_token& stop, std::int64_t most_ns) {
  const std::int64_t began_ns = bus_.now();
  bool changed = false;
  while (!stop.stop_requested()) {
    const std::int64_t now = bus_.now();
    if (now - began_ns >= (changed ? std::min(kLeastPauseNs, most_ns) : most_ns)) return true;
    mailbox_.commands.update();
    if (mailbox_.commands.front().retries != seen_.retries) {
      seen_.retries = mailbox_.commands.front().retries;
      status_.failed_openings = 0;
      changed = true;
    }
    // Short enough that closing never takes long.
    const std::int64_t until = std::min(began_ns + most_ns, now + 100 * kMs);
    bus_.waitForChange(until);
    changed = changed || bus_.now() < until;
  }
  return false;
}

/// The connection was lost, yet the device may still be there: then it is opened anew, after longer
/// and longer pauses.
void Link::waitAfterFailure(const std::stop_token& stop) {
  const int failed = ++status_.failed_openings;
  // Once can be the plug, which is told when it is found to be out.
  if (failed > 1) setState(failed < limits_.attempts ? LinkState::silent : LinkState::not_started);
  constexpr int kDoublings = 9;
  pause(stop, std::min(kLongestPauseNs, kLeastPauseNs << std::min(failed - 1, kDoublings)));
}

/// Motors at zero first, if it takes anything at all: nobody else sends that once it is closed.
void Link::close(std::unique_ptr<Port>& port, bool for_good) {
  if (port && lost_ != PortResult::gone) {
    if (!runs_) port->request(kRunBaud);
    sendNeutralFrame(for_good ? encode({.homing = false}) : encode({.lights = red}));
  }
  port_ = nullptr;
  port.reset();
}

void Link::serve(const std::stop_token& stop, std::unique_ptr<Port>& port) {
  port_ = port.get();
  lost_ = PortResult::ok;
  if (status_.failed_openings == 0 || status_.state == LinkState::absent) {
    setState(LinkState::checking);
  }
  constexpr int kQuestions = 5;
  bool running = prepareToRun() && answers(kQuestions);
  status_.firmware_was_running = running;
  while (!stop.stop_requested() && lost_ == PortResult::ok) {
    if (!running && !start(stop, port)) break;
    const Leave leave = operate(stop);
    if (leave != Leave::silent) break;
    setState(LinkState::checking);
    running = prepareToRun() && answers(kQuestions);
  }
  forgetButtons();
  status_.homed = 0;
  if (stop.stop_requested()) return interrupt(DeviceFault::not_ready, bus_.now());
  interrupt(lost_ == PortResult::failed ? DeviceFault::timeout : DeviceFault::disconnected,
            bus_.now());
}

PortResult Link::request(const BridgeRequest& request) {
  const PortResult result = port_->request(request);
  if (result == PortResult::gone) lost_ = result;
  return result;
}

PortResult Link::write(std::span<const std::uint8_t> bytes) {
  const PortResult result = port_->write(bytes);
  if (result == PortResult::gone) lost_ = result;
  return result;
}

/// @return false: the connection is lost
bool Link::read(std::span<std::uint8_t> into, std::int64_t until_ns, std::size_t& bytes) {
  const Port::Incoming in = port_->read(into, until_ns);
  bytes = in.bytes;
  if (in.damaged) reader_.reset();
  if (in.result == PortResult::gone || in.result == PortResult::failed) lost_ = in.result;
  return lost_ == PortResult::ok;
}

bool Link::requestAll(std::initializer_list<BridgeRequest> requests) {
  return std::all_of(requests.begin(), requests.end(), [this](const BridgeRequest& request) {
    return this->request(request) == PortResult::ok;
  });
}

bool Link::prepareToRun() {
  const bool done = requestAll(
      {kPurge1, kPurge2, latencyTimer(1), kRunBaud, kData8N1, kFlowOff, kPurge1, kPurge2});
  port_->discardInput();
  reader_.reset();
  resting_ = false;
  runs_ = true;
  return done;
}

bool Link::answers(int questions) {
  const Frame neutral = encode({.lights = red});
  for (int i = 0; i < questions; ++i) {
    if (write(neutral) == PortResult::gone) return false;
    const std::int64_t until = bus_.now() + 40 * kMs;
    std::array<std::uint8_t, kReadBytes> bytes{};
    while (bus_.now() < until) {
      std::size_t got = 0;
      if (!read(bytes, until, got)) return false;
      for (std::size_t k = 0; k < got; ++k) {
        if (reader_.take(bytes[k])) return true;
      }
    }
  }
  return false;
}

/// @return false: connection lost, or stopped
bool Link::waitForRetry(const std::stop_token& stop, std::int64_t most_ns) {
  std::array<std::uint8_t, kReadBytes> bytes{};
  const std::int64_t began_ns = bus_.now();
  while (!stop.stop_requested()) {
    if (bus_.now() - began_ns >= most_ns) return true;
    // The latency timer at its longest: two packets a second say that it is still plugged in.
    if (request(latencyTimer(255)) == PortResult::gone) return false;
    const std::int64_t until = bus_.now() + 200 * kMs;
    while (bus_.now() < until) {
      std::size_t got = 0;
      if (!read(bytes, until, got)) return false;
    }
    mailbox_.commands.update();
    if (mailbox_.commands.front().retries != seen_.retries) {
      seen_.retries = mailbox_.commands.front().retries;
      return true;
    }
  }
  return false;
}

void Link::interrupt(DeviceFault fault, std::int64_t now_ns) {
  reading_.interrupt(fault, now_ns);
  buttons_.interrupt();
  force_ramp_.shut(now_ns);
  zero_next_ = true;
  mailbox_.readings.write(reading_);
}

void Link::setState(LinkState state, const std::optional<Message>& detail) {
  if (state == LinkState::homing && status_.state != state) homing_.begin(bus_.now());
  if (state != LinkState::homing) status_.homing_is_long = false;
  status_.state = state;
  status_.detail_size = 0;
  if (detail) putDetail(*detail, status_);
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
    status_.counts.parity = errors.parity;
  }
  status_.counts.malformed = reader_.malformed();
  mailbox_.status.write(status_);
}

void Link::publishReading(std::int64_t now_ns) {
  reading_.time_ns = now_ns;
  mailbox_.readings.write(reading_);
}

}  // namespace relievo::falcon
