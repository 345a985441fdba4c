// SPDX-License-Identifier: BSD-3-Clause
// How near a map comes to the surface that was scanned, all bars in one and the same result: a
// noisy, unevenly dense cloud of relief N at the paper's 800 x 800.
#include <gtest/gtest.h>

#include <iostream>

#include "core/depth/rules/rasterize.h"
#include "tests/core/relief_n_accuracy.h"

namespace relievo {
namespace {

test::ReliefNAccuracy told(const Surface& surface) {
  const test::ReliefNAccuracy found = test::accuracyOnReliefN(surface);
  std::cout << surface.rule << ": rms " << found.rms_mm << " mm, holes kept " << found.holes_kept
            << ", gaps closed " << found.gaps_closed << ", flyers " << surface.losses->outliers
            << '\n';
  return found;
}

TEST(Accuracy, AMillionPointsGiveTheReliefItsHolesAndNoGaps) {
  const Scan scan = test::reliefNScan({.points = 1'000'000});
  const Surface surface = makeSurface(scan, test::topView(800), rasterize);
  EXPECT_EQ(surface.rule, "1.6 points per cell: local quadratic");
  const test::ReliefNAccuracy found = told(surface);
  EXPECT_LE(found.rms_mm, 0.012);
  EXPECT_GE(found.holes_kept, 0.94);
  EXPECT_GE(found.gaps_closed, 0.999);
  ASSERT_GE(surface.holes.size(), 3U);
  EXPECT_NEAR(surface.holes[0].area_mm2, 36 * M_PI, 0.06 * 36 * M_PI);
}

TEST(Accuracy, OutliersDoNotChangeIt) {
  const Scan scan = test::reliefNScan({.points = 1'000'000, .outlier_share = 0.0005});
  const test::ReliefNAccuracy found = told(makeSurface(scan, test::topView(800), rasterize));
  EXPECT_LE(found.rms_mm, 0.012);
  EXPECT_GE(found.holes_kept, 0.94);
  EXPECT_GE(found.gaps_closed, 0.999);
}

TEST(Accuracy, DenseCloudsWithOutliersKeepItToo) {
  const Scan scan = test::reliefNScan({.points = 4'000'000, .outlier_share = 0.0005});
  const test::ReliefNAccuracy found = told(makeSurface(scan, test::topView(500), rasterize));
  EXPECT_LE(found.rms_mm, 0.012);
  EXPECT_GE(found.holes_kept, 0.94);
  EXPECT_GE(found.gaps_closed, 0.999);
}

TEST(Accuracy, TheBilinearSplatIsTheQuickWay) {
  const Scan scan = test::reliefNScan({.points = 1'000'000});
  SurfaceOptions options = test::topView(800);
  options.rule = PointRule::splat;
  const test::ReliefNAccuracy found = told(makeSurface(scan, options, rasterize));
  EXPECT_LE(found.rms_mm, 0.016);
  EXPECT_GE(found.holes_kept, 0.94);
  EXPECT_GE(found.gaps_closed, 0.999);
}

TEST(Accuracy, TheBasePlaneIsWhereItIsWithoutOutliers) {
  const Surface clean =
      makeSurface(test::reliefNScan({.points = 300'000}), test::topView(400), rasterize);
  const Surface flown = makeSurface(test::reliefNScan({.points = 300'000, .outlier_share = 0.003}),
                                    test::topView(400), rasterize);
  const double clean_mm = clean.view_from_file({0, 0, 0}).z;
  EXPECT_NEAR(flown.view_from_file({0, 0, 0}).z, clean_mm, 0.02);
  EXPECT_GT(flown.losses->outliers, 700U);
}

TEST(Accuracy, TheBytesAreTheSameForAnyNumberOfThreads) {
  const Scan scan = test::reliefNScan({.points = 400'000, .outlier_share = 0.001});
  const auto made = [&](int threads) {
    SurfaceOptions options = test::topView(500);
    options.pyramid.threads = threads;
    return makeSurface(scan, options, [threads](const DepthRequest& request, const Task& task) {
      DepthRequest mine = request;
      mine.threads = threads;
      return rasterize(mine, task);
    });
  };
  const Surface one = made(1);
  for (const int threads : {2, 5}) {
    const Surface more = made(threads);
    EXPECT_EQ(one.map.heights_mm, more.map.heights_mm);
    EXPECT_EQ(one.map.origins, more.map.origins);
    EXPECT_EQ(one.pyramid.levels.back().heights_mm, more.pyramid.levels.back().heights_mm);
  }
}

}  // namespace
}  // namespace relievo
