// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/task.h"
#include "core/depth/depth_map.h"

namespace relievo {

/// The radii at which a picture of several scales looks: the given one and its halves, down to two
/// samples, three at most. @param radius_samples  >= 1
std::vector<double> scalesWithin(double radius_samples);

/// By how many standard deviations a cell lies above its neighbourhood, at the scale where that is
/// most, above or below: multi-scale topographic position (Lindsay, Cockburn, Russell 2015), with
/// Gaussian neighbourhoods of half the radius in place of squares, which leave no corners. A spread
/// below a thousandth of a sample's spacing counts as that: level ground is 0, not its rounding.
/// NaN outside. The same values for any number of threads.
/// @throw Cancelled
std::vector<float> largestDeviations(const DepthMap& map, double radius_samples, const Task& task);

/// How much of a ball around a point of the surface lies above it: the integral invariant of its
/// volume (Pottmann and others 2009), as used on tablets at several scales (Mara 2012). Keeps a
/// reference to the map. [any thread]
class BallShares {
 public:
  BallShares(const DepthMap& map, double radius_samples);

  /// 1 - 2 V / V_ball, V the volume below the surface, mean over the scales: 0 on a plane however
  /// it is tilted, above 0 on a ridge; 3 r / (8 R) on a sphere of radius R (ibid., eq. 5).
  /// Offsets count in pairs, so that a rim tilts nothing.
  double bulge(Cell at) const;

 private:
  struct Offset {
    int col = 0, row = 0;
    float half_mm = 0;  ///< Half of the ball's height over that sample.
  };
  struct Scale {
    std::vector<Offset> offsets;  ///< One of each pair of opposite samples.
    double per_share = 1;         ///< Makes up for a disc of samples: a paraboloid is exact.
  };
  static Scale scaleOf(double radius_samples, double spacing_mm);

  const DepthMap& map_;
  std::vector<Scale> scales_;
};

}  // namespace relievo
