// SPDX-License-Identifier: BSD-3-Clause
// PCL's readers and ours give the same scans, to the bit, or refuse with the same words.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/io/formats/pcl_records.h"
#include "core/io/import.h"
#include "core/io/read_scan.h"
#include "core/io/reader_choice.h"
#include "tests/core/io/same_bytes.h"
#include "tests/core/io/sample_files.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using namespace test;
using ::testing::HasSubstr;

/// A scan, or the words of its refusal.
struct Outcome {
  Scan scan;
  std::string refusal;
};

Outcome readBy(const std::filesystem::path& file, ReaderChoice choice) {
  ImportOptions options;
  options.accept_incomplete = true;
  options.scan.reader = choice;
  Outcome outcome;
  try {
    outcome.scan = readScanHere(file, options, {}, {.pcl = &pclLibrary(), .load_texture = nullptr});
  } catch (const FileError& error) {
    outcome.refusal = error.what();
  }
  return outcome;
}

/// @return  whether PCL read it
bool expectTheSame(const std::filesystem::path& file) {
  const Outcome ours = readBy(file, ReaderChoice::own);
  const Outcome other = readBy(file, ReaderChoice::automatic);
  EXPECT_EQ(ours.refusal, other.refusal);
  const Scan &a = ours.scan, &b = other.scan;
  EXPECT_TRUE(sameBytes(a.points, b.points));
  EXPECT_TRUE(sameBytes(a.colours, b.colours));
  EXPECT_TRUE(sameBytes(a.intensities, b.intensities));
  EXPECT_TRUE(sameBytes(a.triangles, b.triangles));
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.info.points, b.info.points);
  EXPECT_EQ(a.info.finite_points, b.info.finite_points);
  EXPECT_EQ(a.info.bounds, b.info.bounds);
  EXPECT_EQ(a.info.format, b.info.format);
  EXPECT_EQ(englishTexts(a.info.warnings), englishTexts(b.info.warnings));
  EXPECT_EQ(a.info.colour.has_value(), b.info.colour.has_value());
  EXPECT_EQ(a.info.reader, "");
  return b.info.reader.starts_with("PCL ");
}

TEST(ReaderChoice, SharedScansAreTheSameByBoth) {
  const std::filesystem::path data = sharedData();
  if (data.empty()) GTEST_SKIP() << "the shared scans are not here";
  int by_pcl = 0;
  for (const char* const folder : {"pcd", "ply"}) {
    for (const auto& entry : std::filesystem::directory_iterator(data / folder)) {
      SCOPED_TRACE(entry.path().filename());
      if (expectTheSame(entry.path())) ++by_pcl;
    }
  }
  EXPECT_GE(by_pcl, 7);
}

struct Type {
  const char* ply;
  char pcd;
  int size;
};
constexpr std::array<Type, 8> kTypes{{{"char", 'I', 1},
                                      {"uchar", 'U', 1},
                                      {"short", 'I', 2},
                                      {"ushort", 'U', 2},
                                      {"int", 'I', 4},
                                      {"uint", 'U', 4},
                                      {"float", 'F', 4},
                                      {"double", 'F', 8}}};

