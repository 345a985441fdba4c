// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "data/generate/panel_figures.h"
#include "data/generate/parallel.h"
#include "data/generate/random.h"
#include "data/generate/shapes.h"

namespace relievo::samples {
namespace {

constexpr double kTopMm = 42;    ///< Nothing is higher.
constexpr double kFrameMm = 12;  ///< Width of the frame.
constexpr double kHitMm = 2e-4;  ///< Nearer than this is on the surface.
constexpr std::size_t kPoints = 600'000;
constexpr double kSmallestStepMm = 1e-4;

/// A bar with rounded edges that runs along x or y: outside distance of a rounded rectangle.
double bar(double across, double z, double half_width, double height) {
  constexpr double kRoundMm = 1.5;
  const double a = std::abs(across) - half_width + kRoundMm;
  const double b = z - height + kRoundMm;
  const double out_a = std::max(a, 0.0);
  const double out_b = std::max(b, 0.0);
  return std::sqrt(out_a * out_a + out_b * out_b) + std::min(std::max(a, b), 0.0) - kRoundMm;
}

/// Beads in the middle of the frame, from corner to corner.
double beads(const Point3& p) {
  constexpr double kRadiusMm = 3.2;
  constexpr double kMiddleMm = 0.5 * kFrameMm;
  const auto row = [](double along, double across, double z, double end, int count) {
    const double pitch = (end - kFrameMm) / count;
    const double i = std::clamp(std::round((along - kMiddleMm) / pitch), 0.0, double(count));
    const double off = along - kMiddleMm - i * pitch;
    return std::sqrt(off * off + across * across + z * z) - kRadiusMm;
  };
  const double across_y = std::min(p.y, kPanelHeightMm - p.y) - kMiddleMm;
  const double across_x = std::min(p.x, kPanelWidthMm - p.x) - kMiddleMm;
  return std::min(row(p.x, across_y, p.z - 11, kPanelWidthMm, 32),
                  row(p.y, across_x, p.z - 11, kPanelHeightMm, 21));
}

double frame(const Point3& p) {
  const double to_x = std::min(p.x, kPanelWidthMm - p.x) - 0.5 * kFrameMm;
  const double to_y = std::min(p.y, kPanelHeightMm - p.y) - 0.5 * kFrameMm;
  // What the figures stand on, between the sides of the frame.
  const double ledge = std::max(bar(p.y - 20, p.z, 9, 18), 0.4 * kFrameMm - to_x);
  return std::min(
      {bar(to_x, p.z, 0.5 * kFrameMm, 11), bar(to_y, p.z, 0.5 * kFrameMm, 11), ledge, beads(p)});
}

/// The ground between the figures: not quite flat, with the traces of the chisel.
double ground(const Point3& p) {
  constexpr double kHighestMm = 0.45;
  constexpr double kSteepest = 1.02;  // keeps the bound below the true distance
  if (p.z > 10) return (p.z - kHighestMm) / kSteepest;
  const double warp = 0.4 * std::sin(p.x / 17) * std::sin(p.y / 13 + 1);
  const double chisel = 0.05 * std::sin(1.9 * (p.x + 0.6 * p.y)) * std::sin(0.23 * (p.y - p.x));
  return (p.z - warp - chisel) / kSteepest;
}

const std::vector<Figure>& figures() {
  static const std::vector<Figure> kFigures = panelFigures();
  return kFigures;
}

double distanceTo(const std::vector<Figure>& among, const Point3& p) {
  double nearest = std::min(ground(p), frame(p));
  for (const Figure& figure : among) nearest = std::min(nearest, figure.distance(p, nearest));
  return nearest;
}

bool onPanel(double x, double y) {
  return x >= 0 && y >= 0 && x <= kPanelWidthMm && y <= kPanelHeightMm;
}

/// Walks from far away toward the panel until the surface is reached.
std::optional<Point3> hit(const Ray& ray) {
  constexpr int kSteps = 2000;
  std::vector<Figure> met;
  for (const Figure& figure : figures()) {
    if (Figure part = figure.along(ray); !part.empty()) met.push_back(std::move(part));
  }
  double along = kTopMm / ray.toward.z;
  for (int i = 0; i < kSteps && along > -5; ++i) {
    const Point3 p = ray.at(along);
    const double free_mm = distanceTo(met, p);
    if (free_mm < kHitMm) return p;
    along -= free_mm;
  }
  return std::nullopt;
}

struct Scanner {
  double tilt_deg = 0;  ///< From straight ahead.
  double turn_deg = 0;  ///< Toward which side, counter-clockwise from +x.
  double share = 0;     ///< Of all rays.
  double from_x_mm = 0, to_x_mm = kPanelWidthMm;
};
constexpr std::array<Scanner, 3> kScanners{
    {{0, 0, 0.5, 0, 300}, {42, 165, 0.3, 0, 230}, {48, 40, 0.2, 90, 300}}};

Point3 towardScanner(const Scanner& s) {
  const double tilt = s.tilt_deg * std::numbers::pi / 180;
  const double turn = s.turn_deg * std::numbers::pi / 180;
  return {std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt)};
}

struct Shot {
  Ray ray;
  double noise_mm = 0;
};

/// One random ray, or nothing where the scanner did not look. Density falls off from the middle of
/// each scan, and stripes overlap.
std::optional<Shot> randomShot(Random& random) {
  const double which = random.uniform();
  const std::size_t i = which < kScanners[0].share                        ? 0
                        : which < kScanners[0].share + kScanners[1].share ? 1
                                                                          : 2;
  const Scanner& scanner = kScanners[i];
  constexpr double kMarginMm = 50;  // slanted rays start beside the panel
  const Point3 foot{random.uniform(-kMarginMm, kPanelWidthMm + kMarginMm),
                    random.uniform(-kMarginMm, kPanelHeightMm + kMarginMm), 0};
  const double fall_off = std::abs(foot.x - 150) / 300 + std::abs(foot.y - 100) / 400;
  const double stripe = std::abs(std::remainder(foot.y - 0.2 * foot.x, 40.0)) < 4 ? 0.2 : 0;
  const bool kept = random.uniform() < 0.8 - 0.6 * fall_off + stripe;
  const double noise_mm = kPanelNoiseMm * random.normal();
  if (!kept || foot.x < scanner.from_x_mm - kMarginMm || foot.x > scanner.to_x_mm) {
    return std::nullopt;
  }
  return Shot{{foot, towardScanner(scanner)}, noise_mm};
}

}  // namespace

