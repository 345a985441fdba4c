// SPDX-License-Identifier: BSD-3-Clause
// replay --verify on a package for citation: every checksum, and every recording to the last bit.
#include <filesystem>
#include <fstream>

#include "core/project/package.h"
#include "tests/app/command_test.h"

namespace relievo {
namespace {

using nlohmann::json;
using test::CommandResult;
using test::runRelievo;
namespace fs = std::filesystem;

class PackageVerify : public test::CommandTest {
 protected:
  void SetUp() override {
    fs::copy_file(test::kReliefF, path("relief.ply"));
    const CommandResult touch = runRelievo({"touch", path("relief.ply"), "--unit", "mm", "--view",
                                            "top", "--cells", "300", "--region", "240,60,50,50",
                                            "--stroke", test::kFlatStroke, "-o", path("log.csv")});
    ASSERT_EQ(touch.exit_code, 0) << touch.err;
  }
  void pack(const std::vector<std::string>& more = {}) {
    ASSERT_EQ(runRelievo({"project", "new", path("log.csv"), "-o", path("p.json"), "--recording",
                          path("log.csv")})
                  .exit_code,
              0);
    const CommandResult packed =
        runRelievo(test::joined({"project", "package", path("p.json"), "-o", path("p.zip")}, more));
    ASSERT_EQ(packed.exit_code, 0) << packed.err;
  }
  CommandResult verify(const std::vector<std::string>& more = {}) const {
    return runRelievo(
        test::joined({"replay", path("p.zip"), "--verify", "--report", "json"}, more));
  }
  void replaceInLog(const std::string& from, const std::string& to) const {
    std::string text = test::bytesOf(path("log.csv"));
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, from.size(), to);
    write("log.csv", text);
  }
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

TEST_F(PackageVerify, ARecordingOfAnotherFileIsNotTakenAlong) {
  for (const std::string name : {"other.csv", "other.h5"}) {
    const CommandResult other = runRelievo(
        {"touch", plane(), "--unit", "mm", "--stroke", test::kFlatStroke, "-o", path(name)});
    ASSERT_EQ(other.exit_code, 0) << other.err;
    const CommandResult refused = runRelievo(
        {"project", "new", path("log.csv"), "-o", path("p.json"), "--recording", path(name)});
    EXPECT_EQ(refused.exit_code, 1) << refused.out;
    EXPECT_NE(refused.err.find(name + " is a recording of plane.xyz"), std::string::npos)
        << refused.err;
    EXPECT_FALSE(fs::exists(path("p.json")));
  }
}

TEST_F(PackageVerify, AnHdf5LogIsEnoughForAProject) {
  const CommandResult made = runRelievo(
      {"touch", plane(), "--unit", "mm", "--stroke", test::kFlatStroke, "-o", path("plane.h5")});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const CommandResult project =
      runRelievo({"project", "new", path("plane.h5"), "-o", path("p.json")});
  ASSERT_EQ(project.exit_code, 0) << project.err;
  const CommandResult info = runRelievo({"project", "info", path("p.json"), "--report", "json"});
  EXPECT_EQ(json::parse(info.out)["input"], plane()) << info.err;
}

TEST_F(PackageVerify, HoldsTheRastersOfFirmGroundThatItsRecordingsNeed) {
  fs::create_directories(path("other"));
  const auto raster = [this](const std::string& name, const char* parts) {
    write(name, "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 100\n" + std::string(parts));
    return path(name);
  };
  const std::string one = raster("firm.asc", "1 0 1 0 1 0\n");
  const std::string two = raster("other/firm.asc", "0 1 0.5 1 0 1\n");  // Of the same name.
  std::vector<std::string> project{"project", "new", path("log.csv"), "-o", path("p.json")};
  for (const auto& [log, firmness] : {std::pair{"a.csv", one}, std::pair{"b.csv", two}}) {
    const CommandResult touch =
        runRelievo({"touch", path("relief.ply"), "--unit", "mm", "--view", "top", "--cells", "300",
                    "--region", "180,60,100,100", "--soft", "0.3", "--firmness", firmness,
                    "--stroke", test::kFlatStroke, "-o", path(log)});
    ASSERT_EQ(touch.exit_code, 0) << touch.err;
    project.insert(project.end(), {"--recording", path(log)});
  }
  EXPECT_NE(test::bytesOf(path("a.csv")), test::bytesOf(path("b.csv")));
  ASSERT_EQ(runRelievo(project).exit_code, 0);
  const std::vector<std::string> pack{"project", "package", path("p.json"), "-o", path("p.zip")};
  ASSERT_EQ(runRelievo(pack).exit_code, 0);
  for (const char* gone : {"relief.ply", "firm.asc", "other/firm.asc"}) fs::remove(path(gone));
  const CommandResult result = verify();
  EXPECT_EQ(result.exit_code, 0) << result.err << result.out;
  EXPECT_EQ(json::parse(result.out)["recordings"].size(), 2U);

  const CommandResult without = runRelievo(pack);
  EXPECT_NE(without.exit_code, 0) << "its input is gone";
  raster("relief.ply", "");
  const CommandResult changed = runRelievo(test::joined(pack, {"--without-input"}));
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_NE(changed.err.find("firm.asc', which is not there (E501)"), std::string::npos)
      << changed.err;
}

/// Whoever made a package chose the names in it: none may lead to a file of whoever checks it.
TEST_F(PackageVerify, ReadsNothingOutsideOfThePackage) {
  fs::create_directories(path("private"));
  write("private/firm.asc",
        "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 100\n1 0 1 0 1 0\n");
  const CommandResult touch =
      runRelievo({"touch", path("relief.ply"), "--unit", "mm", "--view", "top", "--cells", "300",
                  "--region", "180,60,100,100", "--soft", "0.3", "--firmness",
                  path("private/firm.asc"), "--stroke", test::kFlatStroke, "-o", path("log.csv")});
  ASSERT_EQ(touch.exit_code, 0) << touch.err;
  Project project = readProject([this] {
    const CommandResult made = runRelievo(
        {"project", "new", path("log.csv"), "-o", path("p.json"), "--recording", path("log.csv")});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    return path("p.json");
  }());
  writePackage(path("p.zip"), project, {});  // Without what the recording needs.
  const CommandResult result = verify();
  EXPECT_EQ(result.exit_code, 5) << result.out;
  const std::string problem = json::parse(result.out)["recordings"][0]["problem"];
  EXPECT_NE(problem.find("'firm.asc', which the package does not hold"), std::string::npos)
      << problem;
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

TEST_F(PackageVerify, InfoNamesWhatTellsOfAPackage) {
  pack();
  const CommandResult info = runRelievo({"info", path("p.zip")});
  EXPECT_EQ(info.exit_code, 2);
  EXPECT_NE(info.err.find("p.zip: it is a package for citation, not a scan. 'relievo project info' "
                          "says what it holds"),
            std::string::npos)
      << info.err;
  const CommandResult held = runRelievo({"project", "info", path("p.zip"), "--report", "json"});
  ASSERT_EQ(held.exit_code, 0) << held.err;
  const json report = json::parse(held.out);
  EXPECT_EQ(report["input"], "input/relief.ply");
  EXPECT_EQ(report["recordings"], json::array({"recordings/log.csv"}));
  EXPECT_FALSE(fs::exists(path("input"))) << "nothing is unpacked";

  write("other.zip", "PK\x03\x04 of somebody else");
  const CommandResult other = runRelievo({"info", path("other.zip")});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("it is a ZIP archive; unpack it first"), std::string::npos) << other.err;
}

}  // namespace
}  // namespace relievo