std::string randomBytes(std::mt19937_64& random, std::size_t count) {
  std::string bytes(count, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  return bytes;
}

/// LZF of runs that are as they are; enough for a reader.
std::string asLzf(const std::string& bytes) {
  std::string packed;
  for (std::size_t at = 0; at < bytes.size(); at += 32) {
    const std::string run = bytes.substr(at, 32);
    packed += static_cast<char>(run.size() - 1) + run;
  }
  return bytesOf(static_cast<std::uint32_t>(packed.size())) +
         bytesOf(static_cast<std::uint32_t>(bytes.size())) + packed;
}

/// Headers with coordinates of one type between fields of all the others, and with colours.
struct Made {
  std::string header;
  std::size_t record = 0;
};
Made madePcd(const Type& type, const std::string& data, int points, const std::string& colour) {
  PcdWords words{.data = data, .points = std::to_string(points)};
  words.fields = words.size = words.type = words.count = "";
  Made made;
  const auto add = [&](const std::string& name, const Type& t, int count) {
    words.fields += name + " ";
    words.size += std::to_string(t.size) + " ";
    words.type += std::string(1, t.pcd) + " ";
    words.count += std::to_string(count) + " ";
    made.record += static_cast<std::size_t>(t.size * count);
  };
  int other = 0;
  for (const std::string axis : {"x", "y", "z"}) {
    add("odd" + std::to_string(other), kTypes[static_cast<std::size_t>(other * 3 % 8)], 1 + other);
    add(axis, type, 1);
    ++other;
  }
  add("_", kTypes[1], 3);
  if (colour == "rgb") add("rgb", kTypes[6], 1);
  if (colour == "rgba") add("rgba", kTypes[5], 1);
  if (colour == "separate") {
    for (const std::string name : {"red", "green", "blue"}) add(name, kTypes[3], 1);
  }
  add("intensity", kTypes[static_cast<std::size_t>(other)], 1);
  made.header = pcdHeader(words);
  return made;
}
Made madePly(const Type& type, bool big, int points, const std::string& colour) {
  std::string properties;
  Made made;
  const auto add = [&](const std::string& name, const Type& t) {
    properties += std::string("property ") + t.ply + " " + name + "\n";
    made.record += static_cast<std::size_t>(t.size);
  };
  add("odd", kTypes[0]);
  add("x", type);
  add("nx", kTypes[6]);
  add("y", type);
  add("wide", kTypes[7]);
  add("wider", kTypes[7]);
  add("z", type);
  for (const std::string name : {"blue", "red", "green"}) {
    if (!colour.empty()) add(name, colour == "bytes" ? kTypes[1] : kTypes[6]);
  }
  add("num_rows", kTypes[3]);
  add("intensity", kTypes[2]);
  made.header = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                "_endian 1.0\nobj_info num_cols 4\nobj_info num_rows 1\nelement vertex " +
                std::to_string(points) + "\n" + properties + "element face 0\nend_header\n";
  return made;
}

class MadeFiles : public ::testing::Test {
 protected:
  bool same(const std::string& name, const std::string& bytes) {
    return expectTheSame(folder_.write(name, bytes));
  }
  TemporaryFolder folder_;
  std::mt19937_64 random_{1300};
};

TEST_F(MadeFiles, OfEveryTypeAreTheSameByBothWholeAndCut) {
  // Random bytes hold every NaN, infinities and denormals; more than a block of either reader.
  for (const int points : {1, 70, 70'001}) {
    for (const Type& type : kTypes) {
      if (points > 70 && type.size != 4) continue;
      for (const std::string colour : {"", "rgb", "rgba", "separate"}) {
        SCOPED_TRACE(std::string(type.ply) + " " + colour + " " + std::to_string(points));
        const Made pcd = madePcd(type, "binary", points, colour);
        const std::string body =
            randomBytes(random_, pcd.record * static_cast<std::size_t>(points));
        // A single random point may be no number, so that both refuse.
        EXPECT_TRUE(same("a.pcd", pcd.header + body) || points == 1);
        EXPECT_TRUE(same("a.pcd", pcd.header + body.substr(0, body.size() * 2 / 3)) || points == 1);
        EXPECT_TRUE(same("a.pcd",
                         madePcd(type, "binary_compressed", points, colour).header + asLzf(body)) ||
                    points == 1);
      }
      for (const bool big : {false, true}) {
        for (const std::string colour : {"", "bytes", "floats"}) {
          SCOPED_TRACE(std::string(type.ply) + " " + colour + " " + std::to_string(points));
          const Made ply = madePly(type, big, points, colour);
          const std::string body =
              randomBytes(random_, ply.record * static_cast<std::size_t>(points));
          EXPECT_TRUE(same("a.ply", ply.header + body) || points == 1);
          same("a.ply", ply.header + body.substr(0, body.size() * 2 / 3));
        }
      }
    }
  }
}

/// So many that PCL reads blocks of them side by side.
TEST_F(MadeFiles, AMillionPointsOfAPlyKeepTheirOrder) {
  constexpr int kPoints = 1'100'000;
  const Made ply = madePly(kTypes[6], false, kPoints, "");
  EXPECT_TRUE(same("a.ply", ply.header + randomBytes(random_, ply.record * kPoints)));
}

TEST_F(MadeFiles, AThousandDamagedBodiesEndTheSameByBoth) {
  std::vector<std::pair<std::string, std::string>> good;
  for (const std::string data : {"binary", "binary_compressed"}) {
    const Made pcd = madePcd(kTypes[6], data, 200, "rgb");
    const std::string body = binaryRows<float>(static_cast<int>(pcd.record * 200 / 12))
                                 .append(pcd.record * 200 % 12, '\0');
    good.emplace_back(pcd.header, data == "binary" ? body : asLzf(body));
  }
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    auto [header, body] = good[static_cast<std::size_t>(i) % good.size()];
    for (int change = 0; change < 1 + i % 7; ++change) {
      body[random_() % body.size()] = static_cast<char>(random_());
    }
    if (i % 5 == 0) body.resize(random_() % body.size());
    if (i % 11 == 0) body.insert(0, "FIELDS x y\nSIZE 8 8\n");  // PCL's header code would obey.
    same("a.pcd", header + body);
    if (::testing::Test::HasFailure()) break;
  }
}

TEST_F(MadeFiles, TheUsualFilesAreReadByPclInTheWorkerAndSaySo) {
  PcdWords words;
  words.data = "binary";
  const auto pcd = folder_.write("a.pcd", pcdHeader(words) + binaryRows<float>(10));
  const auto ply =
      folder_.write("a.ply", plyHeader("binary_little_endian", "10") + binaryRows<float>(10));
  for (const auto& file : {pcd, ply}) {
    EXPECT_THAT(importScan(file).info.reader, ::testing::StartsWith("PCL 1."));
    ImportOptions own;
    own.scan.reader = ReaderChoice::own;
    EXPECT_EQ(importScan(file, own).info.reader, "relievo");
    ImportOptions pcl;
    pcl.scan.reader = ReaderChoice::pcl;
    EXPECT_THAT(importScan(file, pcl).info.reader, ::testing::StartsWith("PCL 1."));
  }
}

TEST_F(MadeFiles, AskingForPclWhereItIsWrongIsRefusedWithTheReason) {
  struct Case {
    std::string name, content, reason;
  };
  const std::string floats = plyHeader("binary_little_endian", "3", "float", kPlyFaces) +
                             binaryRows<float>(3) + plyTriangles({0, 1, 2, 2, 1, 0});
  PcdWords wide;
  wide.data = "binary";
  wide.size = "8 8 8";
  wide.type = "I I I";
  const std::vector<Case> cases{
      {"a.ply", plyHeader("ascii", "2") + textRows(2), "points at 0 0 0"},
      {"b.ply", floats, "faces"},
      {"c.ply",
       plyHeader("binary_little_endian", "1", "float", "property list uchar int odd\n") +
           binaryRows<float>(1) + std::string(1, '\0'),
       "lists"},
      {"d.ply", plyHeader("binary_little_endian", "2000001"), "many times as long"},
      {"a.pcd", pcdHeader({}) + textRows(10), "points at 0 0 0"},
      {"b.pcd", pcdHeader(wide) + binaryRows<std::int64_t>(10), "64 bits"},
      {"a.obj", "v 1 2 3\n", "rounds coordinates"},
      {"a.stl", binaryStl(1, 1), "through VTK"},
      {"a.xyz", "1 2 3\n", "no reader of this format"}};
  ImportOptions options;
  options.scan.reader = ReaderChoice::pcl;
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const auto file = folder_.write(c.name, c.content);
    try {
      importScan(file, options);
      ADD_FAILURE() << "it was read";
    } catch (const ArgumentError& error) {
      EXPECT_THAT(error.what(), HasSubstr(c.reason));
      EXPECT_THAT(error.what(), HasSubstr(c.name));
      EXPECT_THAT(error.what(), HasSubstr("--reader own"));
    }
  }
}

