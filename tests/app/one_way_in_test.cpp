// SPDX-License-Identifier: BSD-3-Clause
// The program parses no scan and no raster, whatever is done with it: an import process does
// (docs/adr/0146). Two judges: readers end a process in which they are forbidden, and
// reader_preload.cpp sees from outside which bytes of an input the program itself comes to.
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/io/formats/pcd_header.h"
#include "core/io/formats/ply_header.h"
#include "core/io/input_facts.h"
#include "core/io/las/las_header.h"
#include "core/io/point_reader.h"
#include "core/io/raster/embedded_state.h"
#include "core/io/raster/picture_pixels.h"
#include "core/io/raster/tiff_head.h"
#include "core/io/read_scan.h"
#include "core/io/worker/reader_guard.h"
#include "tests/app/command_test.h"
#include "tests/app/program_window.h"
#include "tests/core/io/e57_sample.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/io/laz_sample.h"
#include "tests/core/io/sample_files.h"

namespace relievo {
namespace {

using namespace std::string_literals;
using test::bytesOf;
using test::runRelievo;

constexpr int kSide = 40;

float heightAt(int x, int y) {
  return std::round(8 * std::sin(0.2F * static_cast<float>(x)) *
                    std::cos(0.2F * static_cast<float>(y)));
}

/// Calls take(x, y, z) for the points of a small field of hills.
void forEachPoint(const std::function<void(int x, int y, float z)>& take) {
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) take(x, y, heightAt(x, y));
  }
}

std::string textPoints(const std::string& behind = "") {
  std::string text;
  forEachPoint([&](int x, int y, float z) {
    text += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + behind + "\n";
  });
  return text;
}

std::string binaryPoints() {
  std::string bytes;
  forEachPoint([&](int x, int y, float z) {
    bytes += bytesOf(static_cast<float>(x)) + bytesOf(static_cast<float>(y)) + bytesOf(z);
  });
  return bytes;
}

std::string lasPoints(const test::Las& base = {}) {
  test::Las las = base;
  forEachPoint([&](int x, int y, float z) {
    las.raw.push_back({4 * x, 4 * y, static_cast<std::int32_t>(4 * z)});
  });
  las.promised = las.legacy_promised = static_cast<std::uint32_t>(las.raw.size());
  return lasFile(las);
}

std::string pcdPoints() {
  test::PcdWords words;
  words.points = std::to_string(kSide * kSide);
  words.data = "binary";
  return pcdHeader(words) + binaryPoints();
}

/// Two triangles between any four neighbours, as numbers of the points from `first` on.
void forEachTriangle(const std::function<void(int a, int b, int c)>& take) {
  for (int y = 0; y + 1 < kSide; ++y) {
    for (int x = 0; x + 1 < kSide; ++x) {
      const int corner = y * kSide + x;
      take(corner, corner + 1, corner + kSide);
      take(corner + 1, corner + kSide + 1, corner + kSide);
    }
  }
}

std::string objMesh() {
  std::string text = "mtllib nowhere.mtl\n";
  forEachPoint([&](int x, int y, float z) {
    text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
  });
  forEachTriangle([&](int a, int b, int c) {
    text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " +
            std::to_string(c + 1) + "\n";
  });
  return text;
}

std::string stlMesh() {
  const std::string points = binaryPoints();
  std::string triangles;
  std::uint32_t count = 0;
  forEachTriangle([&](int a, int b, int c) {
    triangles += std::string(12, '\0');
    for (const int corner : {a, b, c}) {
      triangles += points.substr(12 * static_cast<std::size_t>(corner), 12);
    }
    triangles += std::string(2, '\0');
    ++count;
  });
  return std::string(80, ' ') + bytesOf(count) + triangles;
}

std::string threeDsMesh() {
  const auto chunk = [](std::uint16_t kind, const std::string& body) {
    return bytesOf(kind) + bytesOf(static_cast<std::uint32_t>(6 + body.size())) + body;
  };
  std::string faces;
  std::uint16_t count = 0;
  forEachTriangle([&](int a, int b, int c) {
    for (const int corner : {a, b, c, 7}) faces += bytesOf(static_cast<std::uint16_t>(corner));
    ++count;
  });
  const std::string vertices =
      chunk(0x4110, bytesOf(static_cast<std::uint16_t>(kSide * kSide)) + binaryPoints());
  const std::string object =
      chunk(0x4000, "a\0"s + chunk(0x4100, vertices + chunk(0x4120, bytesOf(count) + faces)));
  return chunk(0x4D4D, chunk(0x3D3D, object));
}

