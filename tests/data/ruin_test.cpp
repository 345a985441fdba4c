// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/ruin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "data/generate/ply_bytes.h"
#include "tests/data/checksum.h"
#include "tests/data/empty_squares.h"

namespace relievo::samples {
namespace {

const Cloud& ruin() {
  static const Cloud kCloud = makeRuin();
  return kCloud;
}

/// Median of the absolute residuals: a tenth of a millimetre of rounding beside a wall's edge must
/// not count as noise. For normal noise it is 0.6745 standard deviations.
double medianResidualM(std::size_t first, std::size_t count) {
  std::vector<double> off;
  for (std::size_t i = first; i < first + count; ++i) {
    const auto& [x, y, z] = ruin().points[i];
    off.push_back(std::abs(z - ruinHeightM(x, y)));
  }
  std::nth_element(off.begin(), off.begin() + static_cast<std::ptrdiff_t>(count / 2), off.end());
  return off[count / 2];
}

TEST(Ruin, EachScanDiffersFromTheTrueSurfaceByItsNoise) {
  constexpr double kMedianOfNormal = 0.6745;
  ASSERT_EQ(ruin().points.size(), kRuinAerialPoints + kRuinStationPoints + kRuinCourtPoints);
  EXPECT_NEAR(medianResidualM(0, kRuinAerialPoints), kMedianOfNormal * kRuinAerialNoiseM, 2e-4);
  EXPECT_NEAR(medianResidualM(kRuinAerialPoints, kRuinStationPoints),
              kMedianOfNormal * kRuinStationNoiseM, 1e-4);
  EXPECT_NEAR(medianResidualM(kRuinAerialPoints + kRuinStationPoints, kRuinCourtPoints),
              kMedianOfNormal * kRuinCourtNoiseM, 3e-5);
}

TEST(Ruin, NeedsDoublesBecauseOfItsCoordinates) {
  EXPECT_TRUE(ruin().double_precision);
  const auto& [x, y, z] = ruin().points.back();
  EXPECT_GT(std::abs(y - static_cast<double>(static_cast<float>(y))), 1e-3)
      << "a float would move this point";
}

TEST(Ruin, JointsOfTheCourtAreCentimetresWideAndDeep) {
  // Along a line across the stones there is a joint every 0.6 m, 20 mm deep, about 25 mm wide.
  const double east = kRuinEastM + kRuinCourtEastM + 3.13;
  double deep_m = 0;
  constexpr double kStepM = 0.001;
  for (double along = 0; along < kRuinCourtSideM; along += kStepM) {
    const double north = kRuinNorthM + kRuinCourtNorthM + along;
    const double beside =
        std::max(ruinHeightM(east, north - 0.04), ruinHeightM(east, north + 0.04));
    if (beside - ruinHeightM(east, north) > 0.01) deep_m += kStepM;
  }
  EXPECT_NEAR(deep_m, 10 * 0.025, 0.05);
}

TEST(Ruin, CloseScanResolvesTheJoints) {
  double sum = 0;
  std::vector<double> heights;
  for (std::size_t i = ruin().points.size() - kRuinCourtPoints; i < ruin().points.size(); ++i) {
    heights.push_back(ruin().points[i][2]);
    sum += heights.back();
  }
  const double mean = sum / static_cast<double>(heights.size());
  const auto deep =
      std::count_if(heights.begin(), heights.end(), [mean](double z) { return z < mean - 0.008; });
  // 25 mm of 600 and of 900: 7 % of the area.
  EXPECT_NEAR(static_cast<double>(deep) / static_cast<double>(heights.size()), 0.069, 0.02);
}

TEST(Ruin, HasHolesWhereNothingWasSeen) {
  const SquareCounts counts(ruin(), kRuinEastM, kRuinNorthM, 400, 400, 2);
  EXPECT_EQ(counts.at(kRuinEastM + 150, kRuinNorthM + 160), 0U) << "water of the tank";
  EXPECT_EQ(counts.at(kRuinEastM + 330, kRuinNorthM + 95), 0U) << "thicket";
  const auto behind_north_wall = [](double x, double y) {
    return std::abs(x - kRuinEastM - 200) < 80 && std::abs(y - kRuinNorthM - 276.5) < 1;
  };
  EXPECT_GT(counts.empty(behind_north_wall), 10U) << "shadow of the wall";
}

TEST(Ruin, IsScannedAThousandTimesMoreDenselyInTheCourt) {
  const SquareCounts counts(ruin(), kRuinEastM, kRuinNorthM, 400, 400, 2);
  EXPECT_GT(counts.at(kRuinEastM + 249, kRuinNorthM + 200),
            1000 * counts.at(kRuinEastM + 360, kRuinNorthM + 300));
}

TEST(Ruin, ReferencesAreTheClosedFormAtTheirSamples) {
  const Reference site = ruinReference();
  EXPECT_FLOAT_EQ(site.z[700U * 1600U + 800U],
                  static_cast<float>(ruinHeightM(site.x(800), site.y(700))));
  const Reference court = ruinCourtReference();
  EXPECT_EQ(court.cols, 600);
  EXPECT_FLOAT_EQ(court.z[70U * 600U + 80U],
                  static_cast<float>(ruinHeightM(court.x(80), court.y(70))));
  EXPECT_TRUE(std::isnan(ruinHeightM(kRuinEastM - 1, kRuinNorthM + 5)));
}

TEST(Ruin, GivesTheSameBytesOnEveryRun) {
  const std::string first = plyBytes(ruin());
  EXPECT_EQ(first, plyBytes(makeRuin()));
  EXPECT_EQ(checksum(first), 15992934939775724886U);
}

}  // namespace
}  // namespace relievo::samples
