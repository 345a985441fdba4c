// SPDX-License-Identifier: BSD-3-Clause
// What is said of reliefs whose every height is known: bumps of known size and place, a rim, mirror
// images, rough parts and gaps; and silence where nothing comes out clearly.
#include "core/describe/describe.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "core/region/window.h"
#include "core/session/surface.h"

namespace relievo {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

constexpr RectMm kObject{-100, 50, 300, 200};  // Its corner is not the origin.
using Heights = std::function<double(double x, double y)>;
using Origins = std::function<CellStatus(double x, double y)>;

/// A map of cells of a side; x from the left edge, y from the bottom edge, mm.
DepthMap mapOf(const Heights& z, double cell_mm = 1, const Origins& origin = {}) {
  DepthMap map;
  map.frame = {
      {static_cast<int>(kObject.width_mm / cell_mm), static_cast<int>(kObject.height_mm / cell_mm)},
      cell_mm,
      kObject.x_mm + 0.5 * cell_mm,
      kObject.y_mm + 0.5 * cell_mm};
  for (int row = 0; row < map.frame.size.rows; ++row) {
    for (int col = 0; col < map.frame.size.cols; ++col) {
      const double x = (col + 0.5) * cell_mm, y = (row + 0.5) * cell_mm;
      map.origins.push_back(origin ? origin(x, y) : CellStatus::measured);
      const bool is_hole = map.origins.back() == CellStatus::base_plane;
      map.heights_mm.push_back(is_hole ? 0 : static_cast<float>(z(x, y)));
    }
  }
  return map;
}

Description descriptionOf(const DepthMap& map) {
  Surface surface;
  surface.map = map;
  surface.pyramid = buildPyramid(map);
  surface.ladder = detailLadder(map, surface.pyramid);
  return describe(surface);
}

/// A dome, 0 from its radius on: half its height at half its width, 2 * radius / 3 on either side.
double dome(double x, double y, double at_x, double at_y, double radius_mm, double height_mm) {
  const double part = std::hypot(x - at_x, y - at_y) / radius_mm;
  return part < 1 ? height_mm * (1 - part * part) : 0;
}

double discShare(double radius_mm) {
  return std::numbers::pi * radius_mm * radius_mm / (kObject.width_mm * kObject.height_mm);
}

std::vector<std::string> spokenOf(const Description& d) {
  std::vector<std::string> spoken;
  for (const Message& sentence : sentencesOf(d)) spoken.push_back(englishSpoken(sentence));
  return spoken;
}

constexpr double kCellMm = 1.5;  // Of the window in which areas are looked for: 300 / 200.

TEST(Describe, ABumpHasItsPlaceSizeAndHeight) {
  const Description d =
      descriptionOf(mapOf([](double x, double y) { return dome(x, y, 60, 150, 40, 12); }));
  ASSERT_TRUE(d.highest);
  EXPECT_NEAR(d.highest->x_mm, kObject.x_mm + 60, kCellMm);
  EXPECT_NEAR(d.highest->y_mm, kObject.y_mm + 150, kCellMm);
  EXPECT_NEAR(d.highest->height_mm, 12, 0.05);
  EXPECT_EQ(d.highest->ninth, Ninth::top_left);
  EXPECT_NEAR(d.heights.max_mm, 12, 0.01);
  EXPECT_NEAR(d.heights.min_mm, 0, 1e-6);
  ASSERT_THAT(d.raised, SizeIs(1));
  const RaisedArea& area = d.raised.front();
  EXPECT_NEAR(area.x_mm, kObject.x_mm + 60, kCellMm);
  EXPECT_NEAR(area.y_mm, kObject.y_mm + 150, kCellMm);
  // A dome of this form is cut at the threshold in a disc of a known radius.
  const double cut_mm = 40 * std::sqrt(1 - d.threshold_mm / 12);
  EXPECT_NEAR(area.width_mm, 2 * cut_mm, 2 * kCellMm);
  EXPECT_NEAR(area.height_mm, 2 * cut_mm, 2 * kCellMm);
  EXPECT_NEAR(area.share, discShare(cut_mm), 0.05 * discShare(cut_mm));
  EXPECT_FALSE(area.is_rim);
  EXPECT_THAT(spokenOf(d), Contains("Highest place: top left."));
  EXPECT_THAT(spokenOf(d), Contains("Relief, 30 centimetres by 20 centimetres."));
}

TEST(Describe, TheHighestPlaceIsAsHighAsTheRangeOfHeights) {
  // A point on the dome that Detail 1 smooths away: one value is said, not two.
  const Description d = descriptionOf(mapOf(
      [](double x, double y) { return dome(x, y, 60, 150, 40, 12) + dome(x, y, 60, 150, 1.2, 3); },
      0.5));
  ASSERT_TRUE(d.highest);
  EXPECT_GT(d.heights.max_mm, 14);
  EXPECT_DOUBLE_EQ(d.highest->height_mm, d.heights.max_mm);
}

TEST(Describe, APlateauHasItsOwnEdges) {
  const Description d = descriptionOf(mapOf([](double x, double y) {
    return x > 195 && x < 270 && y > 30 && y < 60 ? 5.0 : 1.0;  // 75 x 30 mm.
  }));
  ASSERT_THAT(d.raised, SizeIs(1));
  EXPECT_NEAR(d.raised[0].width_mm, 75, 2 * kCellMm);
  EXPECT_NEAR(d.raised[0].height_mm, 30, 2 * kCellMm);
  EXPECT_NEAR(d.raised[0].share, 75.0 * 30 / 60000, 0.003);
  EXPECT_EQ(d.raised[0].ninth, Ninth::bottom_right);
  EXPECT_FALSE(d.highest) << "all of the plateau is as high";
}

TEST(Describe, ThreeBumpsAreThreePlacesLargestFirst) {
  const Description d = descriptionOf(mapOf([](double x, double y) {
    return dome(x, y, 250, 40, 25, 10) + dome(x, y, 50, 160, 35, 10) + dome(x, y, 150, 100, 30, 10);
  }));
  std::vector<Ninth> places;
  for (const RaisedArea& area : d.raised) places.push_back(area.ninth);
  EXPECT_THAT(places, ElementsAre(Ninth::top_left, Ninth::middle, Ninth::bottom_right));
  EXPECT_FALSE(d.highest) << "three places are as high";
  EXPECT_THAT(spokenOf(d), Contains("3 raised areas: top left, in the middle, bottom right."));
}

TEST(Describe, TurnsWithTheObject) {
  const Heights z = [](double x, double y) { return dome(x, y, 60, 150, 40, 12); };
  const auto mirrored = descriptionOf(mapOf([&](double x, double y) { return z(300 - x, y); }));
  const auto upside_down = descriptionOf(mapOf([&](double x, double y) { return z(x, 200 - y); }));
  EXPECT_EQ(mirrored.highest->ninth, Ninth::top_right);
  EXPECT_EQ(mirrored.raised.at(0).ninth, Ninth::top_right);
  EXPECT_EQ(upside_down.highest->ninth, Ninth::bottom_left);
}

TEST(Describe, IsTheSameForFinerAndCoarserCells) {
  const Heights z = [](double x, double y) {
    return dome(x, y, 60, 150, 40, 12) + 0.002 * x + 0.001 * y;
  };
  const Description fine = descriptionOf(mapOf(z, 0.5)), coarse = descriptionOf(mapOf(z, 2));
  ASSERT_TRUE(fine.highest && coarse.highest);
  EXPECT_NEAR(fine.highest->x_mm, coarse.highest->x_mm, 2);
  EXPECT_NEAR(fine.highest->y_mm, coarse.highest->y_mm, 2);
  ASSERT_EQ(fine.raised.size(), coarse.raised.size());
  EXPECT_NEAR(fine.raised.at(0).share, coarse.raised.at(0).share, 0.005);
  EXPECT_EQ(spokenOf(fine), spokenOf(coarse));
}

TEST(Describe, ARimGoesAllRound) {
  const Description d = descriptionOf(
      mapOf([](double x, double y) { return x < 20 || y < 20 || x > 280 || y > 180 ? 8.0 : 2.0; }));
  ASSERT_THAT(d.raised, SizeIs(1));
  EXPECT_TRUE(d.raised[0].is_rim);
  EXPECT_THAT(spokenOf(d), Contains("A raised rim goes all round."));
  EXPECT_GT(*d.mirrored_sides, 0.99);
  EXPECT_GT(*d.mirrored_ends, 0.99);
}

TEST(Describe, MirrorImagesAreSaidOfTheirAxisAlone) {
  const Description d = descriptionOf(mapOf(
      [](double x, double y) { return dome(x, y, 60, 150, 30, 9) + dome(x, y, 240, 150, 30, 9); }));
  EXPECT_NEAR(*d.mirrored_sides, 1, 1e-3);
  EXPECT_LT(*d.mirrored_ends, 0.1);
  EXPECT_THAT(spokenOf(d), Contains("Left and right are nearly mirror images."));
  EXPECT_THAT(spokenOf(d), Not(Contains("Top and bottom are nearly mirror images.")));
}

TEST(Describe, APlaneIsFlatAndARampHasNoRaisedArea) {
  const Description flat = descriptionOf(mapOf([](double, double) { return 7.0; }));
  EXPECT_THAT(flat.raised, IsEmpty());
  EXPECT_FALSE(flat.highest);
  EXPECT_FALSE(flat.mirrored_sides);
  EXPECT_THAT(spokenOf(flat), ElementsAre("Relief, 30 centimetres by 20 centimetres.",
                                          "All heights are the same.", "All of it was measured."));
  const Description ramp = descriptionOf(mapOf([](double x, double) { return 0.1 * x; }));
  EXPECT_NEAR(ramp.separability, 0.75, 0.01) << "of heights that are spread evenly";
  EXPECT_THAT(ramp.raised, IsEmpty());
  EXPECT_FALSE(ramp.highest) << "a whole edge is as high";
}

TEST(Describe, NoiseIsNoRaisedArea) {
  std::mt19937 random(1809);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same in every run.
  std::normal_distribution<double> noise(5, 1);
  const Description d = descriptionOf(mapOf([&](double, double) { return noise(random); }));
  EXPECT_THAT(d.raised, IsEmpty());
  EXPECT_FALSE(d.roughest);
  EXPECT_FALSE(d.smoothest);
}

TEST(Describe, TheRoughPartIsNamedAndASmoothBumpIsNone) {
  const Heights smooth = [](double x, double y) {
    return 5 * std::exp(-0.5 * (std::pow((x - 150) / 20, 2) + std::pow((y - 100) / 20, 2)));
  };
  EXPECT_FALSE(descriptionOf(mapOf(smooth)).roughest);
  const Heights rough = [&](double x, double y) {
    // A chequerboard of fields that Detail 1 still shows, four samples wide.
    constexpr double kFieldMm = 4 * kCellMm;
    const int parity = static_cast<int>(x / kFieldMm) + static_cast<int>(y / kFieldMm);
    return smooth(x, y) + (x > 200 && y < 66 && parity % 2 == 0 ? 0.5 : 0.0);
  };
  const Description d = descriptionOf(mapOf(rough));
  ASSERT_TRUE(d.roughest);
  EXPECT_EQ(*d.roughest, Ninth::bottom_right);
  EXPECT_THAT(spokenOf(d), Contains("Roughest part: bottom right."));
}

TEST(Describe, WhatWasNotMeasuredHasItsShareAndPlace) {
  // A tenth of the surface, of which two parts are apart.
  const Origins holes = [](double x, double y) {
    if (x > 10 && x < 60 && y > 10 && y < 110) return CellStatus::base_plane;       // 5000 mm2.
    if (x > 260 && x < 280 && y > 150 && y < 200) return CellStatus::interpolated;  // 1000 mm2.
    return CellStatus::measured;
  };
  const Description d =
      descriptionOf(mapOf([](double x, double y) { return 4 + 0.01 * x + 0.02 * y; }, 1, holes));
  EXPECT_NEAR(d.not_measured, 0.1, 1e-12);
  EXPECT_EQ(d.largest_gap, Ninth::bottom_left);
  EXPECT_THAT(spokenOf(d), Contains("Not measured: about a tenth of the surface."));
  EXPECT_THAT(spokenOf(d), Contains("Largest part that was not measured: bottom left."));
  EXPECT_THAT(d.raised, IsEmpty()) << "the ground of a hole parts nothing";
}

TEST(Describe, WhatFillsAHoleIsNeitherSmoothNorHighest) {
  // Fields everywhere but in the top left, most of which is filled by a high smooth lid.
  const auto is_lid = [](double x, double y) { return x < 100 && y > 140; };
  const Heights z = [&](double x, double y) {
    constexpr double kFieldMm = 4 * kCellMm;
    const int parity = static_cast<int>(x / kFieldMm) + static_cast<int>(y / kFieldMm);
    return is_lid(x, y) ? 3 + 0.01 * x : 0.5 * (parity % 2);
  };
  const Origins filled = [&](double x, double y) {
    return is_lid(x, y) ? CellStatus::interpolated : CellStatus::measured;
  };
  EXPECT_EQ(descriptionOf(mapOf(z)).smoothest, Ninth::top_left) << "as it would be if measured";
  const Description d = descriptionOf(mapOf(z, 1, filled));
  EXPECT_FALSE(d.smoothest);
  EXPECT_FALSE(d.highest);
}

TEST(Describe, StrangeMapsAreDescribedToo) {
  const Description outside = descriptionOf(mapOf(
      [](double, double) { return 0.0; }, 1, [](double, double) { return CellStatus::outside; }));
  EXPECT_FALSE(outside.has_heights);
  EXPECT_THAT(spokenOf(outside), Contains("There are no heights to describe."));
  const Description hole =
      descriptionOf(mapOf([](double, double) { return 0.0; }, 1,
                          [](double, double) { return CellStatus::base_plane; }));
  EXPECT_FALSE(hole.has_heights);
}

TEST(Describe, SentencesForEarsHaveADozenWordsAndNoUnitSigns) {
  const auto words = [](const std::string& text) {
    return 1 + std::count(text.begin(), text.end(), ' ');
  };
  Description d = descriptionOf(mapOf([](double x, double y) {
    return dome(x, y, 250, 40, 25, 10) + dome(x, y, 50, 160, 35, 10) + dome(x, y, 150, 100, 30, 10);
  }));
  d.object.width_mm = 317;  // "a little over".
  d.object.height_mm = 212;
  d.roughest = d.smoothest = Ninth::middle;
  d.not_measured = 0.1;
  d.largest_gap = Ninth::middle;
  for (const std::string& spoken : spokenOf(d)) {
    EXPECT_LE(words(spoken), 12) << spoken;
    EXPECT_EQ(spoken.find(" mm"), std::string::npos) << spoken;
    EXPECT_EQ(spoken.find('%'), std::string::npos) << spoken;
  }
}

}  // namespace
}  // namespace relievo
