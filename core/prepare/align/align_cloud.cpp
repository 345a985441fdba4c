// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/align/align_cloud.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <limits>
#include <string>

#include "core/base/failure.h"
#include "core/prepare/align/align_math.h"

namespace relievo::align {
namespace {

constexpr double kFinePerSpacing = 2.5;
constexpr double kFinestPerSpacing = 1.5;
constexpr double kMidCells = 120;  ///< Along the diagonal.
constexpr double kCoarseCells = 50;
constexpr double kFineNormalCells = 3;  ///< Radius of a normal's neighbourhood.
constexpr double kCoarseNormalCells = 2;
/// Points of the surface that normals are fitted to, per spacing of the coarsest scan: a scan ten
/// times as dense gains nothing from a hundred times as many.
constexpr double kSurfaceCell = 0.5;
constexpr std::size_t kSpacingSample = 20000;
/// A scan whose thickness is less than this share of its width is a plate: its middle lies in its
/// surface and does not say which side is outside.
constexpr double kPlate = 0.1;

struct Box {
  FilePoint min, max;
};

Box boxOf(const AlignScan& scan) {
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  std::array<float, 3> low{kInfinite, kInfinite, kInfinite};
  std::array<float, 3> high{-kInfinite, -kInfinite, -kInfinite};
  for (const Point3f& p : scan.points) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  const auto file = [&](const std::array<float, 3>& p) {
    return scan.origin + FilePoint{static_cast<double>(p[0]), static_cast<double>(p[1]),
                                   static_cast<double>(p[2])};
  };
  return {file(low), file(high)};
}

std::vector<Point3f> fromMiddle(const AlignScan& scan, const FilePoint& middle) {
  const FilePoint shift = scan.origin - middle;
  std::vector<Point3f> points;
  points.reserve(scan.points.size());
  for (const Point3f& p : scan.points) {
    points.push_back({static_cast<float>(static_cast<double>(p[0]) + shift.x),
                      static_cast<float>(static_cast<double>(p[1]) + shift.y),
                      static_cast<float>(static_cast<double>(p[2]) + shift.z)});
  }
  return points;
}

/// Median distance from a point to its nearest neighbour, of some thousands of them.
double spacingOf(const AlignScan& scan, const Task& task) {
  const Box box = boxOf(scan);
  const PointNeighbours neighbours(fromMiddle(scan, 0.5 * (box.min + box.max)), task);
  const std::size_t places = neighbours.places();
  if (places < kFewestPoints) {
    throw failure<MessageId::align_few_points>(scan.name, places, kFewestPoints);
  }
  const std::size_t step = std::max<std::size_t>(1, places / kSpacingSample);
  std::vector<Point3f> sample;
  for (std::size_t i = 0; i < places; i += step) sample.push_back(neighbours.place(i));
  std::vector<float> squared(sample.size());
  neighbours.nearestTo(sample, 2, 0, task,
                       [&](const NearPlaces& near) { squared[near.of] = near.squared[1]; });
  const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(squared.size() / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return std::sqrt(static_cast<double>(*middle));
}

struct Sides {
  Eigen::Vector3d from;  ///< Normals look away from here, or
  bool toward = false;   ///< toward it.
  bool guessed = false;
};

/// Where outside is: toward the viewpoint; else away from the middle. Of a plate: where it rises
/// from its ground, which is a guess.
Sides sidesOf(const AlignScan& scan, const FilePoint& middle, std::span<const Point3f> points) {
  if (scan.viewpoint) return {vector(*scan.viewpoint - middle), true, false};
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Point3f& p : points) mean += vector(p);
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Point3f& p : points) {
    const Eigen::Vector3d d = vector(p) - mean;
    spread += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const double thickness = std::sqrt(std::max(0.0, axes.eigenvalues()(0) / axes.eigenvalues()(1)));
  if (thickness >= kPlate) return {mean, false, false};
  const Eigen::Vector3d across = axes.eigenvectors().col(0);
  double rise = 0;
  for (const Point3f& p : points) rise += std::pow(across.dot(vector(p) - mean), 3);
  const double far = 10 * std::sqrt(axes.eigenvalues()(2) / static_cast<double>(points.size()));
  return {mean + (rise < 0 ? -far : far) * across, true, true};
}

OrientedSet thinnedSet(std::span<const Point3f> points, std::span<const Point3f> surface,
                       double cell, double radius, const Sides& sides, const Task& task) {
  std::vector<Point3f> places;
  for (const std::uint32_t i : thinned(points, cell)) places.push_back(points[i]);
  task.check();
  const std::vector<Point3f> normals = normalsOf(places, surface, radius);
  task.check();
  std::vector<Point3f> kept_places;
  std::vector<Point3f> kept_normals;
  for (std::size_t i = 0; i < places.size(); ++i) {
    Eigen::Vector3d normal = vector(normals[i]);
    if (!normal.allFinite()) continue;
    const bool away = normal.dot(vector(places[i]) - sides.from) > 0;
    if (away == sides.toward) normal = -normal;
    kept_places.push_back(places[i]);
    kept_normals.push_back({static_cast<float>(normal.x()), static_cast<float>(normal.y()),
                            static_cast<float>(normal.z())});
  }
  return setOf(kept_places, kept_normals, cell, task);
}

void turnOver(OrientedSet& set) {
  for (Point3f& n : set.normals) n = {-n[0], -n[1], -n[2]};
}

}  // namespace

Scale scaleOf(std::span<const AlignScan> scans, const Task& task) {
  Scale scale;
  for (const AlignScan& scan : scans) {
    const Box box = boxOf(scan);
    scale.spacing = std::max(scale.spacing, spacingOf(scan, task));
    scale.diagonal = std::max(scale.diagonal, norm(box.max - box.min));
  }
  scale.fine = kFinePerSpacing * scale.spacing;
  scale.mid = std::max(scale.fine, scale.diagonal / kMidCells);
  scale.coarse = std::max(scale.fine, scale.diagonal / kCoarseCells);
  return scale;
}

OrientedSet setOf(std::span<const Point3f> points, std::span<const Point3f> normals, double cell,
                  const Task& task) {
  OrientedSet set;
  set.cell = cell;
  set.neighbours = std::make_unique<PointNeighbours>(points, task);
  for (std::size_t i = 0; i < set.neighbours->places(); ++i) {
    const std::uint32_t point = set.neighbours->pointsAt(i).front();
    set.points.push_back(points[point]);
    set.normals.push_back(normals[point]);
  }
  return set;
}

std::vector<std::uint32_t> OrientedSet::nearest(std::span<const Point3f> queries, double farthest,
                                                const Task& task) const {
  std::vector<std::uint32_t> found(queries.size(), kNobody);
  const double farthest_squared = farthest * farthest;
  neighbours->nearestTo(queries, 1, 0, task, [&](const NearPlaces& near) {
    if (near.places.empty() || static_cast<double>(near.squared[0]) > farthest_squared) return;
    found[near.of] = near.places[0];
  });
  return found;
}

Cloud cloudOf(const AlignScan& scan, const Scale& scale, const Task& task) {
  const Box box = boxOf(scan);
  Cloud cloud;
  cloud.middle = 0.5 * (box.min + box.max);
  const std::vector<Point3f> all = fromMiddle(scan, cloud.middle);
  std::vector<Point3f>& surface = cloud.surface;
  for (const std::uint32_t i : thinned(all, kSurfaceCell * scale.spacing))
    surface.push_back(all[i]);
  task.check();
  const Sides sides = sidesOf(scan, cloud.middle, surface);
  cloud.side_guessed = sides.guessed;
  const double fine_radius = kFineNormalCells * scale.fine;
  cloud.fine = thinnedSet(surface, surface, scale.fine, fine_radius, sides, task);
  cloud.mid = thinnedSet(surface, surface, scale.mid, fine_radius, sides, task);
  cloud.coarse = thinnedSet(surface, cloud.mid.points, scale.coarse,
                            kCoarseNormalCells * scale.coarse, sides, task);
  if (cloud.coarse.points.size() < 3) {
    throw failure<MessageId::align_no_surface>(scan.name);
  }
  return cloud;
}

OrientedSet finestOf(const Cloud& cloud, const Scale& scale, const Task& task) {
  const double cell = kFinestPerSpacing * scale.spacing;
  std::vector<Point3f> places;
  for (const std::uint32_t i : thinned(cloud.surface, cell)) places.push_back(cloud.surface[i]);
  task.check();
  const std::vector<Point3f> normals = normalsOf(places, cloud.surface, kFineNormalCells * cell);
  const std::vector<std::uint32_t> nearest = cloud.fine.nearest(places, scale.diagonal, task);
  std::vector<Point3f> kept_places;
  std::vector<Point3f> kept_normals;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector3d normal = vector(normals[i]);
    if (!normal.allFinite() || nearest[i] == OrientedSet::kNobody) continue;
    const bool along = normal.dot(vector(cloud.fine.normals[nearest[i]])) >= 0;
    const Point3f& n = normals[i];
    kept_places.push_back(places[i]);
    kept_normals.push_back(along ? n : Point3f{-n[0], -n[1], -n[2]});
  }
  return setOf(kept_places, kept_normals, cell, task);
}

