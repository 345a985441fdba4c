// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/prepare/align/align_pair.h"

/// Two scans with no start: features, consensus, judge.
namespace relievo::align {

/// How the surface bends around points, in 33 numbers each (fast point feature histograms).
struct Features {
  std::vector<Point3f> points;
  std::vector<std::array<float, 33>> histograms;
};

/// Of the coarse points with a whole neighbourhood; no number in it is not finite.
Features featuresOf(const OrientedSet& coarse);

/// How one consensus is sought.
struct Consensus {
  unsigned seed = 1;
  double inlier_share = 0.6;  ///< Of the key points; below it a pose is not looked at.
  int candidates = 5;         ///< Nearest features of the reference that a key point may be.
  double distance = 0;        ///< Nearer to the reference is an inlier.
};

/// A pose that many key points of the scan agree on, by PCL; nothing: none was found. Sets the seed
/// of rand(): one at a time in a process.
std::optional<LocalPose> consensus(const Features& scan, const Features& reference,
                                   const Consensus& how);

/// From no start at all. Refused unless the judge accepts it, at the middle size and at the fine
/// one; tries in the same order for the same seed. @throw Cancelled, after at most one try
PairFit fitAutomatically(const Cloud& scan, const Cloud& reference, const Scale& scale,
                         unsigned seed, const Task& task);

}  // namespace relievo::align
