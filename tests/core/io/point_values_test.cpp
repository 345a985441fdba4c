// SPDX-License-Identifier: BSD-3-Clause
// Colours, intensities, classes and parts of every format, through the worker.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/io/import.h"
#include "core/io/point_stream.h"
#include "core/io/point_values.h"
#include "tests/core/io/e57_sample.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/io/sample_files.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
const Rgba kFirst{10, 200, 30, 255}, kSecond{255, 0, 128, 255};
const std::vector<Rgba> kBoth{kFirst, kSecond};

class PointValues : public ::testing::Test {
 protected:
  Scan load(const std::string& name, const std::string& content,
            const ImportOptions& options = {}) {
    Scan scan = importScan(folder_.write(name, content), options);
    EXPECT_EQ(scan.points.size(), scan.info.finite_points);
    if (!scan.colours.empty()) {
      EXPECT_EQ(scan.colours.size(), scan.points.size());
      EXPECT_TRUE(scan.info.colour.has_value());
    }
    return scan;
  }
  TemporaryFolder folder_;
};

std::string plyPoints(const std::string& encoding, const std::string& more,
                      const std::vector<std::string>& rest) {
  std::string file = plyHeader(encoding, std::to_string(rest.size()), "float", more);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      file += encoding == "ascii"
                  ? std::to_string(i) + " "
                  : bytesOf(static_cast<float>(i), encoding.ends_with("big_endian"));
    }
    file += rest[i] + (encoding == "ascii" ? "\n" : "");
  }
  return file;
}

std::string rgbProperties(const std::string& type) {
  return "property " + type + " red\nproperty " + type + " green\nproperty " + type + " blue\n";
}

template <class T>
std::string numbers(const std::vector<double>& values, bool big = false) {
  std::string bytes;
  for (const double v : values) bytes += bytesOf(static_cast<T>(v), big);
  return bytes;
}

TEST_F(PointValues, PlyColoursOfEveryTypeAreTheSame) {
  const std::vector<double> a{10, 200, 30}, b{255, 0, 128};
  const auto scaled = [](std::vector<double> v, double factor) {
    for (double& number : v) number *= factor;
    return v;
  };
  for (const bool big : {false, true}) {
    const std::string encoding = big ? "binary_big_endian" : "binary_little_endian";
    SCOPED_TRACE(encoding);
    const auto file = [&](const std::string& type, const std::string& first,
                          const std::string& second) {
      return plyPoints(encoding, rgbProperties(type), {first, second});
    };
    const Scan bytes =
        load("a.ply", file("uchar", numbers<std::uint8_t>(a), numbers<std::uint8_t>(b)));
    EXPECT_EQ(bytes.colours, kBoth);
    EXPECT_EQ(bytes.info.colour->source, "red green blue");
    EXPECT_EQ(bytes.info.colour->bits, 8);
    EXPECT_EQ(bytes.info.colour->points, 2U);
    // Eight bits in sixteen, times 256 and times 257.
    for (const double factor : {1.0, 256.0, 257.0}) {
      const Scan words =
          load("a.ply", file("ushort", numbers<std::uint16_t>(scaled(a, factor), big),
                             numbers<std::uint16_t>(scaled(b, factor), big)));
      EXPECT_EQ(words.colours, kBoth) << factor;
      EXPECT_EQ(words.info.colour->bits, factor == 1 ? 8 : 16);
    }
    const Scan shares = load("a.ply", file("float", numbers<float>(scaled(a, 1 / 255.0), big),
                                           numbers<float>(scaled(b, 1 / 255.0), big)));
    EXPECT_EQ(shares.colours, kBoth);
    EXPECT_EQ(shares.info.colour->bits, 32);
  }
  const Scan text =
      load("a.ply", plyPoints("ascii", rgbProperties("uchar"), {"10 200 30", "255 0 128"}));
  EXPECT_EQ(text.colours, kBoth);
}

