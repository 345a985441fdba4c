// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "haptics/device/pad/rumble_cue.h"
#include "haptics/rt/spsc_ring.h"

namespace relievo::pad {

/// The motors of one pad. Gone with its cable.
class RumbleMotor {
 public:
  RumbleMotor() = default;
  virtual ~RumbleMotor() = default;
  RumbleMotor(const RumbleMotor&) = delete;
  RumbleMotor& operator=(const RumbleMotor&) = delete;

  /// From now on, for that long at most, in place of what it showed before. @return false: it is
  /// gone, and is not asked again
  virtual bool show(RumbleLevel level, int ms) noexcept = 0;
  virtual bool stop() noexcept = 0;
};

/// Lets all pads rumble as RumbleCue has it. Whatever it shows ends by itself within kMostMs and is
/// renewed before: a program that hangs leaves none rumbling.
class Rumbler {
 public:
  static constexpr int kMostMs = 200;

  Rumbler() = default;
  ~Rumbler();  ///< Stops all. [nobody calls take() any more]
  Rumbler(const Rumbler&) = delete;
  Rumbler& operator=(const Rumbler&) = delete;

  /// Another pad; one of the next take() has it. [owner]
  void add(std::unique_ptr<RumbleMotor> motor);
  /// Off: nothing rumbles from the next take() on. [any thread]
  void setOn(bool on) noexcept { on_.store(on, std::memory_order_relaxed); }
  /// What came since the last call, also if that is nothing; about 100 times a second.
  /// [drain thread]
  void take(std::span<const TouchMoment> moments, std::int64_t now_ns);

 private:
  struct Pad {
    std::unique_ptr<RumbleMotor> motor;
    RumbleLevel shown;
    std::int64_t shown_ns = 0;
  };
  static bool update(Pad& pad, RumbleLevel level, std::int64_t now_ns) noexcept;

  SpscRing<RumbleMotor*, 16> added_;
  std::atomic<bool> on_{false};
  // [drain thread]
  std::vector<Pad> pads_;
  RumbleCue cue_;
};

}  // namespace relievo::pad
