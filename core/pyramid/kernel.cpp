// SPDX-License-Identifier: BSD-3-Clause
#include "core/pyramid/kernel.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include "core/pyramid/pyramid.h"

namespace relievo {
namespace {

constexpr double kReach = 5;         // Standard deviations; what lies beyond is 6e-7 of the whole.
constexpr double kSameNode = 1e-9;   // Spacings; rounding of i M must not cost the last node.
constexpr int kOffsetsPerHalf = 16;  // Places of a node between samples at which gain is looked at.

Taps gaussianTaps(double position, double variance) {
  const double reach = kReach * std::sqrt(variance);
  Taps taps{.first = static_cast<int>(std::ceil(position - reach)), .weights = {}};
  const auto last = static_cast<int>(std::floor(position + reach));
  double sum = 0;
  for (int i = taps.first; i <= last; ++i) {
    const double distance = i - position;
    taps.weights.push_back(std::exp(-0.5 * distance * distance / variance));
    sum += taps.weights.back();
  }
  for (double& weight : taps.weights) weight /= sum;
  return taps;
}

/// How much of a wave of `omega` radians per sample is left at a node.
double gainOf(const Taps& taps, double omega) {
  std::complex<double> sum;
  for (std::size_t k = 0; k < taps.weights.size(); ++k) {
    sum += std::polar(taps.weights[k], omega * (taps.first + static_cast<double>(k)));
  }
  return std::abs(sum);
}

/// Largest gain at the new Nyquist frequency over the places a node can have between samples.
double gaussianGain(double variance, double factor) {
  double most = 0;
  for (int k = 0; k <= kOffsetsPerHalf; ++k) {
    const Taps taps = gaussianTaps(0.5 * k / kOffsetsPerHalf, variance);
    most = std::max(most, gainOf(taps, std::numbers::pi / factor));
  }
  return most;
}

}  // namespace

int mirrored(int i, int count) {
  if (count == 1) return 0;
  const int period = 2 * (count - 1);
  i = ((i % period) + period) % period;
  return i < count ? i : period - i;
}

int reducedCount(int count, double factor) {
  return static_cast<int>(std::floor((count - 1) / factor + kSameNode)) + 1;
}

double kernelVariance(double factor) {
  double low = (factor * factor - 1) / 3;
  if (factor >= 2 || (low > 0.2 && gaussianGain(low, factor) <= kMostNyquistGain)) return low;
  double high = 1.5;
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    const bool narrow = middle < 0.2 || gaussianGain(middle, factor) > kMostNyquistGain;
    (narrow ? low : high) = middle;
  }
  return high;
}

Taps tapsAt(double position, double factor) {
  if (factor != 2) return gaussianTaps(position, kernelVariance(factor));
  return {.first = static_cast<int>(std::lround(position)) - 2,
          .weights = {1.0 / 16, 4.0 / 16, 6.0 / 16, 4.0 / 16, 1.0 / 16}};
}

std::vector<Taps> tapsOfAxis(int count, double factor) {
  std::vector<Taps> axis;
  const double variance = kernelVariance(factor);
  const int nodes = reducedCount(count, factor);
  for (int i = 0; i < nodes; ++i) {
    const double position = i * factor;
    axis.push_back(factor == 2 ? tapsAt(position, factor) : gaussianTaps(position, variance));
  }
  return axis;
}

double gainAtNyquist(double factor) {
  if (factor == 2) return gainOf(tapsAt(0, 2), std::numbers::pi / 2);
  return gaussianGain(kernelVariance(factor), factor);
}

}  // namespace relievo
