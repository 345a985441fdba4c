// SPDX-License-Identifier: BSD-3-Clause
// What comes out of every format: points, digits, triangles, parts of cut files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <string>
#include <vector>

#include "core/io/import.h"
#include "tests/core/io/refusal.h"
#include "tests/core/io/sample_files.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using namespace test;
using ::testing::HasSubstr;

const std::string kLe = "binary_little_endian";

std::string pcdOf(const std::string& kind) {
  PcdWords words;
  words.data = kind;
  return pcdHeader(words);
}

/// Points as PCD's compressed form stores them: axis by axis, here as LZF literals.
std::string compressedPcd(int count) {
  const std::string rows = binaryRows<float>(count);
  std::string by_axis;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      by_axis += rows.substr(12 * i + 4 * axis, 4);
    }
  }
  std::string packed;
  for (std::size_t at = 0; at < by_axis.size(); at += 32) {
    const std::string run = by_axis.substr(at, 32);
    packed += static_cast<char>(run.size() - 1) + run;
  }
  PcdWords words;
  words.data = "binary_compressed";
  words.points = std::to_string(count);
  return pcdHeader(words) + bytesOf(static_cast<std::uint32_t>(packed.size())) +
         bytesOf(static_cast<std::uint32_t>(by_axis.size())) + packed;
}

TEST(Import, TheSamePointsComeOutOfEveryFormat) {
  const TemporaryFolder folder;
  PcdWords doubles;
  doubles.data = "binary";
  doubles.size = "8 8 8";
  std::string obj;
  for (int i = 0; i < 10; ++i) {
    obj += "v " + std::to_string(i) + " " + std::to_string(i / 2.0) + " " +
           std::to_string(i / 4.0) + "\n";
  }
  const std::vector<std::pair<std::string, std::string>> files{
      {"a.ply", plyHeader("ascii", "10") + textRows(10)},
      {"b.ply", plyHeader(kLe, "10") + binaryRows<float>(10)},
      {"c.ply", plyHeader("binary_big_endian", "10") + binaryRows<float>(10, true)},
      {"d.ply", plyHeader(kLe, "10", "double") + binaryRows<double>(10)},
      {"e.ply", plyHeader("binary_big_endian", "10", "double") + binaryRows<double>(10, true)},
      {"a.pcd", pcdOf("ascii") + textRows(10)},
      {"b.pcd", pcdOf("binary") + binaryRows<float>(10)},
      {"c.pcd", pcdHeader(doubles) + binaryRows<double>(10)},
      {"d.pcd", compressedPcd(10)},
      {"a.obj", obj},
      {"a.xyz", textRows(10)},
      {"a.csv", textRows(10, ",")},
      {"a.pts", "10\n" + textRows(10)},
  };
  for (const auto& [name, content] : files) {
    SCOPED_TRACE(name);
    const Scan scan = importScan(folder.write(name, content));
    EXPECT_EQ(scan.info.points, 10U);
    EXPECT_EQ(scan.info.finite_points, 10U);
    EXPECT_EQ(scan.info.file.filename(), name);
    EXPECT_TRUE(scan.info.warnings.empty());
    ASSERT_EQ(scan.points.size(), 10U);
    for (int i = 0; i < 10; ++i) {
      EXPECT_EQ(scan.point(static_cast<std::size_t>(i)), (FilePoint{i + 0.0, i / 2.0, i / 4.0}));
    }
    EXPECT_EQ(*scan.info.bounds, (FileBounds{{0, 0, 0}, {9, 4.5, 2.25}}));
  }
}

TEST(Import, FormatsSayWhatTheyAre) {
  const TemporaryFolder folder;
  const auto format = [&](const std::string& name, const std::string& content) {
    return importScan(folder.write(name, content)).info.format;
  };
  EXPECT_EQ(format("a.ply", plyHeader(kLe, "10") + binaryRows<float>(10)),
            "PLY binary_little_endian");
  EXPECT_EQ(format("a.pcd", pcdOf("ascii") + textRows(10)), "PCD ascii");
  EXPECT_EQ(format("a.stl", binaryStl(2, 2)), "STL binary");
  EXPECT_EQ(format("b.stl", asciiStl()), "STL ascii");
  EXPECT_EQ(format("a.xyz", textRows(10)), "text");
}

TEST(Import, APlyMayStateItsUnitInAComment) {
  const TemporaryFolder folder;
  const auto ply = [](const std::string& comment) {
    return "ply\nformat ascii 1.0\n" + comment +
           "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
           "end_header\n1 2 3\n";
  };
  const auto unit_of = [&](const std::string& comment) {
    return importScan(folder.write("unit.ply", ply(comment))).info.unit;
  };
  EXPECT_EQ(unit_of("comment unit m\n"), LengthUnit::m);
  EXPECT_EQ(unit_of("comment made by hand\n"), std::nullopt);
  EXPECT_EQ(unit_of("comment unit furlong\n"), std::nullopt);
}

