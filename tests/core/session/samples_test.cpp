// SPDX-License-Identifier: BSD-3-Clause
// Maps of the made scans against the surfaces they were taken from.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

#include "core/depth/rules/rasterize.h"
#include "core/session/surface.h"
#include "data/generate/coin.h"
#include "data/generate/panel.h"
#include "data/generate/ruin.h"
#include "tests/core/scan_fixtures.h"

namespace relievo {
namespace {

Scan scanOf(const samples::Cloud& cloud) {
  Scan scan;
  const auto& first = cloud.points.front();
  scan.origin = {std::floor(first[0]), std::floor(first[1]), std::floor(first[2])};
  for (const auto& p : cloud.points) {
    scan.points.push_back({static_cast<float>(p[0] - scan.origin.x),
                           static_cast<float>(p[1] - scan.origin.y),
                           static_cast<float>(p[2] - scan.origin.z)});
  }
  scan.info.unit = lengthUnit(cloud.unit);
  test::finishScan(scan);
  return scan;
}

/// Differences of a map's heights from the truth, in mm, over the cells of one origin. The median
/// tells the method; walls and undercuts, where half a cell aside is another height, are beyond it.
struct Errors {
  std::vector<double> all;

  double quantile(double q) {
    std::sort(all.begin(), all.end());
    return all.at(static_cast<std::size_t>(q * static_cast<double>(all.size() - 1)));
  }
};

using Truth = std::function<double(double, double)>;  // File coordinates; NaN off the object.

Errors errorsOf(const Surface& surface, const Truth& truth, CellStatus origin, int every) {
  const double mm = mmPer(surface.unit);
  const auto file_from_view = surface.view_from_file.inverseOfSimilarity();
  const GridFrame& frame = surface.map.frame;
  Errors errors;
  for (int row = 0; row < frame.size.rows; row += every) {
    for (int col = 0; col < frame.size.cols; col += every) {
      const Cell cell{.col = col, .row = row};
      if (surface.map.origin(cell) != origin) continue;
      const FilePoint at = file_from_view(
          {frame.xMm(col), frame.yMm(row), static_cast<double>(surface.map.heightMm(cell))});
      const double true_z = truth(at.x, at.y);
      if (!std::isnan(true_z)) errors.all.push_back(std::abs(at.z - true_z) * mm);
    }
  }
  return errors;
}

void tell(const char* what, Errors& errors) {
  std::cout << what << ": median " << errors.quantile(0.5) << " mm, 90 % " << errors.quantile(0.9)
            << " mm over " << errors.all.size() << " cells\n";
}

TEST(Samples, TheCoinsMapIsItsTrueSurfaceWithinNoise) {
  const Surface surface = makeSurface(scanOf(samples::makeCoin()), {}, rasterize);
  EXPECT_EQ(surface.view_name, "top");
  EXPECT_EQ(surface.unit_source, UnitSource::file);
  Errors measured = errorsOf(surface, samples::coinHeightMm, CellStatus::measured, 1);
  Errors filled = errorsOf(surface, samples::coinHeightMm, CellStatus::interpolated, 1);
  tell("coin, measured", measured);
  tell("coin, interpolated", filled);
  EXPECT_LT(measured.quantile(0.5), 1.5 * samples::kCoinNoiseMm);
  EXPECT_LT(filled.quantile(0.5), 2 * samples::kCoinNoiseMm);
}

TEST(Samples, ThePanelsMapIsItsFrontMostSurface) {
  const Surface surface = makeSurface(scanOf(samples::makePanel()), {}, rasterize);
  EXPECT_EQ(surface.view_name, "top");
  Errors measured = errorsOf(surface, samples::panelHeightMm, CellStatus::measured, 3);
  tell("panel, measured", measured);
  // Half a cell of 0.5 mm aside on the rounded figures, and the noise.
  EXPECT_LT(measured.quantile(0.5), 0.06);
}

TEST(Samples, TheRuinsCourtKeepsItsCentimetresInUtmCoordinates) {
  const Surface surface = makeSurface(scanOf(samples::makeRuin()), {}, rasterize);
  EXPECT_EQ(surface.unit, LengthUnit::m);
  Errors measured = errorsOf(surface, samples::ruinHeightM, CellStatus::measured, 3);
  tell("ruin, measured", measured);
  EXPECT_LT(measured.quantile(0.5), 25);  // Aerial noise 20 mm, slopes over cells of 0.6 m.
}

TEST(Samples, OnACoarserGridTheProposedRuleIsNearerToTheTruthThanTheFrontMostPoint) {
  // Twice the spacing: about ten points a cell.
  struct Sample {
    const char* name;
    samples::Cloud cloud;
    Truth truth;
  };
  const Sample all[] = {{"coin", samples::makeCoin(), samples::coinHeightMm},
                        {"panel", samples::makePanel(), samples::panelHeightMm},
                        {"ruin", samples::makeRuin(), samples::ruinHeightM}};
  for (const Sample& sample : all) {
    const Scan scan = scanOf(sample.cloud);
    const Surface own = makeSurface(scan, {}, rasterize);
    const GridSize size = own.map.frame.size;
    const auto median_error = [&](std::optional<PointRule> rule, std::optional<int> cells) {
      SurfaceOptions options;
      options.cells = cells;
      options.rule = rule;
      const Surface surface = makeSurface(scan, options, rasterize);
      Errors errors = errorsOf(surface, sample.truth, CellStatus::measured, 1);
      tell((std::string(sample.name) + ", " + surface.rule).c_str(), errors);
      return errors.quantile(0.5);
    };
    std::cout << "on its own grid: ";
    median_error(PointRule::top_mean, std::nullopt);
    const int half = std::max(size.cols, size.rows) / 2;
    const double front = median_error(PointRule::front, half);
    EXPECT_LT(median_error(std::nullopt, half), front) << sample.name;
  }
}

}  // namespace
}  // namespace relievo
