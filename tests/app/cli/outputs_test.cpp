// SPDX-License-Identifier: BSD-3-Clause
// No output takes the place of what it is made from, or of another output.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "tests/app/command_test.h"

namespace relievo::test {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

class Outputs : public CommandTest {
 protected:
  /// Every file of the folder with its bytes.
  std::map<std::string, std::string> everything() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
      if (entry.is_regular_file()) all[entry.path().string()] = bytesOf(entry.path().string());
    }
    return all;
  }
  /// A map of 21 x 21 cells.
  std::string map(const std::string& name) const {
    std::ostringstream text;
    for (int y = 0; y <= 20; ++y) {
      for (int x = 0; x <= 20; ++x) text << x << ' ' << y << ' ' << 5 + x / 10.0 << '\n';
    }
    must({"depthmap", write("small.xyz", text.str()), "--unit", "mm", "--view", "top", "--cells",
          "21", "-o", path(name)});
    return path(name);
  }
  void must(const Words& words) const {
    const CommandResult result = runRelievo(words);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  void isRefused(const Words& words, const std::string& what) const {
    const auto before = everything();
    const CommandResult result = runRelievo(words);
    std::string line;
    for (const std::string& word : words) line += word + " ";
    EXPECT_EQ(result.exit_code, 1) << line << result.err;
    EXPECT_NE(result.err.find(what), std::string::npos) << line << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << line << result.err;
    EXPECT_TRUE(everything() == before) << line;
  }
};

constexpr const char* kScan = "is the scan itself. Nothing was written. Choose another name.";

TEST_F(Outputs, OfNoVerbReplaceTheScan) {
  const std::string m = map("m.tif");
  const std::string cloud = write("cloud.csv", "x,y,z\n0,0,1\n1,0,2\n0,1,3\n1,1,4\n");
  const std::string grid = path("t.asc");
  must({"convert", m, grid});
  const std::vector<Words> commands{
      {"figure", cloud, "--caption", cloud, "-o", path("q.png")},
      {"measure", cloud, "--view", "top", "--point", "0,0", "-o", cloud},
      {"figure", m, "--heights", m, "-o", path("h.png")},
      {"figure", m, "-o", m},
      {"figure", m, "-o", path("h.png"), "--window-out", m},
      {"render", m, "-o", m},
      {"render", m, "--window-out", m, "-o", path("h.png")},
      {"render", m, "--caption", m, "-o", path("h.png")},
      {"convert", m, m},
      {"convert", grid, grid, "--relief", "slope"},
      {"depthmap", m, "-o", m},
      {"depthmap", m, "--memory", "100", "-o", m},
      {"fill", m, "-o", m},
      {"touch", m, "--stroke", kFlatStroke, "-o", m},
      {"touch", m, "--stroke", kFlatStroke, "--plot", m, "-o", path("log.csv")},
      {"touch", m, "--stroke", kFlatStroke, "--window-out", m, "-o", path("log.csv")},
  };
  for (const Words& words : commands) isRefused(words, kScan);
}

TEST_F(Outputs, AreTheScanByAnyOtherNameAsWell) {
  const std::string m = map("m.tif");
  fs::create_symlink("m.tif", path("link.tif"));
  fs::create_directory(path("sub"));
  isRefused({"render", m, "-o", path("link.tif")}, kScan);
  isRefused({"render", path("link.tif"), "-o", m}, kScan);
  isRefused({"render", m, "-o", path("sub/../m.tif")}, kScan);
}

TEST_F(Outputs, DoNotReplacePartsOfAMap) {
  const std::string m = map("m.tif");
  const std::string part = "is a part of the map that is read.";
  isRefused({"render", m, "-o", path("m.origin.tif")}, part);
  const std::string wide = path("wide.tif"), tiled = path("tiled.L0.tif");
  must({"depthmap", path("small.xyz"), "--unit", "mm", "--view", "top", "--cells", "500", "-o",
        wide});
  must({"pyramid", wide, "--memory", "400", "-o", path("tiled.tif")});
  isRefused({"render", tiled, "-o", path("tiled.L1.tif")}, part);
  isRefused({"pyramid", tiled, "-o", path("tiled.tif")}, kScan);
  must({"pyramid", m, "-o", m});  // m.L0.tif and so on: the levels are other files than the map,
  must({"pyramid", m, "-o", m});  // and may be made again.
}

