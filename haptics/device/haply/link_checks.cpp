// SPDX-License-Identifier: BSD-3-Clause
// What is asked of every answer before a force is shown: is it set up as ours, can the hand have
// come there, is what was sent what is shown, and is the device ready?
#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/device/haply/link.h"

namespace relievo::haply {

namespace {
constexpr double kReachMm = 500;  // No arm of Haply's is as long.
constexpr double kJumpMm = 5;     // In a millisecond: faster than a hand.
/// More than a rest between two questions, less than a set-up may take.
constexpr std::int64_t kGapNs = 200'000'000;

/// The fault that the loop is told where the state is no answer to one already.
DeviceFault faultOf(LinkState state) {
  const bool waits = state == LinkState::no_power || state == LinkState::not_started ||
                     state == LinkState::not_calibrated;
  return waits ? DeviceFault::not_ready : DeviceFault::protocol;
}

}  // namespace

void Link::follow(const ServiceDevice& device, std::int64_t now_ns) {
  const bool was_ready = status_.state == LinkState::ready;
  if (device.has_status) told_state_ = stateOf(device);
  const DeviceMm place = device.place ? deviceFromService(*device.place) : DeviceMm{};
  const bool possible = device.place && std::max({std::abs(place.x), std::abs(place.y),
                                                  std::abs(place.z)}) < kReachMm;
  const double ms = 1e-6 * static_cast<double>(now_ns - reading_.time_ns);
  const bool jumped = was_ready && possible && reading_.fault == DeviceFault::none &&
                      norm(place - reading_.position) > kJumpMm * std::max(1.0, ms);
  if (jumped) {
    // Perhaps the axes were changed: no force until that is known.
    ++status_.counts.jumps;
    interrupt(DeviceFault::protocol, now_ns);
    set_up_.doubt(now_ns);
  }
  if (possible) {
    reading_.position = place;
    reading_.time_ns = now_ns;
  } else {
    ++status_.counts.nonsense;
  }
  set_up_.check(device, now_ns);
  checkEcho(device, now_ns);
  const LinkState state = possible ? judge(now_ns) : LinkState::checking;
  if (was_ready && state != LinkState::ready && !jumped) interrupt(faultOf(state), now_ns);
  setState(state, now_ns);
  if (state == LinkState::ready) {
    reading_.fault = DeviceFault::none;
  } else if (reading_.fault == DeviceFault::none) {
    reading_.fault = DeviceFault::not_ready;
  }
}

/// This program stood still, or the computer did: what comes first was asked before.
void Link::forgiveGap(std::int64_t now_ns) {
  if (now_ns - answered_ns_ >= kGapNs) set_up_.forgiveGap(now_ns);
}

void Link::checkEcho(const ServiceDevice& device, std::int64_t now_ns) {
  if (!device.force) return;  // Older services tell none.
  const bool obeyed = !echo_.isDisobeyed();
  echo_.check(*device.force, now_ns);
  if (!obeyed || !echo_.isDisobeyed()) return;
  status_.ordered_n = echo_.orderedN();
  status_.told_n = echo_.toldN();
}

LinkState Link::judge(std::int64_t now_ns) const {
  if (questions_.underWay() > 0 && status_.state == LinkState::silent) return LinkState::silent;
  if (set_up_.state() == SetUpCheck::State::foreign) return LinkState::foreign;
  if (echo_.isDisobeyed()) return LinkState::disobeyed;
  if (echo_.wasPushed(now_ns)) return LinkState::pushed;
  if (told_state_ != LinkState::ready) return told_state_;
  return set_up_.state() == SetUpCheck::State::ours ? LinkState::ready : LinkState::checking;
}

/// A button that was down before an interruption presses nothing until it was let go.
void Link::takeButtons(std::uint32_t buttons) {
  held_over_ &= buttons;
  reading_.buttons = buttons & ~held_over_;
}

}  // namespace relievo::haply