TEST_F(PointValues, AListAmongThePropertiesLeavesColoursInTheirPlaces) {
  const std::string properties =
      "property list uchar int odd\n" + rgbProperties("uchar") + "property float intensity\n";
  const Scan scan = load(
      "a.ply",
      plyPoints("binary_little_endian", properties,
                {"\2" + numbers<std::int32_t>({7, 8}) + numbers<std::uint8_t>({10, 200, 30}) +
                     bytesOf(5.0F),
                 std::string(1, '\0') + numbers<std::uint8_t>({255, 0, 128}) + bytesOf(260.0F)}));
  EXPECT_EQ(scan.colours, kBoth);
  EXPECT_THAT(scan.intensities, ElementsAre(5, 260));
}

TEST_F(PointValues, OtherNamesOfPlyColoursAndIntensitiesAreKnown) {
  const std::string body = numbers<std::uint8_t>({10, 200, 30}) + bytesOf(-1.5F);
  const std::string other = numbers<std::uint8_t>({255, 0, 128}) + bytesOf(2.5F);
  for (const std::string names :
       {"diffuse_red diffuse_green diffuse_blue", "r g b", "Red Green Blue"}) {
    std::string properties, rest = names;
    while (!rest.empty()) {
      const std::string word = rest.substr(0, rest.find(' '));
      rest.erase(0, word.size() + 1);
      properties += "property uchar " + word + "\n";
    }
    const Scan scan =
        load("a.ply", plyPoints("binary_little_endian",
                                properties + "property float scalar_Intensity\n", {body, other}));
    EXPECT_EQ(scan.colours, kBoth) << names;
    ASSERT_TRUE(scan.info.intensity.has_value());
    EXPECT_EQ(scan.info.intensity->low, -1.5);
    EXPECT_EQ(scan.info.intensity->high, 2.5);
    EXPECT_THAT(scan.intensities, ElementsAre(0, 65535));
  }
}

TEST_F(PointValues, ColoursAreThoseOfThePointsThatAreKept) {
  std::string file = plyHeader("binary_little_endian", "4", "float", rgbProperties("uchar"));
  const std::vector<float> x{0, kNaN, 1, std::numeric_limits<float>::infinity()};
  for (std::size_t i = 0; i < 4; ++i) {
    file += bytesOf(x[i]) + bytesOf(0.0F) + bytesOf(0.0F) +
            std::string(3, static_cast<char>(50 * (i + 1)));
  }
  const Scan scan = load("a.ply", file);
  EXPECT_THAT(scan.colours, ElementsAre(Rgba{50, 50, 50, 255}, Rgba{150, 150, 150, 255}));
  EXPECT_EQ(scan.info.colour->points, 2U);
}

TEST_F(PointValues, ColoursThatAreAllZeroAreNone) {
  const std::string zero(3, '\0');
  const Scan scan =
      load("a.ply", plyPoints("binary_little_endian", rgbProperties("uchar"), {zero, zero}));
  EXPECT_THAT(scan.colours, IsEmpty());
  EXPECT_FALSE(scan.info.colour.has_value());
}

TEST_F(PointValues, ColoursOfZeroAndOneAreSpreadWithAWord) {
  const Scan scan = load("a.ply", plyPoints("binary_little_endian", rgbProperties("uchar"),
                                            {std::string("\1\0\1", 3), std::string(3, '\0')}));
  EXPECT_THAT(scan.colours, ElementsAre(Rgba{255, 0, 255, 255}, Rgba{0, 0, 0, 255}));
  EXPECT_THAT(englishTexts(scan.info.warnings), ElementsAre(HasSubstr("nothing but 0 and 1")));
}

TEST_F(PointValues, ColoursOfFacesAloneAreSaid) {
  const Scan scan =
      load("a.ply", plyHeader("ascii", "3", "float",
                              "element face 1\nproperty list uchar int vertex_indices\n" +
                                  rgbProperties("uchar")) +
                        "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n");
  EXPECT_THAT(scan.colours, IsEmpty());
  EXPECT_THAT(englishTexts(scan.info.warnings),
              ElementsAre(HasSubstr("colours of faces are not read")));
}