TEST_F(Outputs, DoNotReplaceWhatIsTouchedWith) {
  const std::string m = map("m.tif");
  const std::string stroke = path("stroke.csv");
  fs::copy_file(kFlatStroke, stroke);
  const std::string firm = path("firm.asc");
  must({"convert", m, firm});
  const std::string log = path("log.csv");
  isRefused({"touch", m, "--stroke", stroke, "-o", stroke}, "is the stroke that is read.");
  isRefused({"touch", m, "--stroke", stroke, "--firmness", firm, "-o", log, "--plot", firm},
            "is the stiffness map that is read.");
  must({"touch", m, "--stroke", stroke, "-o", log});
  isRefused({"record", m, "--seconds", "0.1", "-o", m}, kScan);
  isRefused({"replay", log, "-o", log}, "is the recording that is read.");
  isRefused({"replay", log, "-o", m}, kScan);
  isRefused({"video", log, "-o", log}, "is the recording that is read.");
  isRefused({"video", log, "--frame", "0", "-o", m}, kScan);
  isRefused(
      {"figure", m, "--layout", "plot", "--recording", log, "--caption", log, "-o", path("f.png")},
      "is the recording that is read.");
}

TEST_F(Outputs, DoNotReplaceWhatAStateNames) {
  const std::string m = map("m.tif");
  const std::string picture = path("p.png"), project = path("p.json");
  must({"render", m, "--pixels", "64", "-o", picture});
  must({"project", "new", picture, "-o", project});
  isRefused({"render", "--from-image", picture, "-o", picture}, "is the picture that is read.");
  isRefused({"render", "--from-image", picture, "--caption", m, "-o", path("q.png")}, kScan);
  isRefused({"figure", "--project", project, "--caption", project, "-o", path("q.png")},
            "is the project that is read.");
  isRefused({"figure", "--project", project, "--heights", m, "-o", path("q.png")}, kScan);
  isRefused({"project", "new", picture, "-o", picture}, "is the file that is read.");
  isRefused({"project", "new", picture, "-o", m}, kScan);
  isRefused({"project", "package", project, "-o", project}, "is the file that is read.");
  isRefused({"project", "package", project, "--figure", picture, "-o", picture},
            "is a figure that is packed.");
  isRefused({"project", "relink", project, "-o", m}, kScan);
  fs::create_directory(path("moved"));
  fs::rename(m, path("moved/m.tif"));
  must({"project", "relink", project});  // Its own file, as is meant.
}

/// The system's name of an open file, behind which there may be a regular one.
TEST_F(Outputs, DoNotReplaceTheNameOfAnOpenFile) {
  const std::string m = map("m.tif");
  const std::string opened = path("opened.txt"), link = path("stdout.png");
  const int descriptor = ::open(opened.c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_GE(descriptor, 0);
  const std::string name = "/proc/" + std::to_string(::getpid()) + "/fd/";
  fs::create_symlink(name + std::to_string(descriptor), link);
  const CommandResult result = runRelievo({"render", m, "--pixels", "64", "-o", link});
  ::close(descriptor);
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_NE(result.err.find("is no regular file"), std::string::npos) << result.err;
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(fs::file_size(opened), 0U);
}

TEST_F(Outputs, GoBehindLinksAndStopAtReadOnlyFiles) {
  const std::string m = map("m.tif"), kept = path("kept.png"), link = path("link.png");
  std::ofstream(kept) << "old";
  fs::permissions(kept, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  fs::create_symlink("kept.png", link);
  must({"render", m, "--pixels", "64", "-o", link});
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_GT(fs::file_size(kept), 100U);
  EXPECT_EQ(fs::status(kept).permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  fs::permissions(kept, fs::perms::owner_read);
  const CommandResult result = runRelievo({"render", m, "--pixels", "32", "-o", kept});
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_NE(result.err.find("it is read-only"), std::string::npos) << result.err;
}

TEST_F(Outputs, OfOneCommandAreDifferentFiles) {
  const std::string m = map("m.tif");
  const std::string two = "Two of the outputs would be";
  const std::string same = path("same.csv");
  isRefused({"measure", m, "--profile", "1,1,9,9", "--profile-csv", same, "-o", same}, two);
  isRefused({"measure", m, "--profile", "1,1,9,9", "--profile-csv", same, "-o",
             path("../" + folder_.path().filename().string() + "/same.csv")},
            two);
  isRefused({"render", m, "--caption", path("r.png"), "-o", path("r.png")}, two);
  isRefused({"touch", m, "--stroke", kFlatStroke, "--plot", same, "-o", same}, two);
  isRefused({"figure", m, "--window-out", path("f.tif"), "-o", path("f.tif")}, two);
}

}  // namespace
}  // namespace relievo::test
