// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/depth_map.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/base/bands.h"

namespace relievo {

namespace {

/// Calls work(part, first, end) for parts of so many cells, side by side.
template <class Work>
void forParts(std::size_t cells, std::size_t parts, const Work& work) {
  const auto count = static_cast<int>(parts);
  parallelFor(count, count, [&](int number, int) {
    const auto part = static_cast<std::size_t>(number);
    work(part, cells * part / parts, cells * (part + 1) / parts);
  });
}

std::size_t partsOf(std::size_t cells) {
  return static_cast<std::size_t>(threadsFor(cells, 0));
}

void countOrigins(const CellStatus* origins, std::size_t cells, OriginCounts& counts) {
  // Neighbours are mostly alike: one counter for all would wait for itself.
  constexpr std::size_t kCounters = 4;
  std::array<OriginCounts, kCounters> several{};
  std::size_t i = 0;
  for (; i + kCounters <= cells; i += kCounters) {
    for (std::size_t k = 0; k < kCounters; ++k) {
      ++several[k][static_cast<std::size_t>(origins[i + k])];
    }
  }
  for (; i < cells; ++i) ++several[0][static_cast<std::size_t>(origins[i])];
  for (const OriginCounts& some : several) {
    for (std::size_t k = 0; k < kOriginCount; ++k) counts[k] += some[k];
  }
}

}  // namespace

OriginCounts originCounts(const DepthMap& map) {
  std::vector<OriginCounts> parts(partsOf(map.origins.size()));
  forParts(map.origins.size(), parts.size(),
           [&](std::size_t part, std::size_t first, std::size_t end) {
             countOrigins(map.origins.data() + first, end - first, parts[part]);
           });
  OriginCounts counts{};
  for (const OriginCounts& part : parts) {
    for (std::size_t k = 0; k < kOriginCount; ++k) counts[k] += part[k];
  }
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
  struct Ends {
    float low = std::numeric_limits<float>::infinity();
    float high = -std::numeric_limits<float>::infinity();
  };
  std::vector<Ends> parts(partsOf(map.heights_mm.size()));
  forParts(map.heights_mm.size(), parts.size(),
           [&](std::size_t part, std::size_t first, std::size_t end) {
             Ends ends;
             for (std::size_t i = first; i < end; ++i) {
               if (map.origins[i] == CellStatus::outside) continue;
               ends.low = std::min(ends.low, map.heights_mm[i]);
               ends.high = std::max(ends.high, map.heights_mm[i]);
             }
             parts[part] = ends;
           });
  Ends all;
  for (const Ends& part : parts) {
    all.low = std::min(all.low, part.low);
    all.high = std::max(all.high, part.high);
  }
  if (all.low > all.high) return {};
  return {.min_mm = static_cast<double>(all.low), .max_mm = static_cast<double>(all.high)};
}

}  // namespace relievo
