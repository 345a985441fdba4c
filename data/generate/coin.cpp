// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/coin.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "data/generate/coin_lettering.h"
#include "data/generate/random.h"
#include "data/generate/shapes.h"

namespace relievo::samples {
namespace {

constexpr double kLetterFootMm = 8.75;
constexpr double kLetterHeightMm = 1.75;
constexpr double kStrokeHalfWidthMm = 0.17;
constexpr double kEdgeMm = 0.12;  ///< Width of a struck edge, seen from above.
constexpr std::size_t kPoints = 520'000;
constexpr double kSmallestStepMm = 1e-4;

/// A raised stroke: `distance` from its middle line.
double stroke(double distance, double half_width, double height) {
  return height * smoothStep(-kEdgeMm, 0, half_width - distance);
}

double letters(Point2 p, double r) {
  static const std::vector<Stroke> kStrokes = coinLettering(kLetterFootMm, kLetterHeightMm);
  if (r < kLetterFootMm - 0.5 || r > kLetterFootMm + kLetterHeightMm + 0.5) return 0;
  double nearest = kCoinRadiusMm;
  for (const Stroke& s : kStrokes) {
    nearest = std::min(nearest, distanceToSegment(p, s.from, s.to));
  }
  return stroke(nearest, kStrokeHalfWidthMm, 0.28);
}

/// Distance to the nearest of `count` rays or beads around the centre, as an angle.
double angleToNearest(Point2 p, int count) {
  const double sector = 2 * std::numbers::pi / count;
  const double angle = std::atan2(p.y, p.x);
  return std::abs(angle - std::round(angle / sector) * sector);
}

double wheel(Point2 p, double r) {
  const double hub = 0.42 * smoothStep(0, 0.5, 1.35 - r) - 0.2 * smoothStep(0, 0.2, 0.55 - r);
  const double felloe = stroke(std::abs(r - 5.9), 0.42, 0.36);
  const double groove = stroke(std::abs(r - 5.9), 0.05, 0.12);
  const double off_spoke = r * std::sin(angleToNearest(p, 16));
  const bool along_spoke = r > 0.8 && r < 6;
  const double spoke = along_spoke ? stroke(off_spoke, 0.09 + 0.025 * r, 0.26) : 0;
  const double bead_r = std::hypot(r - 3.4, off_spoke);
  const double bead = 0.4 * smoothStep(0, 0.45, 0.45 - bead_r);
  return std::max({hub, felloe - groove, spoke, bead});
}

double beads(Point2 p, double r) {
  constexpr double kCircleMm = 7.6;
  const double off = std::hypot(r - kCircleMm, kCircleMm * angleToNearest(p, 60));
  return 0.2 * smoothStep(0, 0.22, 0.26 - off);
}

double rim(double r) {
  const double raised = 0.42 * smoothStep(11.05, 11.3, r);
  const double bevel = std::max(0.0, r - 11.7);
  return raised - 1.2 * bevel * bevel;
}

/// Wear: the strike was not even and the field is slightly dished.
double field(Point2 p, double r) {
  return 0.03 + 0.06 * (r / kCoinRadiusMm) * (r / kCoinRadiusMm) +
         0.012 * std::sin(0.7 * p.x + 0.4) * std::cos(0.6 * p.y);
}

double height(Point2 p) {
  const double r = std::hypot(p.x, p.y);
  return field(p, r) + std::max({rim(r), letters(p, r), wheel(p, r), beads(p, r)});
}

/// Heights on a fine grid, for the many look-ups of the shadow test.
class HeightTable {
 public:
  HeightTable() {
    heights_.reserve(static_cast<std::size_t>(kSide) * kSide);
    for (int row = 0; row < kSide; ++row) {
      for (int col = 0; col < kSide; ++col) {
        heights_.push_back(height({(col - kMiddle) * kStepMm, (row - kMiddle) * kStepMm}));
      }
    }
  }
  double at(double x, double y) const {
    const int col = static_cast<int>(std::lround(x / kStepMm)) + kMiddle;
    const int row = static_cast<int>(std::lround(y / kStepMm)) + kMiddle;
    if (col < 0 || row < 0 || col >= kSide || row >= kSide) return 0;
    return heights_[static_cast<std::size_t>(row) * kSide + static_cast<std::size_t>(col)];
  }

 private:
  static constexpr double kStepMm = 0.025;
  static constexpr int kSide = 981;
  static constexpr int kMiddle = kSide / 2;
  std::vector<double> heights_;
};

/// One pass of the scanner: from where it looks, and which part it covers.
struct Pass {
  double azimuth_deg = 0;    ///< Toward the scanner, counter-clockwise from +x.
  double elevation_deg = 0;  ///< Above the coin's plane.
  double share = 0;          ///< Of all points tried.
  double from_x_mm = -kCoinRadiusMm, to_x_mm = kCoinRadiusMm;
};
constexpr std::array<Pass, 2> kPasses{{{215, 33, 0.65, -12, 12}, {80, 40, 0.35, -12, 3}}};

bool shadowed(const HeightTable& table, const std::array<double, 3>& p, const Pass& pass) {
  constexpr double kHighestMm = 0.6;
  constexpr double kStepMm = 0.025;
  const double azimuth = pass.azimuth_deg * std::numbers::pi / 180;
  const double rise = std::tan(pass.elevation_deg * std::numbers::pi / 180);
  for (double along = 2 * kStepMm; p[2] + along * rise < kHighestMm; along += kStepMm) {
    const double x = p[0] + along * std::cos(azimuth);
    const double y = p[1] + along * std::sin(azimuth);
    if (table.at(x, y) > p[2] + along * rise + 0.005) return true;
  }
  return false;
}

/// Chance that the pass keeps a point there: it slows down toward +y, and stripes overlap.
double density(double x, double y) {
  const double speed = 0.45 + 0.35 * smoothStep(-12, 12, y);
  const double overlap = std::abs(std::remainder(x + 0.3 * y, 5.0)) < 0.6 ? 0.2 : 0.0;
  return speed + overlap;
}

}  // namespace

double coinHeightMm(double x_mm, double y_mm) {
  if (std::hypot(x_mm, y_mm) > kCoinRadiusMm) return std::numeric_limits<double>::quiet_NaN();
  return height({x_mm, y_mm});
}

Cloud makeCoin() {
  Cloud cloud{"mm", false, {}};
  const HeightTable table;
  constexpr double kLastMm = kCoinRadiusMm - 1e-3;  // still on the coin when rounded
  Random random(24);
  while (cloud.points.size() < kPoints) {
    const Pass& pass = random.uniform() < kPasses[0].share ? kPasses[0] : kPasses[1];
    const double x = random.uniform(-kCoinRadiusMm, kCoinRadiusMm);
    const double y = random.uniform(-kCoinRadiusMm, kCoinRadiusMm);
    const bool kept = random.uniform() < density(x, y);
    if (!kept || x < pass.from_x_mm || x > pass.to_x_mm || std::hypot(x, y) > kLastMm) {
      continue;
    }
    const double z = height({x, y});
    if (shadowed(table, {x, y, z}, pass)) continue;
    cloud.points.push_back({rounded(x, kSmallestStepMm), rounded(y, kSmallestStepMm),
                            rounded(z + kCoinNoiseMm * random.normal(), kSmallestStepMm)});
  }
  return cloud;
}

Reference coinReference() {
  Reference grid;
  grid.cols = grid.rows = 801;
  grid.spacing = kCoinReferenceSpacingMm;
  grid.first_x = grid.first_y = -kCoinRadiusMm;
  return evaluate(grid, coinHeightMm);
}

}  // namespace relievo::samples
