// SPDX-License-Identifier: BSD-3-Clause
// The same stroke as CSV and as HDF5: every command makes the same of both.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <regex>

#include "core/project/embedded_state.h"
#include "core/project/recording.h"
#include "tests/app/command_test.h"

namespace relievo {
namespace {

using nlohmann::json;
using test::bytesOf;
using test::CommandResult;
using test::reportOf;
using test::runRelievo;
namespace fs = std::filesystem;

class BothFormats : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_.emplace();
    fs::copy_file(test::kReliefF, path("relief.ply"));
    for (const char* log : {"log.csv", "log.h5"}) {
      const CommandResult touch =
          runRelievo({"touch", path("relief.ply"), "--unit", "mm", "--view", "top", "--cells",
                      "300", "--region", "65,75,50,50", "--stroke", test::kCurvedStroke, "--device",
                      "virtual:light", "-o", path(log)});
      ASSERT_EQ(touch.exit_code, 0) << touch.err;
    }
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::string path(const std::string& name) { return (folder_->path() / name).string(); }

  /// A text in which the log's name and checksum do not tell its format.
  static std::string alike(std::string text) {
    text = std::regex_replace(text, std::regex("log\\.h5"), "log.csv");
    return std::regex_replace(text, std::regex("[0-9a-f]{64}"), "SUM");
  }
  static void expectSamePixels(const std::string& a, const std::string& b) {
    const cv::Mat one = cv::imread(path(a), cv::IMREAD_UNCHANGED);
    const cv::Mat other = cv::imread(path(b), cv::IMREAD_UNCHANGED);
    ASSERT_FALSE(one.empty()) << a;
    ASSERT_EQ(one.size(), other.size());
    EXPECT_EQ(cv::norm(one, other, cv::NORM_INF), 0) << a << " and " << b;
  }
  static std::optional<test::TemporaryFolder> folder_;  ///< Of all tests: logs are made once.
};
std::optional<test::TemporaryFolder> BothFormats::folder_;

TEST_F(BothFormats, AreTheSameRecording) {
  const TouchRecording csv = readRecording(path("log.csv")), h5 = readRecording(path("log.h5"));
  ASSERT_GT(csv.rows.size(), 1000U);
  EXPECT_TRUE(csv.rows == h5.rows) << "in every column";
  EXPECT_EQ(csv.input, h5.input);
  EXPECT_EQ(csv.input_sha256, h5.input_sha256);
  EXPECT_EQ(csv.view_from_file, h5.view_from_file);
  ASSERT_EQ(csv.windows.size(), h5.windows.size());
  EXPECT_EQ(csv.windows.at(0).region, h5.windows.at(0).region);
  ASSERT_EQ(csv.events.size(), h5.events.size());
  for (std::size_t i = 0; i < csv.events.size(); ++i) {
    EXPECT_EQ(csv.events[i].t_s, h5.events[i].t_s);
    EXPECT_EQ(csv.events[i].text, h5.events[i].text);
  }
  EXPECT_GT(csv.events.size(), 0U);
}

TEST_F(BothFormats, CarryTheSameState) {
  const auto csv = embeddedProject(path("log.csv")), h5 = embeddedProject(path("log.h5"));
  ASSERT_TRUE(csv && h5);
  EXPECT_EQ(projectJson(*csv), projectJson(*h5));
}

TEST_F(BothFormats, GiveTheSameFigure) {
  const auto figure = [](const std::string& log, const std::string& out) {
    return runRelievo({"figure",      path("relief.ply"),
                       "--unit",      "mm",
                       "--view",      "top",
                       "--cells",     "300",
                       "--region",    "65,75,50,50",
                       "--layout",    "plot",
                       "--recording", path(log),
                       "--dpi",       "100",
                       "-o",          path(out),
                       "--report",    "json"});
  };
  const json csv = reportOf(figure("log.csv", "csv.png"));
  const json h5 = reportOf(figure("log.h5", "h5.png"));
  EXPECT_EQ(csv["pixels"], h5["pixels"]);
  EXPECT_EQ(csv["caption"], h5["caption"]);
  expectSamePixels("csv.png", "h5.png");
  reportOf(figure("log.csv", "csv.svg"));
  reportOf(figure("log.h5", "h5.svg"));
  const auto drawing = [](const std::string& file) {
    const std::string text = bytesOf(path(file));
    const std::size_t state = text.find("<metadata"), end = text.find("</metadata>");
    EXPECT_LT(state, end) << file;
    return text.substr(0, state) + text.substr(end);
  };
  EXPECT_EQ(alike(drawing("csv.svg")), alike(drawing("h5.svg")));
}

/// An HDF5 recording tells as a CSV one does that another scan was touched.
TEST_F(BothFormats, AreRefusedInFiguresOfAnotherScan) {
  std::ofstream points(path("other.xyz"));
  for (int y = 0; y <= 60; ++y) {
    for (int x = 0; x <= 60; ++x) points << x << ' ' << y << ' ' << std::sin(0.1 * x) << '\n';
  }
  points.close();
  for (const char* log : {"log.csv", "log.h5"}) {
    const CommandResult refused =
        runRelievo({"figure", path("other.xyz"), "--unit", "mm", "--layout", "plot", "--recording",
                    path(log), "-o", path("other.png")});
    EXPECT_EQ(refused.exit_code, 2) << log << refused.out;
    EXPECT_NE(refused.err.find(std::string("'") + log + "' is no recording of 'other.xyz'"),
              std::string::npos)
        << refused.err;
  }
}

TEST_F(BothFormats, GiveTheSameFramesOfAVideo) {
  for (const int frame : {0, 7}) {
    for (const char* format : {"csv", "h5"}) {
      const CommandResult made = runRelievo(
          {"video", path(std::string("log.") + format), "--size", "320x180", "--fps", "10", "-o",
           path(std::string("frame_") + format + ".png"), "--frame", std::to_string(frame)});
      ASSERT_EQ(made.exit_code, 0) << made.err;
    }
    expectSamePixels("frame_csv.png", "frame_h5.png");
  }
}

TEST_F(BothFormats, AreDrawnAndReplayedAlike) {
  for (const char* format : {"csv", "h5"}) {
    const CommandResult made =
        runRelievo({"render", "--from-image", path(std::string("log.") + format), "-o",
                    path(std::string("view_") + format + ".png")});
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }
  expectSamePixels("view_csv.png", "view_h5.png");
  const auto replay = [](const std::string& log) {
    json report = reportOf(runRelievo({"replay", path(log), "--verify", "--report", "json"}));
    return alike(report.dump());
  };
  EXPECT_EQ(replay("log.csv"), replay("log.h5"));
}

TEST_F(BothFormats, ArePackedAndVerifiedAlike) {
  const auto verified = [](const std::string& log) {
    const std::string project = path(log + ".relievo.json"), package = path(log + ".zip");
    EXPECT_EQ(runRelievo({"project", "new", path(log), "-o", project, "--recording", path(log)})
                  .exit_code,
              0);
    const CommandResult packed = runRelievo({"project", "package", project, "-o", package});
    EXPECT_EQ(packed.exit_code, 0) << packed.err;
    json report = reportOf(runRelievo({"replay", package, "--verify", "--report", "json"}));
    report.erase("package");
    EXPECT_EQ(report["recordings"].at(0)["different_ticks"], 0);
    return alike(report.dump());
  };
  EXPECT_EQ(verified("log.csv"), verified("log.h5"));
}

}  // namespace
}  // namespace relievo
