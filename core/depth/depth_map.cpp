// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/depth_map.h"

#include <algorithm>
#include <limits>

namespace relievo {

OriginCounts originCounts(const DepthMap& map) {
  OriginCounts counts{};
  for (const CellStatus origin : map.origins) ++counts[static_cast<std::size_t>(origin)];
  return counts;
}

std::array<double, kOriginCount> originShares(const DepthMap& map) {
  const OriginCounts counts = originCounts(map);
  std::array<double, kOriginCount> shares{};
  if (map.origins.empty()) return shares;
  for (std::size_t i = 0; i < kOriginCount; ++i) {
    shares[i] = static_cast<double>(counts[i]) / static_cast<double>(map.origins.size());
  }
  return shares;
}

HeightRange heightRange(const DepthMap& map) {
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  for (std::size_t i = 0; i < map.heights_mm.size(); ++i) {
    if (map.origins[i] == CellStatus::outside) continue;
    low = std::min(low, map.heights_mm[i]);
    high = std::max(high, map.heights_mm[i]);
  }
  if (low > high) return {};
  return {.min_mm = static_cast<double>(low), .max_mm = static_cast<double>(high)};
}

}  // namespace relievo
