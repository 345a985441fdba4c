// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/fill/lowest_values.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>

#include "core/base/exchange.h"
#include "core/base/failure.h"
#include "core/base/plain_bytes.h"

namespace relievo {

LowestValues::LowestValues(std::size_t count, double q)
    : limit_(std::numeric_limits<float>::infinity()) {
  if (count == 0) {
    throw failure<MessageId::no_cell_hit>();
  }
  position_ = q * (static_cast<double>(count) - 1);
  kept_ = std::min(count, static_cast<std::size_t>(position_) + 2);
}

/// @pre more than are needed
void LowestValues::prune(std::vector<float>& values) const {
  const auto last = values.begin() + static_cast<std::ptrdiff_t>(kept_) - 1;
  std::nth_element(values.begin(), last, values.end());
  values.resize(kept_);
}

void LowestValues::add(std::span<const float> values) {
  constexpr std::size_t kSlack = 4096;
  std::vector<float> mine;
  float limit = limit_;
  for (const float value : values) {
    if (!(value <= limit)) continue;  // Nor NaN.
    mine.push_back(value);
    if (mine.size() < 2 * kept_ + kSlack) continue;
    prune(mine);
    limit = mine.back();
  }
  const std::lock_guard one_at_a_time(adds_);
  lowest_.insert(lowest_.end(), mine.begin(), mine.end());
  if (lowest_.size() < 2 * kept_ + kSlack) return;
  prune(lowest_);
  limit_ = lowest_.back();
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
  if (processes.isAlone()) {
    std::vector<float> all = lowest_;
    const auto at = all.begin() + static_cast<std::ptrdiff_t>(k);
    std::nth_element(all.begin(), at, all.end());
    return *at;
  }
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
  if (lowest_.size() > kept_) prune(lowest_);
  const auto below = static_cast<std::size_t>(position_);
  const auto low = static_cast<double>(kth(below, processes));
  const double part = position_ - static_cast<double>(below);
  if (part == 0) return low;
  return low + part * (static_cast<double>(kth(below + 1, processes)) - low);
}

}  // namespace relievo