PcdWords colouredPcd(const std::string& data, const std::string& field, const std::string& type) {
  return {.data = data,
          .points = "2",
          .fields = "x y z " + field + " intensity",
          .size = "4 4 4 4 4",
          .type = "F F F " + type + " F",
          .count = "1 1 1 1 1"};
}

TEST_F(PointValues, PcdColoursArePackedInEveryKindOfData) {
  // A colour with alpha 255 and much red is a signalling NaN as a float; its bits must survive.
  const std::array<std::uint32_t, 2> packed{0x000AC81EU, 0xFFFF0080U};
  for (const std::string field : {"rgb", "rgba", "RGB"}) {
    for (const std::string type : {"U", "F"}) {
      SCOPED_TRACE(field + " " + type);
      std::string body;
      for (std::size_t i = 0; i < 2; ++i) {
        body += numbers<float>({1.0 + static_cast<double>(i), 2, 3}) + bytesOf(packed[i]) +
                bytesOf(static_cast<float>(i) * 300);
      }
      const Scan binary = load("a.pcd", pcdHeader(colouredPcd("binary", field, type)) + body);
      EXPECT_EQ(binary.colours, kBoth);
      EXPECT_EQ(binary.info.colour->source, field);
      EXPECT_THAT(binary.intensities, ElementsAre(0, 300));
      const Scan text = load("a.pcd", pcdHeader(colouredPcd("ascii", field, type)) + "1 2 3 " +
                                          std::to_string(packed[0]) + " 0\n2 2 3 " +
                                          std::to_string(packed[1]) + " 300\n");
      EXPECT_EQ(text.colours, kBoth);
    }
  }
}

TEST_F(PointValues, PcdTextHoldsColoursAsFloatsWhoseBitsCount) {
  const auto text = [](std::uint32_t packed) {  // As old programs wrote them: 9.9014e-40
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.9g",
                  static_cast<double>(std::bit_cast<float>(packed)));
    return std::string(buffer.data());
  };
  const Scan scan =
      load("a.pcd", pcdHeader(colouredPcd("ascii", "rgb", "F")) + "1 2 3 " + text(0x000AC81EU) +
                        " 1\n2 2 3 " + text(0x00FF0080U) + " 3\n");
  EXPECT_EQ(scan.colours, kBoth);
}

TEST_F(PointValues, PcdSeparateColoursAreTaken) {
  const PcdWords words{.data = "binary",
                       .points = "2",
                       .fields = "x y z Red Green Blue",
                       .size = "4 4 4 2 2 2",
                       .type = "F F F U U U",
                       .count = "1 1 1 1 1 1"};
  const Scan scan =
      load("a.pcd", pcdHeader(words) + numbers<float>({1, 2, 3}) +
                        numbers<std::uint16_t>({2560, 51200, 7680}) + numbers<float>({2, 2, 3}) +
                        numbers<std::uint16_t>({65280, 0, 32768}));
  EXPECT_EQ(scan.colours, kBoth);
  EXPECT_EQ(scan.info.colour->bits, 16);
}

TEST_F(PointValues, AViewpointOfAPcdIsKept) {
  std::string file = pcdHeader({.points = "1"}) + "1 2 3\n";
  EXPECT_THAT(load("a.pcd", file).info.parts, IsEmpty());
  file.replace(file.find("VIEWPOINT 0 0 0"), 15, "VIEWPOINT 7 8 9");
  const Scan scan = load("a.pcd", file);
  ASSERT_EQ(scan.info.parts.size(), 1U);
  EXPECT_EQ(scan.info.parts[0].viewpoint, (FilePoint{7, 8, 9}));
  EXPECT_EQ(scan.point(0), (FilePoint{1, 2, 3}));
  EXPECT_EQ(scan.info.parts[0].points, 1U);
  EXPECT_THAT(scan.parts, IsEmpty());
}

