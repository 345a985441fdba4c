// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/rate_watch.h"

#include <algorithm>

namespace relievo {

void RateWatch::tick(std::int64_t now_ns, std::int64_t reading_ns) RELIEVO_REALTIME {
  if (!started_) {
    started_ = true;
    now_ns_ = now_ns;
    reading_ns_ = reading_ns;
    return;
  }
  ++ticks_;
  if (reading_ns != reading_ns_) ++readings_;
  reading_ns_ = reading_ns;
  passed_ns_ += std::min(now_ns - now_ns_, kLongestNs);
  now_ns_ = now_ns;
  if (passed_ns_ < kWindowNs) return;
  measured(1e9 * std::min(ticks_, readings_) / static_cast<double>(passed_ns_), now_ns);
  passed_ns_ = 0;
  ticks_ = readings_ = 0;
}

void RateWatch::measured(double hz, std::int64_t now_ns) RELIEVO_REALTIME {
  if (hz < kLeastHz) {
    slow_hz_ = slow_hz_ > 0 ? std::min(slow_hz_, hz) : hz;
    slow_ns_ = now_ns;
  } else if (now_ns - slow_ns_ >= kRecoverNs) {
    slow_hz_ = 0;
  }
}

}  // namespace relievo
