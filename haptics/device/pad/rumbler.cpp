// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/pad/rumbler.h"

namespace relievo::pad {

namespace {
constexpr std::int64_t kRenewNs = 100'000'000;
}

Rumbler::~Rumbler() {
  for (RumbleMotor* motor = nullptr; added_.pop(motor);) delete motor;
  for (const Pad& pad : pads_) pad.motor->stop();
}

void Rumbler::add(std::unique_ptr<RumbleMotor> motor) {
  if (added_.push(motor.get())) [[maybe_unused]]
    RumbleMotor* const passed_on = motor.release();
}

/// @return false: it is gone
bool Rumbler::update(Pad& pad, RumbleLevel level, std::int64_t now_ns) noexcept {
  if (!level.any()) {
    if (!pad.shown.any()) return true;
    pad.shown = level;
    return pad.motor->stop();
  }
  if (level == pad.shown && now_ns - pad.shown_ns < kRenewNs) return true;
  pad.shown = level;
  pad.shown_ns = now_ns;
  return pad.motor->show(level, kMostMs);
}

void Rumbler::take(std::span<const TouchMoment> moments, std::int64_t now_ns) {
  for (RumbleMotor* motor = nullptr; added_.pop(motor);) {
    pads_.push_back({std::unique_ptr<RumbleMotor>(motor), {}, 0});
  }
  const RumbleLevel asked = cue_.next(moments, now_ns);
  const RumbleLevel level = on_.load(std::memory_order_relaxed) ? asked : RumbleLevel{};
  std::erase_if(pads_, [&](Pad& pad) { return !update(pad, level, now_ns); });
}

}  // namespace relievo::pad
