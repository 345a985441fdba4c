// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace relievo::falcon {
namespace {

/// Poses all over the space that the arms reach between -20 and 90 degrees.
class Poses {
 public:
  BaseMm next() {
    while (true) {
      const BaseMm p{xy_(random_), xy_(random_), z_(random_)};
      const auto angles = anglesFromGrip(p);
      if (!angles) continue;
      bool reachable = true;
      for (const double theta : *angles) {
        reachable = reachable && theta > -20 * kRadian && theta < 90 * kRadian;
      }
      if (reachable) return p;
    }
  }

 private:
  static constexpr double kRadian = 0.017453292519943295;
  std::mt19937 random_{20261121};
  std::uniform_real_distribution<double> xy_{-60, 60}, z_{76, 178};
};

struct Vector {
  BaseMm pose;
  std::array<double, 3> encoders, by_x, by_y, by_z;  // Torques in N mm for one N.
};
constexpr std::array<Vector, 8> kVectors{{
    {{0, 0, 80},
     {-1284.49, -1284.49, -1284.49},
     {9.893, -33.716, 23.824},
     {-33.221, 8.043, 25.178},
     {15.841, 15.841, 15.841}},
    {{0, 0, 100},
     {-740.83, -740.83, -740.83},
     {13.765, -46.947, 33.182},
     {-46.262, 11.210, 35.052},
     {22.389, 22.389, 22.389}},
    {{0, 0, 125},
     {-200.10, -200.10, -200.10},
     {17.890, -60.600, 42.710},
     {-59.646, 14.330, 45.316},
     {25.243, 25.243, 25.243}},
    {{0, 0, 150},
     {336.03, 336.03, 336.03},
     {21.275, -70.856, 49.581},
     {-69.535, 16.343, 53.192},
     {22.768, 22.768, 22.768}},
    {{0, 0, 170},
     {871.59, 871.59, 871.59},
     {22.353, -71.806, 49.453},
     {-70.009, 15.646, 54.363},
     {15.772, 15.772, 15.772}},
    {{30, 0, 125},
     {60.04, -616.72, 232.31},
     {17.004, -48.705, 47.516},
     {-64.580, 11.379, 54.837},
     {20.022, 40.461, 11.455}},
    {{0, 30, 125},
     {-608.90, 30.38, 253.53},
     {14.984, -65.886, 51.650},
     {-47.783, 13.268, 50.264},
     {40.166, 21.099, 10.706}},
    {{-20, 15, 110},
     {-836.65, -28.44, -482.38},
     {11.674, -62.967, 35.739},
     {-44.427, 14.559, 40.087},
     {34.054, 9.998, 25.443}},
}};

TEST(FalconKinematics, AgreesWithTheKnownPoses) {
  for (const Vector& v : kVectors) {
    const auto angles = anglesFromGrip(v.pose);
    ASSERT_TRUE(angles);
    const auto encoders = encodersFromAngles(*angles);
    const auto jacobian = angleJacobian(v.pose, *angles);
    ASSERT_TRUE(jacobian);
    const auto x = torquesForForce(*jacobian, {1, 0, 0});
    const auto y = torquesForForce(*jacobian, {0, 1, 0});
    const auto z = torquesForForce(*jacobian, {0, 0, 1});
    ASSERT_TRUE(x && y && z);
    for (std::size_t i = 0; i < kArms; ++i) {
      EXPECT_NEAR(encoders[i], v.encoders[i], 0.006) << v.pose.x << ' ' << v.pose.z;
      EXPECT_NEAR((*x)[i], v.by_x[i], 6e-4);
      EXPECT_NEAR((*y)[i], v.by_y[i], 6e-4);
      EXPECT_NEAR((*z)[i], v.by_z[i], 6e-4);
    }
  }
}

TEST(FalconKinematics, FindsTheKnownPlacesFromEncoders) {
  const auto at = [](std::int16_t a, std::int16_t b, std::int16_t c) {
    const auto grip = gripFromAngles(anglesFromEncoders({a, b, c}));
    EXPECT_TRUE(grip);
    return grip.value_or(BaseMm{});
  };
  const auto expect = [](BaseMm p, double x, double y, double z) {
    EXPECT_NEAR(p.x, x, 6e-4);
    EXPECT_NEAR(p.y, y, 6e-4);
    EXPECT_NEAR(p.z, z, 6e-4);
  };
  expect(at(0, 0, 0), 0, 0, 134.602);
  expect(at(100, 0, 0), 1.250, -4.146, 136.098);
  expect(at(0, 100, 0), -4.215, 0.991, 136.098);
  expect(at(0, 0, 100), 2.965, 3.155, 136.098);
  expect(at(500, 500, 500), 0, 0, 156.861);
  expect(at(-500, -500, -500), 0, 0, 110.755);
}

TEST(FalconKinematics, ForwardUndoesInverseEverywhere) {
  Poses poses;
  double worst = 0;
  for (int i = 0; i < 100'000; ++i) {
    const BaseMm p = poses.next();
    const auto back = gripFromAngles(*anglesFromGrip(p));
    ASSERT_TRUE(back) << p.x << ' ' << p.y << ' ' << p.z;
    worst = std::max(worst, norm(*back - p));
  }
  EXPECT_LT(worst, 1e-6) << "mm";
}

TEST(FalconKinematics, JacobianIsTheSlopeOfTheInverse) {
  Poses poses;
  constexpr double kStep = 1e-3;
  for (int n = 0; n < 2000; ++n) {
    const BaseMm p = poses.next();
    const auto jacobian = angleJacobian(p, *anglesFromGrip(p));
    ASSERT_TRUE(jacobian);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const BaseMm d{axis == 0 ? kStep : 0, axis == 1 ? kStep : 0, axis == 2 ? kStep : 0};
      const auto up = anglesFromGrip(p + d), down = anglesFromGrip(p - d);
      ASSERT_TRUE(up && down);
      for (std::size_t arm = 0; arm < kArms; ++arm) {
        const double slope = ((*up)[arm] - (*down)[arm]) / (2 * kStep);
        ASSERT_NEAR((*jacobian)[arm][axis], slope, 1e-6) << p.x << ' ' << p.y << ' ' << p.z;
      }
    }
  }
}

