// SPDX-License-Identifier: BSD-3-Clause
// What is asked of every answer before a force is shown: is it set up as ours, can the hand have
// come there, is what was sent what is shown, and is the device ready?
#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/device/haply/link.h"

namespace relievo::haply {

namespace {
constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kSetUpNs = 500 * kMs;       // So long it may take until ours is told.
constexpr std::int64_t kToldAgainNs = 1000 * kMs;  // So long without any configuration is doubt.
constexpr std::int64_t kForeignNs = 10'000 * kMs;  // Twice in this time: others insist.
constexpr double kReachMm = 500;                   // No arm of Haply's is as long.
constexpr double kJumpMm = 5;                      // In a millisecond: faster than a hand.
constexpr double kMuchN = 0.5, kHeardPart = 0.1;
constexpr int kUnheard = 50;
constexpr double kExcessN = 1;
constexpr std::int64_t kExcessNs = 20 * kMs, kPushedNs = 2000 * kMs;
constexpr int kExcesses = 10;
constexpr std::int64_t kToldLateNs = 50 * kMs;  // What is told may be of so long before.
constexpr std::size_t kLastAsks = 4;            // And of one of these, however slow they are.
constexpr std::int64_t kSteadyNs = 100 * kMs;   // So long a service may smooth what it tells.
/// More than a rest between two questions, less than a set-up may take.
constexpr std::int64_t kGapNs = 200 * kMs;

/// The fault that the loop is told where the state is no answer to one already.
DeviceFault faultOf(LinkState state) {
  const bool waits = state == LinkState::no_power || state == LinkState::not_started ||
                     state == LinkState::not_calibrated;
  return waits ? DeviceFault::not_ready : DeviceFault::protocol;
}

/// How far a force is from a part of what was sent: a service may damp, and may not add.
double beyond(ServiceN told, ServiceN sent) {
  const double sent2 = dot(sent, sent);
  const double part = sent2 > 0 ? std::clamp(dot(told, sent) / sent2, 0.0, 1.0) : 0;
  return norm(told - part * sent);
}
}  // namespace

void Link::setUpAnew(std::int64_t now_ns) {
  set_up_ = SetUp::asked;
  set_up_ns_ = told_ns_ = now_ns;
  configure_next_ = true;
  mount_.reset();
  ++status_.counts.configurations;
}

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
    set_up_ = SetUp::asked;
    set_up_ns_ = now_ns;
  }
  if (possible) {
    reading_.position = place;
    reading_.time_ns = now_ns;
  } else {
    ++status_.counts.nonsense;
  }
  checkSetUp(device, now_ns);
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

void Link::checkSetUp(const ServiceDevice& device, std::int64_t now_ns) {
  if (set_up_ == SetUp::foreign) {
    if (now_ns - set_up_ns_ >= kForeignNs) setUpAnew(now_ns);
    return;
  }
  const auto others = [&] {
    const bool again = foreign_ns_ != 0 && now_ns - foreign_ns_ < kForeignNs;
    foreign_ns_ = now_ns;
    setUpAnew(now_ns);
    if (!again) return;
    set_up_ = SetUp::foreign;
    configure_next_ = false;
  };
  const bool turned = !device.transform.isLike({});
  if (device.has_configuration) {
    told_ns_ = now_ns;
    const bool ours = !turned && device.preset.view() == kPreset &&
                      (device.basis.empty() || device.basis.view() == kBasis) &&
                      (!mount_ || mount_->isLike(device.mount));
    if (ours) {
      mount_ = device.mount;
      set_up_ = SetUp::ours;
      return;
    }
    // Until ours was told, it may not have been done yet.
    if (set_up_ == SetUp::ours || mount_) return others();
  } else if (turned && set_up_ == SetUp::ours) {
    return others();
  }
  const bool too_long =
      set_up_ == SetUp::asked ? now_ns - set_up_ns_ >= kSetUpNs : now_ns - told_ns_ >= kToldAgainNs;
  if (too_long) others();
}

/// This program stood still, or the computer did: what comes first was asked before, and nobody
/// failed to tell the set-up meanwhile.
void Link::forgiveGap(std::int64_t now_ns) {
  if (now_ns - answered_ns_ < kGapNs) return;
  told_ns_ = now_ns;
  if (set_up_ == SetUp::asked) set_up_ns_ = now_ns;
}

void Link::noteSent(ServiceN force, std::int64_t now_ns) {
  for (const Sent& sent : sent_) {
    // Whoever still told that would seem to push.
    if (now_ns - sent.time_ns <= kToldLateNs && beyond(sent.force, force) > kExcessN) {
      unsteady_ns_ = now_ns;
    }
  }
  std::rotate(sent_.begin(), sent_.end() - 1, sent_.end());
  sent_.front() = {force, now_ns};
}

void Link::checkEcho(const ServiceDevice& device, std::int64_t now_ns) {
  if (!device.force) return;  // Older services tell none.
  checkHeard(norm(*device.force));
  checkExcess(*device.force, now_ns);
}

void Link::checkHeard(double told_n) {
  double least_n = norm(sent_.front().force);
  for (std::size_t i = 1; i < kLastAsks; ++i) {
    least_n = std::min(least_n, norm(sent_[i].force));
  }
  if (least_n <= kMuchN) return;
  unheard_ = told_n < kHeardPart * least_n ? unheard_ + 1 : 0;
  if (unheard_ < kUnheard || disobeyed_) return;
  disobeyed_ = true;
  unheard_ = 0;
  status_.ordered_n = least_n;
  status_.told_n = told_n;
}

void Link::checkExcess(ServiceN told, std::int64_t now_ns) {
  double excess_n = beyond(told, sent_.front().force);
  for (std::size_t i = 1; i < sent_.size(); ++i) {
    if (i >= kLastAsks && now_ns - sent_[i].time_ns > kToldLateNs) break;
    excess_n = std::min(excess_n, beyond(told, sent_[i].force));
  }
  if (excess_n <= kExcessN || now_ns - unsteady_ns_ < kSteadyNs) {
    excess_ns_ = 0;
    excesses_ = 0;
    return;
  }
  if (std::exchange(excesses_, excesses_ + 1) == 0) excess_ns_ = now_ns;
  if (excesses_ >= kExcesses && now_ns - excess_ns_ >= kExcessNs) pushed_ns_ = now_ns;
}

LinkState Link::judge(std::int64_t now_ns) const {
  if (under_way_ > 0 && status_.state == LinkState::silent) return LinkState::silent;
  if (set_up_ == SetUp::foreign) return LinkState::foreign;
  if (disobeyed_) return LinkState::disobeyed;
  if (pushed_ns_ != 0 && now_ns - pushed_ns_ < kPushedNs) return LinkState::pushed;
  if (told_state_ != LinkState::ready) return told_state_;
  return set_up_ == SetUp::ours ? LinkState::ready : LinkState::checking;
}

/// A button that was down before an interruption presses nothing until it was let go.
void Link::takeButtons(std::uint32_t buttons) {
  held_over_ &= buttons;
  reading_.buttons = buttons & ~held_over_;
}

}  // namespace relievo::haply