double panelHeightMm(double x_mm, double y_mm) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (!onPanel(x_mm, y_mm)) return kNone;
  const auto p = hit({{x_mm, y_mm, 0}, {0, 0, 1}});
  return p ? p->z : kNone;
}

double panelDistanceMm(double x_mm, double y_mm, double z_mm) {
  return distanceTo(figures(), {x_mm, y_mm, z_mm});
}

Cloud makePanel() {
  Cloud cloud{"mm", false, {}};
  Random random(300);
  constexpr std::size_t kBatch = 100'000;
  while (cloud.points.size() < kPoints) {
    std::vector<Shot> shots;
    while (shots.size() < kBatch) {
      if (const auto shot = randomShot(random)) shots.push_back(*shot);
    }
    std::vector<std::optional<Point3>> hits(shots.size());
    inParallel(shots.size(), [&](std::size_t i) { hits[i] = hit(shots[i].ray); });
    for (std::size_t i = 0; i < shots.size() && cloud.points.size() < kPoints; ++i) {
      if (!hits[i] || !onPanel(hits[i]->x, hits[i]->y)) continue;
      const Point3& toward = shots[i].ray.toward;
      const double noise_mm = shots[i].noise_mm;
      cloud.points.push_back({rounded(hits[i]->x + noise_mm * toward.x, kSmallestStepMm),
                              rounded(hits[i]->y + noise_mm * toward.y, kSmallestStepMm),
                              rounded(hits[i]->z + noise_mm * toward.z, kSmallestStepMm)});
    }
  }
  return cloud;
}

Reference panelReference() {
  Reference grid;
  grid.cols = 1200;
  grid.rows = 800;
  grid.spacing = kPanelReferenceSpacingMm;
  grid.first_x = grid.first_y = 0.5 * kPanelReferenceSpacingMm;
  grid.z.resize(static_cast<std::size_t>(grid.cols) * static_cast<std::size_t>(grid.rows));
  inParallel(grid.z.size(), [&](std::size_t i) {
    const int col = static_cast<int>(i % static_cast<std::size_t>(grid.cols));
    const int row = static_cast<int>(i / static_cast<std::size_t>(grid.cols));
    grid.z[i] = static_cast<float>(panelHeightMm(grid.x(col), grid.y(row)));
  });
  return grid;
}

}  // namespace relievo::samples