/// A LAS record behind its coordinates, up to and with the colours.
std::string lasRest(int format, std::uint16_t intensity, std::uint8_t number, bool withheld,
                    const std::array<std::uint16_t, 3>& colour) {
  const bool extended = format >= 6;
  std::string rest = bytesOf(intensity) + std::string(1, '\x11');
  if (extended) {
    rest +=
        std::string(1, withheld ? '\4' : '\0') + static_cast<char>(number) + std::string(13, '\0');
  } else {
    rest += static_cast<char>(number | (withheld ? 0x80 : 0)) + std::string(4, '\0');
    if (format == 3 || format == 5) rest += std::string(8, '\0');
  }
  for (const std::uint16_t channel : colour) rest += bytesOf(channel);
  return rest;
}

Las newLas(int format, int count) {
  Las las;
  las.minor = 4;
  las.format = format;
  las.count = count;
  las.promised = static_cast<std::uint64_t>(count);
  las.legacy_promised = 0;
  return las;
}

TEST_F(PointValues, LasColoursAreDecidedOverTheWholeFile) {
  using Colour = std::array<std::uint16_t, 3>;
  for (const int format : {2, 3, 5, 7, 8, 10}) {
    SCOPED_TRACE(format);
    Las las = newLas(format, 2);
    const auto file = [&](const Colour& a, const Colour& b) {
      las.rest = {lasRest(format, 77, 2, false, a), lasRest(format, 40000, 31, false, b)};
      return lasFile(las);
    };
    const Scan bytes = load("a.las", file({10, 200, 30}, {255, 0, 128}));
    EXPECT_EQ(bytes.colours, kBoth);
    EXPECT_EQ(bytes.info.colour->bits, 8);
    // The first point is as dark as 8 bits would be; the second decides.
    const Scan words = load("a.las", file({10, 200, 30}, {65535, 0, 32768}));
    EXPECT_THAT(words.colours, ElementsAre(Rgba{0, 0, 0, 255}, kSecond));
    EXPECT_EQ(words.info.colour->bits, 16);
    EXPECT_THAT(words.intensities, ElementsAre(77, 40000));
    EXPECT_EQ(words.info.intensity->low, 0);
    EXPECT_EQ(words.info.intensity->high, 65535);
    EXPECT_THAT(words.classes, ElementsAre(2, 31));
    const Scan none = load("a.las", file({0, 0, 0}, {0, 0, 0}));
    EXPECT_THAT(none.colours, IsEmpty());
    EXPECT_FALSE(none.info.colour.has_value());
  }
}

TEST_F(PointValues, LasReturnsAreThoseOfTheirPulse) {
  // The number of a return and of all returns of the pulse: three bits each, later four.
  struct Case {
    int format;
    std::array<unsigned char, 3> stored;
    std::array<std::uint8_t, 3> packed;
  };
  const std::vector<Case> cases{{0, {0x09, 0x1A, 0x3F}, {0x11, 0x32, 0x77}},
                                {0, {0x09, 0xC9, 0x12}, {0x11, 0x11, 0x22}},  // Flags beside them.
                                {6, {0x11, 0x32, 0xFF}, {0x11, 0x32, 0xFF}}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.format);
    Las las = newLas(c.format, 3);
    for (const unsigned char stored : c.stored) {
      std::string rest = lasRest(c.format, 1, 2, false, {9, 9, 9});
      rest[2] = static_cast<char>(stored);
      las.rest.push_back(rest.substr(0, 8));
    }
    EXPECT_THAT(load("a.las", lasFile(las)).returns, testing::ElementsAreArray(c.packed));
  }
}

