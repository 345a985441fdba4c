// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "haptics/force/force_model.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// Velocity of the hand over its last 8 places, by their own times: one step of a coarse encoder is
/// 63 mm/s from tick to tick. [haptic loop]
class HandSpeed {
 public:
  struct Place {
    DeviceMm position;
    std::int64_t time_ns = 0;
  };

  /// Takes the hand's place of this tick; sets `velocity` and, from the second place on, `moved`. A
  /// reading that is handed over twice is one place.
  void measure(DeviceMm hand, std::int64_t reading_ns, ForceInput& input) RELIEVO_REALTIME;
  /// The next place is the first one.
  void forget() RELIEVO_REALTIME { seen_ = 0; }

 private:
  friend struct NamedFields;  // Recordings hold every member by its name.

  static constexpr std::uint64_t kPlaces = 8;
  std::array<Place, kPlaces> places_;  // The last ones; the newest is at seen_ - 1.
  Place oldest_;                       // That the newest is compared with.
  std::uint64_t seen_ = 0;
};

}  // namespace relievo
