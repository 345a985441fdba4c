// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "data/generate/relief_f.h"

/// Relief N: what a scanner really delivers, with a known truth beneath. 100 x 100 mm, heights of 0
/// to 5 mm in closed form, points scattered at random, four times denser at the right border than
/// at the left, noise along z, three round holes, a few outliers on request. Any number of points,
/// the same for the same seed. All lengths in millimetres, z up.
namespace relievo::samples {

inline constexpr double kReliefNSideMm = 100;
inline constexpr double kReliefNDensityRatio = 4;  ///< Right border to left.
inline constexpr double kReliefNNoiseMm = 0.02;    ///< Standard deviation.
inline constexpr double kReliefNOutlierMm = 7;     ///< Outliers lie up to this far above or below.
inline constexpr std::array<Disc, 3> kReliefNHoles{{{30, 60, 6}, {70, 30, 4}, {50, 85, 2}}};
inline constexpr double kReliefNHoleAreaMm2 = 175.92918860102841;  ///< 56 pi: 1.76 %.

/// Height of the closed form; defined everywhere, in the holes too.
double reliefNHeightMm(double x_mm, double y_mm);

bool isReliefNHole(double x_mm, double y_mm);

struct ReliefNOptions {
  std::size_t points = 1'000'000;
  double noise_mm = kReliefNNoiseMm;
  double outlier_share = 0;  ///< Of the points; 0.0005 in the accuracy figures.
  std::uint64_t seed = 800;
};

/// The points in random order. [any thread]
std::vector<std::array<float, 3>> makeReliefN(const ReliefNOptions& options = {});

}  // namespace relievo::samples