// ---- liberties that other programs take ----------------------------------------------------

TEST_F(MadeFiles, PcdFieldsMayBeCapitalsIfOneFits) {
  PcdWords words;
  words.fields = "X Y Z";
  EXPECT_EQ(importScan(folder_.write("a.pcd", pcdHeader(words) + textRows(10))).points.size(), 10U);
  words.fields = "x y z Z";
  words.size = "4 4 4 4";
  words.type = "F F F F";
  words.count = "1 1 1 1";
  words.points = "1";
  const Scan scan = importScan(folder_.write("b.pcd", pcdHeader(words) + "1 2 3 4\n"));
  EXPECT_EQ(scan.point(0), (FilePoint{1, 2, 3})) << "the exact name wins";
  words.fields = "X X y z";
  EXPECT_THROW(importScan(folder_.write("c.pcd", pcdHeader(words) + "1 2 3 4\n")), FileError);
}

TEST_F(MadeFiles, PcdKindsOfDataMayBeCapitals) {
  PcdWords words;
  words.data = "ASCII";
  EXPECT_EQ(importScan(folder_.write("a.pcd", pcdHeader(words) + textRows(10))).points.size(), 10U);
  words.data = "Binary";
  words.points = "1";
  const std::string point = bytesOf(1.0F) + bytesOf(2.0F) + bytesOf(3.0F);
  EXPECT_EQ(importScan(folder_.write("b.pcd", pcdHeader(words) + point)).point(0),
            (FilePoint{1, 2, 3}));
}

