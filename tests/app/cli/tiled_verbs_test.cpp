// SPDX-License-Identifier: BSD-3-Clause
// Maps by tiles by the command line, tried from outside: the same as maps in memory.
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/io/raster/raster.h"
#include "core/project/package.h"
#include "core/tiles/tiled_map.h"
#include "tests/app/command_test.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::CommandResult;
using test::runRelievo;

/// Relief F by tiles, 1500 cells across, and the same cells as one file.
class TiledVerbs : public test::CommandTest {
 protected:
  void SetUp() override {
    ASSERT_EQ(runRelievo({"depthmap", test::kReliefF, "--unit", "mm", "--view", "top", "--cells",
                          "1500", "--memory", "400", "-o", path("map.tif")})
                  .exit_code,
              0);
    ASSERT_TRUE(TiledMap::isOne(path("map.tif")));
    const RasterMap whole = readRaster(path("map.tif"));
    DepthMap map{.frame = {.size = whole.size,
                           .spacing_mm = whole.pixel,
                           .first_x_mm = whole.first.x,
                           .first_y_mm = whole.first.y},
                 .heights_mm = whole.values,
                 .origins = whole.origins};
    writeMap(path("plain.tif"), map, {.view_from_file = *whole.view_from_file});
    ASSERT_FALSE(TiledMap::isOne(path("plain.tif")));
  }
  /// Without what names the file.
  static std::string rowsOf(const std::string& csv) {
    std::istringstream in(csv);
    std::string rows;
    for (std::string line; std::getline(in, line);) {
      if (line[0] != '#') rows += line + '\n';
    }
    return rows;
  }
};

TEST_F(TiledVerbs, AreTheSameForAnyNumberOfThreads) {
  const auto made = [&](const std::string& threads) {
    const std::string file = path("by" + threads + ".tif");
    EXPECT_EQ(runRelievo({"depthmap", test::kReliefF, "--unit", "mm", "--view", "top", "--cells",
                          "900", "--memory", "400", "--threads", threads, "-o", file})
                  .exit_code,
              0);
    return file;
  };
  const RasterMap one = readRaster(made("1"));
  for (const char* threads : {"3", "7"}) {
    const RasterMap other = readRaster(made(threads));
    ASSERT_EQ(other.values.size(), one.values.size());
    const std::size_t bytes = one.values.size() * sizeof(float);  // NaN is no number's equal.
    EXPECT_EQ(std::memcmp(other.values.data(), one.values.data(), bytes), 0) << threads;
    EXPECT_EQ(other.origins, one.origins) << threads;
  }
}

TEST_F(TiledVerbs, ThreadsAreOfMapsByTilesAlone) {
  const auto refused = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"depthmap", test::kReliefF, "--unit", "mm", "-o", path("a.tif")};
    words.insert(words.end(), more.begin(), more.end());
    const CommandResult result = runRelievo(words);
    EXPECT_EQ(result.exit_code, 1) << result.err;
    return result.err;
  };
  EXPECT_NE(refused({"--threads", "2"}).find("--memory"), std::string::npos);
  for (const char* number : {"0", "65", "1.5", "two", "-1"}) {
    EXPECT_NE(refused({"--memory", "400", "--threads", number}).find("--threads"),
              std::string::npos)
        << number;
  }
  EXPECT_FALSE(fs::exists(path("a.tif")));
}

