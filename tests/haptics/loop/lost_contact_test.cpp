// SPDX-License-Identifier: BSD-3-Clause
// A hand keeps still while the surface below it becomes another one, and loses its ground sideways:
// a flank, a thin wall or a hollow that is no longer there. The force goes as gently as it came.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "haptics/loop/haptic_core.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

/// What SceneChange aims at, and what relief may add that moves the proxy sideways.
constexpr double kMostStepN = 0.005;
constexpr double kStiffness = 0.5;

struct Felt {
  double first_n = 0, last_n = 0, largest_step_n = 0;
  bool had_contact = false, has_contact = false;
  int lost = 0, gained = 0;
  long ticks = 0;
};

class Hand {
 public:
  /// Touches down on `was` along a way, then keeps still while the surface becomes `now`.
  static Felt over(const HapticSpace& was, const HapticSpace& now, DeviceMm from, DeviceMm to) {
    Hand hand;
    for (int i = 0; i <= kDownTicks; ++i) {
      hand.tick(was, was, from + (static_cast<double>(i) / kDownTicks) * (to - from));
    }
    hand.felt_ = {};
    hand.felt_.first_n = norm(hand.last_.force);
    hand.felt_.had_contact = hand.last_.contact;
    do {
      hand.tick(now, was, to);
    } while (hand.core_.changing() && hand.felt_.ticks < kMostTicks);
    for (int i = 0; i < 20; ++i) hand.tick(now, now, to);
    hand.felt_.last_n = norm(hand.last_.force);
    hand.felt_.has_contact = hand.last_.contact;
    return hand.felt_;
  }

 private:
  static constexpr int kDownTicks = 300;
  static constexpr long kMostTicks = 20'000;

  void tick(const HapticSpace& now, const HapticSpace& was, DeviceMm hip) {
    HapticOptions options;
    options.stiffness_by_detail = false;
    options.force.stiffness_n_per_mm = kStiffness;
    DeviceReading reading;
    reading.position = hip;
    reading.time_ns = now_ns_ += 1'000'000;
    const HapticSample sample = core_.tick(now, was, options, reading, now_ns_);
    felt_.largest_step_n = std::max(felt_.largest_step_n, norm(sample.force - last_.force));
    felt_.lost += last_.contact && !sample.contact ? 1 : 0;
    felt_.gained += !last_.contact && sample.contact ? 1 : 0;
    ++felt_.ticks;
    // What holds the hand never draws it down.
    EXPECT_GE(sample.force.z, -1e-9);
    last_ = sample;
  }

  HapticCore core_{ForceChain::bare};
  std::int64_t now_ns_ = 0;
  HapticSample last_;
  Felt felt_;
};

/// Ground at 0 with a wall of this height along y in the middle of a window of 80 mm.
std::unique_ptr<HapticSpace> wall(double height_mm, std::uint64_t id, const HapticSpace* like) {
  auto space = test::spaceOf(
      80,
      [height_mm](double x, double) { return height_mm * std::exp(-0.5 * (x - 40) * (x - 40)); },
      id, {}, SurfaceKind::crease_aware);
  if (like != nullptr) space->device_translation = like->device_translation;
  return space;
}

/// The hand has pushed 3 mm beyond a thin wall, and is in the air there; the wall sinks.
TEST(LostContact, AWallThatSinksLetsAHandThroughGently) {
  const auto high = wall(8, 1, nullptr), low = wall(0.5, 2, high.get());
  const double ground = high->deviceFromView({0, 40, 0}).z;
  const DeviceMm left{-15, 0, ground + 3}, beyond{3, 0, ground + 3};
  const Felt felt = Hand::over(*high, *low, left, beyond);
  EXPECT_TRUE(felt.had_contact);
  EXPECT_GT(felt.first_n, 100 * kMostStepN) << "in one tick, if it were let go at once";
  EXPECT_FALSE(felt.has_contact);
  EXPECT_EQ(felt.last_n, 0);
  EXPECT_LE(felt.largest_step_n, kMostStepN);
  EXPECT_LT(felt.ticks, 3000) << "the next surface waits for this";
}

/// The same wall comes up around a hand in the air, and it may stand on either side of it.
TEST(LostContact, AWallThatRisesTakesAHandUpGently) {
  const auto high = wall(8, 2, nullptr), low = wall(0.5, 1, high.get());
  const double ground = high->deviceFromView({0, 40, 0}).z;
  for (const double x : {-0.5, 0.1, 0.7}) {
    const Felt felt = Hand::over(*low, *high, {x, 0, ground + 30}, {x, 0, ground + 3});
    EXPECT_FALSE(felt.had_contact);
    EXPECT_TRUE(felt.has_contact);
    EXPECT_GT(felt.last_n, 0.3);
    EXPECT_LE(felt.largest_step_n, kMostStepN);
  }
}

/// Windows of one relief, as a walk over a map gives them: other places, and levels on which its
/// grooves are weaker. Among them are hands that lose and hands that find the ground.
TEST(LostContact, NoChangeOfWindowsOnAGroovedMapMovesTheForceFaster) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto windowAt = [](std::uint64_t id, double x, double y, double fine) {
    return test::spaceOf(
        20,
        [=](double u, double v) {
          const double a = x + u, b = y + v;
          return 1.5 * std::sin(0.35 * a) * std::cos(0.3 * b) +
                 0.2 * fine * std::sin(7 * a) * std::sin(6 * b);
        },
        id, {}, SurfaceKind::crease_aware);
  };
  constexpr std::array kFine{1.0, 0.5, 0.0};
  int lost = 0, gained = 0;
  for (int i = 0; i < 120; ++i) {
    const double x = 250 * unit(random), y = 250 * unit(random);
    const auto was = windowAt(1, x, y, kFine[random() % 3]);
    const bool far = unit(random) < 0.4;
    const double x_next = far ? 250 * unit(random) : x + 2 * static_cast<double>(random() % 2);
    const double y_next = far ? 250 * unit(random) : y;
    const auto now = windowAt(2, x_next, y_next, kFine[random() % 3]);
    random.discard(6);
    const Felt felt = Hand::over(*was, *now, {0, 0, 35}, {0, 0, -3});
    EXPECT_LE(felt.largest_step_n, kMostStepN) << "walk " << i;
    lost += felt.had_contact && !felt.has_contact ? 1 : 0;
    gained += !felt.had_contact && felt.has_contact ? 1 : 0;
  }
  EXPECT_GT(lost, 3);
  EXPECT_GT(gained, 3);
}

}  // namespace
}  // namespace relievo
