// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/prepare_state.h"

#include <gtest/gtest.h>

namespace relievo {
namespace {

PrepareInput input(const char* file) {
  return {.file = file};
}

PrepareState stateOf(std::initializer_list<const char*> files) {
  PrepareChoices first;
  for (const char* file : files) first.inputs.push_back(input(file));
  return PrepareState(std::move(first));
}

std::vector<std::string> kinds(const Recipe& recipe) {
  std::vector<std::string> words;
  for (const Step& step : recipe.steps) words.emplace_back(kindOf(step));
  return words;
}

Align& alignOf(PrepareChoices& choices, const PrepareState& state) {
  return std::get<Align>(choices.steps.at(state.alignStep().value()).step);
}

/// On the second scan of three and on the third, at x = 1 and 2.
void pickOnePairEach(PrepareState& state) {
  PrepareChoices next = state.now();
  Align& align = alignOf(next, state);
  align.method = AlignMethod::points;
  align.pairs = {{.scan = 1, .point = {1, 0, 0}, .reference = {}},
                 {.scan = 2, .point = {2, 0, 0}, .reference = {}}};
  state.change(next);
}

/// An answer in which every scan was moved along x by its number.
AlignAnswer answerFor(std::size_t scans) {
  AlignAnswer answer;
  for (std::size_t i = 0; i < scans; ++i) {
    AlignVerdict& verdict = answer.scans.emplace_back();
    verdict.pose.m[3] = static_cast<double>(i);
  }
  return answer;
}

TEST(PrepareState, BeginsWithOneScanAndNoStepAndNothingToUndo) {
  const PrepareState state = stateOf({"a.ply"});
  EXPECT_EQ(state.recipe().scans.size(), 1U);
  EXPECT_TRUE(state.recipe().steps.empty());
  EXPECT_FALSE(state.canUndo());
  EXPECT_FALSE(state.alignStep());
}

TEST(PrepareState, UndoAndRedoBringBackEveryChoice) {
  PrepareState state = stateOf({"a.ply"});
  state.addStep(Outliers{});
  const PrepareChoices one = state.now();
  state.addStep(Thin{.spacing_mm = 2});
  const PrepareChoices two = state.now();
  EXPECT_TRUE(state.undo());
  EXPECT_EQ(state.now(), one);
  EXPECT_TRUE(state.redo());
  EXPECT_EQ(state.now(), two);
  EXPECT_TRUE(state.undo());
  EXPECT_TRUE(state.undo());
  EXPECT_FALSE(state.undo());
  EXPECT_TRUE(state.now().steps.empty());
  state.addStep(Normals{});
  EXPECT_FALSE(state.redo()) << "another way was taken";
}

TEST(PrepareState, ChangesOfOneFieldAreOneStepOfTheHistory) {
  PrepareState state = stateOf({"a.ply"});
  state.addStep(Outliers{});
  for (const int neighbours : {9, 10, 11}) {
    PrepareChoices next = state.now();
    next.steps[0].step = Outliers{.neighbours = neighbours};
    state.change(next, 1);
  }
  EXPECT_TRUE(state.undo());
  EXPECT_EQ(std::get<Outliers>(state.now().steps[0].step).neighbours, 8);
}

TEST(PrepareState, SecondScanBringsAlignBetweenWhatSeesEachScanAndWhatSeesAll) {
  PrepareState state = stateOf({"a.ply"});
  state.addStep(Outliers{});
  state.addStep(Thin{.spacing_mm = 1});
  state.addInputs({input("b.ply")});
  EXPECT_EQ(kinds(state.recipe()), (std::vector<std::string>{"outliers", "align", "thin"}));
  state.addStep(Lonely{});
  state.addStep(Normals{});
  EXPECT_EQ(kinds(state.recipe()),
            (std::vector<std::string>{"outliers", "lonely", "align", "thin", "normals"}));
}

TEST(PrepareState, AScanThatIsNotUsedIsInNoRecipeAndOthersAreNumberedWithoutIt) {
  PrepareState state = stateOf({"a.ply", "b.ply", "c.ply"});
  PrepareChoices next = state.now();
  next.inputs[1].used = false;
  Align& align = alignOf(next, state);
  align.method = AlignMethod::points;
  align.reference = 2;
  align.pairs = {{.scan = 0, .point = {1, 2, 3}, .reference = {4, 5, 6}},
                 {.scan = 1, .point = {7, 8, 9}, .reference = {7, 8, 9}}};
  state.change(next);
  const Recipe recipe = state.recipe();
  ASSERT_EQ(recipe.scans.size(), 2U);
  EXPECT_EQ(recipe.scans[1].file, "c.ply");
  const Align& step = std::get<Align>(recipe.steps.at(0));
  EXPECT_EQ(step.reference, 1U);
  ASSERT_EQ(step.pairs.size(), 1U);
  EXPECT_EQ(step.pairs[0].scan, 0U);
  EXPECT_EQ(step.pairs[0].point, (FilePoint{1, 2, 3}));
}

TEST(PrepareState, OneUsedScanIsNotAligned) {
  PrepareState state = stateOf({"a.ply", "b.ply"});
  PrepareChoices next = state.now();
  next.inputs[0].used = false;
  state.change(next);
  EXPECT_TRUE(state.recipe().steps.empty());
  EXPECT_EQ(state.reference(), 1U);
}

TEST(PrepareState, ARemovedScanTakesItsPairsAlong) {
  PrepareState state = stateOf({"a.ply", "b.ply", "c.ply"});
  pickOnePairEach(state);
  state.removeInput(1);
  const Align& left = std::get<Align>(state.now().steps.at(0).step);
  ASSERT_EQ(left.pairs.size(), 1U);
  EXPECT_EQ(left.pairs[0].scan, 1U);
  EXPECT_EQ(left.pairs[0].point, (FilePoint{2, 0, 0}));
  state.removeInput(1);
  EXPECT_FALSE(state.alignStep()) << "one scan has nothing to be laid on";
}

TEST(PrepareState, ASplitFileIsItsScansAndOthersKeepTheirPairs) {
  PrepareState state = stateOf({"a.ply", "arch.e57", "c.ply"});
  pickOnePairEach(state);
  state.splitInput(1, 3);
  ASSERT_EQ(state.now().inputs.size(), 5U);
  for (int part = 1; part <= 3; ++part) {
    const PrepareInput& scan = state.now().inputs[static_cast<std::size_t>(part)];
    EXPECT_EQ(scan.file, "arch.e57");
    EXPECT_EQ(scan.read.parts, std::vector<int>{part});
  }
  const Align& after = std::get<Align>(state.now().steps.at(0).step);
  ASSERT_EQ(after.pairs.size(), 1U) << "nobody said which of the scans a pair was picked on";
  EXPECT_EQ(after.pairs[0].scan, 4U);
  EXPECT_EQ(after.pairs[0].point, (FilePoint{2, 0, 0}));
}

TEST(PrepareState, StepsThatAreOffAndOutlinesNotYetDrawnAreNoSteps) {
  PrepareState state = stateOf({"a.ply"});
  state.addStep(CropOutline{});
  state.addStep(Outliers{});
  state.addStep(Duplicates{});
  PrepareChoices next = state.now();
  next.steps[1].on = false;
  state.change(next);
  EXPECT_EQ(kinds(state.recipe()), std::vector<std::string>{"duplicates"});
  EXPECT_EQ(state.stepsInRecipe(), std::vector<std::size_t>{2});
}

TEST(PrepareState, FoundPosesAreUsedAgainUntilSomethingBeforeThemChanges) {
  PrepareState state = stateOf({"a.ply", "b.ply"});
  PrepareChoices next = state.now();
  alignOf(next, state).method = AlignMethod::automatic;
  state.change(next);
  ASSERT_TRUE(std::get<Align>(state.recipe().steps.at(0)).poses.empty());
  state.keepPoses(state.now(), state.recipe(), answerFor(2));
  ASSERT_EQ(std::get<Align>(state.recipe().steps.at(0)).poses.size(), 2U);
  state.addStep(Thin{.spacing_mm = 1});
  EXPECT_EQ(std::get<Align>(state.recipe().steps.at(0)).poses.size(), 2U) << "a later step";
  EXPECT_NE(state.foundAlign(), nullptr);
  state.addStep(Outliers{});
  EXPECT_TRUE(std::get<Align>(state.recipe().steps.at(1)).poses.empty()) << "an earlier step";
  EXPECT_TRUE(state.undo());
  EXPECT_NE(state.foundAlign(), nullptr);
  next = state.now();
  next.inputs[1].read.parts = {2};
  state.change(next);
  EXPECT_EQ(state.foundAlign(), nullptr) << "other points of the same file";
}

TEST(PrepareState, PosesOfScansThatDoNotHoldAreSearchedAgain) {
  PrepareState state = stateOf({"a.ply", "b.ply"});
  PrepareChoices next = state.now();
  alignOf(next, state).method = AlignMethod::automatic;
  state.change(next);
  AlignAnswer refused = answerFor(2);
  refused.scans[1].holds = false;
  state.keepPoses(state.now(), state.recipe(), refused);
  EXPECT_EQ(state.foundAlign(), nullptr);
}

}  // namespace
}  // namespace relievo
