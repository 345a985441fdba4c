// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/hand_speed.h"

#include <algorithm>

namespace relievo {

void HandSpeed::measure(DeviceMm hand, std::int64_t reading_ns,
                        ForceInput& input) RELIEVO_REALTIME {
  const auto newest = [this]()
                          RELIEVO_REALTIME -> Place& { return places_[(seen_ - 1) % kPlaces]; };
  if (seen_ > 0) input.moved = hand - newest().position;
  const bool twice = seen_ > 0 && newest().time_ns == reading_ns && hand == newest().position;
  if (!twice) {
    // The one that is overwritten is the oldest that counts.
    const std::uint64_t back = std::min(seen_, kPlaces);
    oldest_ = back > 0 ? places_[(seen_ - back) % kPlaces] : Place{hand, reading_ns};
    places_[seen_ % kPlaces] = {hand, reading_ns};
    ++seen_;
  }
  const double seconds = 1e-9 * static_cast<double>(reading_ns - oldest_.time_ns);
  // Fewer than 8 places count as 8: the first steps of a hand are too coarse for a speed.
  const double least = 1e-3 * static_cast<double>(kPlaces);
  input.velocity = (1 / std::max(seconds, least)) * (hand - oldest_.position);
}

}  // namespace relievo
