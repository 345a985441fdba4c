// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/surface_discs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <Eigen/Dense>

#include "core/neighbours/point_neighbours.h"

namespace relievo {
namespace {

constexpr int kNeighbours = 12;   // For the plane.
constexpr int kSpacingOf = 8;     // The distance to this one tells the density.
constexpr float kRadius = 1.15F;  // Of a disc, in distances to that neighbour.
// Points on a plane have pi d^2 / 9 of it each, where d is the distance to the eighth.
constexpr float kSpacingShare = 0.59F;
constexpr int kFewestBonds = 3;  // Of the eight neighbours, how many have the point for theirs.
constexpr int kMostStrayNeighbours = 4;
constexpr float kAlike = 0.85F;      // Cosine between normals of one surface.
constexpr float kOffPlane = 0.6F;    // In distances to the eighth neighbour.
constexpr float kFarFromAll = 3;     // In medians: there a plane must be a good one.
constexpr float kGoodPlane = 0.02F;  // Least over middle variance.
constexpr float kInNoPlane = 0.25F;  // Least over middle variance.
// Roughness that smooth bodies have by their curvature, and one that only noise makes.
constexpr double kSmooth = 0.1;
constexpr double kNoisy = 0.2;

struct Patch {
  float far = 0;        // Distance to the eighth neighbour; 0: there is none.
  float farthest = 0;   // To the last one.
  float off = 0;        // Distance of the point from its neighbours' plane.
  float thickness = 0;  // Their rms distance from it ...
  float width = 0;      // ... and across it, the narrower way.
  Eigen::Vector3f middle, normal;
};

Patch patchOf(const PointNeighbours& points, const NearPlaces& near) {
  Patch patch;
  const auto count = near.places.size() - 1;
  if (count < 3) return patch;
  const Eigen::Vector3f centre(points.place(near.of).data());
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  Eigen::Matrix3f products = Eigen::Matrix3f::Zero();
  // From the point itself: differences keep their digits.
  for (const std::uint32_t place : near.places.subspan(1)) {
    const Eigen::Vector3f d = Eigen::Vector3f(points.place(place).data()) - centre;
    sum += d;
    products += d * d.transpose();
  }
  const Eigen::Vector3f mean = sum / static_cast<float>(count);
  const Eigen::Matrix3f spread = products / static_cast<float>(count) - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> axes;
  axes.computeDirect(spread);
  patch.normal = axes.eigenvectors().col(0).normalized();
  if (patch.normal.z() < 0) patch.normal = -patch.normal;
  patch.middle = centre + mean;
  patch.off = std::abs(patch.normal.dot(mean));
  patch.thickness = std::sqrt(std::max(axes.eigenvalues()[0], 0.0F));
  patch.width = std::sqrt(std::max(axes.eigenvalues()[1], 0.0F));
  patch.far = std::sqrt(near.squared[std::min<std::size_t>(kSpacingOf, count)]);
  patch.farthest = std::sqrt(near.squared.back());
  return patch;
}

void store(const Eigen::Vector3f& from, std::array<float, 3>& to) {
  to = {from.x(), from.y(), from.z()};
}

/// The disc lies in its neighbours' plane; where they lie in none it faces the viewer.
SurfaceDisc discOf(const PointNeighbours& points, const NearPlaces& near, const Patch& patch) {
  SurfaceDisc disc;
  disc.spacing = kSpacingShare * patch.far;
  Eigen::Vector3f centre(points.place(near.of).data());
  Eigen::Vector3f normal = patch.normal;
  const bool is_plane = patch.thickness * patch.thickness < kInNoPlane * patch.width * patch.width;
  if (is_plane) {
    disc.radius = kRadius * patch.far;
  } else {
    normal = Eigen::Vector3f::UnitZ();
    disc.radius = disc.spacing;
  }
  const Eigen::Vector3f side =
      std::abs(normal.x()) < 0.7F ? Eigen::Vector3f::UnitX() : Eigen::Vector3f::UnitY();
  const Eigen::Vector3f right = (side - normal * normal.dot(side)).normalized();
  const Eigen::Vector3f up = normal.cross(right);
  store(centre, disc.centre);
  store(normal, disc.normal);
  store(right, disc.right);
  store(up, disc.up);
  disc.reach.fill(0);
  for (const std::uint32_t place : near.places.subspan(1)) {
    const Eigen::Vector3f d = Eigen::Vector3f(points.place(place).data()) - centre;
    const float a = right.dot(d);
    const float b = up.dot(d);
    const float c = (a + b) * 0.70710678F;
    const float e = (a - b) * 0.70710678F;
    const std::array<float, 8> along{a, -a, b, -b, c, -c, e, -e};
    for (std::size_t i = 0; i < 8; ++i) disc.reach[i] = std::max(disc.reach[i], along[i]);
  }
  for (float& reach : disc.reach) reach = std::min(reach + disc.spacing / 2, disc.radius);
  return disc;
}

/// Noisy points belong onto their neighbours' plane; those of a smooth body do not: the plane cuts
/// off what bulges.
void moveOntoPlane(SurfaceDisc& disc, const Patch& patch, double share) {
  if (disc.radius == disc.spacing) return;  // It lies in no plane.
  Eigen::Vector3f centre(disc.centre.data());
  centre += static_cast<float>(share) * patch.normal * patch.normal.dot(patch.middle - centre);
  store(centre, disc.centre);
}

double median(std::vector<float> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return static_cast<double>(*middle);
}

/// Tells points that stand alone in space from those on surfaces.
class StrayFinder {
 public:
  explicit StrayFinder(std::size_t count) : patches_(count), near_(count), is_stray_(count, 0) {}