TEST_F(PointValues, PulsesThatAllCameBackOnceNeedNoReturns) {
  for (const char stored : {'\0', '\x09'}) {
    Las las = newLas(0, 2);
    for (int i = 0; i < 2; ++i) {
      std::string rest = lasRest(0, 1, 2, false, {9, 9, 9});
      rest[2] = stored;
      las.rest.push_back(rest.substr(0, 8));
    }
    EXPECT_THAT(load("a.las", lasFile(las)).returns, IsEmpty());
  }
}

TEST_F(PointValues, WithheldPointsOfLasAreLeftOutUnlessAskedFor) {
  for (const int format : {2, 7}) {
    SCOPED_TRACE(format);
    Las las = newLas(format, 3);
    for (int i = 0; i < 3; ++i) {
      las.rest.push_back(lasRest(format, static_cast<std::uint16_t>(i), 2, i == 1, {9, 9, 9}));
    }
    const Scan scan = load("a.las", lasFile(las));
    EXPECT_EQ(scan.info.points, 3U);
    EXPECT_EQ(scan.info.withheld, 1U);
    ASSERT_EQ(scan.points.size(), 2U);
    EXPECT_EQ(scan.point(1), (FilePoint{2, 1, 0.5}));
    EXPECT_THAT(scan.intensities, ElementsAre(0, 2));
    EXPECT_THAT(englishTexts(scan.info.warnings), ElementsAre(HasSubstr("left out")));
    ImportOptions keep;
    keep.scan.keep_withheld = true;
    const Scan all = load("a.las", lasFile(las), keep);
    EXPECT_EQ(all.points.size(), 3U);
    EXPECT_EQ(all.info.withheld, 1U);
    EXPECT_THAT(englishTexts(all.info.warnings), ElementsAre(HasSubstr("all the same")));
    // The same in blocks.
    const auto finite = [&](const ImportOptions& options) {
      std::array<FilePoint, 3> block;
      PointStream(folder_.path() / "a.las", options).read(0, block);
      return std::count_if(block.begin(), block.end(),
                           [](const FilePoint& p) { return isFinite(p); });
    };
    EXPECT_EQ(finite({}), 2);
    EXPECT_EQ(finite(keep), 3);
  }
}

const std::string kPtxHead = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";

TEST_F(PointValues, PtxScansKeepColoursPlacesAndNumbers) {
  const std::string file = "1\n2\n" + kPtxHead +
                           "10 20 30 1\n1 2 3 0.25 10 200 30\n0 0 0 0.5 0 0 0\n" + "2\n1\n" +
                           kPtxHead + "-5 0 0 1\n2 2 3 0.75 255 0 128\n3 2 3 0.5\n";
  const Scan scan = load("a.ptx", file);
  EXPECT_THAT(scan.colours, ElementsAre(kFirst, kSecond, Rgba{}));
  EXPECT_EQ(scan.info.colour->points, 2U);
  EXPECT_THAT(scan.parts, ElementsAre(0, 1, 1));
  ASSERT_EQ(scan.info.parts.size(), 2U);
  EXPECT_EQ(scan.info.parts[0].viewpoint, (FilePoint{10, 20, 30}));
  EXPECT_EQ(scan.info.parts[1].viewpoint, (FilePoint{-5, 0, 0}));
  EXPECT_EQ(scan.info.parts[0].points, 2U);
  EXPECT_EQ(scan.info.intensity->low, 0.25);
  EXPECT_EQ(scan.info.intensity->high, 0.75);
  EXPECT_THAT(scan.intensities, ElementsAre(0, 65535, 32768));

  ImportOptions second;
  second.scan.parts = {2};
  const Scan part = load("a.ptx", file, second);
  EXPECT_EQ(part.info.points, 2U);
  EXPECT_EQ(part.point(0), (FilePoint{-3, 2, 3}));
  EXPECT_EQ(part.info.parts.size(), 1U);
  ImportOptions third;
  third.scan.parts = {1, 3};
  EXPECT_THROW(load("a.ptx", file, third), ArgumentError);
  third.scan.parts = {2};
  EXPECT_THROW(load("a.xyz", "1 2 3\n", third), ArgumentError);
  third.scan.parts = {1};
  EXPECT_EQ(load("a.xyz", "1 2 3\n", third).points.size(), 1U);
}

