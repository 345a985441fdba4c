// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/align/judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Eigenvalues>

#include "core/message/catalogue.h"

namespace relievo::align {
namespace {

constexpr std::size_t kFewestMatches = 30;

std::vector<Point3f> moved(const std::vector<Point3f>& points, const LocalPose& pose) {
  std::vector<Point3f> result;
  result.reserve(points.size());
  for (const Point3f& p : points) {
    const Eigen::Vector3d q = pose * vector(p);
    result.push_back(
        {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z())});
  }
  return result;
}

struct Counts {
  std::size_t loose = 0, tight = 0;
};

/// From every point of `from` to the nearest of `to`; `from_first` says which of the two is the
/// scan.
Counts addMatches(const OrientedSet& from, const OrientedSet& to, const LocalPose& to_from_from,
                  bool from_is_scan, const LocalPose& pose, double farthest, const Task& task,
                  std::vector<Match>& list) {
  const std::vector<std::uint32_t> nearest =
      to.nearest(moved(from.points, to_from_from), farthest, task);
  const double tight_squared = from.cell * from.cell;
  Counts counts;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    if (nearest[i] == OrientedSet::kNobody) continue;
    const OrientedSet& scan = from_is_scan ? from : to;
    const OrientedSet& reference = from_is_scan ? to : from;
    const std::size_t s = from_is_scan ? i : nearest[i];
    const std::size_t r = from_is_scan ? nearest[i] : i;
    const Match match{pose * vector(scan.points[s]), vector(reference.points[r]),
                      pose.linear() * vector(scan.normals[s]), vector(reference.normals[r])};
    if (match.scan_normal.dot(match.reference_normal) < kNormalsAgree) continue;
    ++counts.loose;
    if ((match.scan - match.reference).squaredNorm() <= tight_squared) ++counts.tight;
    list.push_back(match);
  }
  return counts;
}

double shareOf(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

NumberArgument percent(double share) {
  return {.value = 100 * share, .unit = MessageUnit::percent};
}

/// Two digits that count.
NumberArgument millimetres(double mm) {
  const int decimals =
      mm > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(mm))), 0, 6) : 3;
  return {.value = mm, .digits = decimals, .unit = MessageUnit::millimetre};
}

/// "x" within 10 degrees of an axis, else the components.
Message directionOf(const Eigen::Vector3d& direction) {
  constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(direction(static_cast<Eigen::Index>(i))) > 0.985) {
      return said<MessageId::quoted>(kAxes[i]);
    }
  }
  const auto component = [](double value) { return NumberArgument{.value = value, .digits = 2}; };
  return said<MessageId::direction>(component(direction.x()), component(direction.y()),
                                    component(direction.z()));
}

Message motionOf(const Judgement& judgement) {
  Message direction = directionOf(judgement.weak_direction);
  return judgement.weak_turn ? said<MessageId::motion_about>(std::move(direction))
                             : said<MessageId::motion_along>(std::move(direction));
}

std::vector<Message> refusalOf(const Judgement& found, const Matches& matches,
                               const Demands& demands, double cell) {
  if (matches.scan_loose < kFewestMatches || matches.reference_loose < kFewestMatches) {
    return {said<MessageId::pose_hardly_touches>()};
  }
  if (found.tight_share < demands.tight_share) {
    return {said<MessageId::pose_shares_little>(percent(found.tight_share))};
  }
  const std::size_t loose = matches.scan_loose + matches.reference_loose;
  if (found.rms > demands.rms_cells * cell ||
      shareOf(matches.scan_tight + matches.reference_tight, loose) < demands.tight_of_loose) {
    return {said<MessageId::pose_only_touches>()};
  }
  return {};
}

}  // namespace

Matches matchesOf(const OrientedSet& scan, const OrientedSet& reference, const LocalPose& pose,
                  double farthest, const Task& task) {
  Matches matches;
  const Counts forth = addMatches(scan, reference, pose, true, pose, farthest, task, matches.list);
  const Counts back = addMatches(reference, scan, pose.inverse(Eigen::Isometry), false, pose,
                                 farthest, task, matches.list);
  matches.scan_loose = forth.loose;
  matches.scan_tight = forth.tight;
  matches.reference_loose = back.loose;
  matches.reference_tight = back.tight;
  return matches;
}