  void set(const NearPlaces& near, const Patch& patch) {
    patches_[near.of] = patch;
    Near& its = near_[near.of];
    its.count = static_cast<int>(std::min<std::size_t>(kSpacingOf, near.places.size() - 1));
    for (std::size_t k = 0; k < static_cast<std::size_t>(its.count); ++k) {
      its.places[k] = near.places[k + 1];
      its.squared[k] = near.squared[k + 1];
    }
  }

  const std::vector<Patch>& patches() const { return patches_; }

  /// Per place 1 for a stray. @param usual  median of Patch::far
  const std::vector<std::uint8_t>& find(float usual) {
    for (std::size_t i = 0; i < patches_.size(); ++i) is_stray_[i] = isAlone(i, usual) ? 1 : 0;
    // Among strays others are strays, too, however well they lie.
    const std::vector<std::uint8_t> alone = is_stray_;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      int strays = 0;
      for (int k = 0; k < near_[i].count; ++k) {
        strays += alone[near_[i].places[static_cast<std::size_t>(k)]];
      }
      if (strays > kMostStrayNeighbours) is_stray_[i] = 1;
    }
    return is_stray_;
  }

 private:
  struct Near {
    std::array<std::uint32_t, kSpacingOf> places{};
    std::array<float, kSpacingOf> squared{};
    int count = 0;
  };

  bool isAlone(std::size_t i, float usual) const {
    const Patch& patch = patches_[i];
    if (!(patch.far > 0) || patch.off > kOffPlane * patch.far) return true;
    const float flatness =
        patch.thickness * patch.thickness / std::max(patch.width * patch.width, 1e-30F);
    if (patch.far > kFarFromAll * usual && (flatness > kGoodPlane || !isOneSurface(i))) return true;
    // On a surface most neighbours are so of each other; who stands off it is nobody's.
    int bonds = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(near_[i].count); ++k) {
      const float theirs = patches_[near_[i].places[k]].farthest;
      bonds += near_[i].squared[k] <= theirs * theirs ? 1 : 0;
    }
    return bonds < std::min(kFewestBonds, near_[i].count);
  }

  /// Do most neighbours face the same way?
  bool isOneSurface(std::size_t i) const {
    int alike = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(near_[i].count); ++k) {
      const Patch& other = patches_[near_[i].places[k]];
      alike += other.far > 0 && std::abs(other.normal.dot(patches_[i].normal)) > kAlike ? 1 : 0;
    }
    return 2 * alike > near_[i].count;
  }

  std::vector<Patch> patches_;
  std::vector<Near> near_;
  std::vector<std::uint8_t> is_stray_;
};

}  // namespace

SurfaceDiscs surfaceDiscs(std::span<const std::array<float, 3>> points, const Task& task) {
  SurfaceDiscs result;
  const PointNeighbours neighbours(points, task);
  const std::size_t count = neighbours.places();
  std::vector<SurfaceDisc> discs(count);
  StrayFinder strays(count);
  neighbours.nearest(kNeighbours + 1, 0, task, [&](const NearPlaces& near) {
    const Patch patch = patchOf(neighbours, near);
    if (patch.far > 0) discs[near.of] = discOf(neighbours, near, patch);
    strays.set(near, patch);
  });
  std::vector<float> far(count);
  std::vector<float> rough(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Patch& patch = strays.patches()[i];
    far[i] = patch.far;
    rough[i] = patch.width > 0 ? patch.thickness / patch.width : 0;
  }
  const double usual = median(std::move(far));
  const std::vector<std::uint8_t>& is_stray = strays.find(static_cast<float>(usual));
  result.spacing = static_cast<double>(kSpacingShare) * usual;
  result.roughness = median(std::move(rough));
  const double share = std::clamp((result.roughness - kSmooth) / (kNoisy - kSmooth), 0.0, 1.0);
  result.discs.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (is_stray[i] != 0) {
      result.strays += neighbours.pointsAt(i).size();
    } else {
      moveOntoPlane(discs[i], strays.patches()[i], share);
      result.discs.push_back(discs[i]);
    }
  }
  return result;
}

}  // namespace relievo
