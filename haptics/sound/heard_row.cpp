// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/sound/heard_row.h"

#include "core/region/region_window.h"

namespace relievo::sound {

TouchSample touchSampleOf(const TouchRow& row, const HeardPlace& place) RELIEVO_REALTIME {
  TouchSample sample{.t_s = row.t_s,
                     .hand = row.hand_hip,
                     .proxy = row.hand_proxy,
                     .normal = row.normal,
                     .force_n = norm(row.force),
                     .contact = row.contact,
                     .origin = row.origin,
                     .detail = row.detail};
  sample.height = shareOf(row.proxy.z / place.gain, place.heights.low_mm, place.heights.high_mm);
  if (place.region == nullptr) {
    sample.place = shareOf(row.proxy.x, place.left_mm, place.right_mm);
    return sample;
  }
  const Region& region = *place.region;
  sample.place = shareOf(row.proxy.x, region.x_mm, region.x_mm + region.side_mm);
  const double half_mm = 0.5 * region.side_mm / kWindowSamples;
  const auto near_end = [&](double value, double start) {
    return value <= start + half_mm || value >= start + region.side_mm - half_mm;
  };
  sample.at_edge = near_end(row.proxy.x, region.x_mm) || near_end(row.proxy.y, region.y_mm);
  return sample;
}

}  // namespace relievo::sound
