// SPDX-License-Identifier: BSD-3-Clause
// touch with a device, record in real time, and replay of both, as a user runs them.
#include <fstream>
#include <sstream>

#include "core/provenance/embedded.h"
#include "core/provenance/provenance.h"
#include "core/recording/log_table.h"
#include "tests/app/command_test.h"

namespace relievo {
namespace {

using test::CommandResult;
using test::runRelievo;

class ReplayVerb : public test::CommandTest {
 protected:
  /// A log of relief F's flat square, by `verb` with more words.
  static CommandResult made(const std::string& verb, const std::string& log,
                            const std::vector<std::string>& more) {
    return runRelievo(test::joined(
        {verb, test::kReliefF, "--unit", "mm", "--view", "top", "--level", "0", "--region",
         "240,60,50,50", "--stroke", test::kFlatStroke, "-o", log, "--report", "json"},
        more));
  }
};

TEST_F(ReplayVerb, RepeatsATouchWithTheVirtualHandBitByBit) {
  for (const char* name : {"verb.csv", "verb.h5"}) {
    const std::string log = path(name);
    const CommandResult touch = made("touch", log, {"--device", "virtual:light"});
    ASSERT_EQ(touch.exit_code, 0) << touch.err;
    const auto report = nlohmann::json::parse(touch.out);
    EXPECT_EQ(report["device"], "virtual:light");
    EXPECT_EQ(report["safety"], "on") << "with a device";
    EXPECT_GT(report["largest_force_n"], 0.05);
    const CommandResult replay = runRelievo({"replay", log, "--verify", "--report", "json"});
    EXPECT_EQ(replay.exit_code, 0) << replay.err;
    const auto found = nlohmann::json::parse(replay.out);
    EXPECT_EQ(found["identical"], true);
    EXPECT_TRUE(found["recorded_by"]["commit"].is_string());
    EXPECT_EQ(found["recorded_by"]["commit"], found["this_program"]["commit"]);
    EXPECT_TRUE(found["recorded_by"]["build"].is_null()) << "a stroke depends on no build";
  }
}

TEST_F(ReplayVerb, RepeatsARealTimeRecordingAndEndsWithFiveOnAMismatch) {
  const std::string log = path("record.csv");
  const CommandResult record = made("record", log, {"--seconds", "1.5"});
  ASSERT_EQ(record.exit_code, 0) << record.err;
  const auto report = nlohmann::json::parse(record.out);
  EXPECT_EQ(report["ticks"], 1500);
  EXPECT_EQ(report["violations"], 0);
  EXPECT_EQ(runRelievo({"replay", log, "--verify"}).exit_code, 0);

  std::string text = test::bytesOf(log);
  EXPECT_NE(text.find("\n# loop ticks "), std::string::npos) << "how the loop ran";
  const std::string word = "--level\",\"0\"";
  ASSERT_NE(text.find(word), std::string::npos);
  text.replace(text.find(word), word.size(), "--level\",\"1\"");  // Another surface.
  std::ofstream(log) << text;
  const CommandResult replay = runRelievo({"replay", log, "--verify", "--report", "json"});
  EXPECT_EQ(replay.exit_code, 5) << replay.err;
  EXPECT_TRUE(nlohmann::json::parse(replay.out).contains("first_difference"));
  EXPECT_EQ(runRelievo({"replay", log}).exit_code, 0) << "without --verify it only tells";
}

/// What a replay is given and what it never looks at: only checksums tell that it was changed.
TEST_F(ReplayVerb, EndsWithFiveForChangesThatNoReplaySees) {
  const std::string log = path("touch.csv");
  ASSERT_EQ(made("touch", log, {"--device", "virtual:light"}).exit_code, 0);
  const CommandResult same = runRelievo({"replay", log, "--verify"});
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_NE(same.out.find("By its checksums every row, event and line is as it was written."),
            std::string::npos)
      << same.out;
  EXPECT_NE(same.out.find("Told by checksums alone: t_s, buttons, rate_Hz"), std::string::npos);

  const std::string text = test::bytesOf(log);
  const std::size_t row = text.find("\n0.4") + 1;
  /// Another value in one column of a row.
  const auto field = [&](int column, const std::string& value) {
    std::string other = text;
    std::size_t begin = row;
    for (int i = 0; i < column; ++i) begin = other.find(',', begin) + 1;
    return other.replace(begin, other.find_first_of(",\n", begin) - begin, value);
  };
  const auto without = [&](const std::string& words) {
    std::string other = text;
    const std::size_t at = other.find(words);
    EXPECT_NE(at, std::string::npos) << words;
    return other.erase(at, words.size());
  };
  const std::string sum = nlohmann::json::parse(embeddedState(log).value())["input"]["sha256"];
  const std::vector<std::pair<const char*, std::string>> changes{
      {"buttons", field(21, "1")},
      {"rate", field(22, "999.25")},
      {"event", field(23, "\"forged\"")},
      {"age", field(30, "0.00012345")},
      {"device", without("virtual")},
      {"checksum of the input", without(sum)},
      {"rows at the end", text.substr(0, row)},
      {"a time", field(0, "0.4000001")}};
  for (const auto& [what, other] : changes) {
    ASSERT_NE(other, text) << what;
    std::ofstream(log, std::ios::binary) << other;
    const CommandResult replay = runRelievo({"replay", log, "--verify", "--report", "json"});
    EXPECT_EQ(replay.exit_code, 5) << what << ": " << replay.err;
    const auto report = nlohmann::json::parse(replay.out, nullptr, false);
    ASSERT_TRUE(report.is_object()) << what;
    EXPECT_EQ(report["integrity"]["state"], "changed") << what;
  }
}

TEST_F(ReplayVerb, EndsWithFiveForAnyBitOfAnHdf5Log) {
  const std::string log = path("touch.h5");
  ASSERT_EQ(made("touch", log, {"--device", "virtual:light"}).exit_code, 0);
  EXPECT_EQ(runRelievo({"replay", log, "--verify"}).exit_code, 0);
  const std::string bytes = test::bytesOf(log);
  for (const std::size_t place : {std::size_t{3}, std::size_t{520}, bytes.size() / 2}) {
    std::string other = bytes;
    other[place] ^= 4;
    std::ofstream(log, std::ios::binary) << other;
    const CommandResult replay = runRelievo({"replay", log, "--verify"});
    EXPECT_EQ(replay.exit_code, 5) << place << ": " << replay.err;
    EXPECT_NE(replay.out.find("It was changed: "), std::string::npos) << replay.out;
  }
}

TEST_F(ReplayVerb, SaysThatALogOfAnEarlierBuildCarriesNoChecksum) {
  const std::string log = path("old.csv");
  ASSERT_EQ(made("touch", log, {"--device", "virtual:light"}).exit_code, 0);
  std::istringstream in(test::bytesOf(log));
  std::string old;
  for (std::string line; std::getline(in, line);) {
    const bool is_about_checksums = line.starts_with("# checksums ") ||
                                    line.starts_with("# sum ") || line.starts_with("# finished ");
    if (!is_about_checksums) old += line + '\n';
  }
  std::ofstream(log, std::ios::binary) << old;
  const CommandResult replay = runRelievo({"replay", log, "--verify"});
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  EXPECT_NE(replay.out.find("It carries no checksum"), std::string::npos) << replay.out;
}

/// A recording of an older build opens, and what differs is put down to the law and not to the
/// file.
TEST_F(ReplayVerb, ARecordingUnderAnEarlierLawSaysWhyItDiffers) {
  const std::string log = path("record.csv");
  ASSERT_EQ(made("touch", log, {"--device", "virtual:light"}).exit_code, 0);
  const std::string text = test::bytesOf(log);
  const std::string law = "\n# law 7\n";
  ASSERT_NE(text.find(law), std::string::npos);
  // Also one digit of the last row.
  const auto altered = [&](const std::string& law_now) {
    std::string old = text;
    old.replace(old.find(law), law.size(), law_now);
    const std::size_t last = old.rfind(',');
    old.insert(last - 1, "9");
    std::ofstream(log) << old;
    return runRelievo({"replay", log, "--verify", "--report", "json"});
  };
  const CommandResult before = altered("\n");
  EXPECT_EQ(before.exit_code, 5) << before.err;
  const auto report = nlohmann::json::parse(before.out);
  EXPECT_TRUE(report["law"]["recorded"].is_null());
  EXPECT_EQ(report["law"]["this_build"], 7);
  const std::string why = report["why"];
  EXPECT_NE(why.find("made by version " RELIEVO_VERSION_STRING
                     " under an earlier force law; this build has law 7"),
            std::string::npos)
      << why;
  EXPECT_NE(why.find("Law 2 (2026-11-22)"), std::string::npos) << why;
  const auto second = nlohmann::json::parse(altered("\n# law 2\n").out);
  EXPECT_NE(second["why"].get<std::string>().find("under force law 2"), std::string::npos);
  EXPECT_EQ(second["why"].get<std::string>().find("Law 2 ("), std::string::npos) << "it had that";
  EXPECT_TRUE(nlohmann::json::parse(altered(law).out)["why"].is_null())
      << "under the same law nothing but the file can differ";
}

TEST_F(ReplayVerb, ADeviceThatAPersonHoldsIsNeverRecordedWithoutItsSafety) {
  for (const char* device : {"mouse", "falcon"}) {
    const std::string log = path("held.csv");
    const CommandResult record = made("record", log, {"--device", device, "--safety", "off"});
    EXPECT_EQ(record.exit_code, 1) << record.err;
    EXPECT_NE(record.err.find("a person holds the device"), std::string::npos) << record.err;
    EXPECT_FALSE(std::filesystem::exists(log));
  }
}

TEST_F(ReplayVerb, WhatIsMoreThanTheDevicesDataSheetIsSaidOnceAndRecorded) {
  const std::string said = "stiffness 3 N/mm instead of 50";
  for (const char* verb : {"record", "touch"}) {
    const std::string log = path("stiff.csv");
    std::vector<std::string> more{"--device", "virtual", "--stiffness", "50"};
    if (std::string(verb) == "record") more.insert(more.end(), {"--seconds", "0.3"});
    const CommandResult result = made(verb, log, more);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::size_t once = result.err.find(said);
    EXPECT_NE(once, std::string::npos) << result.err;
    EXPECT_EQ(result.err.find(said, once + 1), std::string::npos) << result.err;
    const std::string text = test::bytesOf(log);
    EXPECT_LT(text.find("\n# limits More was asked for"), text.find("\nt_s,tick"));
    EXPECT_NE(nlohmann::json::parse(result.out)["limited"].get<std::string>().find(said),
              std::string::npos);
    EXPECT_EQ(runRelievo({"replay", log, "--verify"}).exit_code, 0);
  }
}

TEST_F(ReplayVerb, RecordingsSayWhatTheyWereMadeFromAndHowTheLoopRan) {
  const std::string sha256 = sha256OfFile(test::kReliefF);
  const auto check = [&](const std::string& state) {
    const Provenance provenance = provenanceFromJson(state, "log");
    EXPECT_EQ(provenance.input.sha256, sha256);
    EXPECT_FALSE(provenance.version.empty());
    EXPECT_EQ(nlohmann::json::parse(provenance.touch)["texture_mm"], 0.02);
  };
  const std::vector<std::string> more{"--seconds", "0.3", "--texture", "0.02"};
  const std::string h5 = path("state.h5"), csv = path("state.csv");
  ASSERT_EQ(made("record", h5, more).exit_code, 0);
  check(hdf5State(h5).value());
  ASSERT_EQ(made("record", csv, more).exit_code, 0);
  check(embeddedState(csv).value());
  const std::string text = test::bytesOf(csv);
  EXPECT_LT(text.find("\n# wake-up us "), text.find("\nt_s,tick"));
}

TEST_F(ReplayVerb, SaysWhatCannotBeReplayed) {
  const std::string log = path("foreign.csv");
  std::ofstream(log) << "t_s,x\n1,2\n";
  const CommandResult foreign = runRelievo({"replay", log});
  EXPECT_EQ(foreign.exit_code, 2);
  EXPECT_NE(foreign.err.find("other columns"), std::string::npos) << foreign.err;
  EXPECT_EQ(made("touch", path("x.csv"), {"--device", "virtual:iron"}).exit_code, 6);
  EXPECT_EQ(made("touch", path("x.csv"), {"--device", "loom"}).exit_code, 6);
}

TEST_F(ReplayVerb, SaysThatTheLastLinesOfAWindowsRecordingAreMissing) {
  const std::string log = path("cut.csv");
  ASSERT_EQ(made("touch", log, {}).exit_code, 0);
  const std::string text = test::bytesOf(log);
  std::istringstream lines(text.substr(text.find("t_s,tick")));
  std::string rows;  // Without the checksums of this log.
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with('#')) rows += line + '\n';
  }
  const auto said = [&](const std::string& header) {
    std::ofstream(log, std::ios::trunc) << "# relievo recording, schema 1\n# input f.ply\n"
                                        << header << rows;
    const CommandResult replay = runRelievo({"replay", log, "--verify"});
    EXPECT_EQ(replay.exit_code, 2);
    return replay.err;
  };
  const std::string cut = said("# not ended\n");
  EXPECT_NE(cut.find("lacks its last lines"), std::string::npos) << cut;
  EXPECT_NE(cut.find("cannot be verified"), std::string::npos) << cut;
  const std::string older = said("# loop ticks 5\n");
  EXPECT_NE(older.find("does not say what made it"), std::string::npos) << older;
}

}  // namespace
}  // namespace relievo
