// SPDX-License-Identifier: BSD-3-Clause
// What touch and record write comes back as a recording that knows its map, from CSV and HDF5.
#include "core/project/recording.h"

#include <limits>

#include "core/base/error.h"
#include "core/provenance/sha256.h"
#include "core/recording/log_note.h"
#include "haptics/record/sample_log.h"
#include "haptics/record/stroke.h"
#include "tests/app/command_test.h"

namespace relievo {
namespace {

void writeLog(const std::string& verb, const std::string& log,
              const std::vector<std::string>& more = {}) {
  const test::CommandResult result = test::runRelievo(
      test::joined({verb, test::kReliefF, "--unit", "mm", "--view", "top", "--level", "0",
                    "--region", "240,60,50,50", "--stroke", test::kFlatStroke, "-o", log},
                   more));
  ASSERT_EQ(result.exit_code, 0) << result.err;
}

using Recording = test::CommandTest;

TEST_F(Recording, OfEveryVerbAndFormatKnowsItsInputItsMapAndItsWindow) {
  const std::string sum = sha256OfFile(test::kReliefF);
  writeLog("touch", path("touch.csv"));
  writeLog("touch", path("touch.h5"));
  writeLog("record", path("record.h5"), {"--seconds", "0.2"});
  for (const char* name : {"touch.csv", "touch.h5", "record.h5"}) {
    const TouchRecording recording = readRecording(path(name));
    EXPECT_EQ(recording.input_sha256, sum) << name;
    EXPECT_NE(recording.input.find("relief_f.ply"), std::string::npos) << name;
    ASSERT_TRUE(recording.view_from_file) << name;
    ASSERT_EQ(recording.windows.size(), 1U) << name;
    EXPECT_EQ(recording.windows[0].region, (Region{240, 60, 50, {0}})) << name;
    ASSERT_NE(windowOf(recording, recording.rows.back()), nullptr) << name;
    EXPECT_GE(recording.rows.size(), 200U) << name;
    EXPECT_EQ(recording.name, name);
  }
}

TEST_F(Recording, HasTheSameRowsFromBothFormats) {
  writeLog("touch", path("same.csv"));
  writeLog("touch", path("same.h5"));
  const TouchRecording csv = readRecording(path("same.csv"));
  const TouchRecording h5 = readRecording(path("same.h5"));
  ASSERT_EQ(csv.rows.size(), h5.rows.size());
  const StrokePoint first = readStroke(test::kFlatStroke).points.front();
  EXPECT_NEAR(norm(csv.rows[0].hip - ViewMm{first.x_mm, first.y_mm, first.z_mm}), 0, 1e-9);
  EXPECT_NEAR(csv.rows[0].proxy.x, first.x_mm, 1e-9);
  bool touched = false;
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    EXPECT_EQ(csv.rows[i].hip, h5.rows[i].hip);
    EXPECT_EQ(csv.rows[i].proxy, h5.rows[i].proxy);
    EXPECT_EQ(csv.rows[i].force, h5.rows[i].force);
    touched = touched || (csv.rows[i].contact && norm(csv.rows[i].force) > 0.1);
  }
  EXPECT_TRUE(touched);
}

/// Two rows, the second in another window.
std::string writeTwoRows(const std::string& file, const std::string& footer, double second_s) {
  const auto log = openLog(file, "relievo recording, schema 1");
  HapticSample sample;
  sample.window_id = 5;
  log->write(sample, 1);
  sample.window_id = 6;
  sample.detail = 3;
  log->write(sample, second_s);
  log->close(footer);
  return file;
}

TEST_F(Recording, ReadsFromItsLastLinesWhereLaterWindowsLay) {
  const std::string lines =
      "loop ticks 2\nwindow 5: region_mm 0 0 300 level 3 gain 1\n"
      "window 6: region_mm 100.5 -20 50 level 1 gain 2.5\n";
  for (const char* name : {"windows.csv", "windows.h5"}) {
    const TouchRecording recording = readRecording(writeTwoRows(path(name), lines, 2));
    ASSERT_EQ(recording.windows.size(), 2U) << name;
    const TouchedWindow* later = windowOf(recording, recording.rows[1]);
    ASSERT_NE(later, nullptr);
    EXPECT_EQ(later->region, (Region{100.5, -20, 50, {1}}));
    EXPECT_DOUBLE_EQ(later->gain, 2.5);
  }
}

TEST_F(Recording, HasEventsAndNotesAtTheTimesTheyBelongTo) {
  for (const char* name : {"noted.csv", "noted.h5"}) {
    const auto log =
        openLog(path(name), "relievo recording, schema 1", nullptr, LogKind::recording);
    HapticSample sample;
    for (std::uint64_t tick = 100; tick < 200; ++tick) {
      sample.tick = tick;
      log->write(sample, 0.001 * static_cast<double>(tick - 100),
                 tick == 130   ? "button 1 down"
                 : tick == 180 ? noteEvent(120, "a \"crack\", here")
                               : "");
    }
    log->close("loop ticks 100\n" + noteEvent(190, "late") + '\n');
    const TouchRecording recording = readRecording(path(name));
    ASSERT_EQ(recording.events.size(), 3U) << name;
    EXPECT_DOUBLE_EQ(recording.events[0].t_s, 0.02) << "when it was begun, not when it was ready";
    EXPECT_EQ(recording.events[0].text, "a \"crack\", here");
    EXPECT_TRUE(recording.events[0].is_note);
    EXPECT_DOUBLE_EQ(recording.events[1].t_s, 0.03);
    EXPECT_EQ(recording.events[1].text, "button 1 down");
    EXPECT_FALSE(recording.events[1].is_note);
    EXPECT_DOUBLE_EQ(recording.events[2].t_s, 0.09);
    EXPECT_EQ(recording.events[2].text, "late");
  }
}

TEST_F(Recording, RefusesTimesThatGoBackAndValuesThatAreNoNumbers) {
  EXPECT_THROW(readRecording(writeTwoRows(path("back.csv"), "", 0.5)), FileError);
  EXPECT_THROW(
      readRecording(writeTwoRows(path("nan.h5"), "", std::numeric_limits<double>::quiet_NaN())),
      FileError);
  EXPECT_THROW(readRecording(path("missing.csv")), FileError);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(readRecording(writeTwoRows(path("stop.csv"), "", 2), Task{stop.get_token(), {}}),
               Cancelled);
}

}  // namespace
}  // namespace relievo
