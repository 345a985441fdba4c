// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "core/io/e57/crc32c.h"
#include "core/io/formats/number_text.h"
#include "core/io/formats/scalar.h"
#include "tests/core/io/e57_sample.h"
#include "tests/core/io/file_cases.h"
#include "tests/core/io/refusal.h"

namespace relievo {
namespace {

using namespace test;
using namespace std::string_literals;
using ::testing::HasSubstr;

const std::array<std::string, 3> kAxes{"cartesianX", "cartesianY", "cartesianZ"};

/// Ten points (i, i / 2, i / 4) as numbers of one floating type.
template <class T>
E57SampleScan floats() {
  E57SampleScan scan;
  scan.records = "10";
  const std::string precision = sizeof(T) == 4 ? " precision=\"single\"" : "";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::string stream;
    for (int i = 0; i < 10; ++i) stream += bytesOf(static_cast<T>(i / std::pow(2.0, axis)));
    scan.fields.push_back({kAxes[axis], "type=\"Float\"" + precision, stream});
  }
  return scan;
}

/// The same points as whole quarters from -3, packed into 6 bits each.
E57SampleScan scaledIntegers() {
  E57SampleScan scan;
  scan.records = "10";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    PackedBits stream;
    for (std::uint64_t i = 0; i < 10; ++i) stream.add((4 * i >> axis) + 3, 6);
    scan.fields.push_back({kAxes[axis],
                           "type=\"ScaledInteger\" minimum=\"-3\" maximum=\"60\" "
                           "scale=\"2.5e-1\" offset=\"0\"",
                           stream.bytes()});
  }
  return scan;
}

std::string fileOf(const E57SampleScan& scan) {
  E57Sample sample;
  sample.add(scan);
  return sample.file();
}

std::string numbers(const std::string& name, const std::vector<std::string>& parts) {
  std::string xml = "<" + name + " type=\"Structure\">";
  for (std::size_t i = 0; i < parts.size(); i += 2) {
    xml += "<" + parts[i] + " type=\"Float\">" + parts[i + 1] + "</" + parts[i] + ">";
  }
  return xml + "</" + name + ">";
}

std::string pose(const std::string& content) {
  return "<pose type=\"Structure\">" + content + "</pose>";
}

class ReadE57 : public FileCases {
 protected:
  Scan load(const std::string& content, const ImportOptions& options = {}) {
    return importScan(folder_.write("cloud.e57", content), options);
  }
  void expectTenPoints(const Scan& scan) {
    EXPECT_EQ(scan.info.points, 10U);
    EXPECT_EQ(scan.info.unit, LengthUnit::m);
    EXPECT_TRUE(scan.info.warnings.empty());
    ASSERT_EQ(scan.points.size(), 10U);
    for (int i = 0; i < 10; ++i) {
      EXPECT_EQ(scan.point(static_cast<std::size_t>(i)), (FilePoint{i + 0.0, i / 2.0, i / 4.0}));
    }
  }
};

TEST(Crc32c, KnownValueAndEveryLengthAgreeWithBitByBit) {
  EXPECT_EQ(crc32c("123456789"), 0xE3069283U);
  std::mt19937 random(7);
  std::string bytes;
  for (int length = 0; length < 40; ++length) {
    EXPECT_EQ(crc32c(bytes), checksumBitByBit(bytes)) << length;
    bytes += static_cast<char>(random());
  }
}

TEST_F(ReadE57, FloatsDoublesAndScaledIntegersGiveTheSamePoints) {
  for (const E57SampleScan& scan : {floats<float>(), floats<double>(), scaledIntegers()}) {
    expectTenPoints(load(fileOf(scan)));
  }
}

TEST_F(ReadE57, NumbersMayBeSplitBetweenPacketsAtAnyByte) {
  for (const std::size_t share : {1U, 2U, 3U, 5U, 7U}) {
    SCOPED_TRACE(share);
    for (E57SampleScan scan : {floats<float>(), floats<double>(), scaledIntegers()}) {
      scan.share = share;
      expectTenPoints(load(fileOf(scan)));
    }
  }
}