TEST_F(TiledVerbs, TakeSeveralFilesAndNameThemAll) {
  // A PLY of three pieces: numbers of 24 bytes, as the sample has them or not.
  const auto piece = [&](const std::string& name, int first, int end) {
    std::ofstream out(path(name), std::ios::binary);
    out << "ply\nformat binary_little_endian 1.0\nelement vertex " << end - first
        << "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    for (int i = first; i < end; ++i) {
      const double p[] = {(i % 200) * 0.5, (i / 200) * 0.5, std::sin(i * 0.01)};
      out.write(reinterpret_cast<const char*>(p), sizeof(p));
    }
  };
  fs::create_directories(path("site"));
  piece("site/a.ply", 0, 7'000);
  piece("site/b.ply", 7'000, 30'000);
  piece("whole.ply", 0, 30'000);
  const auto made = [&](const std::vector<std::string>& inputs, const std::string& map) {
    std::vector<std::string> words{"depthmap"};
    words.insert(words.end(), inputs.begin(), inputs.end());
    for (const char* word : {"--unit", "mm", "--view", "top", "--spacing", "0.5", "--memory", "300",
                             "--report", "json", "-o"}) {
      words.emplace_back(word);
    }
    words.push_back(path(map));
    const CommandResult result = runRelievo(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return readRaster(path(map)).values;
  };
  const std::vector<float> whole = made({path("whole.ply")}, "one.tif");
  const auto is_whole = [&](const std::vector<float>& values) {  // NaN is no number's equal.
    return values.size() == whole.size() &&
           std::memcmp(values.data(), whole.data(), 4 * whole.size()) == 0;
  };
  EXPECT_GT(whole.size(), 20'000U);
  EXPECT_TRUE(is_whole(made({path("site")}, "folder.tif")));
  EXPECT_TRUE(is_whole(made({path("site/b.ply"), path("site/a.ply")}, "names.tif")));
  EXPECT_TRUE(is_whole(made({path("site/*.ply")}, "pattern.tif")));
  const std::string tiff = test::bytesOf(path("folder.tif"));
  for (const char* name : {"a.ply", "b.ply"}) {
    EXPECT_NE(tiff.find(std::string("site/") + name), std::string::npos) << name;
  }
  EXPECT_NE(tiff.find("\"files\":["), std::string::npos);
  const CommandResult without =
      runRelievo({"depthmap", path("site/a.ply"), path("site/b.ply"), "-o", path("no.tif")});
  EXPECT_EQ(without.exit_code, 1);
  EXPECT_NE(without.err.find("--memory"), std::string::npos) << without.err;
  EXPECT_EQ(
      runRelievo({"depthmap", path("site"), "--memory", "300", "-o", path("site/a.ply")}).exit_code,
      1)
      << "an input is no output";
}

TEST_F(TiledVerbs, KeepWhatIsFinishedForTheSameCommand) {
  const std::vector<std::string> words{"depthmap", test::kReliefF, "--unit", "mm",       "--view",
                                       "top",      "--cells",      "1500",   "--memory", "400",
                                       "--job",    path("job"),    "-o"};
  const auto run = [&](std::vector<std::string> more) {
    std::vector<std::string> all = words;
    all.insert(all.end(), more.begin(), more.end());
    return runRelievo(all);
  };
  const CommandResult made = run({path("kept.tif"), "--report", "json"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(json::parse(made.out)["taken_over"]["rows_of_tiles"], 0);
  EXPECT_FALSE(fs::exists(path("job"))) << "the work is done";
  EXPECT_EQ(test::bytesOf(path("kept.L1.tif")), test::bytesOf(path("map.L1.tif")));
  fs::create_directories(path("job"));
  std::ofstream(path("job/work.txt")) << "relievo work 1\nan option\t0\n";
  const CommandResult other = run({path("other.tif")});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.err.find("differs"), std::string::npos) << other.err;
  EXPECT_FALSE(fs::exists(path("other.tif")));
  const CommandResult alone =
      runRelievo({"depthmap", test::kReliefF, "--job", path("job"), "-o", path("other.tif")});
  EXPECT_EQ(alone.exit_code, 1);
  EXPECT_NE(alone.err.find("--memory"), std::string::npos) << alone.err;
}

TEST_F(TiledVerbs, MeasureTheSameWithoutReadingThemWhole) {
  const auto measured = [&](const std::string& map) {
    const CommandResult result =
        runRelievo({"measure",           path(map),       "--point",
                    "40.03,29.97",       "--depth",       "20,20,70,60",
                    "--profile",         "3,3,90,70",     "--area",
                    "10,10,90,10,90,70", "--plane",       "1",
                    "--section",         "0,0,1,4",       "--profile-csv",
                    path(map + ".csv"),  "--section-csv", path(map + ".cut.csv"),
                    "--report",          "json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::parse(result.out);
  };
  const json tiled = measured("map.tif");
  EXPECT_EQ(tiled, measured("plain.tif"));
  EXPECT_GT(tiled["measurements"].back()["curves"].size(), 0U);
  EXPECT_EQ(rowsOf(test::bytesOf(path("map.tif.csv"))),
            rowsOf(test::bytesOf(path("plain.tif.csv"))));
  EXPECT_EQ(rowsOf(test::bytesOf(path("map.tif.cut.csv"))),
            rowsOf(test::bytesOf(path("plain.tif.cut.csv"))));
}

/// Rows of comma-separated values without one of their columns.
std::string without(const std::string& column, const std::string& rows) {
  std::istringstream in(rows);
  std::string kept;
  std::size_t left_out = std::string::npos;
  for (std::string line; std::getline(in, line);) {
    std::istringstream cells(line);
    std::size_t i = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++i) {
      if (cell == column) left_out = i;
      if (i != left_out) kept += cell + ',';
    }
    kept += '\n';
  }
  EXPECT_NE(left_out, std::string::npos);
  return kept;
}

TEST_F(TiledVerbs, FeelTheSameAtEveryLevel) {
  std::ofstream(path("s.csv")) << "t_s,x_mm,y_mm,z_mm\n0,40,30,9\n0.05,40,30,1\n0.15,44,33,1\n";
  for (const char* level : {"0", "1", "2"}) {
    const auto felt = [&](const std::string& map) {
      const CommandResult result =
          runRelievo({"touch", path(map), "--region", "30,20,20,20", "--level", level, "--stroke",
                      path("s.csv"), "-o", path(map + ".log.csv")});
      EXPECT_EQ(result.exit_code, 0) << result.err;
      return rowsOf(test::bytesOf(path(map + ".log.csv")));
    };
    const std::string tiled = felt("map.tif");
    EXPECT_GT(tiled.size(), 10'000U);
    const std::string whole = felt("plain.tif");
    if (level == std::string("0")) {
      EXPECT_EQ(tiled, whole);
    }
    // At a coarse level a window's origins are those of its nodes (docs/adr/0037).
    EXPECT_EQ(without("origin", tiled), without("origin", whole)) << level;
  }
}

TEST_F(TiledVerbs, AreDrawnAndPackedWithAllTheirLevels) {
  const CommandResult drawn = runRelievo({"figure", path("map.tif"), "--region", "30,20,20,20",
                                          "--dpi", "60", "-o", path("fig.png"), "--report", "json"},
                                         {"DISPLAY"});
  ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_NE(json::parse(drawn.out)["caption"].get<std::string>().find("Depth map of 1500"),
            std::string::npos)
      << drawn.out;
  ASSERT_EQ(runRelievo({"project", "new", path("fig.png"), "-o", path("p.json")}).exit_code, 0);
  const CommandResult packed =
      runRelievo({"project", "package", path("p.json"), "-o", path("cite.zip")});
  ASSERT_EQ(packed.exit_code, 0) << packed.err;
  fs::create_directories(path("out"));
  unpackPackage(path("cite.zip"), path("out"));
  const TiledMap there(path("map.tif"));
  const TiledMap here(path("out/input/map.tif"));
  EXPECT_EQ(here.frames(), there.frames());
  EXPECT_TRUE(verifyPackage(path("cite.zip")).problems.empty());
}

}  // namespace
}  // namespace relievo
