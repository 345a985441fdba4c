// SPDX-License-Identifier: BSD-3-Clause
#include "tests/emulator/falcon_body.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace relievo::emulator {

namespace {
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kDegreesPerCount = 0.0364347;  // 1280 counts a turn, 14.25 mm on 110 mm.
constexpr double kZeroDeg = 35;
constexpr std::array<int, 3> kUnhomedOffset{-1500, 700, 260};
constexpr double kGripKg = 0.15, kHandNPerMm = 0.25, kHandNsPerMm = 0.012;
constexpr double kArmNsPerMm = 0.003;  // Of the arms alone.
}  // namespace

std::optional<Triple> FalconBody::anglesDeg(const Triple& place) {
  constexpr double a = 60, b = 102.5, c = 14.43, de = 22.5, f = -25, r = 40, s = -23.09;
  constexpr Triple azimuth_deg{105, -15, -135};
  Triple angles{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double phi = azimuth_deg[i] * kDegree;
    const double u = place[0] * std::cos(phi) + place[1] * std::sin(phi) - r;
    const double v = place[1] * std::cos(phi) - place[0] * std::sin(phi) - s;
    const double w = place[2];
    const double theta3 = std::acos((v + f) / b);
    const double m = de + b * std::sin(theta3);
    const double big_a = w * w + u * u + 2 * c * u - 2 * a * u + a * a + c * c - m * m - 2 * a * c;
    const double big_b = -4 * a * w;
    const double big_d = w * w + u * u + 2 * c * u + 2 * a * u + a * a + c * c - m * m + 2 * a * c;
    const double theta =
        2 * std::atan((-big_b - std::sqrt(big_b * big_b - 4 * big_a * big_d)) / (2 * big_d));
    if (!std::isfinite(theta)) return std::nullopt;
    angles[i] = theta / kDegree;
    // The arms' stops.
    if (angles[i] < -25 || angles[i] > 95) return std::nullopt;
  }
  return angles;
}

void FalconBody::hold(const Triple& place) {
  held_ = true;
  carried_ = false;
  wanted_ = place;
  velocity_ = {};
  moveTo(place);
}

void FalconBody::carry(const Triple& place) {
  if (homed_ != 7) return hold(place);
  if (!held_) velocity_ = {};
  held_ = carried_ = true;
  wanted_ = place;
}

void FalconBody::carryOn(double seconds) {
  constexpr double kMostMmPerS = 2000, kMostMmPerS2 = 150'000, kStep = 2.5e-4, kThereMm = 0.01;
  for (double left = std::min(seconds, 0.1); left > 0 && carried_; left -= kStep) {
    const double dt = std::min(left, kStep);
    Triple way{};
    double far = 0, change = 0;
    for (std::size_t i = 0; i < 3; ++i) way[i] = wanted_[i] - grip_[i];
    far = std::hypot(way[0], way[1], way[2]);
    if (far < kThereMm) return hold(wanted_);
    const double speed = std::min({kMostMmPerS, std::sqrt(1.6 * kMostMmPerS2 * far), far / dt});
    Triple faster{};
    for (std::size_t i = 0; i < 3; ++i) faster[i] = speed * way[i] / far - velocity_[i];
    change = std::hypot(faster[0], faster[1], faster[2]);
    const double part = std::min(1.0, kMostMmPerS2 * dt / std::max(change, 1e-12));
    Triple next = grip_;
    for (std::size_t i = 0; i < 3; ++i) {
      velocity_[i] += part * faster[i];
      next[i] += dt * velocity_[i];
    }
    moveTo(next);
  }
}

void FalconBody::letGo(double weight_n) {
  held_ = carried_ = false;
  let_go_ = true;
  weight_n_ = weight_n;
}

void FalconBody::pullToward(const Triple& place) {
  held_ = let_go_ = carried_ = false;
  wanted_ = place;
}

void FalconBody::moveTo(const Triple& place) {
  const auto angles = anglesDeg(place);
  if (!angles) {  // Against a stop.
    velocity_ = {};
    return;
  }
  grip_ = place;
  // An arm finds its zero on its way in from far out.
  for (std::size_t i = 0; i < 3; ++i) {
    if ((*angles)[i] > 60) was_out_[i] = true;
    if (was_out_[i] && (*angles)[i] < 0) homed_ |= 1 << i;
  }
}

Triple FalconBody::force() const {
  // Virtual work: F . dp = tau . dtheta, the motors' positive direction lowering theta.
  Triple force{};
  constexpr double kStep = 1e-3;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Triple up = grip_, down = grip_;
    up[axis] += kStep;
    down[axis] -= kStep;
    const auto high = anglesDeg(up), low = anglesDeg(down);
    if (!high || !low) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const double slope = ((*high)[i] - (*low)[i]) * kDegree / (2 * kStep);
      force[axis] += slope * -counts_[i] / counts_per_n_mm;
    }
  }
  return force;
}

void FalconBody::advance(double seconds) {
  if (carried_) carryOn(seconds);
  if (held_) return;
  constexpr double kStep = 2.5e-4;
  for (double left = std::min(seconds, 0.1); left > 0; left -= kStep) {
    const double dt = std::min(left, kStep);
    const Triple motors = force();
    Triple next = grip_;
    for (std::size_t i = 0; i < 3; ++i) {
      const double weight = i == 1 ? -weight_n_ : 0;
      const double hand = let_go_
                              ? weight - kArmNsPerMm * velocity_[i]
                              : kHandNPerMm * (wanted_[i] - grip_[i]) - kHandNsPerMm * velocity_[i];
      velocity_[i] += (hand + motors[i]) / kGripKg * 1000 * dt;  // N/kg are m/s^2.
      next[i] += velocity_[i] * dt;
    }
    moveTo(next);
  }
}

std::array<int, 3> FalconBody::encoders() const {
  std::array<int, 3> counts{};
  const auto angles = anglesDeg(grip_);
  if (!angles) return counts;
  for (std::size_t i = 0; i < 3; ++i) {
    const double count = ((*angles)[i] - kZeroDeg) / kDegreesPerCount;
    counts[i] = static_cast<int>(std::lround(count));
    if ((homed_ >> i & 1) == 0) counts[i] += kUnhomedOffset[i];
  }
  return counts;
}

void FalconBody::forgetHoming(int arms) {
  homed_ &= ~arms;
  for (std::size_t i = 0; i < 3; ++i) {
    if ((arms >> i & 1) != 0) was_out_[i] = false;
  }
}

}  // namespace relievo::emulator
