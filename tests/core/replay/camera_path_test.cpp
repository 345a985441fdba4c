// SPDX-License-Identifier: BSD-3-Clause
// A camera path meets its keys, does not jump, and goes nowhere beyond them.
#include "core/replay/camera_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace relievo {
namespace {

DetailLadder ladder() {
  return {0, 0, 300, 200, {0.25, 0.5, 1, 2}, 2};
}

KeyView key(double t_s, double x, double y, double side, double azimuth = 0) {
  KeyView key{t_s, {}};
  key.view.region = {x - side / 2, y - side / 2, side, {0}};
  key.view.azimuth_deg = azimuth;
  return key;
}

CameraPath fourKeys() {
  return {"walk",
          {key(0, 150, 100, 300), key(2, 60, 60, 100, 170), key(3, 60, 120, 50, -170),
           key(6, 240, 120, 200, -100)}};
}

TEST(CameraPath, MeetsItsKeys) {
  const CameraPath path = fourKeys();
  for (const KeyView& key : path.keys) {
    const ViewState view = viewAt(path, ladder(), key.t_s);
    EXPECT_NEAR(view.region.centreX(), key.view.region.centreX(), 1e-9);
    EXPECT_NEAR(view.region.centreY(), key.view.region.centreY(), 1e-9);
    EXPECT_NEAR(view.region.side_mm, key.view.region.side_mm, 1e-9);
    EXPECT_NEAR(std::remainder(view.azimuth_deg - key.view.azimuth_deg, 360), 0, 1e-9);
  }
  EXPECT_EQ(viewAt(path, ladder(), 1).region.level, defaultLevel(ladder(), 180));
}

TEST(CameraPath, NeverJumpsInPlaceOrSpeedAndRestsAtItsEnds) {
  const CameraPath path = fourKeys();
  constexpr double kStepS = 1e-3;
  double x = 150, speed = 0;
  for (double t = kStepS; t < 6; t += kStepS) {
    const double now = viewAt(path, ladder(), t).region.centreX();
    const double speed_now = (now - x) / kStepS;
    EXPECT_LT(std::abs(speed_now - speed), 0.5) << "mm/s within a millisecond, at " << t;
    x = now;
    speed = speed_now;
  }
  EXPECT_LT(std::abs(speed), 0.5);
  EXPECT_EQ(viewAt(path, ladder(), -1), viewAt(path, ladder(), 0));
  EXPECT_EQ(viewAt(path, ladder(), 9), viewAt(path, ladder(), 6));
}

TEST(CameraPath, StaysBetweenNeighbouringKeysAndTurnsTheShorterWay) {
  const CameraPath path = fourKeys();
  for (double t = 2; t <= 3; t += 0.01) {
    const ViewState view = viewAt(path, ladder(), t);
    EXPECT_NEAR(view.region.centreX(), 60, 1e-9) << "both keys are at 60";
    EXPECT_GE(view.region.side_mm, 50 - 1e-9);
    EXPECT_LE(view.region.side_mm, 100 + 1e-9);
    EXPECT_GE(std::abs(view.azimuth_deg), 170 - 1e-9) << "170 to -170 is 20 degrees";
  }
}

TEST(CameraPath, SaysWhyItCannotBeFollowed) {
  CameraPath path = fourKeys();
  path.keys[2].t_s = 2;
  try {
    check(path);
    FAIL() << "times must increase";
  } catch (const ArgumentError& error) {
    EXPECT_NE(std::string(error.what()).find("key view 3"), std::string::npos) << error.what();
  }
  path.keys.resize(1);
  EXPECT_THROW(check(path), ArgumentError);
  path = fourKeys();
  path.keys[1].view.region.side_mm = 0;
  EXPECT_THROW(check(path), ArgumentError);
}

/// Keys at unequal times: the speed at a key is the harmonic mean of the speeds on both sides, the
/// nearer key's side weighing more (Fritsch and Butland 1984).
TEST(CameraPath, TheSpeedAtAKeyMindsHowFarItsNeighboursAre) {
  const CameraPath path{"walk", {key(0, 0, 0, 50), key(1, 10, 0, 50), key(4, 100, 0, 50)}};
  const auto x = [&](double t) { return viewAt(path, ladder(), t).region.centreX(); };
  constexpr double kStepS = 1e-5;
  const double speed = (x(1 + kStepS) - x(1 - kStepS)) / (2 * kStepS);
  const double left = 10, right = 30;  // mm/s over 1 s and 3 s.
  EXPECT_NEAR(speed, 12 / (7 / left + 5 / right), 1e-3);
}

}  // namespace
}  // namespace relievo