TEST_F(ReadE57, FieldsInAnyOrderAndOtherFieldsBetweenThem) {
  E57SampleScan scan = floats<float>();
  std::swap(scan.fields[0], scan.fields[2]);
  scan.fields.insert(
      scan.fields.begin() + 1,
      {"colorRed", R"(type="Integer" minimum="0" maximum="255")", std::string(10, 'r')});
  scan.fields.insert(scan.fields.begin(), {"note", "type=\"String\"", std::string(25, 's')});
  expectTenPoints(load(fileOf(scan)));
}

TEST_F(ReadE57, IntegersOfEveryWidthComeBack) {
  for (unsigned bits = 1; bits <= 64; ++bits) {
    SCOPED_TRACE(bits);
    const std::uint64_t top = bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
    const std::int64_t minimum = bits == 64 ? std::numeric_limits<std::int64_t>::min() : -1;
    const auto maximum = static_cast<std::int64_t>(static_cast<std::uint64_t>(minimum) + top);
    if (maximum < minimum) continue;  // From -1, 2^63 values and more do not fit.
    PackedBits x;
    for (const std::uint64_t stored : {top, std::uint64_t{0}, std::uint64_t{1}, top}) {
      x.add(stored, bits);
    }
    E57SampleScan scan;
    scan.records = "4";
    scan.share = 3;
    scan.fields.push_back({"cartesianX",
                           R"(type="Integer" minimum=")" + std::to_string(minimum) +
                               "\" maximum=\"" + std::to_string(maximum) + "\"",
                           x.bytes()});
    for (const std::size_t axis : {1U, 2U}) {
      scan.fields.push_back({kAxes[axis], R"(type="Integer" minimum="5" maximum="5")", ""});
    }
    const Scan loaded = load(fileOf(scan));
    EXPECT_EQ(loaded.info.points, 4U);
    EXPECT_EQ(*loaded.info.bounds, (FileBounds{{static_cast<double>(minimum), 5, 5},
                                               {static_cast<double>(maximum), 5, 5}}));
  }
}

TEST_F(ReadE57, PosesTurnAndMoveEachScan) {
  E57SampleScan first = floats<double>();
  // A quarter turn about z: x becomes y, y becomes -x.
  const std::string half = "7.0710678118654757e-001";
  first.pose = pose(numbers("rotation", {"w", half, "x", "0", "y", "0", "z", half}) +
                    numbers("translation", {"x", "100", "y", "200", "z", "-5"}));
  E57SampleScan second = scaledIntegers();
  second.pose = pose(numbers("translation", {"x", "1000"}));
  E57Sample sample;
  sample.add(first);
  sample.add(second);
  const Scan scan = load(sample.file());
  EXPECT_EQ(scan.info.points, 20U);
  ASSERT_EQ(scan.points.size(), 20U);
  for (int i = 0; i < 10; ++i) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_LT(norm(scan.point(at) - FilePoint{100 - i / 2.0, 200.0 + i, i / 4.0 - 5}), 1e-4);
    EXPECT_LT(norm(scan.point(at + 10) - FilePoint{1000.0 + i, i / 2.0, i / 4.0}), 1e-4);
  }
  EXPECT_NEAR(scan.info.bounds->min.x, 95.5, 1e-12);
  EXPECT_NEAR(scan.info.bounds->max.x, 1009, 1e-12);
  EXPECT_NEAR(scan.info.bounds->max.y, 209, 1e-12);
}

