// SPDX-License-Identifier: BSD-3-Clause
#include "core/relief/neighbourhood.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/relief/smooth.h"

namespace relievo {
namespace {

constexpr std::size_t kMostScales = 3;
constexpr double kLeastRadiusSamples = 2;
constexpr double kLeastSpreadSamples = 1e-3;
/// More samples of a ball than this are thinned evenly: a radius of 400 samples has half a million.
constexpr double kMostOffsets = 600;

}  // namespace

std::vector<double> scalesWithin(double radius_samples) {
  std::vector<double> scales{radius_samples};
  while (scales.size() < kMostScales && scales.back() / 2 >= kLeastRadiusSamples) {
    scales.push_back(scales.back() / 2);
  }
  return scales;
}

std::vector<float> largestDeviations(const DepthMap& map, double radius_samples, const Task& task) {
  const std::size_t count = map.heights_mm.size();
  std::vector<float> largest(count, std::numeric_limits<float>::quiet_NaN());
  const double least_mm = kLeastSpreadSamples * map.frame.spacing_mm;
  DepthMap squares{map.frame, std::vector<float>(count), map.origins};
  std::vector<float> above(count);
  for (const double radius : scalesWithin(radius_samples)) {
    const std::vector<float> mean = smoothed(map, 0.5 * radius, task);
    for (std::size_t i = 0; i < count; ++i) {
      above[i] = map.heights_mm[i] - mean[i];
      squares.heights_mm[i] = above[i] * above[i];
    }
    const std::vector<float> variance = smoothed(squares, 0.5 * radius, task);
    for (std::size_t i = 0; i < count; ++i) {
      if (map.origins[i] == CellStatus::outside) continue;
      const double spread = std::sqrt(std::max(0.0, static_cast<double>(variance[i])));
      const auto deviation =
          static_cast<float>(static_cast<double>(above[i]) / std::max(spread, least_mm));
      if (!(std::abs(deviation) <= std::abs(largest[i]))) largest[i] = deviation;
    }
  }
  return largest;
}

BallShares::BallShares(const DepthMap& map, double radius_samples) : map_(map) {
  for (const double radius : scalesWithin(radius_samples)) {
    scales_.push_back(scaleOf(radius, map.frame.spacing_mm));
  }
}

BallShares::Scale BallShares::scaleOf(double radius_samples, double spacing_mm) {
  const double samples = 3.2 * radius_samples * radius_samples;
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(samples / kMostOffsets))));
  const int reach = static_cast<int>(radius_samples) / step * step;
  Scale scale;
  double squares = 0, halves = 0;  // In samples.
  for (int row = 0; row <= reach; row += step) {
    for (int col = row == 0 ? step : -reach; col <= reach; col += step) {
      const auto square = static_cast<double>(col * col + row * row);
      const double left = radius_samples * radius_samples - square;
      if (left <= 0) continue;
      scale.offsets.push_back({col, row, static_cast<float>(std::sqrt(left) * spacing_mm)});
      squares += square;
      halves += std::sqrt(left);
    }
  }
  if (squares > 0) scale.per_share = 3.0 / 8 * radius_samples / (squares / 2 / halves);
  return scale;
}

double BallShares::bulge(Cell at) const {
  const float here = map_.heightMm(at);
  const GridSize size = map_.frame.size;
  const auto usable = [&](Cell cell) {
    return size.contains(cell) && map_.origin(cell) != CellStatus::outside;
  };
  double sum = 0;
  for (const Scale& scale : scales_) {
    double below = 0;
    double whole = 0;
    for (const Offset& o : scale.offsets) {
      const Cell one{at.col + o.col, at.row + o.row}, other{at.col - o.col, at.row - o.row};
      if (!usable(one) || !usable(other)) continue;
      const auto part = [&](Cell cell) {
        return std::clamp(map_.heightMm(cell) - here, -o.half_mm, o.half_mm);
      };
      below += static_cast<double>(part(one) + part(other));
      whole += 2 * static_cast<double>(o.half_mm);
    }
    if (whole > 0) sum -= std::clamp(scale.per_share * below / whole, -1.0, 1.0);
  }
  return sum / static_cast<double>(scales_.size());
}

}  // namespace relievo
