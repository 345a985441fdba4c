// SPDX-License-Identifier: BSD-3-Clause
// A step as files keep it leads back to the state before, through JSON.
#include <random>

#include <gtest/gtest.h>

#include "core/project/project.h"

namespace relievo {
namespace {

Measurement measurement(int number) {
  return {.name = "m" + std::to_string(number),
          .kind = MeasureKind::depth,
          .places = {{.x = 1.0 * number, .y = 2}, {.x = 3, .y = 4}}};
}

NamedRegion place(int number) {
  NamedRegion place{.name = "p" + std::to_string(number), .region = {}};
  place.region.x_mm = number;
  place.region.side_mm = 5;
  return place;
}

/// The step, written and read again.
UndoStep stored(const UndoStep& step) {
  Project p;
  p.file = "scan.ply";
  p.region.side_mm = 10;
  p.undo = {step};
  return projectFromJson(projectJson(p), "test").undo.at(0);
}

class UndoStepTest : public ::testing::Test {
 protected:
  int any(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

  template <class T, class Make>
  void changeList(std::vector<T>& list, const Make& make) {
    const int what = any(4);
    const auto at = [&] { return list.begin() + any(static_cast<int>(list.size())); };
    if (what == 0 || list.empty()) {
      list.insert(list.begin() + any(static_cast<int>(list.size()) + 1), make(any(1000)));
    } else if (what == 1) {
      list.erase(at());
    } else if (what == 2) {
      *at() = make(any(3));  // Often one that is there already.
    } else {
      list.clear();
    }
  }

  Project changed(Project p) {
    if (any(2) == 0) p.region.x_mm += 1;
    if (any(2) == 0) p.gain *= 1.5;
    if (any(2) == 0) p.look.radius_mm += 1;
    if (any(2) == 0) p.azimuth_deg += 10;
    if (any(2) == 0) {
      p.stereo.automatic_depth = false;
      p.stereo.eye_angle_deg = 0.5 + any(5);
      p.chosen_eye_angle_deg.reset();
      if (any(2) == 0) p.chosen_eye_angle_deg = 7;
    }
    if (any(2) == 0) changeList(p.places, place);
    if (any(2) == 0) changeList(p.measurements, measurement);
    return p;
  }

  std::mt19937 random_{16};
};

TEST_F(UndoStepTest, LeadsBackThroughAnyChange) {
  Project before;
  before.region.side_mm = 10;
  for (int i = 0; i < 500; ++i) {
    const Project after = changed(before);
    Project back = after;
    ASSERT_TRUE(takeBack(stored(undoStep("step", before, after)), back));
    // What the limit of comfort lets through is no step: what was chosen is.
    ASSERT_EQ(chosenStereo(back), chosenStereo(before));
    back.stereo = before.stereo;
    back.chosen_eye_angle_deg = before.chosen_eye_angle_deg;
    ASSERT_TRUE(back == before) << i;
    before = after;
  }
}

TEST_F(UndoStepTest, KeepsOfALongListWhatChangedAlone) {
  Project before;
  for (int i = 0; i < 100; ++i) before.measurements.push_back(measurement(i));
  Project after = before;
  after.measurements.push_back(measurement(100));
  const UndoStep added = undoStep("Measurement", before, after);
  ASSERT_TRUE(added.measurements);
  EXPECT_EQ(added.measurements->at, 100U);
  EXPECT_EQ(added.measurements->gone, 1U);
  EXPECT_TRUE(added.measurements->back.empty());
  EXPECT_FALSE(added.places);
  EXPECT_FALSE(added.before.view) << "nothing was looked at otherwise";
}

TEST_F(UndoStepTest, OneThatDoesNotFitChangesNothing) {
  Project p;
  p.measurements = {measurement(1)};
  const Project as_it_was = p;
  UndoStep step = undoStep("step", p, p);
  step.before.gain = 2;
  step.measurements = ListChange<Measurement>{.at = 1, .gone = 1, .back = {}};
  EXPECT_FALSE(takeBack(step, p));
  step.measurements = ListChange<Measurement>{.at = 5, .gone = 0, .back = {measurement(2)}};
  EXPECT_FALSE(takeBack(step, p));
  step.measurements.reset();
  step.places = ListChange<NamedRegion>{.at = 0, .gone = std::size_t(-1), .back = {}};
  EXPECT_FALSE(takeBack(step, p));
  EXPECT_TRUE(p == as_it_was);
}

}  // namespace
}  // namespace relievo
