// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/off_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

#include <Eigen/Eigenvalues>

namespace relievo {
namespace {

constexpr std::size_t kNear = 12;
constexpr std::size_t kFewest = 5;   ///< Places that make a plane.
constexpr std::size_t kLeftOut = 2;  ///< Of a plane's places, those farthest from it.
constexpr double kSmooth = 0.05;     ///< Of the mean distance: what is nearer the plane is on it.
constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();

struct Plane {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
  double distanceTo(const Eigen::Vector3d& p) const { return std::abs(normal.dot(p - middle)); }
};

Plane planeOf(std::span<const Eigen::Vector3d> places) {
  Plane plane;
  for (const Eigen::Vector3d& p : places) plane.middle += p;
  plane.middle /= static_cast<double>(places.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : places) {
    const Eigen::Vector3d d = p - plane.middle;
    spread += d * d.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(spread);
  plane.normal = axes.eigenvectors().col(0);
  return plane;
}

/// How far a place is from its neighbours' plane, by a plane without the farthest of them: one of
/// them may be a stray itself.
double offPlane(const Eigen::Vector3d& at, std::span<Eigen::Vector3d> near) {
  if (near.size() < kFewest) return 0;
  const Plane all = planeOf(near);
  const std::span<Eigen::Vector3d> most = near.first(near.size() - kLeftOut);
  std::nth_element(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(most.size()),
                   near.end(), [&all](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                     return all.distanceTo(a) < all.distanceTo(b);
                   });
  return planeOf(most).distanceTo(at);
}

struct Around {
  std::array<std::uint32_t, kNear> places;
  double off = 0;            ///< From the plane of these places.
  double mean_distance = 0;  ///< To them.
};

std::vector<Around> aroundAll(const PointNeighbours& neighbours, const Task& task) {
  const auto at = [&neighbours](std::uint32_t place) -> Eigen::Vector3d {
    const Point3f& p = neighbours.place(place);
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  };
  std::vector<Around> all(neighbours.places());
  neighbours.nearest(kNear + 1, 0, task, [&](const NearPlaces& near) {
    Around& around = all[near.of];
    around.places.fill(kNobody);
    std::array<Eigen::Vector3d, kNear> places;
    const std::size_t count = near.places.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
      around.places[i] = near.places[i + 1];
      places[i] = at(near.places[i + 1]);
      around.mean_distance +=
          std::sqrt(static_cast<double>(near.squared[i + 1])) / static_cast<double>(count);
    }
    around.off = offPlane(at(near.places[0]), std::span(places).first(count));
  });
  return all;
}

/// How many times as far from its plane as the middle one of its neighbours.
float timesOff(const Around& around, const std::vector<Around>& all) {
  std::array<double, kNear> offs{};
  std::size_t count = 0;
  for (const std::uint32_t place : around.places) {
    if (place != kNobody) offs[count++] = all[place].off;
  }
  if (count == 0 || !(around.mean_distance > 0)) return 0;
  auto* const middle = offs.begin() + count / 2;
  std::nth_element(offs.begin(), middle, offs.begin() + count);
  return static_cast<float>(around.off / std::max(*middle, kSmooth * around.mean_distance));
}

}  // namespace

std::vector<std::uint32_t> withoutOffSurface(const PointNeighbours& neighbours, std::size_t points,
                                             double times, const Task& task) {
  const std::vector<Around> all = aroundAll(neighbours, task);
  std::vector<float> offs(points, 0);
  for (std::size_t place = 0; place < all.size(); ++place) {
    const float off = timesOff(all[place], all);
    for (const std::uint32_t point : neighbours.pointsAt(place)) offs[point] = off;
  }
  const auto most = static_cast<std::size_t>(kMostOffSurface * static_cast<double>(points));
  auto limit = static_cast<float>(times);
  if (std::vector<float> sorted = offs; most < points) {
    const auto rank = sorted.begin() + static_cast<std::ptrdiff_t>(most);
    std::nth_element(sorted.begin(), rank, sorted.end(), std::greater<>());
    limit = std::max(limit, *rank);
  }
  std::vector<std::uint32_t> kept;
  kept.reserve(points);
  for (std::size_t i = 0; i < points; ++i) {
    if (!(offs[i] > limit)) kept.push_back(static_cast<std::uint32_t>(i));
  }
  return kept;
}

}  // namespace relievo
