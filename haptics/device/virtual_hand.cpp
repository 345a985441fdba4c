// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/virtual_hand.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/failure.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo {

namespace {
constexpr double kMmPerM = 1000;
// Fine enough that halving it changes no figure; coarse enough for a hundred ticks late at once.
constexpr double kStepS = 50e-6;
constexpr double kLongestS = 0.25;  // A longer pause is not simulated: the hand has long settled.

void requireAtLeast(double least, double value, const char* what) {
  if (std::isfinite(value) && value >= least) return;
  throw ArgumentError(std::string("The virtual hand's ") + what + " is " + std::to_string(value) +
                      "; it must be a finite number, " + std::to_string(least) + " or more.");
}

DeviceN shortened(DeviceN force, double most_n) RELIEVO_REALTIME {
  const double size = norm(force);
  if (!std::isfinite(size)) return {};  // Motors cannot follow what is no number.
  return size <= most_n ? force : (most_n / size) * force;
}

double rounded(double value, double step) RELIEVO_REALTIME {
  return step > 0 ? step * std::round(value / step) : value;
}
}  // namespace

VirtualHandOptions virtualHandNamed(std::string_view grip) {
  VirtualHandOptions options;
  std::string known;
  for (const HandImpedance& preset : kHandPresets) {
    if (preset.name == grip) {
      options.hand = preset;
      return options;
    }
    known.append(known.empty() ? "" : ", ").append(preset.name);
  }
  throw failure<MessageId::virtual_hand_unknown>(grip, known);
}

VirtualHand::VirtualHand(const VirtualHandOptions& options) : options_(options) {
  constexpr double kLeastMassKg = 0.001;
  requireAtLeast(kLeastMassKg, options.device_mass_kg, "mass");
  requireAtLeast(0, options.hand.mass_kg, "hand's mass");
  requireAtLeast(0, options.hand.stiffness_n_per_mm, "hand's stiffness");
  requireAtLeast(0, options.hand.damping_n_s_per_mm, "hand's damping");
  requireAtLeast(0, options.device_damping_n_s_per_mm, "damping");
  requireAtLeast(0, options.coulomb_n, "friction");
  requireAtLeast(0, options.position_step_mm, "position step");
  requireAtLeast(0, options.max_force_n, "largest force");
  requireAtLeast(0, options.follow_s, "follower time");
  if (options.delay_ticks < 0 || options.delay_ticks > 2) {
    throw failure<MessageId::virtual_hand_delay>(options.delay_ticks);
  }
  info_.id = "virtual:" + std::string(options.hand.name);
  info_.name = "virtual hand, " + std::string(options.hand.name) + " grip";
  info_.max_force_n = options.max_force_n;
  info_.max_stiffness_n_per_mm = 3;
  info_.max_slew_n_per_s = 200;
  info_.simulated = true;
  info_.position_step_mm = options.position_step_mm;
  info_.force_delay_ticks = options.delay_ticks;
}

void VirtualHand::open() {
  under_way_ = {};
  velocity_ = {};
  cut_ns_.store(0, std::memory_order_relaxed);
  started_ = false;
}

void VirtualHand::moveTo(DeviceMm target) RELIEVO_REALTIME {
  wanted_.position = target;
  wishes_.write(wanted_);
}

void VirtualHand::placeAt(DeviceMm target) RELIEVO_REALTIME {
  ++wanted_.jumps;
  moveTo(target);
}

void VirtualHand::setButtons(std::uint32_t buttons) RELIEVO_REALTIME {
  wanted_.buttons = buttons;
  wishes_.write(wanted_);
}

void VirtualHand::cutForce() noexcept {
  cut_ns_.store(monotonicNs(), std::memory_order_release);
}

// m v' = F + k_h (aim - x) - b v - f_c v/|v|, the dampers implicit so that no step can overshoot,
// dry friction last: it takes speed away and never turns it round.
void VirtualHand::step(double seconds, DeviceN force) RELIEVO_REALTIME {
  const double mass_kg = options_.device_mass_kg + options_.hand.mass_kg;
  const double per_s = seconds * kMmPerM / mass_kg;  // (mm/s) per N over this step.
  const double damping = options_.device_damping_n_s_per_mm + options_.hand.damping_n_s_per_mm;
  const double k = options_.hand.stiffness_n_per_mm;
  const double slow = 1 / (1 + per_s * damping);
  DeviceMmPerS v{slow * (velocity_.x + per_s * (force.x + k * (aim_.x - position_.x))),
                 slow * (velocity_.y + per_s * (force.y + k * (aim_.y - position_.y))),
                 slow * (velocity_.z + per_s * (force.z + k * (aim_.z - position_.z)))};
  const double speed = norm(v), lost = per_s * options_.coulomb_n;
  v = speed <= lost ? DeviceMmPerS{} : (1 - lost / speed) * v;
  velocity_ = v;
  position_ = position_ + DeviceMm{seconds * v.x, seconds * v.y, seconds * v.z};
}

void VirtualHand::advance(double seconds, DeviceN force, const HandWish& wish) RELIEVO_REALTIME {
  if (!(seconds > 0)) return;
  const double time = std::min(seconds, kLongestS);
  const auto steps = static_cast<int>(std::ceil(time / kStepS - 1e-9));
  const double h = time / steps;
  const double toward = options_.follow_s > 0 ? -std::expm1(-h / options_.follow_s) : 1;
  for (int i = 0; i < steps; ++i) {
    aim_ = aim_ + toward * (wish.position - aim_);
    step(h, force);
  }
}

void VirtualHand::send(DeviceN force, std::int64_t /*now_ns*/) RELIEVO_REALTIME {
  const auto last = static_cast<std::size_t>(options_.delay_ticks);
  for (std::size_t i = 0; i < last; ++i) under_way_[i] = under_way_[i + 1];
  under_way_[last] = force;
}

DeviceReading VirtualHand::read(std::int64_t now_ns) RELIEVO_REALTIME {
  wishes_.update();
  const HandWish& wish = wishes_.front();
  const std::int64_t cut_ns = cut_ns_.exchange(0, std::memory_order_acquire);
  if (!isFinite(wish.position)) {
    last_ns_ = now_ns;
    return {wish.position, wish.buttons, now_ns, DeviceFault::none};
  }
  if (!started_ || wish.jumps != jumps_) {
    position_ = aim_ = wish.position;
    velocity_ = {};
    jumps_ = wish.jumps;
    started_ = true;
  } else {
    const DeviceN felt = shortened(under_way_[0], options_.max_force_n);
    const std::int64_t until = cut_ns > last_ns_ ? std::min(cut_ns, now_ns) : now_ns;
    advance(1e-9 * static_cast<double>(until - last_ns_), felt, wish);
    advance(1e-9 * static_cast<double>(now_ns - until), {}, wish);
  }
  last_ns_ = now_ns;
  if (cut_ns != 0) under_way_ = {};
  const double step_mm = options_.position_step_mm;
  return {
      {rounded(position_.x, step_mm), rounded(position_.y, step_mm), rounded(position_.z, step_mm)},
      wish.buttons,
      now_ns,
      DeviceFault::none};
}

}  // namespace relievo
