// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "haptics/rt/realtime.h"

namespace relievo {

/// How often the loop really ticks and the device really says where the hand is; the slower of the
/// two counts. Works on the times of ticks and readings alone, so that a replay comes to the same.
/// [haptic loop]
class RateWatch {
 public:
  static constexpr double kLeastHz = 800;                 ///< Below it, E306.
  static constexpr std::int64_t kWindowNs = 250'000'000;  ///< One measurement.
  /// A longer gap counts as so long: it is a pause, after which the force starts from zero anyway.
  static constexpr std::int64_t kLongestNs = 20'000'000;
  static constexpr std::int64_t kRecoverNs = 2'000'000'000;  ///< Good for so long: it is over.

  /// @param now_ns      of the tick
  /// @param reading_ns  of the hand's place
  void tick(std::int64_t now_ns, std::int64_t reading_ns) RELIEVO_REALTIME;
  /// The slowest measurement since it became slow, per second; 0: it is not slow.
  double slowHz() const RELIEVO_REALTIME { return slow_hz_; }
  void reset() RELIEVO_REALTIME { *this = {}; }

 private:
  friend struct NamedFields;  // Recordings hold every member by its name.
  void measured(double hz, std::int64_t now_ns) RELIEVO_REALTIME;

  bool started_ = false;
  std::int64_t now_ns_ = 0, passed_ns_ = 0, reading_ns_ = 0;
  std::int32_t ticks_ = 0, readings_ = 0;  // Since the mark.
  double slow_hz_ = 0;
  std::int64_t slow_ns_ = 0;  // The last slow measurement.
};

}  // namespace relievo