FilePoint cross(const FilePoint& a, const FilePoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

TEST_F(ReadE57, ATurnAboutAnyAxisIsThatOfItsQuaternion) {
  const std::vector<std::pair<FilePoint, double>> turns{
      {{1, 0, 0}, 90}, {{0, 1, 0}, 90}, {{0, 0, 1}, 90}, {{1, 2, 3}, 50}, {{-3, 1, 2}, 200}};
  for (const auto& [axis, degrees] : turns) {
    const double half = degrees * std::acos(-1.0) / 360;
    const FilePoint v = std::sin(half) / norm(axis) * axis;
    const double w = std::cos(half);
    E57SampleScan turned = floats<double>();
    turned.pose = pose(numbers(
        "rotation", {"w", roundTripText(std::array{w}), "x", roundTripText(std::array{v.x}), "y",
                     roundTripText(std::array{v.y}), "z", roundTripText(std::array{v.z})}));
    const Scan scan = load(fileOf(turned));
    for (int i = 0; i < 10; ++i) {
      const FilePoint p{i + 0.0, i / 2.0, i / 4.0};
      const FilePoint wanted = p + 2 * w * cross(v, p) + 2.0 * cross(v, cross(v, p));
      EXPECT_LT(norm(scan.point(static_cast<std::size_t>(i)) - wanted), 1e-6) << degrees;
    }
  }
}

TEST_F(ReadE57, TheLastPageOfASectionIsCheckedEvenIfNobodyReadsIt) {
  E57SampleScan scan = floats<double>();
  scan.share = 20'000;
  scan.fields.push_back({"note", "type=\"String\"", std::string(5000, 's')});
  E57Sample sample;
  sample.add(scan);
  // The list of scans moves to pages of its own.
  const std::string space(1020, ' ');
  std::string bytes = sample.fileWith(space + sample.xml());
  const auto xml_at = loadAs<std::uint64_t>(bytes.data() + 24, ByteOrder::little);
  bytes = E57Sample::changed(
      bytes, 24, bytesOf(xml_at + 1024) + bytesOf(static_cast<std::uint64_t>(sample.xml().size())));
  expectTenPoints(load(bytes));
  bytes[static_cast<std::size_t>(xml_at) + 1] ^= 1;  // Behind the section, in its last page.
  EXPECT_THAT(refusalOf([&] { load(bytes); }).words, HasSubstr("the checksum of its page"));
}

TEST_F(ReadE57, InvalidPointsAreStoredButNotFinite) {
  E57SampleScan scan = floats<float>();
  PackedBits state;
  for (const std::uint64_t value : {0U, 1U, 2U, 0U, 0U, 0U, 0U, 0U, 0U, 2U}) state.add(value, 2);
  scan.fields.push_back(
      {"cartesianInvalidState", R"(type="Integer" minimum="0" maximum="2")", state.bytes()});
  const Scan loaded = load(fileOf(scan));
  EXPECT_EQ(loaded.info.points, 10U);
  EXPECT_EQ(loaded.info.finite_points, 7U);
  EXPECT_EQ(loaded.info.bounds->max.x, 8);
}

TEST_F(ReadE57, SphericalCoordinatesBecomeCartesian) {
  E57SampleScan scan;
  scan.records = "2";
  scan.fields = {{"sphericalRange", "type=\"Float\"", bytesOf(2.0) + bytesOf(3.0)},
                 {"sphericalAzimuth", "type=\"Float\"", bytesOf(0.0) + bytesOf(std::acos(0.0))},
                 {"sphericalElevation", "type=\"Float\"", bytesOf(std::acos(0.0)) + bytesOf(0.0)}};
  const Scan loaded = load(fileOf(scan));
  ASSERT_EQ(loaded.points.size(), 2U);
  EXPECT_LT(norm(loaded.point(0) - FilePoint{0, 0, 2}), 1e-6);
  EXPECT_LT(norm(loaded.point(1) - FilePoint{0, 3, 0}), 1e-6);
}

TEST_F(ReadE57, AScanThatEndsEarlyIsE101AndLoadsOnRequest) {
  E57SampleScan scan = floats<float>();
  scan.records = "25";
  const Refusal refusal = refusalOf([&] { load(fileOf(scan)); });
  EXPECT_EQ(refusal.code, "E101");
  EXPECT_THAT(refusal.words, HasSubstr("promises 25 points, file ends at 10"));
  ImportOptions options;
  options.accept_incomplete = true;
  EXPECT_EQ(load(fileOf(scan), options).points.size(), 10U);
}

TEST_F(ReadE57, FilesThatLieAboutThemselvesAreRefused) {
  const std::string good = fileOf(floats<float>());
  const auto patched = [&good](std::size_t at, const std::string& value) {
    return E57Sample::changed(good, at, value);
  };
  std::string flipped = good;
  flipped[700] = static_cast<char>(flipped[700] ^ 1);
  const std::uint64_t huge = ~std::uint64_t{0} - 7;
  // Logical places: header 0, section 48, index packet 80, data packet 96.
  check({
      loads("good.bin", good, 10),
      loads("bytes_behind.e57", good + "rest", 10),
      refused("magic_only.e57", "ASTM-E57", "shorter than the header"),
      refused("zeros.e57", "ASTM-E57"s + std::string(300, '\0'), "E57 version 0"),
      refused("version.e57", patched(8, bytesOf(2U)), "E57 version 2"),
      refused("cut.e57", good.substr(0, good.size() - 1), "bytes, file ends at"),
      refused("checksum.e57", flipped, "checksum of its page 1"),
      refused("page_size_0.e57", patched(40, bytesOf(std::uint64_t{0})), "page size"),
      refused("page_size_1000.e57", patched(40, bytesOf(std::uint64_t{1000})), "page size"),
      refused("page_size_4.e57", patched(40, bytesOf(std::uint64_t{4})), "page size"),
      refused("page_size_huge.e57", patched(40, bytesOf(std::uint64_t{1} << 63U)), "page size"),
      refused("length_0.e57", patched(16, bytesOf(std::uint64_t{0})), "multiple of its pages"),
      refused("length_odd.e57", patched(16, bytesOf(std::uint64_t{1000})), "multiple of its pages"),
      refused("length_huge.e57", patched(16, bytesOf(huge)), "file ends at"),
      refused("xml_beyond.e57", patched(24, bytesOf(huge)), "place outside itself"),
      refused("xml_in_checksum.e57", patched(24, bytesOf(std::uint64_t{1022})), "outside itself"),
      refused("xml_length_huge.e57", patched(32, bytesOf(huge)), "impossible length"),
      refused("xml_too_long.e57", patched(32, bytesOf(std::uint64_t{1} << 20U)), "beyond its end"),
      refused("xml_length_0.e57", patched(32, bytesOf(std::uint64_t{0})), "impossible length"),
      refused("xml_short.e57", patched(32, bytesOf(std::uint64_t{200})), "no proper XML"),
      refused("section_kind.e57", patched(48, "\7"), "section of its points"),
      refused("section_length_0.e57", patched(56, bytesOf(std::uint64_t{0})), "section of its"),
      refused("section_length_huge.e57", patched(56, bytesOf(huge)), "section of its points"),
      refused("section_length_long.e57", patched(56, bytesOf(std::uint64_t{1} << 40U)),
              "section of its"),
      refused("data_before_section.e57", patched(64, bytesOf(std::uint64_t{8})), "section of its"),
      refused("data_beyond.e57", patched(64, bytesOf(huge)), "place outside itself"),
      refused("packet_kind.e57", patched(96, "\5"), "packet"),
      refused("packet_length_odd.e57", patched(98, bytesOf(std::uint16_t{16})), "packet"),
      refused("packet_length_huge.e57", patched(98, bytesOf(std::uint16_t{65535})), "packet"),
      refused("packet_length_short.e57", patched(98, bytesOf(std::uint16_t{7})), "packet"),
      refused("stream_count.e57", patched(100, bytesOf(std::uint16_t{4})), "packet"),
      refused("stream_length.e57", patched(106, bytesOf(std::uint16_t{60000})), "packet"),
      refused("stream_empty.e57", patched(102, bytesOf(std::uint16_t{0})), "file ends at 0"),
  });
}

TEST_F(ReadE57, ListsOfScansThatMakeNoSenseAreRefused) {
  E57Sample sample;
  sample.add(floats<float>());
  const std::string xml = sample.xml();
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = xml;
    const std::size_t at = text.find(from);
    if (at == std::string::npos) ADD_FAILURE() << from;
    text.replace(at, from.size(), to);
    return sample.fileWith(text);
  };
  const auto scan_with = [](auto change) {
    E57SampleScan scan = scaledIntegers();
    change(scan);
    return fileOf(scan);
  };
  std::string deep, open, laughs = R"(<!DOCTYPE e [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;">]>)";
  for (int i = 0; i < 5000; ++i) {
    open += "<a>";
    deep += "</a>";
  }
  check({
      refused("not_xml.e57", sample.fileWith("hello"), "no proper XML"),
      refused("unclosed.e57", with("</data3D>", ""), "no proper XML"),
      refused("deep.e57", sample.fileWith(open + deep), "too many elements"),
      refused("entities.e57", sample.fileWith(laughs + xml.substr(xml.find("<e57Root"))),
              "document type"),
      refused("no_scans.e57", sample.fileWith("<e57Root/>"), "no scans"),
      refused("empty_list.e57", sample.fileWith("<e57Root><data3D/></e57Root>"), "no scans"),
      refused("points_kind.e57", with("CompressedVector", "Vector"), "unknown kind"),
      refused("no_prototype.e57", with("<prototype type=\"Structure\">", "<p>"), "no proper XML"),
      refused("no_axis.e57", with("cartesianZ", "cartesianQ"), "no cartesianZ"),
      refused("no_cartesian.e57", with("cartesianX", "colorRed"), "no sphericalRange"),
      refused("string_axis.e57", with("cartesianY type=\"Float\"", "cartesianY type=\"String\""),
              "no cartesianY"),
      refused("count_word.e57", with("recordCount=\"10\"", "recordCount=\"ten\""), "\"ten\""),
      refused("count_negative.e57", with("recordCount=\"10\"", "recordCount=\"-10\""), "\"-10\""),
      refused("count_huge.e57", with("recordCount=\"10\"", "recordCount=\"18446744073709551615\""),
              "200 000 000 points, the limit"),
      refused("count_zero.e57", with("recordCount=\"10\"", "recordCount=\"0\""), "none finite"),
      refused("offset_beyond.e57", with("fileOffset=\"48\"", "fileOffset=\"99999999\""),
              "place outside itself"),
      refused("offset_elsewhere.e57", with("fileOffset=\"48\"", "fileOffset=\"80\""),
              "place outside itself"),
      refused("limits_crossed.e57", scan_with([](E57SampleScan& s) {
                s.fields[1].attributes = R"(type="Integer" minimum="9" maximum="8")";
              }),
              "maximum below its minimum"),
      refused("scale_word.e57", scan_with([](E57SampleScan& s) {
                s.fields[1].attributes = R"(type="ScaledInteger" scale="nan")";
              }),
              "\"nan\""),
      refused("constant_points.e57", scan_with([](E57SampleScan& s) {
                s.records = "4000000000";
                for (auto& f : s.fields) f.attributes = R"(type="Integer" minimum="1" maximum="1")";
              }),
              "200 000 000 points, the limit"),
      refused("rotation_zero.e57", scan_with([](E57SampleScan& s) {
                s.pose = pose(numbers("rotation", {"w", "0"}));
              }),
              "unit quaternion"),
      refused("rotation_huge.e57", scan_with([](E57SampleScan& s) {
                s.pose = pose(numbers("rotation", {"w", "1e200"}));
              }),
              "unit quaternion"),
      refused("codec.e57", scan_with([](E57SampleScan& s) {
                s.codecs = "<vectorChild><zipCodec/></vectorChild>";
              }),
              "unknown codec"),
      loads("bit_pack_codec.e57", scan_with([](E57SampleScan& s) {
              s.codecs = "<vectorChild><bitPackCodec/></vectorChild>";
            }),
            10),
  });
}

