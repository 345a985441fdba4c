// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

#include "haptics/device/falcon/kinematics.h"
#include "haptics/device/falcon/link/link_status.h"

namespace relievo::falcon {

/// From the arms that answers call homed to the state of the link. No clock of its own. [link]
class Homing {
 public:
  /// The firmware runs anew: what was seen of the arms is over.
  void restart() {
    homed_answers_ = 0;
    seen_unhomed_ = false;
  }
  /// Since now it homes.
  void begin(std::int64_t now_ns) { since_ns_ = now_ns; }
  /// It homes for so long that a hint may help.
  bool isLong(std::int64_t now_ns) const { return now_ns - since_ns_ > kHintNs; }

  /// The state after an answer, which may be the one before it.
  /// @param homed  bit i: arm i  @param out_mm  how far the grip is pulled out
  LinkState after(LinkState state, std::uint8_t homed, double out_mm) {
    homed_answers_ = homed == kAllHomed ? std::min(homed_answers_ + 1, kSure) : 0;
    if (homed_answers_ == 0) {
      seen_unhomed_ = true;
      return LinkState::homing;
    }
    if (homed_answers_ == kSure && state == LinkState::homing) {
      // One that was homed before we came may be anywhere, and the loop waits until it is clear.
      return seen_unhomed_ ? LinkState::pull_out : LinkState::ready;
    }
    const bool pulled_out = state == LinkState::pull_out && out_mm > kPulledOutMm;
    return pulled_out ? LinkState::ready : state;
  }

 private:
  static constexpr int kSure = 3;  // In a row.
  static constexpr double kPulledOutMm = 170 - kCentre.z;
  static constexpr std::int64_t kHintNs = 20'000'000'000;

  int homed_answers_ = 0;  // In a row, with all arms homed.
  bool seen_unhomed_ = false;
  std::int64_t since_ns_ = 0;
};

}  // namespace relievo::falcon
