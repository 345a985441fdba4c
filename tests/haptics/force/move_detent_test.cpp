// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/force/move_detent.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "haptics/loop/haptic_core.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

constexpr MoveDetent kDetent{.on = true, .centre = {3, -2, 5}};

DeviceN at(const MoveDetent& detent, double x, double y, double z = 0) {
  return detentForce(detent, detent.centre + DeviceMm{x, y, z});
}

TEST(MoveDetent, HoldsTheHandWhereItBeganAndAsksItBack) {
  EXPECT_EQ(at(kDetent, 0, 0), DeviceN{});
  EXPECT_LT(at(kDetent, 10, 0).x, 0);
  EXPECT_GT(at(kDetent, -10, 0).x, 0);
  EXPECT_LT(at(kDetent, 0, 10).y, 0);
  EXPECT_GT(at(kDetent, 0, 0, -10).z, 0);
  MoveDetent off = kDetent;
  off.on = false;
  EXPECT_EQ(at(off, 10, 4), DeviceN{});
}

TEST(MoveDetent, EachWayGivesInWithOneClickAtTwentyMillimetres) {
  for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
    double before = 0;
    int clicks = 0;
    bool rising = true;
    for (double way = 0; way <= 45; way += 0.1) {
      const double force = norm(at(kDetent, way * x, way * y));
      const bool rises = force > before - 1e-12;
      if (rising && !rises) {
        ++clicks;
        EXPECT_NEAR(way, 20, 2.1);
      }
      rising = rises;
      before = force;
    }
    EXPECT_EQ(clicks, 1);
    EXPECT_GT(norm(at(kDetent, 18 * x, 18 * y)), 2.5 * norm(at(kDetent, 22 * x, 22 * y)));
  }
}

TEST(MoveDetent, BesideAWayTheHandIsGuidedBackToIt) {
  EXPECT_LT(at(kDetent, 15, 4).y, -0.3);
  EXPECT_GT(at(kDetent, 15, -4).y, 0.3);
  EXPECT_LT(at(kDetent, 4, 15).x, -0.3);
}

TEST(MoveDetent, AtTheObjectsEdgeThereIsAWallInPlaceOfAClick) {
  MoveDetent detent = kDetent;
  detent.blocked = 2;
  double before = 0;
  for (double way = 0; way <= 30; way += 0.5) {
    const double force = -at(detent, way, 0).x;
    EXPECT_GE(force, before) << way;
    before = force;
  }
  EXPECT_NEAR(before, 3.1, 1e-9);
  EXPECT_EQ(at(detent, -15, 0), at(kDetent, -15, 0)) << "the other ways stay as they are";
}

TEST(MoveDetent, EachOfTheFourWallsStandsOnItsOwnSide) {
  struct Side {
    std::uint8_t bit;
    int x, y;
  };
  for (const Side& blocked : {Side{1, -1, 0}, Side{2, 1, 0}, Side{4, 0, -1}, Side{8, 0, 1}}) {
    MoveDetent detent = kDetent;
    detent.blocked = blocked.bit;
    for (const Side& way : {Side{1, -1, 0}, Side{2, 1, 0}, Side{4, 0, -1}, Side{8, 0, 1}}) {
      const DeviceN force = at(detent, 15 * way.x, 15 * way.y);
      const DeviceN open = at(kDetent, 15 * way.x, 15 * way.y);
      if (way.bit == blocked.bit) {
        EXPECT_GT(norm(force), norm(open) + 1) << int{way.bit};
      } else {
        EXPECT_EQ(force, open) << int{blocked.bit} << " is no wall on side " << int{way.bit};
      }
    }
  }
}

TEST(MoveDetent, NobodyGainsEnergyByGoingRound) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> size(2, 30), phase(0, 2 * std::numbers::pi);
  MoveDetent detent = kDetent;
  for (int loop = 0; loop < 50; ++loop) {
    detent.blocked = static_cast<std::uint8_t>(loop % 16);
    const double a = size(random), b = size(random), c = phase(random), shift = size(random) - 15;
    const auto place = [&](double t) {
      return DeviceMm{shift + a * std::cos(t), b * std::sin(t + c), 5 * std::sin(2 * t)};
    };
    double work_mj = 0;
    constexpr int kSteps = 40'000;
    for (int i = 0; i < kSteps; ++i) {
      const double t = 2 * std::numbers::pi * i / kSteps, dt = 2 * std::numbers::pi / kSteps;
      const DeviceMm middle = place(t + dt / 2), step = place(t + dt) - place(t);
      const DeviceN force = at(detent, middle.x, middle.y, middle.z);
      work_mj += force.x * step.x + force.y * step.y + force.z * step.z;
    }
    EXPECT_NEAR(work_mj, 0, 0.02) << loop;
  }
}

/// The whole core in Move mode.
class GatedCore : public ::testing::Test {
 protected:
  GatedCore() {
    options_.force.forces_on = true;
    options_.force.strength = 1;
    options_.frame = true;
  }
  HapticSample tick(DeviceMm hand) {
    now_ns_ += 1'000'000;
    return core_.tick(*space_, options_, {.position = hand, .time_ns = now_ns_}, now_ns_);
  }
  /// Slowly from one place to another.
  HapticSample go(DeviceMm from, DeviceMm to, int ticks) {
    HapticSample last;
    for (int i = 1; i <= ticks; ++i) {
      const HapticSample sample = tick(from + (static_cast<double>(i) / ticks) * (to - from));
      EXPECT_LE(norm(sample.force - before_), 0.2001) << "never a kick";
      before_ = sample.force;
      last = sample;
    }
    return last;
  }

  /// Flat, at z = 0 of the hand's space.
  std::unique_ptr<HapticSpace> space_ = test::spaceOf(80, [](double, double) { return 5.0; });
  HapticCore core_;
  HapticOptions options_;
  DeviceN before_;
  std::int64_t now_ns_ = 1'000'000'000;
};

TEST_F(GatedCore, FeelsTheGateInPlaceOfTheSurfaceAndTheSurfaceComesBackGently) {
  const DeviceMm above{0, 0, 6}, pressed{0, 0, -3};
  go(above, above, 1500);
  EXPECT_GT(go(above, pressed, 500).force.z, 1);
  options_.detent = {.on = true, .centre = pressed};
  HapticSample sample = go(pressed, pressed, 1500);
  EXPECT_LT(norm(sample.force), 0.01) << "the surface is not felt any more";
  const DeviceMm right = pressed + DeviceMm{15, 0, 0};
  sample = go(pressed, right, 1000);
  EXPECT_NEAR(sample.force.x, detentForce(options_.detent, right).x, 0.02);
  EXPECT_NEAR(sample.force.z, 0, 0.02);
  go(right, pressed, 1000);
  options_.detent.on = false;
  EXPECT_GT(go(pressed, pressed, 1500).force.z, 1);
  EXPECT_EQ(core_.audit().step_violations, 0U);
  EXPECT_EQ(core_.audit().limit_violations, 0U);
}

}  // namespace
}  // namespace relievo