std::string e57Points() {
  std::array<std::string, 3> floats;
  forEachPoint([&](int x, int y, float z) {
    floats[0] += bytesOf(static_cast<float>(x));
    floats[1] += bytesOf(static_cast<float>(y));
    floats[2] += bytesOf(z);
  });
  const std::string single = R"(type="Float" precision="single")";
  test::E57Sample sample;
  sample.add({std::to_string(kSide * kSide),
              {{"cartesianX", single, floats[0]},
               {"cartesianY", single, floats[1]},
               {"cartesianZ", single, floats[2]}},
              {},
              {}});
  return sample.file();
}

std::string ptxPoints() {
  return std::to_string(kSide) + "\n" + std::to_string(kSide) +
         "\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n" + textPoints(" 0.5");
}

std::string asciiGrid() {
  std::string text = "ncols " + std::to_string(kSide) + "\nnrows " + std::to_string(kSide) +
                     "\nxllcorner 5\nyllcorner 6\ncellsize 1\n";
  forEachPoint(
      [&](int x, int, float z) { text += std::to_string(z) + (x + 1 == kSide ? "\n" : " "); });
  return text;
}

/// A raster of another program. @param facts  GDAL's entries; it may claim to be ours
void writeRaster(const std::string& file, const char* driver, GDALDataType type,
                 const std::vector<std::pair<std::string, std::string>>& facts = {}) {
  GDALAllRegister();
  GDALDriverManager& drivers = *GetGDALDriverManager();
  auto* const cells = drivers.GetDriverByName("MEM")->Create("", kSide, kSide, 1, type, nullptr);
  std::vector<float> heights;
  forEachPoint([&](int, int, float z) { heights.push_back(z + 20); });
  ASSERT_EQ(cells->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, kSide, kSide, heights.data(), kSide,
                                              kSide, GDT_Float32, 0, 0, nullptr),
            CE_None);
  for (const auto& [name, text] : facts) cells->SetMetadataItem(name.c_str(), text.c_str());
  auto* const copy = drivers.GetDriverByName(driver)->CreateCopy(file.c_str(), cells, 0, nullptr,
                                                                 nullptr, nullptr);
  ASSERT_NE(copy, nullptr) << file;
  GDALClose(copy);
  GDALClose(cells);
  std::filesystem::remove(file + ".aux.xml");
}

