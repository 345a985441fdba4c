// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/depth/rules/cell_points.h"

namespace relievo {

/// Height at a sample by a quadratic through the points around it, least squares: for z = f(x, y)
/// what moving least squares (Levin 1998) are for surfaces in space.
///
/// The window grows from the cell's own 3 x 3 until it holds `kEnoughToFit` points. A point far off
/// the fit is left out and the fit made again. Where the fit misses its points by more than the
/// noise allows (an edge, a step) the window shrinks, and at last the cell's own points alone
/// count. A fit that leaves the heights of its points behind does not count either. One per thread.
class LocalFit {
 public:
  /// @param noise_mm  standard deviation of the points about the surface; see `noiseOf`
  explicit LocalFit(double noise_mm, double spacing_mm);

  /// Residuals up to this are noise, mm.
  double allowedMm() const noexcept { return allowed_mm_; }

  /// Nothing where even the widest window holds too few points.
  std::optional<double> heightAt(const RowPoints& rows, int col, int row);

  static constexpr int kWidest = 4;  ///< Cells to each side; the rows must reach that far.
  static constexpr std::size_t kEnoughToFit = 20;

 private:
  struct Fit {
    double height = 0;         ///< At the sample.
    double rms = 0;            ///< Of the residuals, for the degrees of freedom left.
    double low = 0, high = 0;  ///< Of the points.

    /// Points on one side only can send a quadratic anywhere; between them it stays near them.
    bool isNearPoints() const noexcept {
      const double beyond = 0.25 * (high - low);
      return height >= low - beyond && height <= high + beyond;
    }
  };
  std::optional<Fit> fitWithin(const RowPoints& rows, int col, int row, int radius);
  void gather(const RowPoints& rows, int col, int row, int radius);

  friend double noiseOf(const RowPoints& rows, int first_row, int end_row, double spacing_mm);

  double allowed_mm_;                // Residuals above: not one smooth surface.
  std::vector<PlacedPoint> window_;  // du, dv from the sample, in window half sides.
};

/// Noise of the points about the local quadratics of some cells of these rows; the median over the
/// cells, so that edges do not count. 0 if no window can be fitted.
double noiseOf(const RowPoints& rows, int first_row, int end_row, double spacing_mm);

}  // namespace relievo
