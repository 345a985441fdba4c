// SPDX-License-Identifier: BSD-3-Clause
// When pads rumble, how hard and how long: on a clock of the test's own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "haptics/device/pad/rumbler.h"

namespace relievo::pad {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::int64_t kMs = 1'000'000;

struct Shown {
  std::int64_t time_ns = 0;
  RumbleLevel level;
  int ms = 0;  // 0: stopped.
};

/// What the motors of one pad were told.
struct Told {
  std::vector<Shown> all;
  std::int64_t now_ns = 0;
  bool gone = false, destroyed = false;
};

class FakeMotor : public RumbleMotor {
 public:
  explicit FakeMotor(Told& told) : told_(told) {}
  ~FakeMotor() override { told_.destroyed = true; }
  bool show(RumbleLevel level, int ms) noexcept override {
    told_.all.push_back({told_.now_ns, level, ms});
    return !told_.gone;
  }
  bool stop() noexcept override {
    told_.all.push_back({told_.now_ns, {}, 0});
    return !told_.gone;
  }

 private:
  Told& told_;
};

class Rumble : public testing::Test {
 protected:
  Rumble() {
    rumbler.add(std::make_unique<FakeMotor>(told));
    rumbler.setOn(true);
  }
  /// The loop goes on for that long, as `moment` has it, and the drain looks every 10 ms.
  void go(int ms, TouchMoment moment) {
    for (int i = 0; i < ms / 10; ++i) {
      std::vector<TouchMoment> batch;
      for (int k = 0; k < 10; ++k) {
        now_ns += kMs;
        moment.time_ns = now_ns;
        batch.push_back(moment);
      }
      take(batch);
    }
  }
  /// The loop stands still for that long.
  void stall(int ms) {
    for (int i = 0; i < ms / 10; ++i) {
      now_ns += 10 * kMs;
      take({});
    }
  }
  void take(const std::vector<TouchMoment>& batch) {
    told.now_ns = now_ns;
    rumbler.take(batch, now_ns);
  }
  /// Whether its motors turn now.
  bool turns() const {
    return !told.all.empty() && told.all.back().level.any() &&
           now_ns < told.all.back().time_ns + told.all.back().ms * kMs;
  }

  std::int64_t now_ns = 1'000'000 * kMs;
  Told told, other;
  Rumbler rumbler;  // Goes first.
  static constexpr TouchMoment kAir{.counts = true};
  static constexpr TouchMoment kLight{.counts = true, .contact = true, .force_n = 0.2};
  static constexpr TouchMoment kHard{.counts = true, .contact = true, .force_n = 2};
  static constexpr TouchMoment kEdge{.counts = true, .contact = true, .at_edge = true};
};

TEST_F(Rumble, AContactIsOneKnockAtOnceThatEnds) {
  go(100, kAir);
  EXPECT_THAT(told.all, IsEmpty());
  go(10, kHard);
  ASSERT_EQ(told.all.size(), 1U) << "at the first look after it";
  EXPECT_EQ(told.all[0].level, (RumbleLevel{1, 0}));
  EXPECT_LE(told.all[0].ms, 200);
  go(500, kHard);
  ASSERT_EQ(told.all.size(), 2U) << "it goes on touching, and nothing new happens";
  EXPECT_EQ(told.all[1].ms, 0) << "stopped";
  EXPECT_LE(told.all[1].time_ns - told.all[0].time_ns, RumbleCue::kKnockNs + 10 * kMs);
}

TEST_F(Rumble, AHarderContactKnocksHarder) {
  go(20, kAir);
  go(20, kLight);
  const double light = told.all.back().level.strong;
  go(200, kAir);
  go(20, kHard);
  EXPECT_GT(told.all.back().level.strong, light);
  EXPECT_GE(light, RumbleCue::kLeast) << "and each is felt";
}

TEST_F(Rumble, TheEdgeIsRenewedAsLongAsTheHandIsThere) {
  go(20, kAir);
  go(1000, kEdge);
  EXPECT_TRUE(turns());
  int renewed = 0;
  for (const Shown& shown : told.all) {
    EXPECT_LE(shown.ms, 200);
    renewed += shown.level.weak > 0 ? 1 : 0;
  }
  EXPECT_GE(renewed, 8) << "before each ends";
  go(10, kLight);
  EXPECT_FALSE(turns());
}

TEST_F(Rumble, WhenTheLoopStallsItEnds) {
  go(20, kAir);
  go(100, kEdge);
  ASSERT_TRUE(turns());
  stall(60);
  EXPECT_FALSE(turns());
  const std::size_t told_before = told.all.size();
  stall(500);
  EXPECT_EQ(told.all.size(), told_before) << "the last is not shown again and again";
}

TEST_F(Rumble, WhenTheProgramHangsItEndsByItself) {
  go(20, kAir);
  go(100, kEdge);
  ASSERT_TRUE(turns());
  now_ns += 200 * kMs;  // Nobody looks.
  EXPECT_FALSE(turns());
}

TEST_F(Rumble, WithoutForcesNothingRumbles) {
  TouchMoment off = kEdge;
  off.counts = false;
  go(200, off);
  EXPECT_THAT(told.all, IsEmpty());
  go(100, kEdge);
  ASSERT_TRUE(turns());
  go(10, off);
  EXPECT_FALSE(turns()) << "what ends the forces ends it";
}

TEST_F(Rumble, IsOffUntilItIsSwitchedOnAndStopsWhenItIsSwitchedOff) {
  rumbler.setOn(false);
  go(200, kEdge);
  EXPECT_THAT(told.all, IsEmpty());
  rumbler.setOn(true);
  go(20, kEdge);
  ASSERT_TRUE(turns());
  rumbler.setOn(false);
  go(10, kEdge);
  EXPECT_FALSE(turns());
}

TEST_F(Rumble, APadThatIsGoneIsForgottenAndTheOthersGoOn) {
  rumbler.add(std::make_unique<FakeMotor>(other));
  go(20, kAir);
  told.gone = true;
  go(20, kEdge);
  EXPECT_TRUE(told.destroyed);
  EXPECT_EQ(told.all.size(), 1U);
  other.now_ns = now_ns;
  go(200, kEdge);
  EXPECT_GE(other.all.size(), 2U);
  EXPECT_FALSE(other.destroyed);
}

TEST(RumblerEnd, StopsAndLetsGoOfAllPads) {
  Told taken, waiting;
  {
    Rumbler rumbler;
    rumbler.add(std::make_unique<FakeMotor>(taken));
    rumbler.take({}, 0);
    rumbler.add(std::make_unique<FakeMotor>(waiting));
  }
  EXPECT_TRUE(taken.destroyed);
  EXPECT_TRUE(waiting.destroyed);
  ASSERT_EQ(taken.all.size(), 1U);
  EXPECT_EQ(taken.all[0].ms, 0);
}

}  // namespace
}  // namespace relievo::pad