std::string bytesText(const std::vector<int>& values) {
  std::string text;
  for (const int v : values) text += static_cast<char>(v);
  return text;
}

/// Two points; three channels with these attributes and contents.
E57SampleScan e57Scan(const std::array<std::string, 3>& attributes,
                      const std::array<std::string, 3>& streams) {
  E57SampleScan scan;
  scan.records = "2";
  const std::string coordinates = R"(type="Float" precision="single")";
  for (const std::string axis : {"X", "Y", "Z"}) {
    scan.fields.push_back({"cartesian" + axis, coordinates, numbers<float>({1, 2})});
  }
  const std::array<std::string, 3> names{"colorRed", "colorGreen", "colorBlue"};
  for (std::size_t k = 0; k < 3; ++k) scan.fields.push_back({names[k], attributes[k], streams[k]});
  return scan;
}

TEST_F(PointValues, E57ColoursRunOverTheirStatedLimits) {
  const std::string byte = R"(type="Integer" minimum="0" maximum="255")";
  const std::string word = R"(type="Integer" minimum="0" maximum="65535")";
  const std::string share = R"(type="Float" precision="single" minimum="0" maximum="1")";
  const std::string scaled = R"(type="ScaledInteger" minimum="0" maximum="255" scale="0.01")";
  const std::string open = R"(type="Float" precision="single")";
  const auto colours = [&](const std::string& attributes,
                           const std::array<std::string, 3>& streams) {
    E57Sample sample;
    sample.add(e57Scan({attributes, attributes, attributes}, streams));
    return load("a.e57", sample.file()).colours;
  };
  const std::array<std::string, 3> bytes{bytesText({10, 255}), bytesText({200, 0}),
                                         bytesText({30, 128})};
  EXPECT_EQ(colours(byte, bytes), kBoth);
  EXPECT_EQ(colours(scaled, bytes), kBoth);
  EXPECT_EQ(
      colours(word, {numbers<std::uint16_t>({2560, 65280}), numbers<std::uint16_t>({51200, 0}),
                     numbers<std::uint16_t>({7680, 32768})}),
      kBoth);
  EXPECT_EQ(colours(share, {numbers<float>({10 / 255.0, 1}), numbers<float>({200 / 255.0, 0}),
                            numbers<float>({30 / 255.0, 128 / 255.0})}),
            kBoth);
  EXPECT_EQ(colours(open, {numbers<float>({10, 255}), numbers<float>({200, 0}),
                           numbers<float>({30, 128})}),
            kBoth);
}

TEST_F(PointValues, E57LimitsBesideTheFieldsCountAndThoseOfZeroDoNot) {
  const std::string open = R"(type="Float" precision="single")";
  for (const bool zero : {false, true}) {
    E57Sample sample;
    E57SampleScan scan =
        e57Scan({open, open, open},
                {numbers<float>({10, 255}), numbers<float>({200, 0}), numbers<float>({30, 128})});
    std::string limits = "<colorLimits type=\"Structure\">";
    for (const std::string name : {"Red", "Green", "Blue"}) {
      limits += "<color" + name + "Minimum type=\"Float\"/><color" + name +
                "Maximum type=\"Float\">" + (zero ? "" : "510") + "</color" + name + "Maximum>";
    }
    scan.pose = limits + "</colorLimits>";
    sample.add(scan);
    const Scan read = load("a.e57", sample.file());
    ASSERT_EQ(read.colours.size(), 2U);
    EXPECT_EQ(read.colours[0], zero ? kFirst : (Rgba{5, 100, 15, 255}));
  }
}

