// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/guide/guide_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/failure.h"
#include "core/base/line_corners.h"

namespace relievo {
namespace {

constexpr double kToleranceMm = 0.3;
constexpr double kFarthestMm = 1000;  // A device's workspace is a tenth of it.
constexpr double kSamePlaceMm = 1e-6;

/// Points that are not the one before again.
std::vector<DeviceMm> apart(std::span<const DeviceMm> line, bool closed) {
  std::vector<DeviceMm> points;
  for (const DeviceMm& p : line) {
    if (points.empty() || norm(p - points.back()) > kSamePlaceMm) points.push_back(p);
  }
  while (closed && points.size() > 1 && norm(points.back() - points[0]) <= kSamePlaceMm) {
    points.pop_back();
  }
  return points;
}

void requireALine(std::span<const DeviceMm> line, std::size_t least) {
  for (const DeviceMm& p : line) {
    if (!isFinite(p)) throw failure<MessageId::guide_without_way>();
  }
  if (line.size() < least) throw failure<MessageId::guide_without_way>();
}

/// Index of those that are kept: as few as fit.
std::vector<std::size_t> thinned(std::span<const DeviceMm> line, bool closed, double tolerance) {
  std::vector<std::size_t> kept = lineCorners(line, closed, tolerance);
  while (kept.size() > GuidePath::kMostPoints) {
    tolerance = 2 * std::max(tolerance, kToleranceMm / 8);
    kept = lineCorners(line, closed, tolerance);
  }
  return kept;
}

/// Fills in what follows from the points.
void measure(GuidePath& path) {
  path.at_mm[0] = 0;
  for (std::uint32_t i = 0; i < path.stretches(); ++i) {
    path.at_mm[i + 1] = path.at_mm[i] + norm(path.end(i) - path.start(i));
  }
  // Backward, for a closed path twice round: the next stop may lie behind the first point.
  constexpr double kNever = 1e9;
  const std::uint32_t stretches = path.stretches();
  double to_stop = path.closed ? kNever : 0;  // An open path ends in one.
  for (std::uint32_t turn = path.closed ? 2 : 1; turn > 0; --turn) {
    for (std::uint32_t i = stretches; i-- > 0;) {
      const std::uint32_t next = i + 1 < path.count ? i + 1 : 0;
      const bool stops = path.points[next].pause_s > 0 || (!path.closed && next + 1 == path.count);
      const double way = path.at_mm[i + 1] - path.at_mm[i];
      to_stop = stops ? way : std::min(kNever, way + to_stop);
      path.to_stop_mm[i] = to_stop;
    }
  }
}

DeviceMm placeAt(const GuidePath& path, double mm) {
  const double length = path.lengthMm();
  if (path.closed) mm -= length * std::floor(mm / length);
  mm = std::clamp(mm, 0.0, length);
  const std::uint32_t i = path.stretchAt(mm);
  const double way = path.at_mm[i + 1] - path.at_mm[i];
  const double part = way > 0 ? (mm - path.at_mm[i]) / way : 0;
  return path.start(i) + part * (path.end(i) - path.start(i));
}

/// By how much the path turns at a point, degrees, on arms of kCornerArmMm; 0 at an open end.
double turnAt(const GuidePath& path, std::uint32_t i) {
  const double mm = path.at_mm[i];
  if (!path.closed && (i == 0 || i + 1 == path.count)) return 0;
  const DeviceMm in = path.points[i].place - placeAt(path, mm - kCornerArmMm);
  const DeviceMm out = placeAt(path, mm + kCornerArmMm) - path.points[i].place;
  const double lengths = norm(in) * norm(out);
  if (!(lengths > 0)) return 0;
  return std::acos(std::clamp(dot(in, out) / lengths, -1.0, 1.0)) * 180 / std::numbers::pi;
}

/// Pauses where it turns most within an arm's length, if that is a corner.
void pauseAtCorners(GuidePath& path) {
  std::vector<double> turns(path.count);
  for (std::uint32_t i = 0; i < path.count; ++i) turns[i] = turnAt(path, i);
  const double length = path.lengthMm();
  double last_mm = -2 * kCornerArmMm;
  for (std::uint32_t i = 0; i < path.count; ++i) {
    if (turns[i] <= kCornerDegrees) continue;
    bool is_sharpest = path.at_mm[i] - last_mm > kCornerArmMm;
    for (std::uint32_t k = 0; k < path.count && is_sharpest; ++k) {
      double away = std::abs(path.at_mm[k] - path.at_mm[i]);
      if (path.closed) away = std::min(away, length - away);
      if (away <= kCornerArmMm && turns[k] > turns[i]) is_sharpest = false;
    }
    if (!is_sharpest) continue;
    path.points[i].pause_s = kCornerPauseS;
    last_mm = path.at_mm[i];
  }
}

/// The next place on a person's way, and how long the hand had rested there.
struct Rested {
  std::vector<DeviceMm> places;
  std::vector<double> t_s, rest_s;
};

/// Takes the rests out of a way: the hand stays at one place while it is within kRestWithinMm of
/// it. What is too short for a rest is a part of the way.
Rested withoutRests(std::span<const TimedPlace> way) {
  Rested result;
  double gone_s = 0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (i > 0) {
      const double dt = way[i].t_s - way[i - 1].t_s;
      if (!(dt > 0)) throw failure<MessageId::guide_without_way>();
      double& rest_s = result.rest_s.back();
      if (norm(way[i].place - result.places.back()) < kRestWithinMm) {
        rest_s += dt;
        continue;
      }
      if (rest_s < kShortestRestS) gone_s += std::exchange(rest_s, 0);
      gone_s += dt;
    }
    result.places.push_back(way[i].place);
    result.t_s.push_back(gone_s);
    result.rest_s.push_back(0);
  }
  return result;
}

}  // namespace

