// SPDX-License-Identifier: BSD-3-Clause
// Compiled with -O3 and without contraction to fused multiply-add: the same bits in every build.
#include "core/io/point_block.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "core/base/wide_vectors.h"
#include "core/io/scan_builder.h"

namespace relievo {
namespace {

constexpr std::size_t kTogether = 8;  // Points, so that each lane has one axis.
constexpr std::size_t kLanes = 3 * kTogether;
static_assert(kPointBlock % kTogether == 0);

constexpr auto kFarthest = static_cast<float>(kFarthestCoordinate);
static_assert(static_cast<double>(kFarthest) <= kFarthestCoordinate);
constexpr auto kFarthestBits = std::bit_cast<std::uint32_t>(kFarthest);
constexpr std::uint32_t kNoSign = 0x7FFFFFFF;

struct Lanes {
  std::array<float, kLanes> low, high;
  std::array<std::uint32_t, kLanes> most;  // Bits without the sign rise with what they stand for.
};

RELIEVO_WIDE_VECTORS
void look(const float* numbers, std::size_t steps, Lanes& result) {
  Lanes lanes = result;
  for (std::size_t step = 0; step < steps; ++step) {
    const float* const at = numbers + step * kLanes;
    for (std::size_t n = 0; n < kLanes; ++n) {
      lanes.low[n] = at[n] < lanes.low[n] ? at[n] : lanes.low[n];
      lanes.high[n] = at[n] > lanes.high[n] ? at[n] : lanes.high[n];
    }
    for (std::size_t n = 0; n < kLanes; ++n) {
      const std::uint32_t size = std::bit_cast<std::uint32_t>(at[n]) & kNoSign;
      lanes.most[n] = size > lanes.most[n] ? size : lanes.most[n];
    }
  }
  result = lanes;
}

RELIEVO_WIDE_VECTORS
void subtract(const double* origins, std::size_t steps, float* numbers) {
  for (std::size_t step = 0; step < steps; ++step) {
    float* const at = numbers + step * kLanes;
    for (std::size_t n = 0; n < kLanes; ++n) {
      at[n] = static_cast<float>(static_cast<double>(at[n]) - origins[n]);
    }
  }
}

/// The most that an exponent can be is that of infinity and NaN.
RELIEVO_WIDE_VECTORS
bool areFinite(const float* numbers, std::size_t count) {
  constexpr std::uint32_t kInfinite = 0x7F800000;
  std::uint32_t found = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t exponent = std::bit_cast<std::uint32_t>(numbers[i]) & kInfinite;
    found |= exponent == kInfinite ? 1U : 0U;
  }
  return found == 0;
}

std::size_t stepsOf(std::size_t count) {
  return (count + kTogether - 1) / kTogether;
}

}  // namespace

BlockBox boxOf(PointBlock& block, std::size_t count) {
  const std::size_t steps = stepsOf(count);
  std::fill(block.begin() + static_cast<std::ptrdiff_t>(count),
            block.begin() + static_cast<std::ptrdiff_t>(steps * kTogether), block[0]);
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  Lanes lanes;
  lanes.low.fill(kInfinite);
  lanes.high.fill(-kInfinite);
  lanes.most.fill(0);
  look(block[0].data(), steps, lanes);
  BlockBox box{
      .low = {kInfinite, kInfinite, kInfinite},
      .high = {-kInfinite, -kInfinite, -kInfinite},
      .is_usable = *std::max_element(lanes.most.begin(), lanes.most.end()) <= kFarthestBits};
  for (std::size_t n = 0; n < kLanes; ++n) {
    box.low[n % 3] = std::min(box.low[n % 3], lanes.low[n]);
    box.high[n % 3] = std::max(box.high[n % 3], lanes.high[n]);
  }
  return box;
}

bool areFinite(std::span<const std::array<float, 3>> points) {
  return points.empty() || areFinite(points[0].data(), 3 * points.size());
}

void moveTo(const FilePoint& origin, PointBlock& block, std::size_t count) {
  std::array<double, kLanes> origins{};
  for (std::size_t point = 0; point < kTogether; ++point) {
    origins[3 * point] = origin.x;
    origins[3 * point + 1] = origin.y;
    origins[3 * point + 2] = origin.z;
  }
  subtract(origins.data(), stepsOf(count), block[0].data());
}

}  // namespace relievo