TEST_F(PointValues, E57PartsHaveNamesPlacesAndInvalidColoursAreNone) {
  const std::string byte = R"(type="Integer" minimum="0" maximum="255")";
  E57Sample sample;
  E57SampleScan first = e57Scan({byte, byte, byte},
                                {bytesText({10, 255}), bytesText({200, 0}), bytesText({30, 128})});
  first.fields.push_back({"isColorInvalid", R"(type="Integer" minimum="0" maximum="1")", "\2"});
  first.fields.push_back(
      {"intensity", R"(type="Float" precision="single")", numbers<float>({0.5, 1})});
  first.name = "North";
  first.pose =
      "<pose type=\"Structure\"><translation type=\"Structure\"><x type=\"Float\">100</x>"
      "<y type=\"Float\"/><z type=\"Float\"/></translation></pose>";
  E57SampleScan second = first;
  second.name = "South";
  second.pose.clear();
  sample.add(first);
  sample.add(second);
  const Scan scan = load("a.e57", sample.file());
  EXPECT_THAT(scan.colours, ElementsAre(kFirst, Rgba{}, kFirst, Rgba{}));
  EXPECT_THAT(scan.intensities, ElementsAre(0, 65535, 0, 65535));
  EXPECT_THAT(scan.parts, ElementsAre(0, 0, 1, 1));
  ASSERT_EQ(scan.info.parts.size(), 2U);
  EXPECT_EQ(scan.info.parts[0].name, "North");
  EXPECT_EQ(scan.info.parts[0].viewpoint, (FilePoint{100, 0, 0}));
  EXPECT_EQ(scan.info.parts[1].viewpoint, std::nullopt);
  EXPECT_EQ(scan.point(0).x, 101);

  ImportOptions options;
  options.scan.parts = {2};
  const Scan south = load("a.e57", sample.file(), options);
  EXPECT_EQ(south.info.points, 2U);
  ASSERT_EQ(south.info.parts.size(), 1U);
  EXPECT_EQ(south.info.parts[0].name, "South");
  options.scan.parts = {3};
  EXPECT_THROW(load("a.e57", sample.file(), options), ArgumentError);
}

TEST_F(PointValues, ObjColoursNeedExactlySixNumbers) {
  EXPECT_EQ(load("a.obj", "v 1 2 3 10 200 30\nv 2 2 3 255 0 128\n").colours, kBoth);
  const Scan shares =
      load("a.obj", "v 1 2 3 0.039216 0.784314 0.117647 # one\nv 2 2 3 1 0 0.501961\n");
  EXPECT_EQ(shares.colours, kBoth);
  EXPECT_THAT(load("a.obj", "v 1 2 3 1\nv 2 2 3 1\n").colours, IsEmpty());
  EXPECT_THAT(load("a.obj", "v 1 2 3 1 10 200 30\nv 2 2 3 1 255 0 128\n").colours, IsEmpty());
  const Scan some = load("a.obj", "v 1 2 3\nv 2 2 3 255 0 128\nv 3 2 3\n");
  EXPECT_THAT(some.colours, ElementsAre(Rgba{}, kSecond, Rgba{}));
}

