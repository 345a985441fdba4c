// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace relievo {

inline constexpr double kMostNyquistGain = 0.3;  ///< What may fold back into a coarser level.

/// Mirrored without repeating the edge sample: -1 -> 1, n -> n - 2.
int mirrored(int i, int count);

/// Samples of the next coarser level along one axis: its nodes i M stay within 0 ... count - 1.
/// ceil(count / M) for integer M.
int reducedCount(int count, double factor);

/// Variance of the smoothing kernel in squared spacings of the finer level: (M^2 - 1)/3, so that
/// one step of M^2 smooths like two of M; below about M = 1.94, where that lets more than
/// `kMostNyquistGain` through, the least that does not.
double kernelVariance(double factor);

/// Weights of the finer samples first, first + 1, ... for one coarser node; they sum to 1. Indices
/// beyond the map are meant as mirrored.
struct Taps {
  int first = 0;
  std::vector<double> weights;
};

/// For a node at `position` in spacings of the finer level. M = 2: (1 4 6 4 1)/16, the paper's
/// generating kernel; else the Gaussian of `kernelVariance`, evaluated at the node's own place
/// between the samples.
Taps tapsAt(double position, double factor);

/// Taps of all nodes of the next coarser level along one axis.
std::vector<Taps> tapsOfAxis(int count, double factor);

}  // namespace relievo
