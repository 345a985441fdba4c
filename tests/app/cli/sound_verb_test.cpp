// SPDX-License-Identifier: BSD-3-Clause
// relievo sound, as a user runs it on logs of both kinds: what is in the WAV file is what the log's
// rows say; how each of it sounds is haptics/sound/recorded_sound_test's.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "core/recording/log_table.h"
#include "tests/app/command_test.h"

namespace relievo {
namespace {

using nlohmann::json;
using test::bytesOf;
using test::CommandResult;
using test::reportOf;
using test::runRelievo;
using testing::HasSubstr;

constexpr int kRate = 48000;

/// The left samples, -1 .. 1, of a WAV file.
std::vector<double> samplesOf(const std::string& file) {
  const std::string bytes = bytesOf(file);
  const std::size_t data = bytes.find("data");
  std::vector<double> left;
  for (std::size_t i = data + 8; i + 4 <= bytes.size(); i += 4) {
    const auto low = static_cast<unsigned char>(bytes[i]);
    const auto high = static_cast<unsigned char>(bytes[i + 1]);
    left.push_back(static_cast<std::int16_t>(low | high << 8) / 32767.0);
  }
  return left;
}

class SoundVerb : public test::CommandTest {
 protected:
  static void SetUpTestSuite() {
    logs_.emplace();
    for (const char* log : {"log.csv", "log.h5"}) {
      const CommandResult touch = runRelievo(
          {"touch", test::kReliefF, "--unit", "mm", "--view", "top", "--cells", "300", "--region",
           "65,75,50,50", "--stroke", test::kCurvedStroke, "-o", (logs_->path() / log).string()});
      ASSERT_EQ(touch.exit_code, 0) << touch.err;
    }
  }
  static void TearDownTestSuite() { logs_.reset(); }
  static std::string log(const char* name = "log.csv") { return (logs_->path() / name).string(); }
  static std::optional<test::TemporaryFolder> logs_;  ///< Of all tests: they are made once.
};
std::optional<test::TemporaryFolder> SoundVerb::logs_;

TEST_F(SoundVerb, EveryContactOfTheLogIsAClickAtItsTime) {
  const std::string out = path("touch.wav");
  const json report =
      reportOf(runRelievo({"sound", log(), "-o", out, "--tone-for", "0", "--report", "json"}));
  const LogTable table = readLog(log());
  std::vector<double> contacts_s;
  double force_times_way = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const bool before = i > 0 && table.rows[i - 1].contact;
    if (table.rows[i].contact && !before) {
      contacts_s.push_back(table.rows[i].t_s - table.rows[0].t_s);
    }
    if (before) force_times_way += norm(table.rows[i].force);
  }
  ASSERT_FALSE(contacts_s.empty());
  EXPECT_GT(force_times_way, 0);
  EXPECT_EQ(report["heard"]["contact"], contacts_s.size());
  const std::vector<double> samples = samplesOf(out);
  const double length_s = table.rows.back().t_s - table.rows.front().t_s;
  EXPECT_NEAR(static_cast<double>(samples.size()) / kRate, length_s + 0.2, 1e-3);
  // The first contact: silence, and then at once the click.
  const auto first = static_cast<std::size_t>(std::lround(contacts_s[0] * kRate));
  for (std::size_t i = 0; i < first; ++i) ASSERT_EQ(samples[i], 0) << i;
  EXPECT_GT(std::abs(samples[first]), 0.01);
  for (const double s : samples) ASSERT_LE(std::abs(s), 0.9 + 1e-4);
}

TEST_F(SoundVerb, BothKindsOfLogSoundTheSame) {
  reportOf(runRelievo({"sound", log(), "-o", path("a.wav"), "--report", "json"}));
  reportOf(runRelievo({"sound", log("log.h5"), "-o", path("b.wav"), "--report", "json"}));
  EXPECT_EQ(samplesOf(path("a.wav")), samplesOf(path("b.wav")));
  EXPECT_GT(samplesOf(path("a.wav")).size(), 1000U);
}

TEST_F(SoundVerb, TheFileSaysWhereItCameFrom) {
  const json report = reportOf(runRelievo({"sound", log(), "-o", path("touch.wav"), "--heights",
                                           "0,30", "--ceiling", "0.5", "--report", "json"}));
  EXPECT_EQ(report["recording"]["sha256"].get<std::string>().size(), 64U);
  EXPECT_EQ(report["sound"]["heights_mm"], json({0.0, 30.0}));
  EXPECT_EQ(report["heights_given"], true);
  EXPECT_LE(report["peak"].get<double>(), 0.5 + 1e-6);
  EXPECT_THAT(bytesOf(path("touch.wav")),
              HasSubstr(report["recording"]["sha256"].get<std::string>()));
}

TEST_F(SoundVerb, WhatCannotBeMadeIsRefusedAndLeavesNothing) {
  const std::string plain = write("text.csv", "no log\n1,2\n");
  const std::string rows = bytesOf(log());
  const struct {
    std::vector<std::string> words;
    int exit_code;
    const char* says;
  } kCases[] = {
      {{"sound", log(), "-o", path("touch.mp3")}, 1, "does not end in .wav"},
      {{"sound", log(), "-o", path("o.wav"), "--from", "900"}, 1, "There is nothing between"},
      {{"sound", plain, "-o", path("o.wav")}, 2, "no recording"},
      {{"sound", path("none.csv"), "-o", path("o.wav")}, 2, "none.csv"},
      {{"sound", log(), "-o", path("o.wav"), "--ceiling", "1.5"}, 1, "--ceiling"},
      {{"sound", log(), "-o", path("o.wav"), "--heights", "1"}, 1, "--heights"},
      {{"sound", log(), "-o", log()}, 1, ""},
  };
  for (const auto& one : kCases) {
    const CommandResult result = runRelievo(one.words);
    EXPECT_EQ(result.exit_code, one.exit_code) << result.err;
    EXPECT_THAT(result.err, HasSubstr(one.says));
  }
  EXPECT_FALSE(std::filesystem::exists(path("o.wav")));
  EXPECT_FALSE(std::filesystem::exists(path("touch.mp3")));
  EXPECT_EQ(bytesOf(log()), rows) << "a log is not replaced by its sound";
}

TEST_F(SoundVerb, MoreThanAWavFileHoldsIsRefused) {
  // A log as another program wrote it, of the columns that are needed.
  std::string csv =
      "t_s,tick,hip_x_mm,hip_y_mm,hip_z_mm,proxy_x_mm,proxy_y_mm,proxy_z_mm,f_x_N,"
      "f_y_N,f_z_N,contact,detail,region_id,origin,dev_hip_x_mm,dev_hip_y_mm,"
      "dev_hip_z_mm\n";
  for (const char* time : {"0", "0.001", "50000"}) {
    csv += std::string(time) + ",1,1,1,1,1,1,1,0,0,0,0,1,1,0,1,1,1\n";
  }
  const std::string file = write("long.csv", csv);
  const CommandResult refused = runRelievo({"sound", file, "-o", path("o.wav")});
  EXPECT_EQ(refused.exit_code, 1) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("13.9. Nothing was written."));
  EXPECT_EQ(runRelievo({"sound", file, "-o", path("o.wav"), "--to", "1"}).exit_code, 0);
}

}  // namespace
}  // namespace relievo
