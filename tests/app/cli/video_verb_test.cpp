// SPDX-License-Identifier: BSD-3-Clause
// relievo video, as a user runs it on a log.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "core/recording/log_table.h"
#include "tests/app/command_test.h"

namespace relievo {
namespace {

using nlohmann::json;
using test::bytesOf;
using test::CommandResult;
using test::runRelievo;
namespace fs = std::filesystem;

class VideoVerb : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_.emplace();
    for (const char* log : {"log.csv", "log.h5"}) {
      const CommandResult touch =
          runRelievo({"touch", test::kReliefF, "--unit", "mm", "--view", "top", "--cells", "300",
                      "--region", "65,75,50,50", "--stroke", test::kCurvedStroke, "-o", path(log)});
      ASSERT_EQ(touch.exit_code, 0) << touch.err;
    }
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::string path(const std::string& name) { return (folder_->path() / name).string(); }
  static CommandResult video(const std::vector<std::string>& more) {
    return runRelievo(
        test::joined({"video", "--size", "320x180", "--fps", "10", "--to", "0.3"}, more));
  }
  static std::optional<test::TemporaryFolder> folder_;  ///< Of all tests: logs are made once.
};
std::optional<test::TemporaryFolder> VideoVerb::folder_;

TEST_F(VideoVerb, MakesTheMapOfALogAgainFromBothFormats) {
  for (const char* log : {"log.csv", "log.h5"}) {
    const std::string out = path(std::string(log) + ".mp4");
    const CommandResult made = video({path(log), "-o", out, "--report", "json"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const json report = json::parse(made.out);
    EXPECT_EQ(report["frames"], 4);
    EXPECT_EQ(report["pixels"], json({320, 180}));
    EXPECT_EQ(report["bytes"], fs::file_size(out));
    const json beside = json::parse(bytesOf(out + ".json"));
    EXPECT_EQ(beside["figure"]["recording"]["file"], log);
    EXPECT_EQ(beside["figure"]["video"]["fps"], 10);
    EXPECT_EQ(beside["input"]["sha256"].get<std::string>().size(), 64U);
    EXPECT_NE(bytesOf(out).find("relievo_provenance"), std::string::npos) << "also in the file";
    const CommandResult frame =
        video({path(log), "-o", path(std::string(log) + ".png"), "--frame", "2"});
    EXPECT_EQ(frame.exit_code, 0) << frame.err;
    const std::string tiff = path(std::string(log) + ".tif");
    const CommandResult other = video({path(log), "-o", tiff, "--frame", "2"});
    EXPECT_EQ(other.exit_code, 0) << other.err;
    EXPECT_EQ(bytesOf(tiff).substr(0, 2), "II") << "its name says TIFF";
  }
}

TEST_F(VideoVerb, FollowsTheCameraPathOfAProjectWithAndWithoutARecording) {
  ASSERT_EQ(runRelievo({"project", "new", path("log.csv"), "-o", path("p.json")}).exit_code, 0);
  EXPECT_EQ(video({"--path", path("p.json"), "-o", path("none.mp4")}).exit_code, 2);
  json project = json::parse(bytesOf(path("p.json")));
  const auto key = [](double t_s, double x, double side) {
    return json{
        {"t_s", t_s},
        {"view",
         {{"relievo_view", 1},
          {"region_mm", {x, 20, side, side}},
          {"level", 0},
          {"gain", 1},
          {"turn_deg", {0, -20}},
          {"look",
           {{"kind", "lit"},
            {"colours", "viridis"},
            {"light_azimuth_deg", 315},
            {"light_elevation_deg", 45},
            {"radius_mm", 0},
            {"range", nullptr}}},
          {"stereo", {{"mode", "off"}, {"eye_angle_deg", 4}, {"zero_plane_mm", nullptr}}}}}};
  };
  project["camera_paths"] = {{{"name", "walk"}, {"keys", {key(0, 10, 150), key(2, 200, 80)}}}};
  std::ofstream(path("p.json")) << project;
  const CommandResult alone =
      video({"--path", path("p.json"), "-o", path("path.mp4"), "--report", "json"});
  ASSERT_EQ(alone.exit_code, 0) << alone.err;
  EXPECT_EQ(json::parse(alone.out)["frames"], 4);
  const json beside = json::parse(bytesOf(path("path.mp4.json")));
  EXPECT_EQ(beside["figure"]["video"]["path"]["keys"].size(), 2U);
  const CommandResult both =
      video({path("log.csv"), "--path", path("p.json"), "-o", path("both.png"), "--frame", "1"});
  EXPECT_EQ(both.exit_code, 0) << both.err;
}

TEST_F(VideoVerb, WritesTheVideoOfEachEyeToo) {
  const CommandResult made = video({path("log.csv"), "-o", path("eyes.mp4"), "--both-eyes",
                                    "--eye-angle", "8", "--report", "json"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  std::uintmax_t bytes = 0;
  for (const char* name : {"eyes.mp4", "eyes.left.mp4", "eyes.right.mp4"}) {
    ASSERT_TRUE(fs::exists(path(name))) << name;
    bytes += fs::file_size(path(name));
  }
  EXPECT_EQ(json::parse(made.out)["bytes"], bytes);
  const auto request = [](const char* name) {
    return json::parse(bytesOf(path(std::string(name) + ".json")))["figure"]["video"];
  };
  EXPECT_EQ(request("eyes.left.mp4")["eye"], "left");
  EXPECT_EQ(request("eyes.right.mp4")["eye"], "right");
  EXPECT_FALSE(request("eyes.mp4").contains("eye"));
  EXPECT_EQ(request("eyes.left.mp4")["eye_angle_deg"], 8);
  EXPECT_NE(bytesOf(path("eyes.left.mp4")), bytesOf(path("eyes.right.mp4")));
  // An eye's file may not be what is read.
  fs::copy_file(path("log.csv"), path("x.left.mp4"));
  const CommandResult refused = video({path("x.left.mp4"), "-o", path("x.mp4"), "--both-eyes"});
  EXPECT_EQ(refused.exit_code, 1) << refused.err;
  EXPECT_EQ(bytesOf(path("x.left.mp4")), bytesOf(path("log.csv")));
}

/// The samples of a video, or those of a WAV file.
std::string heard(const std::string& file) {
  const std::string bytes = file.ends_with(".wav") ? bytesOf(file) : std::string();
  if (!bytes.empty()) return bytes.substr(bytes.find("data") + 8);
  const std::string out = file + ".pcm";
  EXPECT_EQ(
      std::system(("ffmpeg -v error -nostdin -y -i '" + file + "' -map 0:a -f s16le '" + out + "'")
                      .c_str()),
      0);
  return bytesOf(out);
}

/// When the left side is first loud, in seconds.
double firstHeardS(const std::string& samples) {
  for (std::size_t i = 0; i + 4 <= samples.size(); i += 4) {
    const auto low = static_cast<unsigned char>(samples[i]);
    const auto high = static_cast<unsigned char>(samples[i + 1]);
    if (std::abs(static_cast<std::int16_t>(low | high << 8)) > 300) {
      return static_cast<double>(i) / 4 / 48000;
    }
  }
  return -1;
}

TEST_F(VideoVerb, SoundsAsTheRecordingDoesByItself) {
  const LogTable table = readLog(path("log.csv"));
  const auto contact = std::find_if(table.rows.begin(), table.rows.end(),
                                    [](const TouchRow& row) { return row.contact; });
  ASSERT_NE(contact, table.rows.end());
  const double contact_s = contact->t_s - table.rows.front().t_s;
  const double from_s = std::max(0.0, contact_s - 0.1);
  for (const char* speed : {"1", "0.25"}) {
    const std::vector<std::string> part{
        "--from", std::to_string(from_s), "--to", std::to_string(from_s + 0.5), "--speed", speed};
    const std::string wav = path("alone.wav");
    ASSERT_EQ(runRelievo(test::joined({"sound", path("log.csv"), "-o", wav}, part)).exit_code, 0);
    const auto made = [&](const char* profile) {
      const std::string out = path(std::string(profile) + ".mp4");
      const CommandResult result =
          runRelievo(test::joined({"video", path("log.csv"), "-o", out, "--size", "320x180",
                                   "--fps", "10", "--profile", profile, "--report", "json"},
                                  part));
      EXPECT_EQ(result.exit_code, 0) << result.err;
      EXPECT_EQ(json::parse(result.out)["sound"], true);
      EXPECT_EQ(json::parse(bytesOf(out + ".json"))["figure"]["video"]["sound"],
                std::string(profile) == "archive" ? "alac" : "aac");
      return heard(out);
    };
    const std::string alone = heard(wav), archive = made("archive"), talk = made("talk");
    const double speed_factor = std::stod(speed);
    const auto pictures = static_cast<std::size_t>(std::lround(5 / speed_factor)) + 1;
    EXPECT_EQ(archive.size(), 4 * 4800 * pictures) << "as long as the pictures";
    EXPECT_EQ(archive, alone.substr(0, archive.size())) << speed;
    EXPECT_EQ(alone.find_first_not_of('\0'), archive.find_first_not_of('\0'));
    const double click_s = (contact_s - from_s) / speed_factor;
    EXPECT_NEAR(firstHeardS(archive), click_s, 0.001);
    EXPECT_NEAR(firstHeardS(talk), click_s, 0.01) << "within a tenth of a picture";
  }
}

TEST_F(VideoVerb, IsSilentWhereNothingShallOrCanBeHeard) {
  const auto made = [&](const std::string& log, const std::vector<std::string>& more) {
    return video(test::joined({log, "-o", path("silent.mp4"), "--report", "json"}, more));
  };
  const auto sounds = [&] {
    return bytesOf(path("silent.mp4")).find("soun") != std::string::npos;  // The track's handler.
  };
  const CommandResult plain = made(path("log.csv"), {});
  EXPECT_TRUE(sounds()) << plain.err;
  const CommandResult without = made(path("log.csv"), {"--without", "plots,sound"});
  EXPECT_EQ(json::parse(without.out)["sound"], false);
  EXPECT_FALSE(sounds());
  // An earlier build did not write where the hand was, nor, where it was killed, the last window.
  std::istringstream lines(bytesOf(path("log.csv")));
  std::ostringstream old;
  std::vector<std::string> columns;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) {
      old << line << '\n';
      continue;
    }
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (columns.empty()) columns = cells;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (columns[i].starts_with("dev_hip_")) continue;
      const bool is_late = columns[i] == "region_id" && cells[0] > "1";
      old << (i > 0 ? "," : "") << (is_late && cells[i] != columns[i] ? "7" : cells[i]);
    }
    old << '\n';
  }
  std::ofstream(path("old_hand.csv")) << old.str();
  const CommandResult silent = made(path("old_hand.csv"), {});
  EXPECT_EQ(silent.exit_code, 0) << silent.err;
  EXPECT_NE(silent.err.find("The video has no sound."), std::string::npos) << silent.err;
  EXPECT_NE(silent.err.find("dev_hip_x_mm"), std::string::npos) << silent.err;
  EXPECT_EQ(json::parse(silent.out)["sound"], false);
  EXPECT_FALSE(sounds());
}

TEST_F(VideoVerb, SaysWhatItCannotMake) {
  EXPECT_EQ(video({path("log.csv"), "-o", path("x.avi")}).exit_code, 1);
  EXPECT_EQ(video({path("log.csv"), "-o", path("x.mp4"), "--profile", "film"}).exit_code, 1);
  EXPECT_EQ(video({path("log.csv"), "-o", path("x.mp4"), "--stereo", "grey"}).exit_code, 1);
  EXPECT_EQ(video({path("log.csv"), "-o", path("x.png"), "--frame", "9"}).exit_code, 1);
  EXPECT_EQ(video({path("none.csv"), "-o", path("x.mp4")}).exit_code, 2);
  const CommandResult moved =
      video({path("log.csv"), "-o", path("x.mp4"), "--input", test::kCurvedStroke});
  EXPECT_EQ(moved.exit_code, 5);
  EXPECT_NE(moved.err.find("E501"), std::string::npos) << moved.err;
  const CommandResult bare =
      runRelievo({"video", path("log.csv"), "-o", path("x.mp4")}, {"PATH=/usr/sbin"});
  EXPECT_NE(bare.exit_code, 0);
  std::ofstream(path("old.csv"))
      << "# relievo log, schema 1\n"
      << bytesOf(path("log.csv")).substr(bytesOf(path("log.csv")).find("t_s,tick"));
  const CommandResult old = video({path("old.csv"), "-o", path("x.mp4")});
  EXPECT_EQ(old.exit_code, 2);
  EXPECT_NE(old.err.find("does not say how its map was made"), std::string::npos) << old.err;
  EXPECT_FALSE(fs::exists(path("x.mp4")));
}

TEST_F(VideoVerb, SaysWhichPartThereIs) {
  const std::string out = path("part.png");
  const auto asked = [&](const std::string& from, const std::string& to) {
    return runRelievo({"video", path("log.csv"), "-o", out, "--size", "320x180", "--frame", "0",
                       "--from", from, "--to", to});
  };
  const CommandResult cut = asked("0.1", "99");
  EXPECT_EQ(cut.exit_code, 0) << cut.err;
  EXPECT_NE(cut.err.find("The part from 0.1 s to 99 s is cut to"), std::string::npos) << cut.err;
  const CommandResult whole = asked("0.1", "0.2");
  EXPECT_EQ(whole.err.find("is cut to"), std::string::npos) << whole.err;
  const CommandResult none = asked("98", "99");
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_NE(none.err.find("nothing between 98 s and 99 s: the recording is "), std::string::npos)
      << none.err;
}

}  // namespace
}  // namespace relievo
