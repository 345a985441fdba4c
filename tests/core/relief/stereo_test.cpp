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

}  // namespace
}  // namespace relievo
