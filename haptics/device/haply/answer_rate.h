// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

namespace relievo::haply {

/// How many answers come in a second, over some hundred of them. [device thread]
class AnswerRate {
 public:
  void restart(std::int64_t now_ns, std::uint64_t answers) {
    mark_ns_ = now_ns;
    answers_ = answers;
  }
  /// @param answers  so far
  /// @return per second, once enough have come since it said so last
  std::optional<double> take(std::int64_t now_ns, std::uint64_t answers) {
    constexpr std::uint64_t kAnswersPerRate = 256;
    const std::uint64_t came = answers - answers_;
    if (came < kAnswersPerRate || now_ns <= mark_ns_) return std::nullopt;
    const double rate_hz = 1e9 * static_cast<double>(came) / static_cast<double>(now_ns - mark_ns_);
    restart(now_ns, answers);
    return rate_hz;
  }

 private:
  std::int64_t mark_ns_ = 0;
  std::uint64_t answers_ = 0;
};

}  // namespace relievo::haply