TEST_F(PointValues, ColumnsOfTextAreColoursByNameOrByWhatTheyHold) {
  struct Case {
    std::string what, name, content;
    bool colours = true;
    std::vector<std::uint16_t> intensities = {};
  };
  const std::vector<Case> cases{
      {"six", "a.xyz", "1 2 3 10 200 30\n2 2 3 255 0 128\n"},
      {"commas", "a.csv", "1,2,3,10,200,30\n2,2,3,255,0,128\n"},
      {"colours then normals", "a.xyz", "1 2 3 10 200 30 0 0 1\n2 2 3 255 0 128 0 0 1\n"},
      {"alpha", "a.xyz", "1 2 3 10.0 200.0 30.0 255.0\n2 2 3 255.0 0.0 128.0 255.0\n"},
      {"names", "a.csv", "z,b,x,g,y,r\n3,30,1,200,2,10\n3,128,2,0,2,255\n"},
      {"long names", "a.csv", "x,y,z,Red,Green,Blue\n1,2,3,10,200,30\n2,2,3,255,0,128\n"},
      {"names of CloudCompare", "a.asc", "//X Y Z R G B\n1 2 3 10 200 30\n2 2 3 255 0 128\n"},
      {"shares", "a.csv", "x,y,z,Rf,Gf,Bf\n1,2,3,0.039216,0.784314,0.117647\n2,2,3,1,0,0.501961\n"},
      {"pts", "a.pts", "2\n1 2 3 -10 10 200 30\n2 2 3 20 255 0 128\n", true, {0, 65535}},
      {"pts without count", "a.pts", "1 2 3 5 10 200 30\n2 2 3 7500 255 0 128\n", true, {5, 7500}},
      {"named intensity", "a.csv", "x,y,z,intensity\n1,2,3,0\n2,2,3,9\n", false, {0, 9}},
      {"normals", "a.asc", "1,2,3,0.5,0.5,0.7\n2,2,3,0,0,1\n", false},
      {"flat normals", "a.asc", "1,2,3,0,0,1\n2,2,3,0,0,1\n", false},
      {"not all bytes", "a.xyz", "1 2 3 10 200 30\n2 2 3 255 0 128.5\n", false},
      {"one further column", "a.xyz", "1 2 3 77\n2 2 3 78\n", false},
      {"words", "a.xyz", "1 2 3 a b c\n2 2 3 d e f\n", false},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.what);
    const Scan scan = load(c.name, c.content);
    EXPECT_EQ(scan.colours, c.colours ? kBoth : std::vector<Rgba>{});
    EXPECT_EQ(scan.info.colour.has_value(), c.colours);
    EXPECT_EQ(scan.intensities, c.intensities);
  }
}

TEST_F(PointValues, AColumnThatIsNoColourFurtherDownIsNone) {
  std::string content;
  for (int i = 0; i < 1000; ++i) content += "1 2 3 10 200 30\n";
  EXPECT_EQ(load("a.xyz", content).colours.size(), 1000U);
  EXPECT_THAT(load("a.xyz", content + "1 2 3 10 200 -30\n").colours, IsEmpty());
}

TEST(PointValueRanges, OneStrayIntensityDoesNotFlattenTheOthers) {
  std::vector<float> stored;
  for (int i = 0; i < 5000; ++i) stored.push_back(static_cast<float>(i % 100) / 100);
  stored.push_back(1e9F);
  stored.push_back(kNaN);
  IntensityRange range;
  const std::vector<std::uint16_t> whole = settledIntensities(stored, range);
  EXPECT_EQ(range.low, 0);
  EXPECT_LT(range.high, 2.1);
  EXPECT_EQ(whole[5000], 65535);
  EXPECT_EQ(whole[5001], 0);
  EXPECT_NEAR(range.low + whole[50] * (range.high - range.low) / 65535, 0.5, 1e-4);
}

TEST(PointValueRanges, NumbersBeyondSixteenBitsAreNoColours) {
  ColourFact fact;
  std::vector<Message> warnings;
  EXPECT_THAT(settledColours(std::vector<std::array<float, 3>>{{1, 2, 70000}}, fact, warnings),
              IsEmpty());
  EXPECT_THAT(englishTexts(warnings), ElementsAre(HasSubstr("left out")));
}

TEST(PointValueRanges, AFileWithoutColoursHasNoListsAtAll) {
  const TemporaryFolder folder;
  const Scan scan = importScan(folder.write("a.xyz", "1 2 3\n4 5 6\n"));
  EXPECT_EQ(scan.colours.capacity() + scan.intensities.capacity() + scan.classes.capacity() +
                scan.returns.capacity() + scan.parts.capacity() + scan.texture_of.capacity(),
            0U);
  EXPECT_EQ(scan.info.reader, "relievo");
}

}  // namespace
}  // namespace relievo
