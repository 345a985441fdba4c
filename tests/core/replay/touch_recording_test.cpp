// SPDX-License-Identifier: BSD-3-Clause
// What a replay shows at a time, and whether a recording belongs to a map.
#include "core/replay/touch_recording.h"

#include <gtest/gtest.h>

namespace relievo {
namespace {

TouchRecording tenMilliseconds() {
  TouchRecording recording;
  for (int i = 0; i < 10; ++i) {
    TouchRow row;
    row.t_s = 0.001 * i;
    row.proxy = {100.0 + i, 50, 3};
    row.window_id = i < 5 ? 7 : 8;
    row.detail = i < 5 ? 1 : 3;
    recording.rows.push_back(row);
  }
  recording.windows = {{7, {0, 0, 300, {3}}}};
  return recording;
}

/// Relief F's: 300 x 200 mm, four levels.
DetailLadder ladder() {
  return {0, 0, 300, 200, {0.25, 0.5, 1, 2}, 2};
}

TEST(TouchRecording, ShowsAtATimeTheLastRowThatIsNotLater) {
  const TouchRecording recording = tenMilliseconds();
  EXPECT_DOUBLE_EQ(rowAt(recording, -1).proxy.x, 100);
  EXPECT_DOUBLE_EQ(rowAt(recording, 0.0034).proxy.x, 103);
  EXPECT_DOUBLE_EQ(rowAt(recording, 9).proxy.x, 109);
  for (int i = 0; i < 10; ++i) {
    double sum = 0;  // Not exactly 0.001 i.
    for (int k = 0; k < i; ++k) sum += 0.001;
    EXPECT_DOUBLE_EQ(rowAt(recording, sum).proxy.x, 100.0 + i);
  }
}

TEST(TouchRecording, FindsTheEventsBesideATime) {
  TouchRecording recording = tenMilliseconds();
  EXPECT_EQ(eventAfter(recording, 0), nullptr);
  EXPECT_EQ(eventBefore(recording, 1), nullptr);
  recording.events = {{0.002, "a"}, {0.004, "b"}, {0.004, "c"}};
  EXPECT_EQ(eventAfter(recording, 0)->text, "a");
  EXPECT_EQ(eventAfter(recording, 0.001 + 0.001)->text, "b") << "not the one that is here";
  EXPECT_EQ(eventAfter(recording, 0.004), nullptr);
  EXPECT_EQ(eventBefore(recording, 0.002), nullptr);
  recording.events[2].t_s = 0.3;
  ASSERT_LT(0.7 - 0.4, 0.3);
  EXPECT_EQ(eventAfter(recording, 0.7 - 0.4), nullptr) << "it is here, but for a rounding";
  recording.events[2].t_s = 0.004;
  EXPECT_EQ(eventBefore(recording, 0.004)->text, "a");
  EXPECT_EQ(eventBefore(recording, 0.003)->text, "a");
  EXPECT_EQ(eventAt(recording, 0.001), nullptr);
  EXPECT_EQ(eventAt(recording, 0.002)->text, "a");
  EXPECT_EQ(eventAt(recording, 0.009)->text, "c");
}

TEST(TouchRecording, PlacesAnUnnamedWindowAroundWhatWasTouchedThere) {
  TouchRecording recording = tenMilliseconds();
  EXPECT_EQ(windowOf(recording, recording.rows[9]), nullptr);
  EXPECT_EQ(placeUnknownWindows(recording, ladder()), 1);
  const TouchedWindow* placed = windowOf(recording, recording.rows[9]);
  ASSERT_NE(placed, nullptr);
  EXPECT_FALSE(placed->known);
  EXPECT_DOUBLE_EQ(placed->region.side_mm, ladder().sideMm(3));
  EXPECT_EQ(placed->region.level.value, 1);
  EXPECT_DOUBLE_EQ(placed->region.centreX(), 107);
  EXPECT_TRUE(windowOf(recording, recording.rows[0])->known);
  EXPECT_EQ(placeUnknownWindows(recording, ladder()), 0) << "once";
}

TEST(TouchRecording, FitsTheMapItWasMadeOnAndNoOther) {
  TouchRecording recording = tenMilliseconds();
  std::array<double, 16> map{1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1};
  EXPECT_EQ(fitOf(recording, "abc", map), RecordingFit::not_said);
  recording.input_sha256 = "abc";
  EXPECT_EQ(fitOf(recording, "abc", map), RecordingFit::fits);
  EXPECT_EQ(fitOf(recording, "abd", map), RecordingFit::other_input);
  recording.view_from_file = map;
  EXPECT_EQ(fitOf(recording, "abc", map), RecordingFit::fits);
  map[3] = 5.001;
  EXPECT_EQ(fitOf(recording, "abc", map), RecordingFit::other_view);
}

TEST(TouchRecording, DrawsAForceOnlyWhereOneWasFelt) {
  TouchRow row;
  row.contact = true;
  EXPECT_FALSE(probeOf(row, 1).forces_on);
  row.force = {0, 0, 0.5};
  row.origin = CellStatus::base_plane;
  const Probe probe = probeOf(row, 42);
  EXPECT_TRUE(probe.forces_on);
  EXPECT_TRUE(probe.touching);
  EXPECT_EQ(probe.window_id, 42U);
  EXPECT_EQ(probe.origin, CellStatus::base_plane);
}

}  // namespace
}  // namespace relievo
