// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/prepare/align/judge.h"

/// Two scans: from a rough start to the pose, and what it is worth.
namespace relievo::align {

/// Where a pair of scans was found to lie.
struct PairFit {
  LocalPose pose = LocalPose::Identity();  ///< Between their middles, reference from scan.
  LocalPose start = LocalPose::Identity();
  Judgement judgement;
};

/// Symmetric point-to-plane iterative closest points by PCL, in double, at falling distances.
/// `start` again if it leads nowhere. @throw Cancelled, after at most one iteration
LocalPose closestPoints(const OrientedSet& scan, const OrientedSet& reference,
                        const LocalPose& start, std::span<const double> distances,
                        const Task& task);

/// Gauss-Newton on the matches of both directions.
/// @param keep_sliding  without the motions that nothing holds: there the start stays
LocalPose settle(const OrientedSet& scan, const OrientedSet& reference, const LocalPose& start,
                 double farthest, bool keep_sliding, const Task& task);

/// Turns all normals of the scan over if more of them look against the reference's than along,
/// where the scans meet at `pose`. Only where its side was guessed.
void agreeOnSides(Cloud& scan, const Cloud& reference, const LocalPose& pose, const Scale& scale,
                  const Task& task);

/// From a start by hand, or as stored, that is off by some percent of the size.
PairFit fitFromStart(const Cloud& scan, const Cloud& reference, const LocalPose& start,
                     const Scale& scale, const Task& task);

}  // namespace relievo::align
