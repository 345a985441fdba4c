// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/outliers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relievo {
namespace {

/// Calls use(squared distance, points) for places near one of them until `wanted` other points
/// were met. A place of w points stands for w neighbours, the point itself left out.
template <class Use>
void forNeighbours(const PointNeighbours& neighbours, const NearPlaces& near, std::size_t wanted,
                   const Use& use) {
  std::size_t met = 0;
  for (std::size_t i = 0; i < near.places.size() && met < wanted; ++i) {
    std::size_t points = neighbours.pointsAt(near.places[i]).size();
    if (i == 0) --points;
    points = std::min(points, wanted - met);
    met += points;
    use(near.squared[i], points);
  }
}

}  // namespace

std::vector<std::uint32_t> withoutOutliers(const PointNeighbours& neighbours, std::size_t points,
                                           const Outliers& step, const Task& task) {
  std::vector<float> distances(points);
  const auto wanted = static_cast<std::size_t>(step.neighbours);
  neighbours.nearest(step.neighbours + 1, 0, task, [&](const NearPlaces& near) {
    double sum = 0;
    forNeighbours(neighbours, near, wanted, [&sum](float squared, std::size_t times) {
      // One after the other: a product would round differently from PCL's sum.
      const double distance = std::sqrt(static_cast<double>(squared));
      for (std::size_t i = 0; i < times && squared > 0; ++i) sum += distance;
    });
    const auto mean = static_cast<float>(sum / step.neighbours);
    for (const std::uint32_t point : neighbours.pointsAt(near.of)) distances[point] = mean;
  });
  // Over the points in their own order, so that the sums are PCL's to the bit.
  double sum = 0;
  double sum_of_squares = 0;
  for (const float distance : distances) {
    sum += static_cast<double>(distance);
    sum_of_squares += static_cast<double>(distance * distance);
  }
  const auto count = static_cast<double>(points);
  const double variance = (sum_of_squares - sum * sum / count) / (count - 1);
  const double limit = sum / count + step.deviations * std::sqrt(variance);
  std::vector<std::uint32_t> kept;
  kept.reserve(points);
  for (std::size_t i = 0; i < points; ++i) {
    // A limit that is no number, of a single point or of rounding below 0, removes nothing.
    if (!(static_cast<double>(distances[i]) > limit)) kept.push_back(static_cast<std::uint32_t>(i));
  }
  return kept;
}

std::vector<std::uint32_t> withoutLonely(const PointNeighbours& neighbours, std::size_t points,
                                         double radius, int at_least, const Task& task) {
  std::vector<std::uint8_t> stays(points, 0);
  const auto wanted = static_cast<std::size_t>(at_least);
  neighbours.nearest(at_least + 1, 0, task, [&](const NearPlaces& near) {
    std::size_t close = 0;
    forNeighbours(neighbours, near, wanted, [&](float squared, std::size_t times) {
      if (static_cast<double>(squared) <= radius * radius) close += times;
    });
    if (close < wanted) return;
    for (const std::uint32_t point : neighbours.pointsAt(near.of)) stays[point] = 1;
  });
  std::vector<std::uint32_t> kept;
  kept.reserve(points);
  for (std::size_t i = 0; i < points; ++i) {
    if (stays[i] != 0) kept.push_back(static_cast<std::uint32_t>(i));
  }
  return kept;
}

std::vector<std::uint32_t> withoutSparse(const PointNeighbours& neighbours, std::size_t points,
                                         const Sparse& step, const Task& task) {
  constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();
  const auto wanted = static_cast<std::size_t>(step.neighbours);
  const std::size_t places = neighbours.places();
  std::vector<float> distances(places, 0);
  std::vector<std::uint32_t> near_by(places * wanted, kNobody);
  neighbours.nearest(step.neighbours + 1, 0, task, [&](const NearPlaces& near) {
    const std::size_t others = near.places.size() - 1;
    double sum = 0;
    for (std::size_t i = 0; i < others; ++i) {
      sum += std::sqrt(static_cast<double>(near.squared[i + 1]));
      near_by[near.of * wanted + i] = near.places[i + 1];
    }
    if (others > 0) distances[near.of] = static_cast<float>(sum / static_cast<double>(others));
  });
  std::vector<std::uint8_t> stays(points, 0);
  for (std::size_t place = 0; place < places; ++place) {
    float densest = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < wanted; ++i) {
      const std::uint32_t other = near_by[place * wanted + i];
      if (other != kNobody) densest = std::min(densest, distances[other]);
    }
    if (static_cast<double>(distances[place]) > step.factor * static_cast<double>(densest))
      continue;
    for (const std::uint32_t point : neighbours.pointsAt(place)) stays[point] = 1;
  }
  std::vector<std::uint32_t> kept;
  kept.reserve(points);
  for (std::size_t i = 0; i < points; ++i) {
    if (stays[i] != 0) kept.push_back(static_cast<std::uint32_t>(i));
  }
  return kept;
}

double spacingOf(const PointNeighbours& neighbours, const Task& task) {
  const std::size_t places = neighbours.places();
  if (places < 2) return 0;
  std::vector<float> squared(places);
  neighbours.nearest(2, 0, task,
                     [&](const NearPlaces& near) { squared[near.of] = near.squared[1]; });
  const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(places / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return std::sqrt(static_cast<double>(*middle));
}

}  // namespace relievo
