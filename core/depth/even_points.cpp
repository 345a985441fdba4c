// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/even_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace relievo {
namespace {

// Cubes across the longest side, to learn the area: as many as hold some points each.
constexpr double kMostAcross = 192;
constexpr double kPointsOfCube = 8;
// Points in a cube and around it, itself among them: a surface meets some nine of these cubes.
constexpr double kFewestCompany = 4;
constexpr double kCompanyOfMean = 0.8;  // In cubes of the mean number of points.

/// How many points each cube of a grid holds: a table by the cubes' numbers, open addressing.
class CubeCounts {
 public:
  explicit CubeCounts(std::size_t expected)
      : cubes_(std::bit_ceil(2 * std::max<std::size_t>(expected, 1024))) {}

  /// One more point. @return  how many cubes were met before the point's own
  std::size_t add(std::uint64_t number) {
    if (2 * (count_ + 1) > cubes_.size()) grow();
    Cube& cube = cubes_[placeOf(number)];
    if (cube.number == kFree) {
      cube.number = number;
      cube.order = static_cast<std::uint32_t>(count_++);
    }
    ++cube.points;
    return cube.order;
  }
  std::uint32_t points(std::uint64_t number) const { return cubes_[placeOf(number)].points; }
  std::size_t count() const { return count_; }

 private:
  static constexpr std::uint64_t kFree = ~std::uint64_t{0};
  struct Cube {
    std::uint64_t number = kFree;
    std::uint32_t points = 0;
    std::uint32_t order = 0;
  };

  /// Where the cube is, or would be put.
  std::size_t placeOf(std::uint64_t number) const {
    // Fibonacci hashing: the upper bits of the product are well mixed.
    std::size_t at = (number * 0x9E3779B97F4A7C15U) >> (64 - std::countr_zero(cubes_.size()));
    while (cubes_[at].number != kFree && cubes_[at].number != number) {
      at = (at + 1) & (cubes_.size() - 1);
    }
    return at;
  }
  void grow() {
    std::vector<Cube> old(2 * cubes_.size());
    old.swap(cubes_);
    for (const Cube& cube : old) {
      if (cube.number != kFree) cubes_[placeOf(cube.number)] = cube;
    }
  }

  std::vector<Cube> cubes_;
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

  /// Points in a cube and the 26 around it.
  static std::uint32_t around(std::uint64_t number, const CubeCounts& counts) {
    std::uint32_t sum = 0;
    for (int k = 0; k < 27; ++k) {
      const std::array<int, 3> off{k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
      std::uint64_t near = 0;
      bool is_there = true;
      for (unsigned axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::int64_t>(number >> (21U * axis) & kLast) + off[axis];
        is_there = is_there && at >= 0 && at <= static_cast<std::int64_t>(kLast);
        near |= (static_cast<std::uint64_t>(at) & kLast) << (21U * axis);
      }
      if (is_there) sum += counts.points(near);
    }
    return sum;
  }

 private:
  static constexpr std::uint64_t kLast = (1U << 21U) - 1;
  static constexpr auto kMostSteps = static_cast<double>(kLast);
  ViewMm low_;
  double per_mm_;
};

std::array<float, 3> single(const ViewMm& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// The points of a cube, from the box's corner.
class Gathered {
 public:
  void add(const ViewMm& p) {
    sum_.x += p.x;
    sum_.y += p.y;
    sum_.z += p.z;
    ++count_;
  }
  std::array<float, 3> middle() const {
    return single({sum_.x / count_, sum_.y / count_, sum_.z / count_});
  }

 private:
  ViewMm sum_{};
  std::uint32_t count_ = 0;
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
  const auto forInside = [&](auto&& take) {
    points([&](std::span<const ViewMm> block) {
      task.check();
      for (const ViewMm& p : block) {
        if (isInside(box, p)) take(p - box.min, p);
      }
    });
  };
  if (count <= wanted) {
    chosen.reserve(static_cast<std::size_t>(count));
    forInside(
        [&](const ViewMm& from_corner, const ViewMm&) { chosen.push_back(single(from_corner)); });
    return chosen;
  }
  // A surface meets the square of twice as many cubes of half the side.
  const double across = std::sqrt(static_cast<double>(count) / kPointsOfCube);
  const double counted_side = side / std::clamp(across, 1.0, kMostAcross);
  CubeCounts coarse(1U << 16U);
  const CubeGrid coarse_grid(box, counted_side);
  forInside([&](const ViewMm&, const ViewMm& p) { coarse.add(coarse_grid(p)); });
  const double cube_side =
      counted_side * std::sqrt(static_cast<double>(coarse.count()) / static_cast<double>(wanted));
  CubeCounts cubes(wanted);
  const CubeGrid grid(box, std::max(cube_side, side / (1U << 20U)));
  std::vector<std::uint64_t> numbers;
  std::vector<Gathered> gathered;
  gathered.reserve(wanted + wanted / 2);
  forInside([&](const ViewMm& from_corner, const ViewMm& p) {
    const std::uint64_t number = grid(p);
    const std::size_t order = cubes.add(number);
    if (order == numbers.size()) {
      numbers.push_back(number);
      gathered.emplace_back();
    }
    gathered[order].add(from_corner);
  });
  // Thinning leaves of a surface one point in many, of strays every one: most of what is chosen
  // would be strays. Their cubes have nobody around.
  const double mean = static_cast<double>(count) / static_cast<double>(cubes.count());
  const auto company = static_cast<std::uint32_t>(std::max(kFewestCompany, kCompanyOfMean * mean));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool has_company =
        cubes.points(numbers[i]) >= company || CubeGrid::around(numbers[i], cubes) >= company;
    if (has_company) chosen.push_back(gathered[i].middle());
  }
  return chosen;
}

}  // namespace relievo
