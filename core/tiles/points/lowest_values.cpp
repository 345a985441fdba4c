// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/points/lowest_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/failure.h"

namespace relievo {

LowestValues::LowestValues(std::size_t count, double q)
    : limit_(std::numeric_limits<float>::infinity()) {
  if (count == 0) {
    throw failure<MessageId::no_cell_hit>();
  }
  position_ = q * (static_cast<double>(count) - 1);
  kept_ = std::min(count, static_cast<std::size_t>(position_) + 2);
}

void LowestValues::prune() {
  const auto last = lowest_.begin() + static_cast<std::ptrdiff_t>(kept_) - 1;
  std::nth_element(lowest_.begin(), last, lowest_.end());
  limit_ = *last;
  lowest_.resize(kept_);
}

void LowestValues::add(const std::vector<float>& values) {
  constexpr std::size_t kSlack = 65536;
  for (const float value : values) {
    if (std::isnan(value) || value > limit_) continue;
    lowest_.push_back(value);
    if (lowest_.size() >= 2 * kept_ + kSlack) prune();
  }
}

double LowestValues::quantile() {
  if (lowest_.size() > kept_) prune();
  std::sort(lowest_.begin(), lowest_.end());
  const auto below = static_cast<std::size_t>(position_);
  const auto low = static_cast<double>(lowest_[below]);
  const double part = position_ - static_cast<double>(below);
  if (part == 0) return low;
  return low + part * (static_cast<double>(lowest_[below + 1]) - low);
}

}  // namespace relievo