TEST_F(MadeFiles, PlyNamesMayBeCapitalsIfOneFits) {
  const auto file = [this](const std::string& element, const std::string& x) {
    return folder_.write("a.ply", "ply\nformat ascii 1.0\nelement " + element +
                                      " 1\nproperty float " + x +
                                      "\nproperty float Y\nproperty float Z\nend_header\n1 2 3\n");
  };
  EXPECT_EQ(importScan(file("vertex", "X")).point(0), (FilePoint{1, 2, 3}));
  EXPECT_EQ(importScan(file("Vertex", "x")).point(0), (FilePoint{1, 2, 3}));
  EXPECT_THROW(importScan(file("patch", "x")), FileError);
}

TEST_F(MadeFiles, PlyPointsMayBeCalledSo) {
  for (const char* element : {"vertices", "point", "Points", "Vertex"}) {
    SCOPED_TRACE(element);
    const std::string head =
        std::string("element ") + element +
        " 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    const std::string text = "ply\nformat ascii 1.0\n" + head + "1 2 3\n";
    EXPECT_EQ(importScan(folder_.write("a.ply", text)).point(0), (FilePoint{1, 2, 3}));
    const std::string bytes = "ply\nformat binary_little_endian 1.0\n" + head + bytesOf(1.0F) +
                              bytesOf(2.0F) + bytesOf(3.0F);
    EXPECT_EQ(importScan(folder_.write("a.ply", bytes)).point(0), (FilePoint{1, 2, 3}));
  }
}

TEST_F(MadeFiles, HeaderLinesOfNoStandardAreSaidAndPassedOver) {
  std::string ply = plyHeader("ascii", "2") + textRows(2);
  ply.insert(ply.find("element"), "made_by scanner 7\n");
  const Scan scan = importScan(folder_.write("a.ply", ply));
  EXPECT_EQ(scan.points.size(), 2U);
  EXPECT_THAT(englishTexts(scan.info.warnings),
              ::testing::ElementsAre(HasSubstr("(\"made_by scanner 7\") is not of PLY")));
  std::string pcd = pcdHeader({}) + textRows(10);
  pcd.insert(pcd.find("WIDTH"), "SENSOR kinect\n");
  const Scan cloud = importScan(folder_.write("a.pcd", pcd));
  EXPECT_EQ(cloud.points.size(), 10U);
  EXPECT_THAT(englishTexts(cloud.info.warnings),
              ::testing::ElementsAre(HasSubstr("(\"SENSOR kinect\") is not of PCD")));
}

