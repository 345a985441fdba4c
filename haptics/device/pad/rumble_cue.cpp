// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/pad/rumble_cue.h"

#include <algorithm>
#include <cmath>

namespace relievo::pad {

namespace {
constexpr std::int64_t kChangeNs = 20'000'000;
/// Motors cannot be told apart more finely, and each new value is a message to the pad.
constexpr double kSteps = 8;
}  // namespace

void RumbleCue::take(const TouchMoment& moment) noexcept {
  if (!moment.counts) {
    *this = {};
    before_.time_ns = moment.time_ns;
    return;
  }
  if (moment.contact && !before_.contact) {
    contact_ns_ = moment.time_ns;
    knock_until_ns_ = moment.time_ns + kKnockNs;
    force_before_n_ = before_.force_n;
    knock_ = kLeast;
  }
  if (moment.time_ns < knock_until_ns_ && moment.time_ns - contact_ns_ <= kChangeNs) {
    const double part = std::min(1.0, std::abs(moment.force_n - force_before_n_) / kFullN);
    knock_ = std::max(knock_, std::round(kSteps * part) / kSteps);
  }
  before_ = moment;
}

RumbleLevel RumbleCue::next(std::span<const TouchMoment> moments, std::int64_t now_ns) noexcept {
  for (const TouchMoment& moment : moments) take(moment);
  if (now_ns - before_.time_ns > kStaleNs) return {};
  return {.strong = now_ns < knock_until_ns_ ? knock_ : 0, .weak = before_.at_edge ? kEdge : 0};
}

}  // namespace relievo::pad
