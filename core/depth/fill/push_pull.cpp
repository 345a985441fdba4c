// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/fill/push_pull.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace relievo {
namespace {

/// Push: bilinear value of the coarse grid under a fine cell; fine cell f lies at (f - 0.5) / 2.
float coarseValue(const PushPullLayer& coarse, Cell fine) {
  const auto split = [](int f, int count, int& low, int& high) {
    const double x = std::clamp((f - 0.5) / 2, 0.0, count - 1.0);
    low = static_cast<int>(x);
    high = std::min(low + 1, count - 1);
    return static_cast<float>(x - low);
  };
  int c0 = 0;
  int c1 = 0;
  int r0 = 0;
  int r1 = 0;
  const float u = split(fine.col, coarse.size.cols, c0, c1);
  const float v = split(fine.row, coarse.size.rows, r0, r1);
  const auto at = [&](int col, int row) {
    return coarse.values[coarse.size.index({.col = col, .row = row})];
  };
  return (1 - v) * ((1 - u) * at(c0, r0) + u * at(c1, r0)) +
         v * ((1 - u) * at(c0, r1) + u * at(c1, r1));
}

/// Calls take(index) for every 0. In most rows there are few, so eight are looked at together.
template <class Take>
void forZeros(std::span<const std::uint8_t> mask, const Take& take) {
  constexpr std::uint64_t kAllOnes = 0x0101010101010101U;
  for (std::size_t first = 0; first < mask.size(); first += 8) {
    const std::size_t count = std::min<std::size_t>(8, mask.size() - first);
    std::uint64_t eight = kAllOnes;
    std::memcpy(&eight, &mask[first], count);
    if (eight == kAllOnes) continue;
    for (std::size_t i = first; i < first + count; ++i) {
      if (mask[i] == 0) take(i);
    }
  }
}

/// From sums of weighted values to means.
void finishPull(PushPullLayer& coarse) {
  for (std::size_t i = 0; i < coarse.values.size(); ++i) {
    if (coarse.weights[i] > 0) coarse.values[i] /= coarse.weights[i];
    coarse.weights[i] = std::min(coarse.weights[i], 1.0F);
  }
}

/// The second lowest and the second highest of some values.
struct NeighbourRange {
  static constexpr float kFar = std::numeric_limits<float>::infinity();
  float lowest = kFar, low = kFar, high = -kFar, highest = -kFar;
  int found = 0;

  void add(float z) {
    low = std::min(low, z < lowest ? std::exchange(lowest, z) : z);
    high = std::max(high, z > highest ? std::exchange(highest, z) : z);
    ++found;
  }
};

}  // namespace

PushPullLayer pulled(const PushPullLayer& fine) {
  PushPullLayer coarse;
  coarse.size = {.cols = (fine.size.cols + 1) / 2, .rows = (fine.size.rows + 1) / 2};
  coarse.values.assign(coarse.size.count(), 0.0F);
  coarse.weights.assign(coarse.size.count(), 0.0F);
  for (int row = 0; row < fine.size.rows; ++row) {
    for (int col = 0; col < fine.size.cols; ++col) {
      const std::size_t from = fine.size.index({.col = col, .row = row});
      const std::size_t to = coarse.size.index({.col = col / 2, .row = row / 2});
      coarse.values[to] += fine.weights[from] * fine.values[from];
      coarse.weights[to] += fine.weights[from];
    }
  }
  finishPull(coarse);
  return coarse;
}

void pushInto(PushPullLayer& fine, const PushPullLayer& coarse) {
  for (int row = 0; row < fine.size.rows; ++row) {
    for (int col = 0; col < fine.size.cols; ++col) {
      const std::size_t i = fine.size.index({.col = col, .row = row});
      const float w = fine.weights[i];
      if (w >= 1) continue;
      fine.values[i] = w * fine.values[i] + (1 - w) * coarseValue(coarse, {.col = col, .row = row});
    }
  }
}

PushPullLayer pulledFrom(std::span<const float> values, const Mask& known, GridSize size) {
  PushPullLayer coarse;
  coarse.size = {.cols = (size.cols + 1) / 2, .rows = (size.rows + 1) / 2};
  coarse.values.assign(coarse.size.count(), 0.0F);
  coarse.weights.assign(coarse.size.count(), 0.0F);
  const auto pairs = static_cast<std::size_t>(size.cols / 2);
  for (int row = 0; row < size.rows; ++row) {
    const std::size_t from = size.index({.col = 0, .row = row});
    const float* const z = &values[from];
    const std::uint8_t* const counts = &known[from];
    const std::size_t to = coarse.size.index({.col = 0, .row = row / 2});
    float* const sums = &coarse.values[to];
    float* const weights = &coarse.weights[to];
    const auto add = [&](std::size_t cell, std::size_t fine) {
      sums[cell] += counts[fine] != 0 ? z[fine] : 0.0F;
      weights[cell] += static_cast<float>(counts[fine]);
    };
    for (std::size_t i = 0; i < pairs; ++i) {
      add(i, 2 * i);
      add(i, 2 * i + 1);
    }
    if (size.cols % 2 != 0) add(pairs, 2 * pairs);
  }
  finishPull(coarse);
  return coarse;
}

void pushIntoUnknown(std::vector<float>& values, const Mask& known, GridSize size,
                     const PushPullLayer& coarse) {
  for (int row = 0; row < size.rows; ++row) {
    forZeros(std::span(known).subspan(size.index({.col = 0, .row = row}),
                                      static_cast<std::size_t>(size.cols)),
             [&](std::size_t col) {
               const Cell cell{.col = static_cast<int>(col), .row = row};
               values[size.index(cell)] = coarseValue(coarse, cell);
             });
  }
}

void keepWithinNeighbours(std::vector<float>& values, Mask&& known, const Mask& gaps,
                          GridSize size) {
  constexpr int kEnough = 4;
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (gaps[i] != 0) left.push_back(i);
  }
  std::vector<std::size_t> kept;
  for (int round = 0; round < kNeighbourRounds; ++round) {
    kept.clear();
    const auto is_kept = [&](std::size_t i) {
      const int row = static_cast<int>(i / static_cast<std::size_t>(size.cols));
      const int col = static_cast<int>(i % static_cast<std::size_t>(size.cols));
      NeighbourRange range;
      for (int r = std::max(row - 1, 0); r < std::min(row + 2, size.rows); ++r) {
        for (int c = std::max(col - 1, 0); c < std::min(col + 2, size.cols); ++c) {
          const std::size_t k = size.index({.col = c, .row = r});
          if (known[k] != 0) range.add(values[k]);
        }
      }
      if (range.found < kEnough) return false;
      values[i] = std::clamp(values[i], range.low, range.high);
      kept.push_back(i);
      return true;
    };
    std::erase_if(left, is_kept);
    for (const std::size_t i : kept) known[i] = 1;
  }
}

}  // namespace relievo