class OneWayIn : public test::CommandTest {
 protected:
  void SetUp() override {
    for (const char* variable :
         {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"}) {
      ASSERT_EQ(::setenv(variable, path(variable).c_str(), 1), 0);
    }
    const std::string points = std::to_string(kSide * kSide);
    scans_ = {write("a.xyz", textPoints()),
              write("a.csv", "x,y,z\n" + textPoints()),
              write("text.ply", test::plyHeader("ascii", points) + textPoints()),
              write("binary.ply", test::plyHeader("binary_little_endian", points) + binaryPoints()),
              write("a.pcd", pcdPoints()),
              write("a.obj", objMesh()),
              write("a.stl", stlMesh()),
              write("a.3ds", threeDsMesh()),
              write("a.las", lasPoints()),
              write("system.las", lasPoints(test::withRecord(test::geoKeys({{3072, 0, 1, 2225}})))),
              write("a.e57", e57Points()),
              write("a.ptx", ptxPoints())};
    test::Laz laz;
    laz.records = test::wanderingRecords(laz.how, 3000);
    laz.chunk_points = 1000;
    scans_.push_back(write("a.laz", lazFile(laz).bytes));
    rasters_ = {write("grid.asc", asciiGrid()), path("site.tif"), path("words.png"),
                path("claims.tif"), path("claims_tiles.tif")};
    writeRaster(path("site.tif"), "GTiff", GDT_Float32);
    writeRaster(path("words.png"), "PNG", GDT_UInt16);
    const std::string frame = "0.5 0.5 1";
    writeRaster(path("claims.tif"), "GTiff", GDT_Float32,
                {{"RELIEVO_VERSION", "1.0"}, {"RELIEVO_CONTENT", "map"}, {"RELIEVO_FRAME", frame}});
    writeRaster(path("claims_tiles.tif"), "GTiff", GDT_Float32,
                {{"RELIEVO_VERSION", "1.0"},
                 {"RELIEVO_LEVEL", "0"},
                 {"RELIEVO_LEVELS", "1"},
                 {"RELIEVO_FRAME", frame}});
    ASSERT_EQ(
        runRelievo({"depthmap", path("a.xyz"), "--unit", "mm", "-o", path("own.tif")}).exit_code,
        0);
    rasters_.push_back(path("own.tif"));
    ASSERT_EQ(runRelievo({"pyramid", path("a.las"), "--unit", "mm", "--memory", "500", "-o",
                          path("tiles.tif")})
                  .exit_code,
              0);
    rasters_.push_back(path("tiles.L0.tif"));
  }

  std::vector<std::string> all() const {
    std::vector<std::string> files = scans_;
    files.insert(files.end(), rasters_.begin(), rasters_.end());
    return files;
  }

  std::vector<std::string> guard(const std::string& input) {
    std::filesystem::remove(path("guard.log"));
    return {"LD_PRELOAD=" RELIEVO_READER_PRELOAD, "RELIEVO_GUARDED=" + input,
            "RELIEVO_GUARD_LOG=" + path("guard.log")};
  }
  /// What the program itself did with the input that it must not; tiles may be taken out.
  std::string judgement() const {
    std::string bad;
    std::istringstream lines(test::bytesOf(path("guard.log")));
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("cells ")) bad += line + "\n";
    }
    return bad;
  }

  /// Runs a verb on one input. Whether the file suits the verb is not the question here, but it
  /// must come to a decent end.
  void expectNothingParsed(const std::vector<std::string>& words, const std::string& input) {
    const test::CommandResult result = runRelievo(words, guard(input));
    EXPECT_LT(result.exit_code, 128) << result.err;
    EXPECT_EQ(judgement(), "") << words.front() << " " << input << "\n" << result.err;
    ++runs_;
    if (result.exit_code == 0 || result.exit_code == 4) ++done_;
  }

  std::vector<std::string> scans_, rasters_;
  int runs_ = 0, done_ = 0;
};

TEST_F(OneWayIn, TheJudgeFromOutsideSeesWhatItIsToSee) {
  const std::string scan = path("a.xyz");
  EXPECT_EQ(runRelievo({"info", scan}, guard(scan)).exit_code, 0);
  EXPECT_EQ(judgement(), "");
  // Recordings are read by the program itself.
  EXPECT_EQ(runRelievo({"touch", scan, "--unit", "mm", "--view", "top", "--stroke",
                        test::kFlatStroke, "-o", path("log.h5")})
                .exit_code,
            0);
  const auto touched = runRelievo({"replay", path("log.h5")}, guard(path("log.h5")));
  EXPECT_THAT(judgement(), testing::HasSubstr("library H5Fopen")) << touched.err;
}

TEST_F(OneWayIn, InfoOfEveryFormat) {
  for (const std::string& file : all()) expectNothingParsed({"info", file}, file);
  EXPECT_EQ(done_, static_cast<int>(all().size()));
}

TEST_F(OneWayIn, EveryVerbOnEveryFormat) {
  for (const std::string& file : all()) {
    const auto on = [&](std::vector<std::string> words, const std::vector<std::string>& more) {
      words.push_back(file);
      words.insert(words.end(), more.begin(), more.end());
      expectNothingParsed(words, file);
    };
    const std::string out = path("out" + std::to_string(runs_));
    on({"depthmap"}, {"--unit", "mm", "--cells", "60", "-o", out + ".tif"});
    on({"pyramid"}, {"--unit", "mm", "-o", out + "-p.tif"});
    on({"pyramid"}, {"--unit", "mm", "--memory", "500", "-o", out + "-m.tif"});
    on({"convert"}, {out + ".asc", "--unit", "mm"});
    on({"render"}, {"--unit", "mm", "--pixels", "64", "-o", out + ".png"});
    on({"measure"}, {"--unit", "mm", "--point", "5,5"});
    on({"suggest"}, {"--unit", "mm"});
    on({"describe"}, {"--unit", "mm"});
    on({"fill"}, {"--unit", "mm", "--holes", "interpolate:5", "-o", out + "-f.tif"});
    on({"touch"}, {"--unit", "mm", "--stroke", test::kFlatStroke, "-o", out + ".csv"});
    on({"prepare"}, {"--unit", "mm", "-o", out + ".ply"});
    on({"figure"}, {"--unit", "mm", "--dpi", "40", "-o", out + ".pdf"});
  }
  // Some verbs refuse some files; most are done.
  EXPECT_GT(done_, runs_ / 2);
}