TEST_F(MadeFiles, PcdMayLeaveOutWhatFollowsFromTheRest) {
  const auto without = [this](std::initializer_list<std::string> lines) {
    std::string header = pcdHeader({});
    for (const std::string& line : lines) {
      const std::size_t at = header.find("\n" + line + " ") + 1;
      header.erase(at, header.find('\n', at) + 1 - at);
    }
    return importScan(folder_.write("a.pcd", header + textRows(10))).points.size();
  };
  EXPECT_EQ(without({"COUNT"}), 10U);
  EXPECT_EQ(without({"POINTS"}), 10U);
  EXPECT_EQ(without({"WIDTH", "HEIGHT"}), 10U);
  EXPECT_EQ(without({"HEIGHT", "POINTS", "COUNT"}), 10U) << "the width alone";
}

TEST_F(MadeFiles, PlyOfAnyVersionAndWithCommentsBeforeItsFormat) {
  const auto file = [this](const std::string& beginning) {
    return folder_.write("a.ply", beginning +
                                      "element vertex 1\nproperty float x\nproperty float y\n"
                                      "property float z\nend_header\n1 2 3\n");
  };
  for (const std::string beginning :
       {"ply\nformat ascii 1.1\n", "ply\nformat ascii 2.0\n",
        "ply\ncomment first\nobj_info second\nformat ascii 1.0\ncomment third\n"}) {
    EXPECT_EQ(importScan(file(beginning)).point(0), (FilePoint{1, 2, 3})) << beginning;
  }
}

TEST_F(MadeFiles, PlyFacesHaveTwoNamesAndOthersAreNoFaces) {
  const auto scan = [this](const std::string& name) {
    return importScan(folder_.write(
        "a.ply",
        plyHeader("ascii", "3", "float", "element face 1\nproperty list uchar int " + name + "\n") +
            textRows(3) + "3 0 1 2\n"));
  };
  EXPECT_EQ(scan("vertex_indices").triangles.size(), 1U);
  EXPECT_EQ(scan("vertex_index").triangles.size(), 1U);
  const Scan other = scan("corners");
  EXPECT_EQ(other.points.size(), 3U);
  EXPECT_TRUE(other.triangles.empty());
  EXPECT_THAT(englishTexts(other.info.warnings),
              ::testing::ElementsAre(HasSubstr("loaded without faces")));
}

// ---- what is no liberty --------------------------------------------------------------------

TEST_F(MadeFiles, CornersThatAreNoWholeNumbersAreNoFaces) {
  const std::string ply = plyHeader("binary_little_endian", "3", "float",
                                    "element face 1\nproperty list uchar float vertex_indices\n") +
                          binaryRows<float>(3) + "\3" + bytesOf(0.0F) + bytesOf(1.0F) +
                          bytesOf(2.0F);
  const Scan scan = importScan(folder_.write("a.ply", ply));
  EXPECT_EQ(scan.points.size(), 3U);
  EXPECT_TRUE(scan.triangles.empty());
  EXPECT_THAT(englishTexts(scan.info.warnings),
              ::testing::ElementsAre(HasSubstr("loaded without faces")));
}

TEST_F(MadeFiles, AFieldOfSeveralNumbersIsNoCoordinate) {
  PcdWords words;
  words.count = "3 1 1";
  words.data = "binary";
  EXPECT_THROW(importScan(folder_.write("a.pcd", pcdHeader(words) + std::string(400, '\0'))),
               FileError);
}

}  // namespace
}  // namespace relievo
