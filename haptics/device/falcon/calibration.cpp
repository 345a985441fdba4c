// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/calibration.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/failure.h"

namespace relievo::falcon {

namespace {
constexpr double kLeastGrams = 20, kMostGrams = 300;
constexpr double kNPerGram = 9.80665e-3;
// A soft hold: any stiffness does, because the integral carries the weight in the end.
constexpr double kNPerMm = 0.12, kNPerMmS = 0.25, kNsPerMm = 0.003;
constexpr double kMostHoldN = 4;
constexpr double kMeanSeconds = 0.5, kLeastSeconds = 3, kMostSeconds = 20;
constexpr double kSteadyN = 0.01;
constexpr double kLateS = 0.02;    // Of ourselves: then the driver shows no force.
constexpr double kRecoverS = 0.5;  // Until the grip is back in its place.

/// Each let the force rise from zero again.
std::uint64_t interruptions(const LinkCounts& counts) {
  return counts.hiccups + counts.malformed + counts.stalls + counts.impossible_poses +
         counts.failed_reads;
}
}  // namespace

Calibration::Calibration(FalconDevice& device, double counts_per_n_mm, double weight_g)
    : device_(device), counts_per_n_mm_(counts_per_n_mm), weight_n_(kNPerGram * weight_g) {
  if (!(weight_g >= kLeastGrams && weight_g <= kMostGrams)) {
    throw failure<MessageId::calibration_weight>();
  }
}

void Calibration::fail(Message why) {
  phase_ = Phase::failed;
  why_ = std::move(why);
  force_ = {};
}

DeviceN Calibration::holdingForce(const DeviceReading& reading, double dt_s) {
  if (!place_) {
    place_ = reading.position;
    last_position_ = reading.position;
  }
  const DeviceMm off = *place_ - reading.position;
  const DeviceMm way = reading.position - last_position_;
  last_position_ = reading.position;
  const auto axis = [dt_s](double error, double step, double& integral) {
    integral = std::clamp(integral + kNPerMmS * error * dt_s, -kMostHoldN, kMostHoldN);
    const double speed = dt_s > 0 ? step / dt_s : 0;
    return std::clamp(kNPerMm * error + integral - kNsPerMm * speed, -kMostHoldN, kMostHoldN);
  };
  return {axis(off.x, way.x, integral_.x), axis(off.y, way.y, integral_.y),
          axis(off.z, way.z, integral_.z)};
}

bool Calibration::settled(std::int64_t now_ns) {
  const double since_s = 1e-9 * static_cast<double>(now_ns - phase_ns_);
  if (since_s > kMostSeconds) {
    fail(undisturbed_s_ > kLeastSeconds ? said<MessageId::calibration_no_rest>()
                                        : said<MessageId::calibration_interrupted>());
    return false;
  }
  return undisturbed_s_ > kLeastSeconds && drift_n_ < kSteadyN;
}

void Calibration::begin(Phase phase, std::int64_t now_ns) {
  phase_ = phase;
  phase_ns_ = now_ns;
  undisturbed_s_ = 0;
}

// While the force is off or rising again, what is asked for is more than what the motors show.
void Calibration::follow(std::int64_t now_ns, double dt_s) {
  const std::uint64_t interrupted = interruptions(device_.status().counts);
  if (interrupted != interrupted_ || dt_s > kLateS) disturbed_ns_ = now_ns;
  interrupted_ = interrupted;
  if (1e-9 * static_cast<double>(now_ns - disturbed_ns_) < kRecoverS) return;
  undisturbed_s_ += dt_s;
  const double weight = std::min(1.0, dt_s / kMeanSeconds);
  mean_up_n_ += weight * (force_.y - mean_up_n_);
  drift_n_ += weight * (std::abs(force_.y - mean_up_n_) - drift_n_);
}

bool Calibration::step(std::int64_t now_ns) {
  if (phase_ == Phase::done || phase_ == Phase::failed) return false;
  const DeviceReading reading = device_.exchange(force_, now_ns);
  if (reading.fault != DeviceFault::none) {
    fail(messageOf(reading.fault));
    return false;
  }
  if (phase_ns_ == 0) {
    begin(Phase::hold_empty, now_ns);
    last_ns_ = disturbed_ns_ = now_ns;
  }
  const double dt_s = 1e-9 * static_cast<double>(now_ns - last_ns_);
  last_ns_ = now_ns;
  force_ = holdingForce(reading, dt_s);
  follow(now_ns, dt_s);
  switch (phase_) {
    case Phase::hold_empty:
      if (!settled(now_ns)) break;
      empty_n_ = mean_up_n_;
      phase_ = Phase::hang_weight;
      break;
    case Phase::hang_weight:
      if (!weight_hangs_) break;
      begin(Phase::hold_weight, now_ns);
      break;
    case Phase::hold_weight: {
      if (!settled(now_ns)) break;
      const double gain = counts_per_n_mm_ * (mean_up_n_ - empty_n_) / weight_n_;
      if (!(gain > 0.9 * kLeastCountsPerNmm && gain < 1.1 * kMostCountsPerNmm)) {
        fail(said<MessageId::calibration_wrong_weight>(
            std::lround((mean_up_n_ - empty_n_) / kNPerGram)));
        break;
      }
      result_ = std::clamp(gain, kLeastCountsPerNmm, kMostCountsPerNmm);
      // Counts are what was asked for; by the true gain they are this force.
      grip_weight_n_ = std::clamp(counts_per_n_mm_ / *result_ * empty_n_, 0.0, kMostGripN);
      phase_ = Phase::done;
      break;
    }
    case Phase::done:
    case Phase::failed:
      break;
  }
  if (phase_ != Phase::done && phase_ != Phase::failed) return true;
  device_.exchange({}, now_ns);
  return false;
}

Message Calibration::prompt() const {
  switch (phase_) {
    case Phase::hold_empty:
      return said<MessageId::calibration_hands_off>();
    case Phase::hang_weight:
      return said<MessageId::calibration_hang_weight>();
    case Phase::hold_weight:
      return said<MessageId::calibration_holding>();
    case Phase::done:
      return said<MessageId::calibration_done>();
    case Phase::failed:
      break;
  }
  return said<MessageId::calibration_ended>(why_.value());
}

}  // namespace relievo::falcon