TEST(Import, ContentDecidesAndTheNameDoesNot) {
  const TemporaryFolder folder;
  EXPECT_EQ(importScan(folder.write("ply.xyz", plyHeader("ascii", "3") + textRows(3))).info.format,
            "PLY ascii");
  EXPECT_EQ(importScan(folder.write("stl", binaryStl(2, 2))).info.format, "STL binary");
  EXPECT_EQ(importScan(folder.write("obj.txt", "v 1 2 3\nv 4 5 6\n")).info.format, "OBJ");
}

// ---- georeferenced doubles -----------------------------------------------------------------

/// Coordinates that float cannot hold: its step there is 0.5.
const std::vector<FilePoint> kUtm{{635619.8512345, 5403117.0625001, 406.59},
                                  {635620.0012345, 5403117.5625003, 406.60},
                                  {635718.8512345, 5403216.3125002, 431.27}};

std::string digits(double value) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.begin(), buffer.end(), value).ptr};
}

std::string utmText(const std::string& prefix) {
  std::string text;
  for (const FilePoint& p : kUtm) {
    text += prefix + digits(p.x) + " " + digits(p.y) + " " + digits(p.z) + "\n";
  }
  return text;
}

std::string utmBytes(bool big_endian) {
  std::string bytes;
  for (const FilePoint& p : kUtm) {
    for (const double value : {p.x, p.y, p.z}) bytes += bytesOf(value, big_endian);
  }
  return bytes;
}

TEST(Import, GeoreferencedDoublesKeepTheirDigits) {
  const TemporaryFolder folder;
  PcdWords text_words;
  text_words.points = "3";
  text_words.size = "8 8 8";
  PcdWords binary_words = text_words;
  binary_words.data = "binary";
  const std::vector<std::pair<std::string, std::string>> files{
      {"a.ply", plyHeader("ascii", "3", "double") + utmText("")},
      {"b.ply", plyHeader(kLe, "3", "double") + utmBytes(false)},
      {"c.ply", plyHeader("binary_big_endian", "3", "double") + utmBytes(true)},
      {"a.pcd", pcdHeader(text_words) + utmText("")},
      {"b.pcd", pcdHeader(binary_words) + utmBytes(false)},
      {"a.obj", utmText("v ")},
      {"a.xyz", utmText("")},
  };
  const double longest = kUtm[2].x - kUtm[0].x;
  for (const auto& [name, content] : files) {
    SCOPED_TRACE(name);
    const Scan scan = importScan(folder.write(name, content));
    EXPECT_EQ(*scan.info.bounds, (FileBounds{kUtm[0], kUtm[2]}));
    ASSERT_EQ(scan.points.size(), kUtm.size());
    for (std::size_t i = 0; i < kUtm.size(); ++i) {
      EXPECT_LT(norm(scan.point(i) - kUtm[i]), 2e-7 * longest);
    }
  }
}

TEST(Import, AnOutlierDoesNotTakeTheResolutionFromTheRest) {
  const TemporaryFolder folder;
  const Scan scan = importScan(folder.write("a.xyz", "-9999 -9999 -9999\n" + utmText("")));
  ASSERT_EQ(scan.points.size(), 4U);
  for (std::size_t i = 0; i < kUtm.size(); ++i) {
    EXPECT_LT(norm(scan.point(i + 1) - kUtm[i]), 1e-4);
  }
}

// ---- faces ---------------------------------------------------------------------------------

TEST(Import, FacesBecomeTrianglesOfTheSameSurface) {
  const TemporaryFolder folder;
  const Scan scan = importScan(
      folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf -4 -3 -2\n"));
  EXPECT_EQ(scan.info.faces, 2U);
  EXPECT_EQ(scan.info.dropped_faces, 0U);
  using Triangle = std::array<std::uint32_t, 3>;
  EXPECT_THAT(scan.triangles,
              ::testing::ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 1, 2}));
}

