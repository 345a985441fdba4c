// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "haptics/device/falcon/link/link_status.h"

namespace relievo::falcon {

/// Counts answers and how evenly they come, into a status. No clock of its own. [link]
class AnswerTimes {
 public:
  /// The rate is counted from now on.
  void restart(std::int64_t now_ns, const LinkStatus& status) {
    mark_ns_ = now_ns;
    mark_frames_ = status.counts.frames;
  }
  /// Longest and mean times begin anew.
  void measureAnew(LinkStatus& status) {
    status.counts.worst_gap_ns = 0;
    status.mean_answer_ms = status.worst_answer_ms = sum_ms_ = 0;
    timed_ = 0;
  }

  struct Answer {
    std::int64_t now_ns = 0;
    std::int64_t gap_ns = 0;    ///< Since the answer before it.
    std::int64_t asked_ns = 0;  ///< When it was asked for.
    bool at_rest = false;       ///< Nobody hurried: it tells nothing of the pace.
  };
  void count(const Answer& answer, LinkStatus& status) {
    LinkCounts& counts = status.counts;
    if (!answer.at_rest) time(answer, status);
    ++counts.frames;
    constexpr std::uint64_t kFramesPerRate = 256;
    const std::uint64_t frames = counts.frames - mark_frames_;
    if (frames < kFramesPerRate || answer.now_ns <= mark_ns_) return;
    status.rate_hz =
        1e9 * static_cast<double>(frames) / static_cast<double>(answer.now_ns - mark_ns_);
    restart(answer.now_ns, status);
  }

 private:
  void time(const Answer& answer, LinkStatus& status) {
    LinkCounts& counts = status.counts;
    std::size_t bin = 0;
    while (bin < LinkCounts::kGapEdgesNs.size() && answer.gap_ns > LinkCounts::kGapEdgesNs[bin]) {
      ++bin;
    }
    ++counts.gaps[bin];
    counts.worst_gap_ns = std::max(counts.worst_gap_ns, answer.gap_ns);
    const double answer_ms = 1e-6 * static_cast<double>(answer.now_ns - answer.asked_ns);
    sum_ms_ += answer_ms;
    status.mean_answer_ms = sum_ms_ / static_cast<double>(++timed_);
    status.worst_answer_ms = std::max(status.worst_answer_ms, answer_ms);
  }

  std::int64_t mark_ns_ = 0;
  std::uint64_t mark_frames_ = 0, timed_ = 0;
  double sum_ms_ = 0;
};

}  // namespace relievo::falcon
