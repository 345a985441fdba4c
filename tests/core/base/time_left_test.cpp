// SPDX-License-Identifier: BSD-3-Clause
// How long a step still takes, by how fast it went.
#include "core/base/time_left.h"

#include <gtest/gtest.h>

namespace relievo {
namespace {

TEST(TimeLeft, IsWhatWasNeededForAsMuch) {
  EXPECT_DOUBLE_EQ(secondsLeft(30, 0, 0.25).value_or(0), 90);
  EXPECT_DOUBLE_EQ(secondsLeft(30, 0.5, 0.75).value_or(0), 30) << "a step that went on";
  EXPECT_DOUBLE_EQ(secondsLeft(3600, 0, 0.02).value_or(0), 176'400);
}

TEST(TimeLeft, IsNotSaidWhileThereIsNothingToJudgeBy) {
  EXPECT_FALSE(secondsLeft(2.9, 0, 0.5)) << "too soon";
  EXPECT_FALSE(secondsLeft(60, 0.3, 0.305)) << "too little was done";
  EXPECT_FALSE(secondsLeft(60, 0.3, 0.2)) << "it began anew";
  EXPECT_FALSE(secondsLeft(60, 0, 1)) << "it is done";
}

}  // namespace
}  // namespace relievo
