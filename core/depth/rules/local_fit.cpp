// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/rules/local_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace relievo {
namespace {

constexpr std::size_t kUnknowns = 6;  // 1, u, v, u^2, uv, v^2
constexpr std::size_t kFewest = 8;    // Points for a quadratic.
constexpr double kMisfit = 1.6;       // Residuals this many times the noise: not one quadratic.
constexpr double kExact = 1e-3;       // Spacings; misfits below it do not matter.
constexpr int kMostDropped = 2;       // Points of a window that may be outliers.

using Coefficients = std::array<double, kUnknowns>;

struct NormalEquations {
  std::array<double, 21> lower{};  // Row by row.
  Coefficients right{};

  void add(double u, double v, double z) {
    const Coefficients b{1, u, v, u * u, u * v, v * v};
    std::size_t k = 0;
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      for (std::size_t j = 0; j <= i; ++j) lower[k++] += b[i] * b[j];
      right[i] += b[i] * z;
    }
  }

  /// Cholesky; nothing where the points do not determine the coefficients.
  std::optional<Coefficients> solved() const {
    std::array<std::array<double, kUnknowns>, kUnknowns> l{};
    std::size_t k = 0;
    const double tiny = 1e-7 * lower[0];
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        double sum = lower[k++];
        for (std::size_t m = 0; m < j; ++m) sum -= l[i][m] * l[j][m];
        if (i == j) {
          if (sum <= tiny) return std::nullopt;
          l[i][i] = std::sqrt(sum);
        } else {
          l[i][j] = sum / l[j][j];
        }
      }
    }
    Coefficients x = right;
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      for (std::size_t m = 0; m < i; ++m) x[i] -= l[i][m] * x[m];
      x[i] /= l[i][i];
    }
    for (std::size_t i = kUnknowns; i-- > 0;) {
      for (std::size_t m = i + 1; m < kUnknowns; ++m) x[i] -= l[m][i] * x[m];
      x[i] /= l[i][i];
    }
    return x;
  }
};

double residual(const Coefficients& c, const PlacedPoint& p) {
  const auto u = static_cast<double>(p.du);
  const auto v = static_cast<double>(p.dv);
  return static_cast<double>(p.z) -
         (c[0] + c[1] * u + c[2] * v + c[3] * u * u + c[4] * u * v + c[5] * v * v);
}

std::size_t pointsWithin(const RowPoints& rows, int col, int row, int radius) {
  std::size_t count = 0;
  const int first_col = std::max(col - radius, 0);
  const int end_col = std::min(col + radius + 1, rows.cols);
  for (int r = std::max(row - radius, rows.first_row); r < std::min(row + radius + 1, rows.end_row);
       ++r) {
    count += rows.count(first_col, end_col, r);
  }
  return count;
}

double meanOf(std::span<const PlacedPoint> points) {
  double sum = 0;
  for (const PlacedPoint& p : points) sum += static_cast<double>(p.z);
  return sum / static_cast<double>(points.size());
}

}  // namespace

LocalFit::LocalFit(double noise_mm, double spacing_mm)
    : allowed_mm_(std::max(kMisfit * noise_mm, kExact * spacing_mm)) {}

void LocalFit::gather(const RowPoints& rows, int col, int row, int radius) {
  window_.clear();
  const float scale = 1.0F / (static_cast<float>(radius) + 0.5F);
  for (int r = std::max(row - radius, rows.first_row); r < std::min(row + radius + 1, rows.end_row);
       ++r) {
    for (int c = std::max(col - radius, 0); c < std::min(col + radius + 1, rows.cols); ++c) {
      for (const PlacedPoint& p : rows.of(c, c + 1, r)) {
        window_.push_back({.du = (p.du + static_cast<float>(c - col)) * scale,
                           .dv = (p.dv + static_cast<float>(r - row)) * scale,
                           .z = p.z});
      }
    }
  }
}

std::optional<LocalFit::Fit> LocalFit::fitWithin(const RowPoints& rows, int col, int row,
                                                 int radius) {
  gather(rows, col, row, radius);
  std::optional<Fit> first;
  for (int dropped = 0; window_.size() >= kFewest; ++dropped) {
    NormalEquations equations;
    for (const PlacedPoint& p : window_) {
      equations.add(static_cast<double>(p.du), static_cast<double>(p.dv), static_cast<double>(p.z));
    }
    const std::optional<Coefficients> fit = equations.solved();
    if (!fit) break;
    double squares = 0;
    double most = 0;
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < window_.size(); ++i) {
      const double off = residual(*fit, window_[i]);
      squares += off * off;
      if (off * off > most) {
        most = off * off;
        farthest = i;
      }
    }
    const double freedom = static_cast<double>(window_.size()) - static_cast<double>(kUnknowns);
    const auto [low, high] =
        std::minmax_element(window_.begin(), window_.end(),
                            [](const PlacedPoint& a, const PlacedPoint& b) { return a.z < b.z; });
    const Fit found{.height = (*fit)[0],
                    .rms = std::sqrt(squares / freedom),
                    .low = static_cast<double>(low->z),
                    .high = static_cast<double>(high->z)};
    if (found.rms <= allowed_mm_) return found;
    if (!first) first = found;
    // A outlier or two spoil a fit that is good without them; an edge stays one.
    if (dropped == kMostDropped) break;
    window_[farthest] = window_.back();
    window_.pop_back();
  }
  return first;
}

std::optional<double> LocalFit::heightAt(const RowPoints& rows, int col, int row) {
  int radius = 1;
  while (radius < kWidest && pointsWithin(rows, col, row, radius) < kEnoughToFit) ++radius;
  std::optional<double> widest;
  for (; radius >= 1; --radius) {
    const std::optional<Fit> fit = fitWithin(rows, col, row, radius);
    if (!fit) break;
    if (fit->rms <= allowed_mm_ && fit->isNearPoints()) return fit->height;
    if (!widest) widest = std::clamp(fit->height, fit->low, fit->high);
  }
  const auto own = rows.of(col, col + 1, row);
  if (!own.empty()) return meanOf(own);
  return widest;
}

double noiseOf(const RowPoints& rows, int first_row, int end_row, double spacing_mm) {
  constexpr int kStep = 7;  // One cell in 49 tells enough.
  LocalFit fit(std::numeric_limits<double>::infinity(), spacing_mm);
  std::vector<double> all;
  for (int row = first_row; row < end_row; row += kStep) {
    for (int col = 0; col < rows.cols; col += kStep) {
      int radius = 1;
      while (radius < LocalFit::kWidest &&
             pointsWithin(rows, col, row, radius) < LocalFit::kEnoughToFit) {
        ++radius;
      }
      if (const auto found = fit.fitWithin(rows, col, row, radius)) all.push_back(found->rms);
    }
  }
  if (all.empty()) return 0;
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

}  // namespace relievo