std::uint32_t GuidePath::stretchAt(double mm) const RELIEVO_REALTIME {
  std::uint32_t low = 0, high = stretches();  // at_mm[low] <= mm < at_mm[high], or at the ends.
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    (at_mm[middle] <= mm ? low : high) = middle;
  }
  return low;
}

GuidePath guidePath(std::span<const DeviceMm> corners, bool closed, std::uint32_t rounds) {
  requireALine(corners, 0);
  const std::vector<DeviceMm> line = apart(corners, closed);
  requireALine(line, closed ? 3 : 2);
  GuidePath path;
  path.closed = closed;
  path.rounds = std::clamp<std::uint32_t>(rounds, 1, kMostRounds);
  for (const std::size_t i : thinned(line, closed, 0)) path.points[path.count++].place = line[i];
  requireALine(std::span(line).first(path.count), closed ? 3 : 2);
  measure(path);
  const double speed = std::min(kGuideMmPerS, path.lengthMm() / kLeastRoundS);
  for (std::uint32_t i = 0; i < path.count; ++i) path.points[i].speed_mm_per_s = speed;
  pauseAtCorners(path);
  measure(path);
  return path;
}

GuidePath guideAlong(std::span<const TimedPlace> way) {
  for (const TimedPlace& at : way) {
    if (!isFinite(at.place) || !std::isfinite(at.t_s))
      throw failure<MessageId::guide_without_way>();
  }
  const Rested rested = withoutRests(way);
  const std::span<const DeviceMm> places(rested.places);
  requireALine(places, 2);
  const auto rests = [&](std::size_t i) { return rested.rest_s[i] >= kShortestRestS; };
  // From rest to rest, so that the places where the hand rested are corners.
  std::vector<std::size_t> kept{0};
  for (std::size_t first = 0, i = 1; i < places.size(); ++i) {
    if (!rests(i) && i + 1 < places.size()) continue;
    for (const std::size_t k : thinned(places.subspan(first, i - first + 1), false, kToleranceMm)) {
      if (k > 0) kept.push_back(first + k);
    }
    first = i;
  }
  while (kept.size() > GuidePath::kMostPoints) {  // More rests than points: every other goes.
    std::vector<std::size_t> fewer;
    for (std::size_t i = 0; i < kept.size(); i += 2) fewer.push_back(kept[i]);
    fewer.back() = kept.back();
    kept = std::move(fewer);
  }
  GuidePath path;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    GuidePoint& point = path.points[path.count++];
    point.place = places[kept[i]];
    point.speed_mm_per_s = kSlowestStrokeMmPerS;
    if (rests(kept[i])) point.pause_s = std::min(rested.rest_s[kept[i]], kLongestRestS);
    if (i == 0) continue;
    const double seconds = rested.t_s[kept[i]] - rested.t_s[kept[i - 1]];
    const double speed = norm(point.place - path.points[i - 1].place) / seconds;
    path.points[i - 1].speed_mm_per_s =
        std::clamp(speed, kSlowestStrokeMmPerS, kFastestStrokeMmPerS);
  }
  if (path.count < 2) throw failure<MessageId::guide_without_way>();
  measure(path);
  return path;
}

bool completePath(GuidePath& path) {
  const std::uint32_t least = path.closed ? 3 : 2;
  if (path.count < least || path.count > GuidePath::kMostPoints) return false;
  if (path.rounds < 1 || path.rounds > kMostRounds) return false;
  for (std::uint32_t i = 0; i < path.count; ++i) {
    const GuidePoint& p = path.points[i];
    const bool fits = isFinite(p.place) && norm(p.place) <= kFarthestMm && p.speed_mm_per_s > 0 &&
                      p.speed_mm_per_s <= kFastestStrokeMmPerS && p.pause_s >= 0 &&
                      p.pause_s <= kLongestRestS;
    if (!fits) return false;
  }
  measure(path);
  return path.lengthMm() > 0;
}

}  // namespace relievo
