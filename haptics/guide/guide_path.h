// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

#include "core/base/vec3.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// A corner of a path, and the way from it to the next.
struct GuidePoint {
  DeviceMm place;
  double speed_mm_per_s = 0;  ///< Of the way from here to the next one; > 0.
  double pause_s = 0;         ///< Waits here for so long.
};

/// What a hand is led along, mm of hand. Fixed size and trivially copyable, so that it crosses
/// threads by value inside a TripleBuffer. Made by guidePath() or guideAlong(), which fill in
/// what follows from the points. All const members: [any thread], real-time safe.
struct GuidePath {
  static constexpr std::size_t kMostPoints = 1024;

  std::uint64_t id = 0;        ///< Given by whoever sets it; 0: none. A new run has a new one.
  std::uint64_t scene_id = 0;  ///< HapticSpace::scene_id of the surface that it lies on.
  std::uint32_t count = 0;     ///< Of points; 2 at least.
  std::uint32_t rounds = 1;    ///< Of a closed path: so often round; 1 .. kMostRounds.
  bool closed = false;         ///< The last point leads back to the first.
  std::array<GuidePoint, kMostPoints> points{};
  // What follows from the points.
  std::array<double, kMostPoints + 1> at_mm{};   ///< Way to each point; of a closed path also back.
  std::array<double, kMostPoints> to_stop_mm{};  ///< From each point to the next stop after it.

  /// Way of one round, or of all of an open path.
  double lengthMm() const RELIEVO_REALTIME { return at_mm[closed ? count : count - 1]; }
  /// Stretches between points.
  std::uint32_t stretches() const RELIEVO_REALTIME { return closed ? count : count - 1; }
  /// Of the stretch on which a place is. @param mm  0 .. lengthMm()
  std::uint32_t stretchAt(double mm) const RELIEVO_REALTIME;
  DeviceMm start(std::uint32_t stretch) const RELIEVO_REALTIME { return points[stretch].place; }
  DeviceMm end(std::uint32_t stretch) const RELIEVO_REALTIME {
    return points[stretch + 1 < count ? stretch + 1 : 0].place;
  }
};
static_assert(std::is_trivially_copyable_v<GuidePath>);

inline constexpr std::uint32_t kMostRounds = 3;
/// Led no faster than this, and one round takes no less than kLeastRoundS. Ways are felt as well at
/// 28 and 42 mm/s (AHCI 2013/740324).
inline constexpr double kGuideMmPerS = 40, kLeastRoundS = 6;
inline constexpr double kCornerPauseS = 0.4, kCornerDegrees = 35, kCornerArmMm = 2;
/// A person's own speed and rests are kept within these.
inline constexpr double kSlowestStrokeMmPerS = 15, kFastestStrokeMmPerS = 60;
inline constexpr double kRestWithinMm = 0.3, kShortestRestS = 0.2, kLongestRestS = 3;

/// Along a line of corners, with a pause at each that turns by more than kCornerDegrees on arms of
/// kCornerArmMm.
/// @param corners  finite, mm of hand; of a closed line the first is not said again. More than fit
///                 are thinned out until they do
/// @throw ArgumentError  fewer than two different places (three of a closed line), or one that is
/// no number
GuidePath guidePath(std::span<const DeviceMm> corners, bool closed, std::uint32_t rounds = 1);

/// Where a hand was at a time.
struct TimedPlace {
  double t_s = 0;
  DeviceMm place;
};
/// Along the way of a person's hand, as it was gone: at its own speed, from 15 to 60 mm/s, with
/// its rests. Simplified to 0.3 mm.
/// @param way  times increase; finite
/// @throw ArgumentError  as above, or times that do not increase
GuidePath guideAlong(std::span<const TimedPlace> way);

/// The same path with what follows from its points; for paths that were read.
/// @return false: it is none: too few or too many points, or one that is no number or out of range
bool completePath(GuidePath& path);

}  // namespace relievo