double Stability::ratio() const {
  return values(5) > 0 ? std::max(0.0, values(0)) / values(5) : 0.0;
}

bool Stability::slides(Eigen::Index motion) const {
  return values(motion) < std::clamp(noise, kSlides * values(5), kSlidesAtMost * values(5));
}

Stability stabilityOf(const std::vector<Match>& matches) {
  Stability stability;
  if (matches.empty()) return stability;
  const double count = static_cast<double>(matches.size());
  for (const Match& m : matches) stability.centre += m.middle() / count;
  double arms = 0;
  for (const Match& m : matches) arms += (m.middle() - stability.centre).norm() / count;
  if (arms > 0) stability.arm = arms;
  Matrix6d products = Matrix6d::Zero();
  double differences = 0;
  for (const Match& m : matches) {
    const Eigen::Vector3d arm = (m.middle() - stability.centre) / stability.arm;
    Vector6d scan;
    Vector6d reference;
    scan << arm.cross(m.scan_normal), m.scan_normal;
    reference << arm.cross(m.reference_normal), m.reference_normal;
    differences += (m.scan_normal - m.reference_normal).squaredNorm() / count;
    products += (scan * reference.transpose() + reference * scan.transpose()) / (2 * count);
  }
  // A normal's noise has two directions and comes twice; so many matches share their points.
  constexpr double kShareNormals = 28;
  stability.noise = 5 * differences / 4 / std::sqrt(std::max(1.0, count / kShareNormals));
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(products);
  stability.values = solver.eigenvalues();
  stability.vectors = solver.eigenvectors();
  return stability;
}

Judgement judge(const OrientedSet& scan, const OrientedSet& reference, const LocalPose& pose,
                const Demands& demands, const Task& task) {
  const double cell = reference.cell;
  const Matches matches = matchesOf(scan, reference, pose, kLooseCells * cell, task);
  Judgement found;
  found.share = std::max(shareOf(matches.scan_loose, scan.points.size()),
                         shareOf(matches.reference_loose, reference.points.size()));
  found.tight_share = std::max(shareOf(matches.scan_tight, scan.points.size()),
                               shareOf(matches.reference_tight, reference.points.size()));
  double squares = 0;
  for (const Match& m : matches.list) squares += m.residual() * m.residual();
  if (!matches.list.empty()) {
    found.rms = std::sqrt(squares / static_cast<double>(matches.list.size()));
  }
  const Stability stability = stabilityOf(matches.list);
  found.stability = stability.ratio();
  const Vector6d weakest = stability.vectors.col(0);
  found.weak_turn = weakest.head<3>().norm() > weakest.tail<3>().norm();
  found.weak_direction = found.weak_turn ? weakest.head<3>() : weakest.tail<3>();
  found.weak_direction.normalize();
  found.slides = stability.slides(0);
  if (!found.slides) {
    const double seen = static_cast<double>(std::min(matches.scan_loose, matches.reference_loose));
    found.weak_motion =
        kUncertaintyFactor * found.rms / std::sqrt(std::max(1.0, seen) * stability.values(0));
  }
  found.reason = refusalOf(found, matches, demands, cell);
  found.fits = found.reason.empty();
  if (found.fits && found.stability < demands.stability) {
    found.reason = {said<MessageId::pose_undecided>(motionOf(found))};
  }
  if (!found.reason.empty()) {
    found.answer = Answer::refused;
  } else if (found.slides) {
    found.answer = Answer::slides;
  } else {
    found.answer = found.stability < kHolds ? Answer::weak : Answer::holds;
  }
  return found;
}

Message messageOf(const Judgement& judgement, double mm_per_unit) {
  if (judgement.answer == Answer::refused) {
    return said<MessageId::pose_refused>(judgement.reason);
  }
  const NumberArgument rms = millimetres(judgement.rms * mm_per_unit);
  const NumberArgument common = percent(judgement.share);
  if (judgement.answer == Answer::weak) {
    return said<MessageId::pose_is_weak>(rms, common, motionOf(judgement),
                                         millimetres(judgement.weak_motion * mm_per_unit));
  }
  if (judgement.answer == Answer::slides) {
    return said<MessageId::pose_slides>(rms, common, motionOf(judgement));
  }
  return said<MessageId::pose_holds>(rms, common);
}

}  // namespace relievo::align
