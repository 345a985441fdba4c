// SPDX-License-Identifier: BSD-3-Clause
#include "core/relief/stereo.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/error.h"

namespace relievo {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes mixed(StereoPrint print, Bytes left, const Bytes& right) {
  mixAnaglyph(print, left, right);
  return left;
}

TEST(StereoForPrint, EqualGreysStayThatGreyInEveryMix) {
  const Bytes grey{120, 120, 120, 255};
  for (const StereoPrint print : {StereoPrint::grey, StereoPrint::half_colour}) {
    const Bytes out = mixed(print, grey, grey);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(out[i], 120, 1) << name(print);
  }
  // Dubois' rows sum to 0.999, 1.000 and 1.000.
  const Bytes out = mixed(StereoPrint::dubois, grey, grey);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(out[i], 120, 2);
}

TEST(StereoForPrint, TheRedChannelIsTheLeftEyesAndTheOthersTheRightEyes) {
  const Bytes white{255, 255, 255, 255};
  const Bytes black{0, 0, 0, 255};
  for (const StereoPrint print :
       {StereoPrint::grey, StereoPrint::half_colour, StereoPrint::dubois}) {
    const Bytes left = mixed(print, white, black);
    EXPECT_GT(left[0], 250) << name(print);
    EXPECT_LT(left[1], 5) << name(print);
    EXPECT_LT(left[2], 5) << name(print);
    const Bytes right = mixed(print, black, white);
    EXPECT_LT(right[0], 5) << name(print);
    EXPECT_GT(right[1], 250) << name(print);
    EXPECT_GT(right[2], 250) << name(print);
  }
}

TEST(StereoForPrint, HalfColourKeepsTheRightEyesBlueAndGreyDoesNot) {
  const Bytes blue{0, 0, 255, 255};
  EXPECT_EQ(mixed(StereoPrint::half_colour, blue, blue)[2], 255);
  EXPECT_EQ(mixed(StereoPrint::half_colour, blue, blue)[1], 0);
  const Bytes grey = mixed(StereoPrint::grey, blue, blue);
  EXPECT_EQ(grey[1], grey[2]);
}

TEST(StereoForPrint, ATransparentPixelStaysSoUnlessOneEyeSeesSomething) {
  const Bytes nothing{0, 0, 0, 0};
  EXPECT_EQ(mixed(StereoPrint::grey, nothing, nothing), nothing);
  EXPECT_EQ(mixed(StereoPrint::grey, nothing, {9, 9, 9, 255})[3], 255);
  EXPECT_THROW(mixed(StereoPrint::grey, nothing, {}), ArgumentError);
}

TEST(StereoForPrint, TheComfortableAngleMeetsTheLimitAndALowReliefKeepsTheChosenOne) {
  const double angle = comfortableEyeAngle(100, 0.5, 10);
  EXPECT_NEAR(parallax(100, angle, 0.5).visual_deg, kComfortDeg, 1e-6);
  EXPECT_LT(angle, 10);
  EXPECT_EQ(comfortableEyeAngle(1, 0.5, 4), 4);
  // 10 mm under 4 degrees, printed 1:2: 2 * 10 * tan(2 degrees) / 2 mm apart.
  EXPECT_NEAR(parallax(10, 4, 0.5).paper_mm, 0.349, 1e-3);
}

TEST(StereoForPrint, AutomaticDepthFillsTheComfortableRangeAndHidesNoFlanks) {
  for (const double height : {1.0, 5.0, 200.0}) {
    const double angle = automaticEyeAngle(height, 10, 600);
    EXPECT_NEAR(parallax(height, angle, 10, 600).visual_deg, kComfortDeg, 1e-9) << height;
    EXPECT_LE(angle, kMostEyeAngleDeg);
  }
  EXPECT_EQ(automaticEyeAngle(0.01, 1, 600), kMostEyeAngleDeg);
  EXPECT_EQ(automaticEyeAngle(0, 1, 600), StereoOptions{}.eye_angle_deg) << "a plane has no depth";
}

TEST(StereoForPrint, AColourOfBothEyesIsGreyInAGreyAnaglyphAndItselfWithoutOne) {
  const std::array<std::uint8_t, 3> orange{213, 94, 0};
  EXPECT_EQ(mixedColour(StereoPrint::off, orange), orange);
  EXPECT_EQ(mixedColour(StereoPrint::side_by_side, orange), orange);
  const auto grey = mixedColour(StereoPrint::grey, orange);
  EXPECT_EQ(grey[0], grey[1]);
  EXPECT_EQ(grey[1], grey[2]);
  EXPECT_GT(mixedColour(StereoPrint::half_colour, orange)[0],
            mixedColour(StereoPrint::half_colour, orange)[2]);
}

/// By the share that is dark for one eye: green and blue reach the right eye, yellow both.
TEST(Rivalry, CountsStrongRedsAndCyans) {
  const std::vector<Rgba> rivals{{220, 30, 20, 255}, {200, 10, 60, 255}, {20, 210, 200, 255}};
  EXPECT_EQ(rivalShare(rivals), 1);
  const std::vector<Rgba> others{{200, 190, 180, 255},  // Marble.
                                 {150, 110, 90, 255},   // Terracotta.
                                 {20, 200, 30, 255},   {230, 220, 20, 255},
                                 {20, 30, 220, 255},   {50, 5, 5, 255},  // Dark for both.
                                 {220, 30, 20, 0}};                      // Stone.
  EXPECT_EQ(rivalShare(others), 0);
  EXPECT_EQ(rivalShare({}), 0);
  std::vector<Rgba> mixed = others;
  mixed.insert(mixed.end(), rivals.begin(), rivals.end());
  EXPECT_NEAR(rivalShare(mixed), 0.3, 1e-12);
}

/// One byte a pixel, rows from the top.
Bytes paired(StereoPrint print, Bytes left, const Bytes& right, PixelRows rows) {
  rows.channels = 1;
  pairPictures(print, left, right, rows);
  return left;
}

TEST(StereoForScreens, SideBySideSqueezesEachPictureIntoItsHalf) {
  EXPECT_EQ(paired(StereoPrint::side_by_side, {10, 20, 30, 40, 1, 1, 3, 3},
                   {50, 50, 70, 70, 5, 7, 9, 9}, {.width = 4, .height = 2}),
            (Bytes{15, 35, 50, 70, 1, 3, 6, 9}));
}

TEST(StereoForScreens, OverAndUnderHasTheLeftEyeAboveWhereverMemoryBegins) {
  const Bytes left{10, 30, 50, 70}, right{100, 120, 140, 160};  // A column of four.
  EXPECT_EQ(paired(StereoPrint::over_under, left, right, {.width = 1, .height = 4}),
            (Bytes{20, 60, 110, 150}));
  const Bytes left_up(left.rbegin(), left.rend()), right_up(right.rbegin(), right.rend());
  EXPECT_EQ(paired(StereoPrint::over_under, left_up, right_up,
                   {.width = 1, .height = 4, .from_bottom = true}),
            (Bytes{150, 110, 60, 20}));
}

TEST(StereoForScreens, InterlacedGivesTheLeftEyeTheEvenRowsOfTheScreen) {
  const Bytes left(6, 1), right(6, 2);
  EXPECT_EQ(paired(StereoPrint::interlaced, left, right, {.width = 2, .height = 3}),
            (Bytes{1, 1, 2, 2, 1, 1}));
  EXPECT_EQ(paired(StereoPrint::interlaced, left, right, {.width = 2, .height = 3, .first_row = 1}),
            (Bytes{2, 2, 1, 1, 2, 2}))
      << "a window that begins in an odd row";
  EXPECT_EQ(paired(StereoPrint::interlaced, Bytes(4, 1), Bytes(4, 2),
                   {.width = 1, .height = 4, .from_bottom = true}),
            (Bytes{2, 1, 2, 1}));
}

TEST(StereoForScreens, OddSizesLoseNothingAndTwoSizesAreRefused) {
  EXPECT_EQ(paired(StereoPrint::side_by_side, {9, 9, 9}, {5, 5, 7}, {.width = 3, .height = 1}),
            (Bytes{9, 5, 6}));
  EXPECT_EQ(paired(StereoPrint::side_by_side, {9}, {5}, {.width = 1, .height = 1}), (Bytes{5}));
  EXPECT_THROW(paired(StereoPrint::side_by_side, {9, 9}, {5}, {.width = 1, .height = 1}),
               ArgumentError);
}

TEST(StereoForScreens, EveryKindOnScreenHasItsNameOnPaper) {
  for (std::size_t i = 0; i < kStereoModeNames.size(); ++i) {
    const auto mode = static_cast<StereoMode>(i);
    if (mode == StereoMode::anaglyph) continue;  // "grey".
    EXPECT_EQ(name(printed(mode)), name(mode));
  }
  EXPECT_TRUE(isPair(StereoPrint::interlaced));
  EXPECT_FALSE(isPair(StereoPrint::dubois));
  Bytes joined{120, 120, 120, 255};
  joinEyes(StereoPrint::grey, joined, Bytes{0, 0, 0, 255}, {.width = 1, .height = 1});
  EXPECT_NEAR(joined[0], 120, 1);
  EXPECT_EQ(joined[1], 0);
}

}  // namespace
}  // namespace relievo
