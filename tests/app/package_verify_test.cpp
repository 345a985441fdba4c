// SPDX-License-Identifier: BSD-3-Clause
// replay --verify on a package for citation: every checksum, and every recording to the last bit.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/app/command.h"

namespace relievo {
namespace {

using nlohmann::json;
using test::CommandResult;
using test::runRelievo;
namespace fs = std::filesystem;

const std::string kScan = RELIEVO_SOURCE_DIR "/data/samples/relief_f.ply";
const std::string kStroke = RELIEVO_SOURCE_DIR "/data/strokes/flat.csv";

class PackageVerify : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) / "relievo_package_verify";
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    fs::copy_file(kScan, path("relief.ply"));
    const CommandResult touch =
        runRelievo({"touch", path("relief.ply"), "--unit", "mm", "--view", "top", "--cells", "300",
                    "--region", "240,60,50,50", "--stroke", kStroke, "-o", path("log.csv")});
    ASSERT_EQ(touch.exit_code, 0) << touch.err;
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void pack(const std::vector<std::string>& more = {}) {
    ASSERT_EQ(runRelievo({"project", "new", path("log.csv"), "-o", path("p.json"), "--recording",
                          path("log.csv")})
                  .exit_code,
              0);
    std::vector<std::string> words{"project", "package", path("p.json"), "-o", path("p.zip")};
    words.insert(words.end(), more.begin(), more.end());
    const CommandResult packed = runRelievo(words);
    ASSERT_EQ(packed.exit_code, 0) << packed.err;
  }
  CommandResult verify(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"replay", path("p.zip"), "--verify", "--report", "json"};
    words.insert(words.end(), more.begin(), more.end());
    return runRelievo(words);
  }
  void replaceInLog(const std::string& from, const std::string& to) const {
    std::ifstream in(path("log.csv"));
    std::string text((std::istreambuf_iterator<char>(in)), {});
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, from.size(), to);
    std::ofstream(path("log.csv")) << text;
  }

  fs::path folder_;
};

TEST_F(PackageVerify, RepeatsEveryRecordingOnThePackedInput) {
  pack();
  fs::remove(path("relief.ply"));  // The package must be enough.
  fs::remove(path("log.csv"));
  const CommandResult result = verify();
  ASSERT_EQ(result.exit_code, 0) << result.err << result.out;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["identical"], true);
  ASSERT_EQ(report["recordings"].size(), 1U);
  EXPECT_EQ(report["recordings"][0]["replayed"], true);
  EXPECT_GT(report["recordings"][0]["ticks"], 1000);
  EXPECT_EQ(report["recordings"][0]["different_ticks"], 0);
}

TEST_F(PackageVerify, EndsWithFiveWhereARecordingIsAnotherSurfaces) {
  replaceInLog("\"240,60,50,50\"", "\"230,60,50,50\"");
  pack();
  const CommandResult result = verify();
  EXPECT_EQ(result.exit_code, 5) << result.out;
  EXPECT_EQ(json::parse(result.out)["identical"], false);
}

TEST_F(PackageVerify, AsksForAnInputThatMayNotBeGivenAway) {
  pack({"--without-input"});
  EXPECT_EQ(verify().exit_code, 2);
  const CommandResult given = verify({"--input", path("relief.ply")});
  EXPECT_EQ(given.exit_code, 0) << given.err;
}

TEST_F(PackageVerify, EndsWithFiveWhereAByteDiffers) {
  pack();
  {
    std::fstream zip(path("p.zip"), std::ios::in | std::ios::out | std::ios::binary);
    zip.seekp(static_cast<std::streamoff>(fs::file_size(path("p.zip")) / 2));
    zip.put('\x55');
    zip.put('\x2a');
  }
  const CommandResult result = verify();
  EXPECT_EQ(result.exit_code, 5) << result.err;
}

}  // namespace
}  // namespace relievo
