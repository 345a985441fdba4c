// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/align/align_picks.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>

#include "core/base/failure.h"
#include "core/prepare/align/align_math.h"

namespace relievo::align {
namespace {

constexpr double kLeastAngle = 5 * std::numbers::pi / 180;
constexpr double kMostStretch = 1.5;    ///< Of the picks' spread, one scan over the other.
constexpr std::size_t kTriangles = 32;  ///< Of the first so many picks all are tried.

using Places = std::vector<Eigen::Vector3d>;

double angleAt(const Eigen::Vector3d& corner, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d u = a - corner;
  const Eigen::Vector3d v = b - corner;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// Of the best triangle of the picks its smallest angle; 0 where they lie in one line.
double bestAngle(const Places& places) {
  const std::size_t count = std::min(places.size(), kTriangles);
  double best = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      for (std::size_t k = j + 1; k < count; ++k) {
        best = std::max(best, std::min({angleAt(places[i], places[j], places[k]),
                                        angleAt(places[j], places[k], places[i]),
                                        angleAt(places[k], places[i], places[j])}));
      }
    }
  }
  return best;
}

Eigen::Vector3d meanOf(const Places& places) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : places) mean += p;
  return mean / static_cast<double>(places.size());
}

double spreadOf(const Places& places, const Eigen::Vector3d& mean) {
  double sum = 0;
  for (const Eigen::Vector3d& p : places) sum += (p - mean).squaredNorm();
  return std::sqrt(sum / static_cast<double>(places.size()));
}

/// A column for each place, from their mean: projected coordinates would lose the picks.
Eigen::Matrix3Xd columns(const Places& places, const Eigen::Vector3d& mean) {
  Eigen::Matrix3Xd matrix(3, static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) {
    matrix.col(static_cast<Eigen::Index>(i)) = places[i] - mean;
  }
  return matrix;
}

/// The places of pairs, on the one scan and on the reference.
struct Sides {
  explicit Sides(std::span<const PickedPair> picks) {
    for (const PickedPair& pair : picks) {
      on_scan.push_back(vector(pair.point));
      on_reference.push_back(vector(pair.reference));
    }
  }
  Places on_scan, on_reference;
};

}  // namespace

std::optional<Message> pickProblem(std::span<const PickedPair> picks, const std::string& scan) {
  if (picks.size() < 3) return said<MessageId::picks_too_few>(scan, picks.size());
  const Sides sides(picks);
  if (std::min(bestAngle(sides.on_scan), bestAngle(sides.on_reference)) < kLeastAngle) {
    return said<MessageId::picks_in_one_line>(scan);
  }
  const double stretch = spreadOf(sides.on_reference, meanOf(sides.on_reference)) /
                         spreadOf(sides.on_scan, meanOf(sides.on_scan));
  if (!(stretch < kMostStretch && stretch > 1 / kMostStretch)) {
    return said<MessageId::picks_of_two_sizes>(scan);
  }
  return std::nullopt;
}

PickedFit fitPicks(std::span<const PickedPair> picks, const std::string& scan) {
  if (const auto message = pickProblem(picks, scan)) throw ArgumentError(*message);
  const Sides sides(picks);
  const Eigen::Vector3d scan_mean = meanOf(sides.on_scan);
  const Eigen::Vector3d reference_mean = meanOf(sides.on_reference);
  LocalPose local = LocalPose::Identity();
  local.matrix() = Eigen::umeyama(columns(sides.on_scan, scan_mean),
                                  columns(sides.on_reference, reference_mean), false);
  assert(local.linear().determinant() > 0);  // Of mirrored places it gives the nearest turn.
  local = exactlyRigid(local);
  const auto file = [](const Eigen::Vector3d& p) { return FilePoint{p.x(), p.y(), p.z()}; };
  PickedFit fit{.pose = fileFromMiddles(local, file(reference_mean), file(scan_mean)),
                .error = 0,
                .errors = {}};
  double squares = 0;
  for (const PickedPair& pair : picks) {
    const FilePoint miss = fit.pose(pair.point) - pair.reference;
    squares += dot(miss, miss);
    fit.errors.push_back(norm(miss));
  }
  fit.error = std::sqrt(squares / static_cast<double>(picks.size()));
  return fit;
}

}  // namespace relievo::align