TEST(FalconKinematics, MotorsDoTheWorkThatTheHandFeels) {
  Poses poses;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> newtons(-8, 8), mm_per_s(-300, 300);
  for (int n = 0; n < 20'000; ++n) {
    const BaseMm p = poses.next();
    const auto h = angleJacobian(p, *anglesFromGrip(p));
    ASSERT_TRUE(h);
    const DeviceN force{newtons(random), newtons(random), newtons(random)};
    const std::array<double, 3> v{mm_per_s(random), mm_per_s(random), mm_per_s(random)};
    const auto torque = torquesForForce(*h, force);
    ASSERT_TRUE(torque) << p.x << ' ' << p.y << ' ' << p.z;
    double motors = 0, size = 1;
    for (std::size_t i = 0; i < kArms; ++i) {
      const double rate = (*h)[i][0] * v[0] + (*h)[i][1] * v[1] + (*h)[i][2] * v[2];
      motors += (*torque)[i] * rate;
      size += std::abs((*torque)[i] * rate);
    }
    const double hand = force.x * v[0] + force.y * v[1] + force.z * v[2];
    ASSERT_NEAR(motors, hand, 1e-9 * size);
  }
}

TEST(FalconKinematics, PushingOutInTheMiddleIsEqualForAllMotors) {
  const auto h = angleJacobian(kCentre, *anglesFromGrip(kCentre));
  const auto torques = torquesForForce(*h, {0, 0, 1});
  const auto counts = countsForTorques(*torques, kNominalCountsPerNmm);
  EXPECT_EQ(counts, (std::array<std::int16_t, 3>{-252, -252, -252}));
}

TEST(FalconKinematics, TooMuchForceKeepsItsDirection) {
  const auto h = angleJacobian(kCentre, *anglesFromGrip(kCentre));
  const auto torques = torquesForForce(*h, {10, -25, 40});
  const auto counts = countsForTorques(*torques, kNominalCountsPerNmm);
  std::size_t largest = 0;
  for (std::size_t i = 1; i < kArms; ++i) {
    if (std::abs(counts[i]) > std::abs(counts[largest])) largest = i;
  }
  EXPECT_EQ(std::abs(counts[largest]), kMaxCounts);
  for (std::size_t i = 0; i < kArms; ++i) {
    EXPECT_NEAR(counts[i], counts[largest] * (*torques)[i] / (*torques)[largest], 0.5);
  }
}

TEST(FalconKinematics, ImpossiblePlacesAndTorquesAreRefused) {
  EXPECT_FALSE(anglesFromGrip({0, 0, 400}));
  EXPECT_FALSE(anglesFromGrip({200, 0, 125}));
  EXPECT_FALSE(anglesFromGrip({std::nan(""), 0, 125}));
  EXPECT_FALSE(gripFromAngles({std::nan(""), 0, 0}));
  EXPECT_EQ(countsForTorques({std::nan(""), 0, 0}, 10), (std::array<std::int16_t, 3>{}));
  EXPECT_EQ(countsForTorques({1, INFINITY, 0}, 10), (std::array<std::int16_t, 3>{}));
}

TEST(FalconKinematics, AnyEncodersGiveAPlaceOrNone) {
  std::mt19937 random(99);
  std::uniform_int_distribution<int> encoder(-32768, 32767);
  for (int i = 0; i < 50'000; ++i) {
    const auto any = [&] { return static_cast<std::int16_t>(encoder(random)); };
    const auto grip = gripFromAngles(anglesFromEncoders({any(), any(), any()}));
    if (grip) {
      ASSERT_TRUE(isFinite(*grip));
    }
  }
}

}  // namespace
}  // namespace relievo::falcon
