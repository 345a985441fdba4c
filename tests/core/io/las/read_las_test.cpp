// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "core/io/point_stream.h"
#include "tests/core/io/file_cases.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/io/refusal.h"
#include "tests/core/io/sample_files.h"

namespace relievo {
namespace {

using namespace test;
using namespace std::string_literals;
using ::testing::HasSubstr;

class ReadLas : public FileCases {
 protected:
  Scan load(const Las& las, const ImportOptions& options = {}) {
    return importScan(folder_.write("cloud.las", lasFile(las)), options);
  }
};

TEST_F(ReadLas, EveryVersionAndPointFormatGivesTheSamePoints) {
  for (int minor = 0; minor <= 4; ++minor) {
    for (int format = 0; format <= 10; ++format) {
      SCOPED_TRACE("1." + std::to_string(minor) + " format " + std::to_string(format));
      Las las;
      las.minor = minor;
      las.format = format;
      las.extra_bytes = format % 3;
      if (minor == 4 && format >= 6) las.legacy_promised = 0;
      const Scan scan = load(las);
      ASSERT_EQ(scan.points.size(), 10U);
      EXPECT_EQ(scan.info.points, 10U);
      EXPECT_EQ(scan.info.unit, std::nullopt);
      EXPECT_TRUE(scan.info.warnings.empty());
      for (int i = 0; i < 10; ++i) {
        EXPECT_EQ(scan.point(static_cast<std::size_t>(i)), (FilePoint{i + 0.0, i / 2.0, i / 4.0}));
      }
    }
  }
}

TEST_F(ReadLas, CoordinatesAreStoredTimesScalePlusOffsetToTheLastBit) {
  Las las;
  las.scale = {0.01, 0.001, 1e-7};
  las.offset = {600000.1, 5400000.3, -0.7};
  las.raw = {{{std::numeric_limits<std::int32_t>::min(), -1, 3},
              {1234567, 7654321, -2147483647},
              {std::numeric_limits<std::int32_t>::max(), 0, 2000000011}}};
  las.legacy_promised = 3;
  FileBounds wanted;
  const auto coordinate = [&](std::size_t i, std::size_t axis) {
    return static_cast<double>(las.raw[i][axis]) * las.scale[axis] + las.offset[axis];
  };
  wanted.min = {coordinate(0, 0), coordinate(0, 1), coordinate(1, 2)};
  wanted.max = {coordinate(2, 0), coordinate(1, 1), coordinate(2, 2)};
  EXPECT_EQ(*load(las).info.bounds, wanted);
}

TEST_F(ReadLas, TheUnitComesFromTheProjectionRecords) {
  const auto unit_of = [this](const std::string& record) {
    return load(withRecord(record)).info.unit;
  };
  EXPECT_EQ(unit_of(geoKeys({{1024, 0, 1, 1}, {3076, 0, 1, 9001}})), LengthUnit::m);
  EXPECT_EQ(unit_of(geoKeys({{3076, 0, 1, 9002}})), LengthUnit::ft);
  EXPECT_EQ(unit_of(geoKeys({{3076, 0, 1, 9003}})), LengthUnit::us_ft);
  EXPECT_EQ(unit_of(geoKeys({{3076, 0, 1, 9084}})), std::nullopt);
  EXPECT_EQ(unit_of(geoKeys({{3076, 34736, 1, 9001}})), std::nullopt);
  const std::string projected =
      R"(PROJCS["a",GEOGCS["b",UNIT["degree",0.0174532925199433]],PARAMETER["c",1])";
  EXPECT_EQ(unit_of(variableRecord(2112, projected + ",UNIT[\"metre\",1]]")), LengthUnit::m);
  EXPECT_EQ(
      unit_of(variableRecord(2112, projected + ",UNIT[\"US survey foot\",0.3048006096012192]]\0"s)),
      LengthUnit::us_ft);
  EXPECT_EQ(
      unit_of(variableRecord(2112, "COMPD_CS[\"d\"," + projected +
                                       ",UNIT[\"metre\",1]],VERT_CS[\"e\",UNIT[\"metre\",1]]]")),
      LengthUnit::m);
  EXPECT_EQ(unit_of(variableRecord(2112, projected + "]")), std::nullopt);
  const std::string later =
      R"wkt(PROJCRS["a",BASEGEOGCRS["b",ANGLEUNIT["degree",0.0174532925199433]],CONVERSION["c",)wkt"
      R"wkt(PARAMETER["d",1,SCALEUNIT["unity",1]]],CS[Cartesian,2],AXIS["(E)",east],)wkt"
      R"wkt(LENGTHUNIT["US survey foot",0.304800609601219],ID["EPSG",2992]])wkt";
  EXPECT_EQ(unit_of(variableRecord(2112, later)), LengthUnit::us_ft);
  EXPECT_EQ(unit_of(variableRecord(
                2112, "COMPOUNDCRS[\"d\"," + later + R"(,VERTCRS["e",LENGTHUNIT["metre",1]]])")),
            LengthUnit::us_ft);
  EXPECT_EQ(unit_of(variableRecord(2112, "PROJCS[UNIT[\"")), std::nullopt);
}

/// Numbers by the registry: 26910 UTM zone 10 N, 2263 New York Long Island, 2222 Arizona East,
/// 4326 longitude and latitude.
TEST_F(ReadLas, ASystemWithoutAUnitHasTheUnitOfTheRegistry) {
  const auto info_of = [this](std::uint16_t code) {
    return load(withRecord(geoKeys({{1024, 0, 1, 1}, {3072, 0, 1, code}}))).info;
  };
  EXPECT_EQ(info_of(26910).unit, LengthUnit::m);
  EXPECT_EQ(info_of(2263).unit, LengthUnit::us_ft);
  EXPECT_EQ(info_of(2222).unit, LengthUnit::ft);
  EXPECT_TRUE(info_of(2222).warnings.empty());
  EXPECT_TRUE(info_of(32767).warnings.empty()) << "defined by the user";
  const ScanInfo degrees = info_of(4326);
  EXPECT_FALSE(degrees.unit.has_value());
  EXPECT_THAT(englishTexts(degrees.warnings),
              ::testing::ElementsAre(HasSubstr("degrees, not lengths")));
  EXPECT_THAT(englishTexts(info_of(1).warnings),
              ::testing::ElementsAre(HasSubstr("EPSG:1, which is not known")));
  // The ten points run over 9 feet, a foot being 304.8 mm by definition.
  const Las feet = withRecord(geoKeys({{3072, 0, 1, 2222}}));
  const Scan scan = load(feet);
  EXPECT_DOUBLE_EQ((scan.info.bounds->max.x - scan.info.bounds->min.x) * mmPer(*scan.info.unit),
                   9 * 304.8);
  // The same for points in blocks, and a unit that is stated wins.
  EXPECT_EQ(PointStream(folder_.write("feet.las", lasFile(feet))).info().unit, LengthUnit::ft);
  EXPECT_EQ(load(withRecord(geoKeys({{3072, 0, 1, 2222}, {3076, 0, 1, 9001}}))).info.unit,
            LengthUnit::m);
}

TEST_F(ReadLas, AUnitThatIsNotKnownHereIsSaid) {
  const auto warnings_of = [this](const std::string& record) {
    return englishTexts(load(withRecord(record)).info.warnings);
  };
  EXPECT_THAT(warnings_of(geoKeys({{3076, 0, 1, 9084}})),
              ::testing::ElementsAre(HasSubstr("a unit of code 9084, which is not known here")));
  EXPECT_THAT(warnings_of(variableRecord(
                  2112, R"(PROJCS["a",GEOGCS["b"],UNIT["Clarke's foot",0.3047972654]])")),
              ::testing::ElementsAre(HasSubstr("a unit of 0.3047972654 m, which is not known")));
}

TEST_F(ReadLas, DegreesAndHeightsInAnotherUnitAreSaid) {
  const auto warning_of = [this](const std::string& record) {
    const Scan scan = load(withRecord(record));
    return scan.info.warnings.empty() ? std::string() : englishText(scan.info.warnings.front());
  };
  EXPECT_THAT(warning_of(geoKeys({{1024, 0, 1, 2}})), HasSubstr("degrees"));
  EXPECT_THAT(warning_of(variableRecord(2112, "GEOGCS[\"b\",UNIT[\"degree\",0.01745]]")),
              HasSubstr("degrees"));
  EXPECT_THAT(warning_of(variableRecord(2112, "GEOGCRS[\"b\",ANGLEUNIT[\"degree\",0.01745]]")),
              HasSubstr("degrees"));
  for (const char* const word : {"GEOGRAPHICCRS", "GEODCRS"}) {
    EXPECT_THAT(warning_of(variableRecord(
                    2112, std::string(word) + "[\"b\",ANGLEUNIT[\"degree\",0.01745]]")),
                HasSubstr("degrees"));
  }
  // A unit beside them is no length of x and y.
  EXPECT_EQ(load(withRecord(geoKeys({{1024, 0, 1, 2}, {3076, 0, 1, 9001}}))).info.unit,
            std::nullopt);
  EXPECT_THAT(warning_of(geoKeys({{3076, 0, 1, 9003}, {4099, 0, 1, 9001}})),
              HasSubstr("heights are in m"));
  EXPECT_EQ(warning_of(geoKeys({{3076, 0, 1, 9001}, {4099, 0, 1, 9001}})), "");
  // UTM zone 10 N is in metres by the registry.
  EXPECT_THAT(warning_of(geoKeys({{3072, 0, 1, 26910}, {4099, 0, 1, 9003}})),
              HasSubstr("heights are in us-ft, its x and y in m"));
  EXPECT_EQ(warning_of(geoKeys({{3072, 0, 1, 26910}, {4099, 0, 1, 9001}})), "");
}

TEST_F(ReadLas, HeightsInAnotherUnitBecomeThoseOfXAndY) {
  // By the records alone, and with the unit of x and y from the registry: by import and in blocks.
  const auto check = [this](const std::string& record, double factor) {
    const Scan scan = load(withRecord(record));
    EXPECT_EQ(scan.info.unit, LengthUnit::m);
    EXPECT_THAT(englishTexts(scan.info.warnings),
                ::testing::ElementsAre(HasSubstr("heights were converted to m")));
    for (int i = 0; i < 10; ++i) {
      const FilePoint p = scan.point(static_cast<std::size_t>(i));
      EXPECT_EQ(p.y, i / 2.0);
      EXPECT_NEAR(p.z, i / 4.0 * factor, 1e-7);
    }
    EXPECT_NEAR(scan.info.bounds->max.z, 9 / 4.0 * factor, 1e-7);
    const PointStream stream(folder_.path() / "cloud.las");
    std::array<FilePoint, 10> block;
    EXPECT_EQ(stream.read(0, block), 10U);
    EXPECT_NEAR(block[9].z, 9 / 4.0 * factor, 1e-12);
    EXPECT_EQ(block[9].x, 9);
  };
  check(geoKeys({{3076, 0, 1, 9001}, {4099, 0, 1, 9002}}), 0.3048);
  check(geoKeys({{3072, 0, 1, 26910}, {4099, 0, 1, 9003}}), 1200.0 / 3937.0);
}

TEST_F(ReadLas, TheReferenceSystemIsKept) {
  const auto system_of = [this](const std::string& record) {
    return load(withRecord(record)).info.reference_system;
  };
  EXPECT_EQ(system_of(geoKeys({{1024, 0, 1, 1}, {3072, 0, 1, 26910}})), "EPSG:26910");
  EXPECT_EQ(system_of(geoKeys({{3072, 0, 1, 26910}, {4096, 0, 1, 5703}})), "EPSG:26910+5703");
  EXPECT_EQ(system_of(geoKeys({{1024, 0, 1, 2}, {2048, 0, 1, 4326}})), "EPSG:4326");
  EXPECT_EQ(system_of(geoKeys({{1024, 0, 1, 1}, {3072, 0, 1, 32767}})),
            "GeoTIFF 1024=1 3072=32767");
  const std::string text = R"(PROJCS["a",GEOGCS["b"],UNIT["metre",1]])";
  EXPECT_EQ(system_of(variableRecord(2112, text + std::string(3, '\0'))), text);
  EXPECT_EQ(load({}).info.reference_system, "");
}

/// Planted faults that went unseen: the size of format 8 taken for 36 bytes.
TEST_F(ReadLas, EveryFormatOneByteShortIsRefused) {
  for (int format = 0; format <= 10; ++format) {
    SCOPED_TRACE(format);
    Las las;
    las.minor = 4;
    las.format = format;
    std::string file = lasFile(las);
    const auto record =
        static_cast<std::uint16_t>(kLasRecordBytes[static_cast<std::size_t>(format)] - 1);
    file.replace(105, 2, bytesOf(record));
    EXPECT_THAT(refusalOf([&] { importScan(folder_.write("short.las", file)); }).words,
                HasSubstr("they need " + std::to_string(record + 1)));
  }
}

TEST_F(ReadLas, ACutFileLoadsItsCompletePointsOnRequest) {
  const std::string whole = lasFile({});
  const auto file = folder_.write("cut.las", whole.substr(0, whole.size() - 30));
  const Refusal refusal = refusalOf([&] { importScan(file); });
  EXPECT_EQ(refusal.code, "E101");
  EXPECT_THAT(refusal.words, HasSubstr("promises 10 points, file ends at 8"));
  ImportOptions options;
  options.accept_incomplete = true;
  const Scan scan = importScan(file, options);
  EXPECT_EQ(scan.points.size(), 8U);
  EXPECT_EQ(scan.info.warnings.size(), 1U);
}

TEST_F(ReadLas, OddFilesLoadOrAreRefused) {
  const std::string good = lasFile({});
  const auto with = [](auto change) {
    Las las;
    change(las);
    return lasFile(las);
  };
  const auto patched = [](std::string bytes, std::size_t at, const std::string& value) {
    return bytes.replace(at, value.size(), value);
  };
  const std::string las14 = with([](Las& las) { las.minor = 4; });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  check({
      loads("good.bin", good, 10),
      refused("magic_only.las", "LASF", "shorter than the header"),
      refused("cut_header.las", good.substr(0, 200), "shorter than the header"),
      refused("cut_header14.las", las14.substr(0, 300), "shorter than the header"),
      refused("zeros.las", "LASF"s + std::string(300, '\0'), "LAS version 0.0"),
      refused("version_2.las", patched(good, 24, "\2\0"s), "LAS version 2.0"),
      refused("version_5.las", patched(good, 25, "\5"), "LAS version 1.5"),
      refused("short_header.las", patched(good, 94, bytesOf(std::uint16_t{100})), "227"),
      refused("short_header14.las", patched(las14, 94, bytesOf(std::uint16_t{227})), "375"),
      refused("points_in_header.las", patched(good, 96, bytesOf(10U)), "within itself"),
      refused("points_beyond.las", patched(good, 96, bytesOf(0xFFFFFFF0U)), "file ends at 0"),
      refused("format_11.las", patched(good, 104, "\x0B"), "format 11"),
      refused("compressed.las", patched(good, 104, "\x80"), "no record in it says how"),
      refused("compressed_1.laz", patched(las14, 104, "\x40"), "no record in it says how"),
      refused("short_records.las", patched(good, 105, bytesOf(std::uint16_t{12})), "they need 20"),
      refused("zero_records.las", patched(good, 105, bytesOf(std::uint16_t{0})), "they need 20"),
      refused("huge_count.las", patched(good, 107, bytesOf(0xFFFFFFFFU)), "file ends at 10"),
      refused("huge_count14.las", patched(las14, 247, bytesOf(~std::uint64_t{0})),
              "promises 18 446 744 073 709 551 615 points, file ends at 10"),
      refused("no_points.las", patched(good, 107, bytesOf(0U)), "0 points, none finite"),
      refused("nan_scale.las", with([&](Las& las) { las.scale[1] = nan; }), "scale and offset"),
      refused("zero_scale.las", with([](Las& las) { las.scale[2] = 0; }), "scale and offset"),
      refused("nan_offset.las", with([&](Las& las) { las.offset[0] = nan; }), "scale and offset"),
      refused("far_offset.las", with([](Las& las) { las.offset[0] = 1e300; }), "none finite"),
      loads("records_lie.las", patched(good, 100, bytesOf(0xFFFFFFFFU)), 10),
      loads("record_too_long.las",
            lasFile(withRecord(
                patched(variableRecord(34735, "1234"), 20, bytesOf(std::uint16_t{65535})))),
            10),
      loads("odd_keys.las", lasFile(withRecord(variableRecord(34735, "12345"))), 10),
      loads("bytes_behind.las", good + std::string(1000, 'w'), 10),
      loads("count_of_14_wins.las", with([](Las& las) {
              las.minor = 4;
              las.legacy_promised = 7;
            }),
            10),
  });
}

}  // namespace
}  // namespace relievo
