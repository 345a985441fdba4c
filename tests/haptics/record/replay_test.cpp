// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/replay.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/base/error.h"
#include "haptics/device/virtual_hand.h"
#include "haptics/record/events.h"
#include "haptics/record/log/log_writer.h"
#include "haptics/record/stroke.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

std::filesystem::path temporary(const std::string& name) {
  return test::ownPath(name);
}

/// A hand that is pushed back slides over waves, with the whole chain of a device.
class Replay : public ::testing::Test {
 protected:
  Replay() {
    options_.chain = ForceChain::whole;
    options_.device = &hand_;
    hand_.open();
  }
  void record(const std::filesystem::path& file) {
    const auto log = openLog(file, "relievo log", space_.get());
    runStroke(*space_, options_, {{{0.25, 20, 30, 9}, {2, 20, 30, 9}, {4, 60, 34, -3}}},
              [&](const HapticSample& sample, double t_s) { log->write(sample, t_s); });
    log->close("loop ticks 3751");
  }
  ReplayResult replayed(const LogTable& log) {
    return replay(*space_, strokeHapticOptions(options_), options_.chain, log,
                  [](const HapticSample&, double) {});
  }

  std::unique_ptr<HapticSpace> space_ = test::spaceOf(
      80, [](double x, double y) { return std::sin(x) + 2 * std::cos(0.3 * y); }, 4);
  VirtualHand hand_;
  StrokeOptions options_;
};

TEST_F(Replay, GivesTheSameBitsFromBothFormats) {
  for (const char* name : {"replay.csv", "replay.h5"}) {
    const std::filesystem::path file = temporary(name);
    hand_.open();
    record(file);
    const LogTable log = readLog(file);
    EXPECT_EQ(log.rows.size(), 3751U);
    EXPECT_TRUE(log.header.starts_with("relievo log"));
    double largest = 0;
    for (const auto& row : log.rows) largest = std::max(largest, row.force.z);
    EXPECT_GT(largest, 0.2) << "the hand was pushed";
    const ReplayResult result = replayed(log);
    EXPECT_EQ(result.ticks, 3751U);
    EXPECT_EQ(result.different, 0U) << (result.first ? result.first->column : "") << " in " << name;
  }
}

TEST_F(Replay, FindsASingleBitThatDiffers) {
  const std::filesystem::path file = temporary("replay_bit.csv");
  record(file);
  LogTable log = readLog(file);
  double& force = log.rows[3000].force.z;
  force = std::nextafter(force, 100);
  const ReplayResult result = replayed(log);
  EXPECT_EQ(result.different, 1U);
  ASSERT_TRUE(result.first);
  EXPECT_EQ(result.first->tick, 3000U);
  EXPECT_EQ(result.first->column, "f_z_N");
}

/// An earlier build did not record a column that a replay would compare.
TEST_F(Replay, AColumnThatTheRecordingLacksIsNotCompared) {
  const std::filesystem::path file = temporary("replay_lacks.csv");
  record(file);
  LogTable log = readLog(file);
  EXPECT_TRUE(log.lacking.empty());
  for (TouchRow& row : log.rows) row.unlimited_n = 0;
  EXPECT_GT(replayed(log).different, 100U);
  log.lacking = {"f_cmd_N"};
  EXPECT_EQ(replayed(log).different, 0U);
}

TEST_F(Replay, FindsAnotherStiffness) {
  const std::filesystem::path file = temporary("replay_k.csv");
  record(file);
  options_.stiffness_n_per_mm = 0.51;
  EXPECT_GT(replayed(readLog(file)).different, 1000U);
}

TEST_F(Replay, NamesTheRowThatCannotBeRead) {
  const std::filesystem::path file = temporary("replay_bad.csv");
  std::ofstream(file) << "# x\n" << logColumns() << "\n1,2,three\n";
  try {
    readLog(file);
    FAIL() << "read it";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("number 1"), std::string::npos) << error.what();
  }
  std::ofstream(file) << "a,b,c\n1,2,3\n";
  EXPECT_THROW(readLog(file), FileError);
  EXPECT_THROW(readLog(temporary("not_there.csv")), FileError);
  EXPECT_THROW(readLog(temporary("not_there.h5")), FileError);
}

TEST_F(Replay, SaysThatAFileIsNoRecording) {
  const auto said = [](const std::filesystem::path& file) -> std::string {
    try {
      readLog(file);
    } catch (const FileError& error) {
      return error.what();
    }
    return "read it";
  };
  for (const char* name : {"no_recording.csv", "no_recording.h5"}) {
    const std::filesystem::path file = temporary(name);
    for (const char* text :
         {"a,b,c\n1,2,3\n", "dear diary", "{\"relievo_project\": 1}\n", "ply\nformat ascii 1.0\n",
          "PK\x03\x04 cut off", "# only\n# comments\n", ""}) {
      std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
      EXPECT_EQ(said(file), "\"" + file.string() +
                                "\" is no recording of relievo. Choose a .csv or .h5 file that it "
                                "recorded.")
          << text;
    }
  }
  const std::filesystem::path later = temporary("later.csv");
  std::ofstream(later) << "# relievo recording, schema 9\nt_s,tick,mood\n1,2,3\n";
  EXPECT_NE(said(later).find("other columns than this version's"), std::string::npos)
      << said(later);
}

}  // namespace
}  // namespace relievo
