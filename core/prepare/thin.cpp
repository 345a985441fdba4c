// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/thin.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/failure.h"

namespace relievo {
namespace {

constexpr unsigned kAxisBits = 21;
constexpr std::int64_t kMostCells = std::int64_t{1} << kAxisBits;
constexpr std::size_t kCheckEvery = 1U << 18U;

struct Candidate {
  std::uint64_t cell;
  float off_middle;  ///< Squared distance, in cubes.
  std::uint32_t number;

  friend bool operator<(const Candidate& a, const Candidate& b) {
    if (a.cell != b.cell) return a.cell < b.cell;
    if (a.off_middle != b.off_middle) return a.off_middle < b.off_middle;
    return a.number < b.number;
  }
};

/// The lowest cube along each axis. The difference of two points' cubes fits into 21 bits.
std::array<double, 3> lowestCells(std::span<const Point3f> points,
                                  const std::array<double, 3>& centre, double spacing) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{kInfinite, kInfinite, kInfinite};
  std::array<double, 3> high{-kInfinite, -kInfinite, -kInfinite};
  for (const Point3f& p : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], static_cast<double>(p[axis]));
      high[axis] = std::max(high[axis], static_cast<double>(p[axis]));
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double first = std::floor((centre[axis] + low[axis]) / spacing);
    const double last = std::floor((centre[axis] + high[axis]) / spacing);
    // Beyond 2^53 neighbouring cubes have one number.
    const bool counts = std::abs(first) < 9e15 && std::abs(last) < 9e15;
    if (!counts || last - first >= static_cast<double>(kMostCells)) {
      throw failure<MessageId::scan_too_long_to_thin>();
    }
    low[axis] = first;
  }
  return low;
}

}  // namespace

std::vector<std::uint32_t> thinned(std::span<const Point3f> points, const FilePoint& centre,
                                   double spacing, const Task& task) {
  std::vector<std::uint32_t> kept;
  if (points.empty()) return kept;
  const std::array<double, 3> middle{centre.x, centre.y, centre.z};
  const std::array<double, 3> low = lowestCells(points, middle, spacing);
  std::vector<Candidate> candidates(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % kCheckEvery == 0) task.check();
    std::uint64_t key = 0;
    double off = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double place = (middle[axis] + static_cast<double>(points[i][axis])) / spacing;
      const double cell = std::floor(place);
      key = key << kAxisBits | static_cast<std::uint64_t>(cell - low[axis]);
      const double from_middle = place - cell - 0.5;
      off += from_middle * from_middle;
    }
    candidates[i] = {key, static_cast<float>(off), static_cast<std::uint32_t>(i)};
  }
  task.check();
  std::sort(candidates.begin(), candidates.end());
  task.check();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (i == 0 || candidates[i].cell != candidates[i - 1].cell) {
      kept.push_back(candidates[i].number);
    }
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

std::vector<std::uint32_t> withoutDuplicates(std::span<const Point3f> points, const Task& task) {
  struct Place {
    std::array<std::uint32_t, 3> bits;
    std::uint32_t number;
    auto operator<=>(const Place&) const = default;
  };
  std::vector<Place> places(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % kCheckEvery == 0) task.check();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // -0 becomes 0: the two are one place.
      places[i].bits[axis] = std::bit_cast<std::uint32_t>(points[i][axis] + 0.0F);
    }
    places[i].number = static_cast<std::uint32_t>(i);
  }
  task.check();
  std::sort(places.begin(), places.end());
  task.check();
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i == 0 || places[i].bits != places[i - 1].bits) kept.push_back(places[i].number);
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace relievo
