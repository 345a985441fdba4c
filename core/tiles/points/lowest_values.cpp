// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/points/lowest_values.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/failure.h"
#include "core/tiles/job/exchange.h"
#include "core/tiles/job/plain_bytes.h"

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

namespace {

/// Ordered as the floats are.
std::uint32_t keyOf(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return (bits & 0x80000000U) != 0 ? ~bits : bits | 0x80000000U;
}

float valueOf(std::uint32_t key) {
  return std::bit_cast<float>((key & 0x80000000U) != 0 ? key & 0x7fffffffU : ~key);
}

constexpr std::size_t kBins = std::size_t{1} << 16U;

/// Adds up what every process counted. @return  the bin of the k-th; k is then counted in it
std::size_t binOf(const std::vector<std::uint64_t>& mine, std::size_t& k, Exchange& processes) {
  std::vector<std::uint64_t> all(kBins);
  for (const std::string& one : processes.share(plainBytes(mine))) {
    std::vector<std::uint64_t> counts;
    PlainBytes(one).take(counts, kBins);
    for (std::size_t bin = 0; bin < counts.size(); ++bin) all[bin] += counts[bin];
  }
  std::size_t bin = 0;
  for (; bin + 1 < kBins && k >= all[bin]; ++bin) k -= all[bin];
  return bin;
}

}  // namespace

/// By counting twice: the upper and the lower half of each value. So processes tell each other how
/// many there are, however many that is.
float LowestValues::kth(std::size_t k, Exchange& processes) const {
  std::vector<std::uint64_t> counts(kBins);
  for (const float value : lowest_) ++counts[keyOf(value) >> 16U];
  const std::size_t upper = binOf(counts, k, processes);
  std::fill(counts.begin(), counts.end(), 0);
  for (const float value : lowest_) {
    const std::uint32_t key = keyOf(value);
    if (key >> 16U == upper) ++counts[key & 0xffffU];
  }
  const std::size_t lower = binOf(counts, k, processes);
  return valueOf(static_cast<std::uint32_t>(upper << 16U | lower));
}

double LowestValues::quantile(Exchange& processes) {
  if (lowest_.size() > kept_) prune();
  const auto below = static_cast<std::size_t>(position_);
  const auto low = static_cast<double>(kth(below, processes));
  const double part = position_ - static_cast<double>(below);
  if (part == 0) return low;
  return low + part * (static_cast<double>(kth(below + 1, processes)) - low);
}

}  // namespace relievo