TEST(Import, FacesWithoutTheirPointsAreDroppedAndSaid) {
  const TemporaryFolder folder;
  const std::string v = "v 0 0 0\nv nan 0 0\nv 1 1 0\nv 0 1 0\n";
  const Scan scan =
      importScan(folder.write("a.obj", v + "f 1 3 4\nf 1 2 3\nf 1 3 99\nf 0 1 3\nf 1 3\n"));
  EXPECT_EQ(scan.info.points, 4U);
  EXPECT_EQ(scan.info.finite_points, 3U);
  EXPECT_EQ(scan.info.faces, 5U);
  EXPECT_EQ(scan.info.dropped_faces, 4U);
  ASSERT_EQ(scan.triangles.size(), 1U);
  // Stored points 0, 2, 3 are now 0, 1, 2.
  EXPECT_EQ(scan.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
  ASSERT_EQ(scan.info.warnings.size(), 1U);
  EXPECT_THAT(englishText(scan.info.warnings[0]), HasSubstr("4 of 5 faces"));
}

TEST(Import, PlyFacesOutOfRangeAreDroppedInBothForms) {
  const TemporaryFolder folder;
  for (const bool text : {false, true}) {
    SCOPED_TRACE(text);
    const std::string file = plyHeader(text ? "ascii" : kLe, "10", "float", kPlyFaces) +
                             (text ? textRows(10) + "3 0 1 999999\n3 2 3 4\n"
                                   : binaryRows<float>(10) + plyTriangles({0, 1, 999999, 2, 3, 4}));
    const Scan scan = importScan(folder.write("a.ply", file));
    EXPECT_EQ(scan.info.faces, 2U);
    EXPECT_EQ(scan.info.dropped_faces, 1U);
    ASSERT_EQ(scan.triangles.size(), 1U);
    EXPECT_EQ(scan.triangles[0], (std::array<std::uint32_t, 3>{2, 3, 4}));
  }
}

TEST(Import, StlHasThreePointsForEveryTriangle) {
  const TemporaryFolder folder;
  for (const std::string& content : {binaryStl(2, 2), asciiStl()}) {
    const Scan scan = importScan(folder.write("a.stl", content));
    EXPECT_EQ(scan.info.points, 6U);
    EXPECT_EQ(scan.info.faces, 2U);
    EXPECT_EQ(scan.triangles.size(), 2U);
  }
}

// ---- incomplete files ----------------------------------------------------------------------

Refusal refusal(const std::filesystem::path& file) {
  return refusalOf([&] { importScan(file); });
}

TEST(Import, CutFilesAreE101AndLoadInPartOnRequest) {
  const TemporaryFolder folder;
  PcdWords binary_pcd;
  binary_pcd.data = "binary";
  const std::vector<std::pair<std::string, std::string>> files{
      {"a.ply", plyHeader(kLe, "10") + binaryRows<float>(10).substr(0, 100)},
      {"b.ply", plyHeader("ascii", "10") + textRows(8) + "8 4.0 2"},
      {"c.ply", plyHeader("binary_big_endian", "10") + binaryRows<float>(8, true)},
      {"a.pcd", pcdHeader(binary_pcd) + binaryRows<float>(10).substr(0, 107)},
      {"b.pcd", pcdHeader({}) + textRows(8) + "8 4"},
      {"a.pts", "10\n" + textRows(8) + "8"},
  };
  for (const auto& [name, content] : files) {
    SCOPED_TRACE(name);
    const std::filesystem::path file = folder.write(name, content);
    EXPECT_EQ(refusal(file).code, "E101");
    EXPECT_EQ(refusal(file).words,
              "Cannot read " + name +
                  ": header promises 10 points, file ends at 8. Nothing was "
                  "loaded. Load the 8 complete points, or choose another file.");
    ImportOptions accept;
    accept.accept_incomplete = true;
    const Scan scan = importScan(file, accept);
    EXPECT_EQ(scan.info.points, 8U);
    EXPECT_EQ(scan.points.size(), 8U);
    EXPECT_EQ(scan.info.bounds->max.x, 7);
    ASSERT_EQ(scan.info.warnings.size(), 1U);
    EXPECT_THAT(englishText(scan.info.warnings[0]), HasSubstr("incomplete"));
  }
}

TEST(Import, AMeshCutWithinItsFacesKeepsPointsAndCompleteFaces) {
  const TemporaryFolder folder;
  const std::string whole = plyHeader(kLe, "10", "float", kPlyFaces) + binaryRows<float>(10) +
                            plyTriangles({0, 1, 2, 2, 3, 4});
  const std::filesystem::path file = folder.write("a.ply", whole.substr(0, whole.size() - 5));
  EXPECT_EQ(refusal(file).code, "E101");
  EXPECT_THAT(refusal(file).words, HasSubstr("Load the 10 points and 1 complete face,"));
  ImportOptions accept;
  accept.accept_incomplete = true;
  const Scan scan = importScan(file, accept);
  EXPECT_EQ(scan.points.size(), 10U);
  EXPECT_EQ(scan.triangles.size(), 1U);
}

}  // namespace
}  // namespace relievo
