// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/frame_pace.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <vector>

namespace relievo {
namespace {

constexpr int kRestMs = FramePace::kFrameMs * FramePace::kFramesAtRest;

TEST(FramePace, LooksLessOftenOnceNothingHasChangedForASecond) {
  FramePace pace;
  pace.start();
  EXPECT_EQ(pace.timer().interval(), FramePace::kFrameMs);
  for (int look = 1; look < FramePace::kFramesUntilRest; ++look) pace.follow(false);
  EXPECT_FALSE(pace.isAtRest());
  EXPECT_EQ(pace.framesOfLook(), 1);
  pace.follow(false);
  EXPECT_TRUE(pace.isAtRest());
  EXPECT_EQ(pace.timer().interval(), kRestMs);
  EXPECT_EQ(pace.framesOfLook(), FramePace::kFramesAtRest);
}

TEST(FramePace, AChangeBeginsTheSecondAnew) {
  FramePace pace;
  pace.start();
  for (int look = 1; look < FramePace::kFramesUntilRest; ++look) pace.follow(false);
  pace.follow(true);
  for (int look = 1; look < FramePace::kFramesUntilRest; ++look) pace.follow(false);
  EXPECT_FALSE(pace.isAtRest());
}

TEST(FramePace, WhoeverDoesSomethingIsFollowedAtOnce) {
  FramePace pace;
  std::vector<bool> told;
  pace.onRest([&](bool at_rest) { told.push_back(at_rest); });
  pace.start();
  for (int look = 0; look < 2 * FramePace::kFramesUntilRest; ++look) pace.follow(false);
  pace.wake();
  EXPECT_FALSE(pace.isAtRest());
  EXPECT_EQ(pace.timer().interval(), FramePace::kFrameMs);
  EXPECT_TRUE(pace.timer().isActive());
  pace.wake();
  EXPECT_EQ(told, (std::vector{true, false})) << "once each";
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  const QCoreApplication app(argc, argv);
  return RUN_ALL_TESTS();
}
