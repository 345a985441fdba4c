// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/ruin.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "data/generate/parallel.h"
#include "data/generate/random.h"
#include "data/generate/ruin_site.h"
#include "data/generate/shapes.h"

namespace relievo::samples {
namespace {

constexpr double kLowestM = 455;  ///< Above sea level, of site height 0.
constexpr double kSmallestStepM = 1e-4;
constexpr double kHighestM = 30;  ///< Site height that nothing exceeds.

/// Site heights on a grid, for the many look-ups along lines of sight.
class SiteTable {
 public:
  SiteTable() : heights_(static_cast<std::size_t>(kSide) * kSide) {
    inParallel(heights_.size(), [this](std::size_t i) {
      const std::size_t row = i / kSide;
      const std::size_t col = i % kSide;
      heights_[i] = static_cast<float>(
          siteHeightM(static_cast<double>(col) * kStepM, static_cast<double>(row) * kStepM));
    });
  }
  /// Nothing blocks the view off the site.
  double at(double east, double north) const {
    const auto col = std::lround(east / kStepM);
    const auto row = std::lround(north / kStepM);
    if (col < 0 || row < 0 || col >= kSide || row >= kSide) return -kHighestM;
    return heights_[static_cast<std::size_t>(row) * kSide + static_cast<std::size_t>(col)];
  }

  static constexpr double kStepM = 0.2;

 private:
  static constexpr int kSide = 2001;
  std::vector<float> heights_;
};

/// Does something between `from` and `steps` steps along `step` stand higher than the line?
bool blocked(const SiteTable& table, std::array<double, 3> from, const std::array<double, 3>& step,
             int steps) {
  constexpr double kGrazingM = 0.1;  // the table is coarse; the point's own edge must not hide it
  for (int i = 0; i < steps && from[2] < kHighestM; ++i) {
    for (std::size_t k = 0; k < 3; ++k) from[k] += step[k];
    if (i > 1 && table.at(from[0], from[1]) > from[2] + kGrazingM) return true;
  }
  return false;
}

/// From the air: the scanner looks down aslant from the south-west, in strips that overlap.
bool seenFromTheAir(const SiteTable& table, const std::array<double, 3>& p) {
  constexpr std::array<double, 3> kStep{-0.25, -0.2, 0.5};
  return !blocked(table, p, kStep, 100);
}
double aerialDensity(double east, double north) {
  const double strip = std::remainder(east * 0.8 + north * 0.6, 70.0);
  return std::abs(strip) < 10 ? 1.0 : 0.55 - 0.002 * std::abs(strip);
}

struct Station {
  double east = 0, north = 0;
};
constexpr std::array<Station, 3> kStations{{{262, 207}, {176, 180}, {322, 200}}};

bool seenFrom(const Station& station, const SiteTable& table, const std::array<double, 3>& p) {
  constexpr double kTripodM = 2.2;
  const double eye = siteHeightM(station.east, station.north) + kTripodM;
  const double away = std::hypot(station.east - p[0], station.north - p[1]);
  const int steps = static_cast<int>(away / SiteTable::kStepM);
  if (steps == 0) return true;
  return !blocked(
      table, p,
      {(station.east - p[0]) / steps, (station.north - p[1]) / steps, (eye - p[2]) / steps}, steps);
}

bool onSite(double east, double north) {
  return east >= 0 && north >= 0 && east <= kRuinSideM && north <= kRuinSideM;
}

/// Collects points of one scan until there are enough.
class Scan {
 public:
  Scan(Cloud& cloud, Random& random, std::size_t count, double noise_m)
      : cloud_(cloud), random_(random), end_(cloud.points.size() + count), noise_m_(noise_m) {}

  bool complete() const { return cloud_.points.size() >= end_; }
  void add(const std::array<double, 3>& p) {
    const double z = p[2] + noise_m_ * random_.normal();
    cloud_.points.push_back({kRuinEastM + rounded(p[0], kSmallestStepM),
                             kRuinNorthM + rounded(p[1], kSmallestStepM),
                             kLowestM + rounded(z, kSmallestStepM)});
  }

 private:
  Cloud& cloud_;
  Random& random_;
  std::size_t end_;
  double noise_m_;
};

void scanFromTheAir(Cloud& cloud, Random& random, const SiteTable& table) {
  Scan scan(cloud, random, kRuinAerialPoints, kRuinAerialNoiseM);
  while (!scan.complete()) {
    const double east = random.uniform(0, kRuinSideM);
    const double north = random.uniform(0, kRuinSideM);
    const bool kept = random.uniform() < aerialDensity(east, north);
    if (!kept || siteUnseen(east, north)) continue;
    const std::array<double, 3> p{east, north, siteHeightM(east, north)};
    if (seenFromTheAir(table, p)) scan.add(p);
  }
}

/// From a station the points get sparser with the distance: as many in the ring from 2 to 4 m as
/// in that from 32 to 64 m.
void scanFromStations(Cloud& cloud, Random& random, const SiteTable& table) {
  constexpr double kNearestM = 2;
  constexpr double kDoublings = 5;
  Scan scan(cloud, random, kRuinStationPoints, kRuinStationNoiseM);
  while (!scan.complete()) {
    const Station& station = kStations[static_cast<std::size_t>(3 * random.uniform())];
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    const double away = kNearestM * std::exp2(random.uniform(0, kDoublings));
    const double east = station.east + away * std::cos(angle);
    const double north = station.north + away * std::sin(angle);
    if (!onSite(east, north) || siteUnseen(east, north)) continue;
    const std::array<double, 3> p{east, north, siteHeightM(east, north)};
    if (seenFrom(station, table, p)) scan.add(p);
  }
}

void scanTheCourt(Cloud& cloud, Random& random) {
  Scan scan(cloud, random, kRuinCourtPoints, kRuinCourtNoiseM);
  while (!scan.complete()) {
    const double east = kRuinCourtEastM + random.uniform(0, kRuinCourtSideM);
    const double north = kRuinCourtNorthM + random.uniform(0, kRuinCourtSideM);
    scan.add({east, north, siteHeightM(east, north)});
  }
}

Reference evaluateSite(double east, double north, double side, double spacing) {
  Reference grid;
  grid.cols = grid.rows = static_cast<int>(std::lround(side / spacing));
  grid.spacing = spacing;
  grid.first_x = kRuinEastM + east + 0.5 * spacing;
  grid.first_y = kRuinNorthM + north + 0.5 * spacing;
  return evaluate(grid, ruinHeightM);
}

}  // namespace

double ruinHeightM(double east_m, double north_m) {
  const double east = east_m - kRuinEastM;
  const double north = north_m - kRuinNorthM;
  if (!onSite(east, north)) return std::numeric_limits<double>::quiet_NaN();
  return kLowestM + siteHeightM(east, north);
}

Cloud makeRuin() {
  Cloud cloud{"m", true, {}};
  const SiteTable table;
  Random random(400);
  scanFromTheAir(cloud, random, table);
  scanFromStations(cloud, random, table);
  scanTheCourt(cloud, random);
  return cloud;
}

Reference ruinReference() {
  return evaluateSite(0, 0, kRuinSideM, kRuinReferenceSpacingM);
}

Reference ruinCourtReference() {
  return evaluateSite(kRuinCourtEastM, kRuinCourtNorthM, kRuinCourtSideM,
                      kRuinCourtReferenceSpacingM);
}

}  // namespace relievo::samples
