// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/sound/touch_events.h"

#include <algorithm>
#include <cmath>

namespace relievo::sound {
namespace {

bool isFilled(const TouchSample& sample) RELIEVO_REALTIME {
  return sample.contact &&
         (sample.origin == CellStatus::interpolated || sample.origin == CellStatus::base_plane);
}

bool isAtEdge(const TouchSample& sample) RELIEVO_REALTIME {
  return sample.contact && (sample.at_edge || sample.origin == CellStatus::outside);
}

void strike(Heard& heard, Earcon earcon, double approach_mm_per_s = 0) RELIEVO_REALTIME {
  if (heard.count < heard.struck.size()) heard.struck[heard.count++] = {earcon, approach_mm_per_s};
}

}  // namespace

void TouchEvents::keep(const TouchSample& sample) RELIEVO_REALTIME {
  const auto last = kept_.begin() + static_cast<std::ptrdiff_t>(count_);
  // A pause, or a clock that was set: what was before it says nothing of a speed now.
  const auto first = std::find_if(kept_.begin(), last, [&](const TouchSample& old) {
    return old.t_s < sample.t_s && sample.t_s - old.t_s <= kSpanS + 1e-9;
  });
  const auto oldest = last - first == static_cast<std::ptrdiff_t>(kMost) ? first + 1 : first;
  count_ = static_cast<std::size_t>(std::move(oldest, last, kept_.begin()) - kept_.begin());
  kept_[count_++] = sample;
}

TouchEvents::Velocity TouchEvents::speedOf(DeviceMm TouchSample::*member) const RELIEVO_REALTIME {
  if (count_ < 2) return {};
  const TouchSample& first = kept_[0];
  const TouchSample& last = kept_[count_ - 1];
  const DeviceMm by = last.*member - first.*member;
  const double s = last.t_s - first.t_s;
  return {by.x / s, by.y / s, by.z / s};
}

Heard TouchEvents::next(const TouchSample& given) RELIEVO_REALTIME {
  TouchSample sample = given;
  // The surface is not felt meanwhile; it is touched anew when the guide lets go.
  if (sample.led) sample.contact = false;
  const bool has_before = count_ > 0;
  const TouchSample before = has_before ? kept_[count_ - 1] : sample;
  Heard heard{.contact = sample.contact,
              .led = sample.led,
              .force_n = sample.force_n,
              .height = sample.height,
              .place = sample.place};
  const ViewMm& n = sample.normal;
  const auto along = [&](const Velocity& v) { return v.x * n.x + v.y * n.y + v.z * n.z; };
  // Another window may lie elsewhere: the hand has not moved, but the numbers have.
  if (sample.detail != before.detail) {
    count_ = 0;
    strike(heard, sample.detail > before.detail ? Earcon::finer : Earcon::coarser);
  }
  keep(sample);
  const bool touches = sample.contact && (!has_before || !before.contact);
  if (touches) {
    strike(heard, Earcon::contact, std::max(0.0, -along(speedOf(&TouchSample::hand))));
    // From here on the proxy slides on the surface; before, it was wherever the hand was.
    kept_[0] = sample;
    count_ = 1;
  }
  if (isFilled(sample) && (touches || !isFilled(before))) strike(heard, Earcon::not_measured);
  if (isAtEdge(sample) && (touches || !isAtEdge(before))) strike(heard, Earcon::edge);
  if (sample.contact) {
    const Velocity v = speedOf(&TouchSample::proxy);
    const double off = along(v);
    heard.slide_mm_per_s = std::hypot(v.x - off * n.x, v.y - off * n.y, v.z - off * n.z);
  }
  return heard;
}

}  // namespace relievo::sound
