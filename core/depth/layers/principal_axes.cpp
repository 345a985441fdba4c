// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/principal_axes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <Eigen/Eigenvalues>
#include <vector>

namespace relievo {
namespace {

constexpr std::size_t kMostSamples = 400'000;  // More do not move the axes.

struct Sample {
  Eigen::Vector3d at;
  double weight = 1;
};

Eigen::Vector3d localPoint(const Scan& scan, std::size_t i) {
  const auto& p = scan.points[i];
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

std::vector<Sample> samplesOf(const Scan& scan, const Task& task) {
  std::vector<Sample> samples;
  if (scan.triangles.empty()) {
    const std::size_t stride = std::max<std::size_t>(1, scan.points.size() / kMostSamples);
    for (std::size_t i = 0; i < scan.points.size(); i += stride) {
      samples.push_back({.at = localPoint(scan, i), .weight = 1});
    }
    return samples;
  }
  samples.reserve(scan.triangles.size());
  for (std::size_t i = 0; i < scan.triangles.size(); ++i) {
    if (i % (1U << 16U) == 0) task.check();
    const auto& t = scan.triangles[i];
    const Eigen::Vector3d a = localPoint(scan, t[0]);
    const Eigen::Vector3d b = localPoint(scan, t[1]);
    const Eigen::Vector3d c = localPoint(scan, t[2]);
    samples.push_back({.at = (a + b + c) / 3, .weight = 0.5 * (b - a).cross(c - a).norm()});
  }
  return samples;
}

struct Fit {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // Columns, by rising variance.
  Eigen::Vector3d variances = Eigen::Vector3d::Zero();
};

Fit fit(const std::vector<Sample>& samples) {
  Fit result;
  double weight = 0;
  for (const Sample& s : samples) {
    result.mean += s.weight * s.at;
    weight += s.weight;
  }
  if (!(weight > 0)) return result;
  result.mean /= weight;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Sample& s : samples) {
    const Eigen::Vector3d d = s.at - result.mean;
    covariance += s.weight / weight * d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  result.axes = solver.eigenvectors();
  result.variances = solver.eigenvalues().cwiseMax(0.0);
  return result;
}

/// Leaves out the share of the samples for which `distance` is largest.
template <class Distance>
std::vector<Sample> trimmed(std::vector<Sample> samples, double share, Distance&& distance) {
  const auto kept = static_cast<std::ptrdiff_t>((1 - share) * static_cast<double>(samples.size()));
  std::nth_element(samples.begin(), samples.begin() + kept, samples.end(),
                   [&](const Sample& a, const Sample& b) { return distance(a) < distance(b); });
  samples.resize(static_cast<std::size_t>(kept));
  return samples;
}

Eigen::Vector3d medianOf(const std::vector<Sample>& samples) {
  Eigen::Vector3d median = Eigen::Vector3d::Zero();
  std::vector<double> values;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    values.clear();
    for (const Sample& s : samples) values.push_back(s.at(axis));
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    median(axis) = *middle;
  }
  return median;
}

/// A plane through what is near the middle, so that a few far outliers cannot turn it; then twice
/// through what is near that plane.
Fit trimmedFit(const std::vector<Sample>& samples, double share, const Task& task) {
  const Eigen::Vector3d middle = medianOf(samples);
  Fit found = fit(trimmed(samples, share, [&](const Sample& s) { return (s.at - middle).norm(); }));
  for (int pass = 0; pass < 2; ++pass) {
    task.check();
    const Eigen::Vector3d normal = found.axes.col(0);
    const Eigen::Vector3d mean = found.mean;
    found = fit(trimmed(samples, share,
                        [&](const Sample& s) { return std::abs(normal.dot(s.at - mean)); }));
  }
  return found;
}

}  // namespace

PrincipalAxes principalAxes(const Scan& scan, double trimmed_share, const Task& task) {
  const std::vector<Sample> samples = samplesOf(scan, task);
  const Fit found = trimmed_share > 0 && !samples.empty() ? trimmedFit(samples, trimmed_share, task)
                                                          : fit(samples);
  PrincipalAxes result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto column = static_cast<Eigen::Index>(2 - i);
    result.axes[i] = {found.axes(0, column), found.axes(1, column), found.axes(2, column)};
    result.spreads[i] = std::sqrt(found.variances(column));
  }
  return result;
}

}  // namespace relievo