TEST_F(OneWayIn, WhatAStateNames) {
  for (const std::string& file : {path("a.las"), path("site.tif"), path("tiles.L0.tif")}) {
    ASSERT_EQ(runRelievo({"render", file, "--unit", "mm", "-o", path("fig.png")}).exit_code, 0);
    expectNothingParsed({"render", "--from-image", path("fig.png"), "-o", path("again.png")}, file);
    ASSERT_EQ(
        runRelievo({"project", "new", path("fig.png"), "-o", path("p.relievo.json")}).exit_code, 0);
    expectNothingParsed({"figure", "--project", path("p.relievo.json"), "-o", path("p.pdf")}, file);
    // The picture itself is a raster that somebody may have sent.
    expectNothingParsed({"info", path("fig.png")}, path("fig.png"));
    expectNothingParsed({"project", "new", path("fig.png"), "-o", path("q.relievo.json")},
                        path("fig.png"));
    expectNothingParsed({"figure", "--compare", path("fig.png")}, path("fig.png"));
    expectNothingParsed({"figure", "--compare", path("fig.png")}, file);
  }
  EXPECT_EQ(done_, runs_);
}

TEST_F(OneWayIn, WhatARecordingNames) {
  for (const std::string& file : {path("a.las"), path("site.tif"), path("tiles.L0.tif")}) {
    const std::string log = path("touched.csv");
    ASSERT_EQ(runRelievo({"touch", file, "--unit", "mm", "--stroke", test::kFlatStroke, "-o", log})
                  .exit_code,
              0);
    expectNothingParsed({"replay", log}, file);
    expectNothingParsed({"sound", log, "-o", path("touched.wav")}, file);
    expectNothingParsed({"video", log, "--frame", "0", "--size", "64x64", "-o", path("frame.png")},
                        file);
  }
  EXPECT_EQ(done_, runs_);
}

TEST_F(OneWayIn, TheWindowOpensEveryFormat) {
  for (const std::string& file : all()) {
    SCOPED_TRACE(file);
    for (const std::string& entry : guard(file)) {
      const std::size_t equals = entry.find('=');
      ASSERT_EQ(::setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1), 0);
    }
    {
      test::ProgramWindow window({file});
      const std::string name = std::filesystem::path(file).filename().string();
      // What no map is made of is said in the window, without a title.
      const bool opens = !file.ends_with("claims_tiles.tif");
      if (opens) {
        EXPECT_TRUE(test::eventually([&] { return window.title().starts_with(name); }));
      } else {
        EXPECT_TRUE(test::eventually([&] { return !window.title().empty(); }));
      }
      EXPECT_TRUE(window.runs());
    }
    for (const char* variable : {"LD_PRELOAD", "RELIEVO_GUARDED", "RELIEVO_GUARD_LOG"}) {
      ::unsetenv(variable);
    }
    EXPECT_EQ(judgement(), "");
  }
}

/// A reader that runs where it is forbidden ends the process, in every build.
TEST(ReaderGuard, EndsAProcessThatParses) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const std::filesystem::path file = test::kFlatStroke;
  const std::vector<std::pair<const char*, std::function<void()>>> readers{
      {"readScanHere", [&] { readScanHere(file, {}, {}); }},
      {"PointReader", [&] { const PointReader reader(file); }},
      {"readTiffHead", [&] { readTiffHead(file); }},
      {"embeddedStateHere", [&] { embeddedStateHere(file); }},
      {"readPixelsHere", [&] { readPixelsHere(file); }},
      {"inputFactsHere", [&] { inputFactsHere(file); }},
      {"parsePlyHeader", [&] { parsePlyHeader("ply\n", file); }},
      {"parsePcdHeader", [&] { parsePcdHeader("", file); }},
      {"parseLasHeader", [&] { parseLasHeader("", file); }}};
  for (const auto& [name, read] : readers) {
    EXPECT_DEATH(
        {
          forbidReaders();
          read();
        },
        std::string("the reader ") + name);
  }
}

}  // namespace
}  // namespace relievo
