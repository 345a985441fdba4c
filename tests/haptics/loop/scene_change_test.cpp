// SPDX-License-Identifier: BSD-3-Clause
// One surface turns into another under the hand: gently, never through the proxy, and ends exactly.
#include "haptics/loop/scene_change.h"

#include <gtest/gtest.h>

#include <random>

#include "haptics/loop/haptic_core.h"
#include "haptics/proxy/blend.h"
#include "tests/haptics/proxy/measure.h"

namespace relievo {
namespace {

constexpr double kStiffness = 0.5;
constexpr double kMostStepN = 0.005;

HapticOptions bare() {
  HapticOptions options;
  options.stiffness_by_detail = false;
  options.force.stiffness_n_per_mm = kStiffness;
  return options;
}

/// Drives the core with the surface of now and the one before.
class Hand {
 public:
  explicit Hand(HapticOptions options = bare()) : options_(options) {}
  HapticSample to(const HapticSpace& now, const HapticSpace& was, DeviceMm hip) {
    DeviceReading reading;
    reading.position = hip;
    reading.time_ns = now_ns_;
    const HapticSample sample = core_.tick(now, was, options_, reading, now_ns_);
    now_ns_ += 1'000'000;
    return sample;
  }
  bool changing() const { return core_.changing(); }

 private:
  HapticOptions options_;
  HapticCore core_{ForceChain::bare};
  std::int64_t now_ns_ = 0;
};

double hills(double x, double y) {
  return 1.5 * std::sin(0.35 * x) * std::cos(0.3 * y);
}
double otherHills(double x, double y) {
  return 3 + 1.2 * std::sin(0.5 * x + 1) * std::cos(0.45 * y) + 0.2 * std::sin(1.7 * x);
}

struct Change {
  double largest_step_n = 0;
  int ticks = 0;
  double last_n = 0;
};

/// Rests on `was`, changes to `now` under a still hand.
Change changeUnderAStillHand(const HapticSpace& was, const HapticSpace& now, DeviceMm hip,
                             HapticOptions options = bare()) {
  Hand hand(options);
  hand.to(was, was, {hip.x, hip.y, 35});
  HapticSample sample;
  for (int i = 0; i < 40; ++i) {
    const double part = std::min(1.0, i / 30.0);
    sample = hand.to(was, was, {hip.x, hip.y, 35 + part * (hip.z - 35)});
  }
  Change change;
  DeviceN last = sample.force;
  for (int i = 0; i < 20000; ++i) {
    sample = hand.to(now, was, hip);
    change.largest_step_n = std::max(change.largest_step_n, norm(sample.force - last));
    last = sample.force;
    ++change.ticks;
    if (i > 0 && !hand.changing()) break;
  }
  change.last_n = norm(last);
  return change;
}

TEST(SceneChange, MovesTheForceByLessThanAHandFeelsInATick) {
  for (const SurfaceKind kind :
       {SurfaceKind::crease_aware, SurfaceKind::spline, SurfaceKind::bilinear}) {
    const auto was = test::spaceOf(80, hills, 1, {}, kind);
    const auto now = test::spaceOf(80, otherHills, 2, {}, kind);
    for (const DeviceMm hip : {DeviceMm{0, 0, -4}, DeviceMm{13, -7, -3}, DeviceMm{-21, 9, -5}}) {
      const Change change = changeUnderAStillHand(*was, *now, hip);
      EXPECT_LE(change.largest_step_n, kMostStepN);
      EXPECT_GE(change.ticks, SceneChange::kLeastTicks);
      EXPECT_LT(change.ticks, 5000);
      EXPECT_GT(change.last_n, 0.1);
    }
  }
}

TEST(SceneChange, ChangesTheForceByAtMostSixteenTenthsOfTheMeanStep) {
  const auto was = test::spaceOf(
      80, [](double, double) { return 0.0; }, 1);
  const auto now = test::spaceOf(
      80, [](double, double) { return 3.0; }, 2);
  // Both lie at mid height: the same place in the hand's space unless it is said otherwise.
  now->device_translation = was->device_translation;
  const Change change = changeUnderAStillHand(*was, *now, {0, 0, -2});
  EXPECT_LE(change.largest_step_n, kMostStepN);
  EXPECT_NEAR(change.last_n, kStiffness * 5, 1e-6);
  EXPECT_GT(kStiffness * 3, 100 * kMostStepN) << "in one tick without the change";
  // 1.6 k dz / ticks.
  EXPECT_LE(change.largest_step_n, 1.6 * kStiffness * 3 / change.ticks + 1e-9);
}

TEST(SceneChange, EndsExactlyOnTheNewSurface) {
  const auto was = test::spaceOf(80, hills, 1, {}, SurfaceKind::crease_aware);
  const auto now = test::spaceOf(40, otherHills, 2, {}, SurfaceKind::crease_aware);
  Hand hand;
  hand.to(*was, *was, {5, 5, 20});
  for (int i = 0; i < 20; ++i) hand.to(*was, *was, {5, 5, -4});
  HapticSample sample = hand.to(*now, *was, {5, 5, -4});
  while (hand.changing()) sample = hand.to(*now, *was, {5, 5, -4});
  sample = hand.to(*now, *now, {5, 5, -4});
  const GridPoint p = now->gridFromDevice(sample.proxy);
  EXPECT_NEAR(p.z, surfaceHeight(*now, p.x, p.y), 1e-9);
  const DeviceN along{sample.normal.x, sample.normal.y, sample.normal.z};
  EXPECT_LT(test::angleDegrees(sample.force, along), 1e-4);
}

TEST(SceneChange, PicksUpAHandThatTheNewSurfaceRisesOver) {
  const auto was = test::spaceOf(
      80, [](double, double) { return 0.0; }, 1);
  const auto now = test::spaceOf(
      80, [](double, double) { return 6.0; }, 2);
  now->device_translation = was->device_translation;
  Hand hand;
  DeviceN last;
  for (int i = 0; i < 5000; ++i) {
    const HapticSample sample = hand.to(i < 10 ? *was : *now, *was, {3, 4, 2});
    EXPECT_LE(norm(sample.force - last), kMostStepN) << i;
    last = sample.force;
    if (i > 20 && !hand.changing()) break;
  }
  EXPECT_NEAR(norm(last), kStiffness * 4, 1e-6) << "6 mm above a hand at 2 mm";
}

std::unique_ptr<HapticSpace> flat(double height_mm, std::uint64_t id, const HapticSpace* like) {
  auto space = test::spaceOf(
      80, [height_mm](double, double) { return height_mm; }, id);
  if (like != nullptr) space->device_translation = like->device_translation;
  return space;
}

TEST(SceneChange, AHandThatTouchesNeitherSurfaceGetsTheNewOneAtOnce) {
  const auto low = flat(0, 1, nullptr), high = flat(20, 2, low.get());
  for (const bool rises : {true, false}) {
    const HapticSpace& was = rises ? *low : *high;
    const HapticSpace& now = rises ? *high : *low;
    Hand hand;
    for (int i = 0; i < 10; ++i) hand.to(was, was, {3, 4, 25});
    const HapticSample sample = hand.to(now, was, {3, 4, 25});
    EXPECT_FALSE(hand.changing()) << "20 mm of height took 6 s";
    EXPECT_FALSE(sample.contact);
    EXPECT_EQ(hand.to(now, now, {3, 4, 19}).contact, rises);
  }
}

TEST(SceneChange, LastsAsLongAsTheForceThatIsFeltAndNotAsTheHeight) {
  const auto low = flat(0, 1, nullptr), high = flat(20, 2, low.get());
  const Change sinks = changeUnderAStillHand(*high, *low, {3, 4, 19});
  EXPECT_LE(sinks.largest_step_n, kMostStepN);
  EXPECT_EQ(sinks.last_n, 0);
  EXPECT_GT(sinks.ticks, kStiffness * 1 / kMostStepN);
  EXPECT_LT(sinks.ticks, kStiffness * 1 / 0.002 + 5) << "0.5 N, not 10 N";
  // Lifting off ends it.
  Hand hand;
  for (int i = 0; i < 10; ++i) hand.to(*high, *high, {3, 4, i < 5 ? 25.0 : 19.0});
  hand.to(*low, *high, {3, 4, 19});
  EXPECT_TRUE(hand.changing());
  hand.to(*low, *high, {3, 4, 22});
  hand.to(*low, *high, {3, 4, 22});
  EXPECT_FALSE(hand.changing());
}

/// With strength, rise and cap, as in the loop: beyond the cap no difference is felt.
TEST(SceneChange, UnderTheWholeChainItLastsAsLongAsTheCappedForce) {
  const auto low = flat(0, 1, nullptr), high = flat(40, 2, low.get());
  HapticOptions options;
  options.force.forces_on = true;
  options.force.limit_n = 3;
  options.force.passivity.on = options.force.oscillation.on = false;
  HapticCore core;
  std::int64_t now_ns = 0;
  const auto tick = [&](const HapticSpace& now, const HapticSpace& was, double z) {
    DeviceReading reading;
    reading.position = {3, 4, z};
    reading.time_ns = now_ns += 1'000'000;
    return core.tick(now, was, options, reading, now_ns);
  };
  for (int i = 0; i < 1500; ++i) tick(*low, *low, 5);
  DeviceN last;
  for (int i = 0; i < 500; ++i) last = tick(*low, *low, -0.5).force;
  int ticks = 0;
  do {
    const DeviceN now = tick(*high, *low, -0.5).force;
    ASSERT_LE(norm(now - last), kMostStepN) << ticks;
    last = now;
  } while (core.changing() && ++ticks < 10'000);
  EXPECT_NEAR(norm(last), 3, 0.01);
  EXPECT_GT(ticks, 500);
  EXPECT_LT(ticks, 3 / 0.002);
}

TEST(SceneChange, AnotherFirmnessOfTheSameWindowComesGradually) {
  const RegionWindow window = test::windowOf(80, hills, 1);
  const auto filled = [&window](float firm, std::uint64_t scene_id) {
    auto space = std::make_unique<HapticSpace>();
    const std::vector<float> firmness(kWindowCount, firm);
    fill(*space, window, {}, SurfaceKind::crease_aware, {}, firmness);
    space->scene_id = scene_id;
    return space;
  };
  const auto firm = filled(1, 5), soft = filled(0, 6);
  HapticOptions options = bare();
  options.fields.softest_part = 0.5;
  const double firm_n = changeUnderAStillHand(*firm, *firm, {0, 0, -4}, options).last_n;
  const Change softened = changeUnderAStillHand(*firm, *soft, {0, 0, -4}, options);
  EXPECT_GT(firm_n, 100 * kMostStepN);
  EXPECT_LE(softened.largest_step_n, kMostStepN);
  EXPECT_NEAR(softened.last_n, 0.5 * firm_n, 1e-6);
  EXPECT_LE(changeUnderAStillHand(*soft, *firm, {0, 0, -4}, options).largest_step_n, kMostStepN);
}

TEST(SceneChange, StiffnessOfAnotherDetailComesGradually) {
  const auto was = test::spaceOf(80, hills, 1, {1, 4}, SurfaceKind::crease_aware);
  const auto now = test::spaceOf(80, hills, 2, {4, 4}, SurfaceKind::crease_aware);
  HapticOptions options = bare();
  options.stiffness_by_detail = true;
  const Change change = changeUnderAStillHand(*was, *now, {2, 3, -3.5}, options);
  EXPECT_LE(change.largest_step_n, kMostStepN);
}

/// What the old surface was as firm as still counts while it goes: the ground turns from one slope
/// to another, and from a spring of 3 N/mm to one of 0.1 N/mm, and back.
TEST(SceneChange, FromFirmToSoftAndBackTheForceTurnsAsGently) {
  HapticOptions options = bare();
  options.stiffness_by_detail = true;
  options.detail_stiffness = {3, 1, 0.3, 0.1};
  const auto slope = [](double x) { return [x](double at, double) { return x * (at - 40); }; };
  for (const SurfaceKind kind : {SurfaceKind::crease_aware, SurfaceKind::bilinear}) {
    const auto firm = test::spaceOf(80, slope(0.8), 1, {1, 4}, kind);
    const auto soft = test::spaceOf(80, slope(-0.8), 2, {4, 4}, kind);
    for (const DeviceMm hip : {DeviceMm{0, 0, -1}, DeviceMm{0, 3, -2.5}, DeviceMm{1, 0, -1.5}}) {
      const Change softer = changeUnderAStillHand(*firm, *soft, hip, options);
      EXPECT_LE(softer.largest_step_n, kMostStepN);
      const Change firmer = changeUnderAStillHand(*soft, *firm, hip, options);
      EXPECT_LE(firmer.largest_step_n, kMostStepN);
    }
  }
}

TEST(SceneChange, RandomWalksWithSwitchesStayOutsideAndFinite) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<std::unique_ptr<HapticSpace>> spaces;
  for (int i = 0; i < 6; ++i) {
    const double phase = i, wall = i % 2 == 0 ? 4 : 0;
    spaces.push_back(test::spaceOf(
        40 + 13 * i,
        [&](double x, double y) {
          return std::sin(0.4 * x + phase) * std::cos(0.5 * y) + 0.1 * unit(random) +
                 (x > 25 ? wall : 0);
        },
        static_cast<std::uint64_t>(i) + 1, {},
        i == 3 ? SurfaceKind::bilinear : SurfaceKind::crease_aware));
  }
  Hand hand;
  std::size_t was = 0, now = 0;
  DeviceMm hip{0, 0, 30};
  int changes = 0, contacts = 0;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (int n = 0; n < 40000; ++n) {
    if (!hand.changing() && n % 400 == 0) {
      was = now;
      now = (now + 1 + static_cast<std::size_t>(2 * (1 + unit(random)))) % spaces.size();
      changes += now == was ? 0 : 1;
    }
    if (n % 97 == 0) hip = {45 * unit(random), 45 * unit(random), 12 * unit(random)};
    hip = hip + DeviceMm{0.2 * unit(random), 0.2 * unit(random), 0.2 * unit(random)};
    DeviceMm seen = hip;
    if (n % 331 == 0) seen.x = kNan;
    if (n % 337 == 0) seen.z = -kInfinite;
    const HapticSample sample = hand.to(*spaces[now], *spaces[was], seen);
    ASSERT_TRUE(isFinite(sample.force) && isFinite(sample.proxy) && isFinite(sample.normal)) << n;
    contacts += sample.contact ? 1 : 0;
    if (hand.changing()) continue;
    const GridPoint p = spaces[now]->gridFromDevice(sample.proxy);
    const double below = surfaceHeight(*spaces[now], p.x, p.y) - p.z;
    ASSERT_LE(below * spaces[now]->cell_mm, 1e-6) << n;
  }
  EXPECT_GT(changes, 20);
  EXPECT_GT(contacts, 10000);
}

TEST(BlendedSurface, IsLinearInItsWeightWithItsDerivatives) {
  const auto was = test::spaceOf(80, hills, 1, {}, SurfaceKind::crease_aware);
  const auto now = test::spaceOf(33, otherHills, 2, {}, SurfaceKind::crease_aware);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-30, 230);
  for (int i = 0; i < 3000; ++i) {
    const double x = place(random), y = place(random);
    const auto jetAt = [&](double weight) {
      return BlendedSurface(*was, *now, weight).patch(x, y, 1, 1).jet(x, y);
    };
    const Jet a = jetAt(0), b = jetAt(1), mid = jetAt(0.25);
    EXPECT_NEAR(b.f, surfaceHeight(*now, x, y), 1e-9);
    EXPECT_NEAR(mid.f, 0.75 * a.f + 0.25 * b.f, 1e-9);
    EXPECT_NEAR(mid.fxx, 0.75 * a.fxx + 0.25 * b.fxx, 1e-9);
    const GridPoint q = gridFromGrid(*was, *now)({x, y, a.f});
    EXPECT_NEAR(q.z, surfaceHeight(*was, q.x, q.y), 1e-9) << "the old surface in the new grid";
    const BlendedPatch patch = BlendedSurface(*was, *now, 0.25).patch(x, y, 1, 1);
    constexpr double kStep = 1e-4;
    EXPECT_NEAR(mid.fx, (patch.height(x + kStep, y) - patch.height(x - kStep, y)) / (2 * kStep),
                1e-5);
    EXPECT_NEAR(mid.fxy, (patch.jet(x, y + kStep).fx - patch.jet(x, y - kStep).fx) / (2 * kStep),
                1e-5);
  }
}

TEST(BlendedSurface, RaysMeetItFirstWhereSamplingSaysSo) {
  const auto was = test::spaceOf(80, hills, 1, {}, SurfaceKind::bilinear);
  const auto now = test::spaceOf(33, otherHills, 2, {}, SurfaceKind::crease_aware);
  const BlendedSurface surface(*was, *now, 0.6);
  const auto height = [&](GridPoint p) { return surface.patch(p.x, p.y, 1, 1).height(p.x, p.y); };
  std::mt19937 random(14);
  std::uniform_real_distribution<double> place(-20, 220), low(-30, 10), high(30, 60);
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    const GridPoint from{place(random), place(random), high(random)};
    const GridPoint to{place(random), place(random), low(random)};
    const Hit hit = firstHit(surface, from, to);
    const double reached = hit.found ? norm(hit.point - from) / norm(to - from) : 1;
    hits += hit.found ? 1 : 0;
    for (int k = 0; k < 1000; ++k) {
      const GridPoint p = from + (reached * k / 1000) * (to - from);
      ASSERT_GE(p.z - height(p), -1e-7) << i;
    }
    if (hit.found) {
      EXPECT_NEAR(hit.point.z, height(hit.point), 1e-7);
    }
  }
  EXPECT_GT(hits, 100);
}

}  // namespace
}  // namespace relievo
