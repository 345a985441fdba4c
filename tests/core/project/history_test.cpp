// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/history.h"

#include <gtest/gtest.h>

namespace relievo {
namespace {

TEST(History, GoesBackAndForthThroughNamedSteps) {
  History<int> history(0);
  EXPECT_FALSE(history.canUndo());
  EXPECT_FALSE(history.undo());
  for (int i = 1; i <= 150; ++i) history.push("step " + std::to_string(i), i);
  EXPECT_EQ(history.now(), 150);
  EXPECT_EQ(history.undoName(), "step 150");
  for (int i = 149; i >= 0; --i) {
    ASSERT_TRUE(history.undo());
    ASSERT_EQ(history.now(), i);
  }
  EXPECT_FALSE(history.undo());
  EXPECT_EQ(history.undoName(), "");
  for (int i = 1; i <= 150; ++i) {
    ASSERT_EQ(history.redoName(), "step " + std::to_string(i));
    ASSERT_TRUE(history.redo());
    ASSERT_EQ(history.now(), i);
  }
  EXPECT_FALSE(history.redo());
  EXPECT_EQ(history.names().size(), 150U);
  EXPECT_EQ(history.names().front(), "step 1");
}

TEST(History, ANewStepForgetsWhatWasUndone) {
  History<int> history(0);
  history.push("a", 1);
  history.push("b", 2);
  history.undo();
  history.push("c", 3);
  EXPECT_FALSE(history.canRedo());
  EXPECT_EQ(history.names(), (std::vector<std::string>{"a", "c"}));
  history.undo();
  EXPECT_EQ(history.now(), 1);
}

TEST(History, StepsOfOneGestureBecomeOneButNotAcrossAnUndo) {
  History<int> history(0);
  history.push("gain", 1, 7);
  history.push("gain", 2, 7);
  history.push("gain", 3, 7);
  EXPECT_EQ(history.names().size(), 1U);
  history.push("gain", 4, 8);
  EXPECT_EQ(history.names().size(), 2U);
  history.undo();
  EXPECT_EQ(history.now(), 3);
  history.push("gain", 5, 7);
  EXPECT_EQ(history.names().size(), 2U);
  history.undo();
  EXPECT_EQ(history.now(), 3);
  history.undo();
  EXPECT_EQ(history.now(), 0);
}

TEST(History, ForgetsTheOldestBeyondItsSteps) {
  History<int> history(0, 100);
  for (int i = 1; i <= 1000; ++i) history.push("s", i);
  int steps = 0;
  while (history.undo()) ++steps;
  EXPECT_EQ(steps, 100);
  EXPECT_EQ(history.now(), 900);
  History<int> copy = history;  // A value: a copy goes its own way.
  copy.redo();
  EXPECT_EQ(history.now(), 900);
  EXPECT_EQ(copy.now(), 901);
}

}  // namespace
}  // namespace relievo
