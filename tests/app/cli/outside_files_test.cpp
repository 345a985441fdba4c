// SPDX-License-Identifier: BSD-3-Clause
// A project, picture or log from elsewhere names files; whoever opens it is asked before those are
// read that lie outside of its folder (docs/adr/0136-outside-files.md).
#include <gmock/gmock.h>

#include <filesystem>

#include "core/project/project.h"
#include "tests/app/command_test.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::CommandResult;
using test::joined;
using test::runRelievo;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class OutsideFiles : public test::CommandTest {
 protected:
  void SetUp() override {
    for (const char* name : {"work", "scans", "private"}) fs::create_directories(path(name));
    fs::copy_file(plane(), path("scans/plane.xyz"));
    write("private/notes.xyz", "my password is 1234\nand more of it\n");
    const CommandResult drawn = runRelievo({"render", path("scans/plane.xyz"), "--unit", "mm",
                                            "--view", "top", "-o", path("work/own.png")});
    ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
    ASSERT_EQ(
        runRelievo({"project", "new", path("work/own.png"), "-o", path("work/own.json")}).exit_code,
        0);
  }
  /// A project as somebody else may send it: of a file of whoever opens it.
  std::string hostile(const std::string& file) const {
    Project project = readProject(path("work/own.json"));
    project.file = file;
    project.sha256.clear();
    project.bytes = 0;
    writeProject(path("work/hostile.json"), project);
    return path("work/hostile.json");
  }
  static void expectRefused(const std::vector<std::string>& words) {
    const CommandResult refused = runRelievo(words);
    EXPECT_EQ(refused.exit_code, 2) << words[0] << refused.out;
    EXPECT_THAT(refused.err, AllOf(HasSubstr("lies outside of its folder"),
                                   HasSubstr("--outside-files allow"), Not(HasSubstr("1234"))))
        << words[0];
    EXPECT_THAT(refused.out, Not(HasSubstr("1234")));
  }
};

TEST_F(OutsideFiles, OfOnesOwnProjectsAndPicturesAreReadWithoutAQuestion) {
  for (const std::vector<std::string>& host_file :
       {std::vector<std::string>{"--project", path("work/own.json")},
        std::vector<std::string>{"--from-image", path("work/own.png")}}) {
    for (const char* verb : {"render", "figure"}) {
      const CommandResult drawn =
          runRelievo(joined(joined({verb}, host_file), {"-o", path("again.png")}));
      EXPECT_EQ(drawn.exit_code, 0) << verb << drawn.err;
    }
  }
}

TEST_F(OutsideFiles, ThatAForeignProjectNamesAreRefusedUnlessAllowed) {
  for (const std::string& file : {path("private/notes.xyz"), std::string("/etc/passwd")}) {
    for (const char* verb : {"render", "figure"}) {
      expectRefused({verb, "--project", hostile(file), "-o", path("new.png")});
      EXPECT_FALSE(fs::exists(path("new.png")));
    }
  }
  const std::vector<std::string> render{"render", "--project", hostile(path("scans/plane.xyz")),
                                        "-o", path("new.png")};
  expectRefused(render);
  const CommandResult allowed = runRelievo(joined(render, {"--outside-files", "allow"}));
  EXPECT_EQ(allowed.exit_code, 0) << allowed.err;
  fs::remove(path("new.png"));
  auto given = render;
  given.insert(given.begin() + 1, path("scans/plane.xyz"));
  EXPECT_EQ(runRelievo(given).exit_code, 0) << "whoever opens it named it";
}

TEST_F(OutsideFiles, AreRefusedBehindALinkInTheFolder) {
  fs::create_symlink(path("private/notes.xyz"), path("work/notes.xyz"));
  // writeProject() would follow the link.
  const std::string project = hostile(path("work/plane.xyz"));
  std::string text = test::bytesOf(project);
  text.replace(text.find("plane.xyz"), 9, "notes.xyz");
  write("work/hostile.json", text);
  expectRefused({"render", "--project", project, "-o", path("new.png")});
}

TEST_F(OutsideFiles, ThatAreNotWhatAProjectWasMadeFromNeedBothLeaves) {
  write("scans/plane.xyz", test::bytesOf(path("scans/plane.xyz")) + "50 50 11\n");
  const std::vector<std::string> render{"render", "--project", path("work/own.json"), "-o",
                                        path("new.png")};
  EXPECT_EQ(runRelievo(render).exit_code, 5) << "its checksum differs";
  expectRefused(joined(render, {"--changed-input"}));
  const CommandResult both =
      runRelievo(joined(render, {"--changed-input", "--outside-files", "allow"}));
  EXPECT_EQ(both.exit_code, 0) << both.err;
}

TEST_F(OutsideFiles, ThatAForeignLogsCommandNamesAreRefused) {
  const CommandResult touch =
      runRelievo({"touch", path("scans/plane.xyz"), "--unit", "mm", "--view", "top", "--stroke",
                  write("flat.csv", "t_s,x_mm,y_mm,z_mm\n0,50,50,20\n0.02,50,50,1\n"), "-o",
                  path("work/log.csv")});
  ASSERT_EQ(touch.exit_code, 0) << touch.err;
  EXPECT_EQ(runRelievo({"replay", path("work/log.csv"), "--verify"}).exit_code, 0);
  std::string log = test::bytesOf(path("work/log.csv"));
  const std::string named = path("scans/plane.xyz"), secret = path("private/notes.xyz");
  for (std::size_t at = log.find(named); at != std::string::npos; at = log.find(named, at + 1)) {
    log.replace(at, named.size(), secret);
  }
  write("work/hostile.csv", log);
  expectRefused({"replay", path("work/hostile.csv")});
  const CommandResult given =
      runRelievo({"replay", path("work/hostile.csv"), "--input", path("scans/plane.xyz")});
  EXPECT_EQ(given.exit_code, 0) << given.err;
}

TEST_F(OutsideFiles, ThatAForeignRecipeNamesAreRefused) {
  const CommandResult own =
      runRelievo({"prepare", path("scans/plane.xyz"), "--unit", "mm", "--thin", "2", "-o",
                  path("work/thin.ply"), "--write-recipe", path("work/own.recipe.json")});
  ASSERT_EQ(own.exit_code, 0) << own.err;
  const std::vector<std::string> again{"prepare", "--recipe", path("work/own.recipe.json"), "-o",
                                       path("work/again.ply")};
  const CommandResult read = runRelievo(again);
  EXPECT_EQ(read.exit_code, 0) << read.err;
  json recipe = json::parse(test::bytesOf(path("work/own.recipe.json")));
  for (json& scan : recipe["scans"]) {
    scan["file"] = "../private/notes.xyz";
    scan.erase("sha256");
  }
  write("work/hostile.recipe.json", recipe.dump());
  expectRefused(
      {"prepare", "--recipe", path("work/hostile.recipe.json"), "-o", path("work/hostile.ply")});
}

TEST_F(OutsideFiles, ThatAForeignProjectWouldPlotAreRefused) {
  Project project = readProject(path("work/own.json"));
  project.figure.layout = FigureLayout::plot;
  project.figure.recording = path("private/notes.xyz");
  writeProject(path("work/hostile.json"), project);
  expectRefused({"figure", "--project", path("work/hostile.json"), "-o", path("new.png")});
}

}  // namespace
}  // namespace relievo