/// Three scans of 300 points each, long enough to have pages of their own; x starts at 0, 1000
/// and 2000.
E57Sample threeScans(const std::function<void(E57SampleScan&)>& change_second = {}) {
  E57Sample sample;
  for (int number = 0; number < 3; ++number) {
    E57SampleScan scan;
    scan.records = "300";
    scan.name = "Station <![CDATA[" + std::to_string(number + 1) + "]]>";
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::string stream;
      for (int i = 0; i < 300; ++i) stream += bytesOf(axis == 0 ? 1000.0 * number + i : 0.5 * i);
      scan.fields.push_back({kAxes[axis], "type=\"Float\"", stream});
    }
    if (number == 1 && change_second) change_second(scan);
    sample.add(scan);
  }
  return sample;
}

struct BrokenScan {
  std::string file, why;
};

TEST_F(ReadE57, ABrokenScanIsLeftOutAndTheOthersAreRead) {
  const std::string good = threeScans().file();
  const std::size_t second = threeScans().sections()[1];
  ASSERT_EQ(load(good).points.size(), 900U);
  ASSERT_TRUE(load(good).info.warnings.empty());
  std::string flipped = good;
  const auto page = static_cast<std::size_t>(E57Sample::physical(second + 3000));
  flipped[page] = static_cast<char>(flipped[page] ^ 1);
  const auto with = [](const std::function<void(E57SampleScan&)>& change) {
    return threeScans(change).file();
  };
  const std::vector<BrokenScan> broken{
      {flipped, "the checksum of its page 11 of 23 is wrong"},
      {E57Sample::changed(good, second, "\7"), "a section of its points makes no sense"},
      {E57Sample::changed(good, second + 32 + 16, "\5"), "a packet of its points makes no sense"},
      {with([](E57SampleScan& s) { s.codecs = "<vectorChild><zipCodec/></vectorChild>"; }),
       "its entry in the list of scans names an unknown codec"},
      {with([](E57SampleScan& s) { s.records = "ten"; }),
       "its entry in the list of scans holds \"ten\" in place of a number"},
      {with([](E57SampleScan& s) { s.fields[2].name = "colorRed"; }), "it has no cartesianZ"},
      {with([](E57SampleScan& s) {
         s.pose = pose(numbers("rotation", {"w", "0"}));
       }),
       "its entry in the list of scans holds a rotation that is no unit quaternion"},
  };
  for (const BrokenScan& b : broken) {
    SCOPED_TRACE(b.why);
    const Scan scan = load(b.file);
    EXPECT_EQ(scan.info.points, 600U);
    ASSERT_EQ(scan.points.size(), 600U);
    EXPECT_EQ(scan.point(299), (FilePoint{299, 149.5, 149.5}));
    EXPECT_EQ(scan.point(300), (FilePoint{2000, 0, 0}));
    EXPECT_THAT(
        englishTexts(scan.info.warnings),
        ::testing::ElementsAre("1 of 3 scans was left out: scan 2 \"Station 2\" (" + b.why + ")."));
  }
}