void turnOver(Cloud& cloud) {
  turnOver(cloud.fine);
  turnOver(cloud.mid);
  turnOver(cloud.coarse);
}

std::vector<std::uint32_t> thinned(std::span<const Point3f> points, double cell) {
  if (points.empty()) return {};
  Point3f low = points[0];
  Point3f high = points[0];
  for (const Point3f& p : points) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  constexpr double kMostCells = 0x1p20;  // 21 bits an axis.
  double side = cell;
  for (std::size_t i = 0; i < 3; ++i) {
    side = std::max(side, static_cast<double>(high[i] - low[i]) / kMostCells);
  }
  struct Kept {
    std::uint64_t key;
    double from_middle;
    std::uint32_t point;
  };
  std::vector<Kept> kept;
  kept.reserve(points.size());
  for (std::size_t n = 0; n < points.size(); ++n) {
    Kept k{0, 0, static_cast<std::uint32_t>(n)};
    for (std::size_t i = 0; i < 3; ++i) {
      const double place = static_cast<double>(points[n][i] - low[i]) / side;
      const double at = std::floor(place);
      k.key = k.key << 21U | static_cast<std::uint64_t>(at);
      k.from_middle += (place - at - 0.5) * (place - at - 0.5);
    }
    kept.push_back(k);
  }
  std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) {
    if (a.key != b.key) return a.key < b.key;
    if (a.from_middle != b.from_middle) return a.from_middle < b.from_middle;
    return a.point < b.point;
  });
  std::vector<std::uint32_t> chosen;
  for (std::size_t n = 0; n < kept.size(); ++n) {
    if (n == 0 || kept[n].key != kept[n - 1].key) chosen.push_back(kept[n].point);
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace relievo::align
