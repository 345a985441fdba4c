// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/even_points.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace relievo {
namespace {

// Cubes across the longest side, to learn the area: as many as hold some points each.
constexpr double kMostAcross = 192;
constexpr double kPointsOfCube = 8;

/// Which cubes of a grid hold a point: a table of their numbers, open addressing.
class CubeSet {
 public:
  explicit CubeSet(std::size_t expected)
      : numbers_(std::bit_ceil(2 * std::max<std::size_t>(expected, 1024)), kFree) {}

  /// Was the cube not in the set?
  bool insert(std::uint64_t number) {
    if (2 * (count_ + 1) > numbers_.size()) grow();
    if (!place(number)) return false;
    ++count_;
    return true;
  }
  std::size_t count() const { return count_; }

 private:
  static constexpr std::uint64_t kFree = ~std::uint64_t{0};

  bool place(std::uint64_t number) {
    // Fibonacci hashing: the upper bits of the product are well mixed.
    std::size_t at = (number * 0x9E3779B97F4A7C15U) >> (64 - std::countr_zero(numbers_.size()));
    while (numbers_[at] != kFree) {
      if (numbers_[at] == number) return false;
      at = (at + 1) & (numbers_.size() - 1);
    }
    numbers_[at] = number;
    return true;
  }
  void grow() {
    std::vector<std::uint64_t> old(2 * numbers_.size(), kFree);
    old.swap(numbers_);
    for (const std::uint64_t number : old) {
      if (number != kFree) place(number);
    }
  }

  std::vector<std::uint64_t> numbers_;
  std::size_t count_ = 0;
};

class CubeGrid {
 public:
  CubeGrid(const ViewBox& box, double side_mm) : low_(box.min), per_mm_(1 / side_mm) {}

  std::uint64_t operator()(const ViewMm& p) const {
    const auto step = [this](double value, double low) {
      return static_cast<std::uint64_t>(std::clamp((value - low) * per_mm_, 0.0, kMostSteps));
    };
    return step(p.x, low_.x) | step(p.y, low_.y) << 21U | step(p.z, low_.z) << 42U;
  }

 private:
  static constexpr double kMostSteps = (1U << 21U) - 1;
  ViewMm low_;
  double per_mm_;
};

bool isInside(const ViewBox& box, const ViewMm& p) {
  return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y &&
         p.z >= box.min.z && p.z <= box.max.z;
}

}  // namespace

std::vector<std::array<float, 3>> evenPoints(const ViewBlocks& points, const ViewBox& box,
                                             std::uint64_t count, std::size_t wanted,
                                             const Task& task) {
  const double side =
      std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z, 1e-300});
  std::vector<std::array<float, 3>> chosen;
  chosen.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(count, wanted + wanted / 2)));
  const auto choose = [&](auto&& is_chosen) {
    points([&](std::span<const ViewMm> block) {
      task.check();
      for (const ViewMm& p : block) {
        if (!isInside(box, p) || !is_chosen(p)) continue;
        chosen.push_back({static_cast<float>(p.x - box.min.x), static_cast<float>(p.y - box.min.y),
                          static_cast<float>(p.z - box.min.z)});
      }
    });
  };
  if (count <= wanted) {
    choose([](const ViewMm&) { return true; });
    return chosen;
  }
  // A surface meets the square of twice as many cubes of half the side.
  const double across = std::sqrt(static_cast<double>(count) / kPointsOfCube);
  const double counted_side = side / std::clamp(across, 1.0, kMostAcross);
  CubeSet coarse(1U << 16U);
  const CubeGrid coarse_grid(box, counted_side);
  points([&](std::span<const ViewMm> block) {
    task.check();
    for (const ViewMm& p : block) {
      if (isInside(box, p)) coarse.insert(coarse_grid(p));
    }
  });
  const double cube_side =
      counted_side * std::sqrt(static_cast<double>(coarse.count()) / static_cast<double>(wanted));
  CubeSet cubes(wanted);
  const CubeGrid grid(box, std::max(cube_side, side / (1U << 20U)));
  choose([&](const ViewMm& p) { return cubes.insert(grid(p)); });
  return chosen;
}

}  // namespace relievo