TEST_F(ReadE57, WhereNoScanIsSoundTheFileIsRefused) {
  const E57Sample sample = threeScans();
  std::string bytes = sample.file();
  const auto damage = [&](std::size_t scan) {
    bytes = E57Sample::changed(bytes, sample.sections()[scan], "\7");
  };
  damage(0);
  damage(1);
  EXPECT_THAT(
      englishTexts(load(bytes).info.warnings),
      ::testing::ElementsAre(HasSubstr("2 of 3 scans were left out: scan 1 \"Station 1\" (a "
                                       "section of its points makes no sense), scan 2")));
  damage(2);
  check({refused("all_broken.e57", bytes, "a section of its points makes no sense")});
}

/// Damage behind right checksums reaches the packets and the XML.
TEST_F(ReadE57, RandomDamageIsLoadedOrRefused) {
  E57SampleScan scan = scaledIntegers();
  scan.share = 3;
  const std::string good = fileOf(scan);
  std::mt19937 random(2026);
  for (int round = 0; round < 150; ++round) {
    std::string bytes = good;
    for (auto n = 1 + random() % 3; n > 0; --n) {
      bytes =
          E57Sample::changed(bytes, random() % 1019, std::string(1, static_cast<char>(random())));
    }
    try {
      EXPECT_GT(load(bytes).points.size(), 0U);
    } catch (const FileError& error) {
      EXPECT_THAT(error.what(), ::testing::StartsWith("Cannot read cloud.e57"));
      EXPECT_THAT(error.what(), ::testing::Not(HasSubstr("broke down")));
    }
  }
}

}  // namespace
}  // namespace relievo
