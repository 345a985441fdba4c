// SPDX-License-Identifier: BSD-3-Clause
// An object turns under the hand: reliefs of a scan from one side after the other, each with the
// window about the touched place, go over into each other without a jump of the force.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "core/depth/rules/rasterize.h"
#include "core/region/hand.h"
#include "core/session/large/tiled_surface.h"
#include "core/session/surface.h"
#include "core/session/turned_region.h"
#include "haptics/device/virtual_hand.h"
#include "haptics/loop/device_limits.h"
#include "haptics/loop/haptic_core.h"
#include "tests/core/scan_fixtures.h"

namespace relievo {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kMostStepN = 0.005;  // As scene_change_test.
constexpr double kStiffness = 0.5;

/// A hill of 12 mm with waves on it, 80 mm across.
Scan hill() {
  Scan scan;
  constexpr int kAcross = 320;
  for (int row = 0; row < kAcross; ++row) {
    for (int col = 0; col < kAcross; ++col) {
      const double x = 0.25 * col - 40, y = 0.25 * row - 40;
      const double z =
          12 * std::exp(-(x * x + y * y) / 500) + 0.8 * std::sin(0.6 * x) * std::cos(0.5 * y);
      scan.points.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
    }
  }
  test::finishScan(scan);
  return scan;
}

/// From the top, turned to the right by an angle.
Surface seenFrom(const Scan& scan, double angle_deg) {
  const double a = angle_deg * kPi / 180;
  SurfaceOptions options;
  options.spacing_mm = 0.3;
  options.view = ViewChoice{
      "free", Rotation{std::cos(a), 0, -std::sin(a), 0, 1, 0, std::sin(a), 0, std::cos(a)}};
  return makeSurface(scan, options, rasterize);
}

/// The turning window: one space for each side.
std::vector<std::unique_ptr<HapticSpace>> turningObject() {
  const Scan scan = hill();
  std::vector<std::unique_ptr<HapticSpace>> spaces;
  Surface surface = seenFrom(scan, 0);
  Region region = regionFromRect(
      surface.ladder, {surface.ladder.left_mm + 20, surface.ladder.bottom_mm + 20, 40, 40});
  for (int i = 0; i <= 6; ++i) {
    if (i > 0) {
      const RegionWindow window = windowOf(surface, region);
      const double x = region.centreX(), y = region.centreY();
      Surface next = seenFrom(scan, 5.0 * i);
      region = turnedRegion(surface, region, {x, y, windowHeightMm(window, x, y)}, next);
      surface = std::move(next);
    }
    auto space = std::make_unique<HapticSpace>();
    fill(*space, windowOf(surface, region),
         {surface.ladder.detailOf(region.level), surface.ladder.levels()},
         SurfaceKind::crease_aware);
    space->scene_id = static_cast<std::uint64_t>(i) + 1;
    spaces.push_back(std::move(space));
  }
  return spaces;
}

struct Felt {
  double largest_step_n = 0;   ///< Of the force in a tick.
  double least_margin_mj = 0;  ///< What the surface is said to owe.
  bool softened = false;
  double least_n = 1e9, most_n = 0;
  double most_mm_per_s = 0;  ///< Of the hand.
  int ticks = 0;
  bool ended = true;  ///< Every change did.
};

/// Goes through all sides, the next one as soon as the one before is there, as in the loop.
Felt turnUnder(const std::vector<std::unique_ptr<HapticSpace>>& sides,
               const std::function<HapticSample(const HapticSpace&, const HapticSpace&)>& tick,
               const HapticCore& core) {
  Felt felt;
  HapticSample last = tick(*sides[0], *sides[0]);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    int n = 0;
    do {
      const HapticSample now = tick(*sides[i], *sides[i - 1]);
      const double step = norm(now.force - last.force);
      const double way = norm(now.hip - last.hip);
      felt.largest_step_n = std::max(felt.largest_step_n, step);
      felt.least_margin_mj = std::min(felt.least_margin_mj, now.margin_mj);
      felt.softened = felt.softened || now.softened > 0;
      felt.most_mm_per_s = std::max(felt.most_mm_per_s, 1000 * way);
      felt.least_n = std::min(felt.least_n, norm(now.force));
      felt.most_n = std::max(felt.most_n, norm(now.force));
      last = now;
      ++felt.ticks;
    } while (core.changing() && ++n < 10'000);
    felt.ended = felt.ended && !core.changing();
  }
  return felt;
}

TEST(TurnedObject, MovesTheForceOfAStillHandByLessThanItFeels) {
  const auto sides = turningObject();
  for (const DeviceMm hip : {DeviceMm{0, 0, -3}, DeviceMm{14, -9, -6}, DeviceMm{-22, 11, -8}}) {
    HapticCore core(ForceChain::bare);
    HapticOptions options;
    options.stiffness_by_detail = false;
    options.force.stiffness_n_per_mm = kStiffness;
    std::int64_t now_ns = 0;
    double z = 40;
    const auto tick = [&](const HapticSpace& now, const HapticSpace& was) {
      DeviceReading reading;
      reading.position = {hip.x, hip.y, z};
      reading.time_ns = now_ns += 1'000'000;
      return core.tick(now, was, options, reading, now_ns);
    };
    for (; z > hip.z; z -= 0.1) tick(*sides[0], *sides[0]);
    z = hip.z;
    const Felt felt = turnUnder(sides, tick, core);
    EXPECT_LE(felt.largest_step_n, kMostStepN);
    EXPECT_TRUE(felt.ended);
    EXPECT_GT(felt.most_n, felt.least_n + 0.3) << "the object turned, and was felt to";
  }
}

TEST(TurnedObject, LeadsHandsGentlyAndOwesThemNothing) {
  const auto sides = turningObject();
  for (const HandImpedance& grip : kHandPresets) {
    VirtualHandOptions of_hand;
    of_hand.hand = grip;
    of_hand.position_step_mm = 0;  // A count of an encoder is a step of the force of its own.
    VirtualHand hand(of_hand);
    HapticCore core(ForceChain::whole);
    HapticOptions options;
    options.stiffness_by_detail = false;
    options.force.stiffness_n_per_mm = kStiffness;
    options.force.forces_on = true;
    options = withinDevice(options, hand.info());
    hand.open();
    hand.placeAt({5, -4, 40});
    std::int64_t now_ns = 0;
    const auto tick = [&](const HapticSpace& now, const HapticSpace& was) {
      now_ns += 1'000'000;
      const HapticSample sample = core.tick(now, was, options, hand.read(now_ns), now_ns);
      hand.send(sample.force, now_ns);
      return sample;
    };
    for (int i = 0; i < 4000; ++i) {  // Down on the hill, and at rest there.
      hand.moveTo({5, -4, std::max(-10.0, 40 - 0.02 * i)});
      tick(*sides[0], *sides[0]);
    }
    const Felt felt = turnUnder(sides, tick, core);
    EXPECT_TRUE(felt.ended);
    EXPECT_LE(felt.largest_step_n, kMostStepN);
    EXPECT_GT(felt.most_n, felt.least_n + 0.3) << "the object turned, and was felt to";
    EXPECT_LT(felt.most_mm_per_s, 20) << "the hand is led, not thrown";
    // The surface gives by its turning what it gave a hand that it lifts: that is no debt.
    EXPECT_GT(felt.least_margin_mj, -0.02);
    EXPECT_FALSE(felt.softened);
  }
}

}  // namespace
}  // namespace relievo
