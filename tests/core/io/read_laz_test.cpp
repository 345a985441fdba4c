// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/io/las/las_records.h"
#include "core/io/mapped_file.h"
#include "core/io/point_stream.h"
#include "core/message/catalogue.h"
#include "tests/core/io/laz_sample.h"
#include "tests/core/io/refusal.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using namespace test;
using namespace std::string_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::uint32_t kAnyChunks = ~std::uint32_t{0};

/// All records of a file in memory, one after the other, and what was said of them.
struct Unpacked {
  std::string records;
  std::vector<std::string> doubts;
};

Unpacked unpacked(std::string_view bytes, const LazWanted& wanted = {}, int threads = 1) {
  const std::filesystem::path name = "made.laz";
  const ImportOptions options;
  const Task task;
  const ReadJob job{name, bytes, options, task};
  const LasHeader header = parseLasHeader(bytes, name);
  LasRecords records(job, header, wanted, threads);
  Unpacked result;
  records.forEachBlock([&](const char* at, std::size_t count) {
    result.records.append(at, count * header.record_bytes);
  });
  result.doubts = englishTexts(records.doubts());
  return result;
}

std::string joined(const Records& records) {
  std::string all;
  for (const std::string& record : records) all += record;
  return all;
}

Laz wandering(int format, std::size_t count, std::uint32_t chunk_points = 500,
              std::size_t extra_bytes = 0, unsigned channels = 1) {
  Laz laz;
  laz.how = {.format = format, .extra_bytes = extra_bytes};
  laz.records = wanderingRecords(laz.how, count, channels);
  laz.chunk_points = chunk_points;
  return laz;
}

/// The same without points that lie anywhere.
Laz tame(int format, std::size_t count, unsigned channels = 1) {
  Laz laz = wandering(format, count, 500, 2, channels);
  laz.records = wanderingRecords(laz.how, count, channels, 1, false);
  return laz;
}

TEST(ReadLaz, EveryFormatComesBackBitForBit) {
  for (int format = 0; format <= 10; ++format) {
    for (const std::size_t extra_bytes : {0U, 3U}) {
      for (const std::uint32_t chunk_points : {1U, 2U, 500U, 50'000U}) {
        SCOPED_TRACE(testing::Message() << format << ", " << extra_bytes << ", " << chunk_points);
        const Laz laz = wandering(format, chunk_points == 1 ? 50 : 2103, chunk_points, extra_bytes);
        const Unpacked found = unpacked(lazFile(laz).bytes);
        ASSERT_EQ(found.records, joined(laz.records));
        EXPECT_THAT(found.doubts, IsEmpty());
      }
    }
  }
}

TEST(ReadLaz, TheFirstVersionOfThePackingComesBackBitForBit) {
  for (int format = 0; format <= 5; ++format) {
    for (const std::size_t extra_bytes : {0U, 3U}) {
      for (const bool one_stream : {false, true}) {
        SCOPED_TRACE(testing::Message() << format << ", " << extra_bytes << ", " << one_stream);
        Laz laz = wandering(format, 2103, 500, extra_bytes);
        laz.how.version = 1;
        laz.one_stream = one_stream;
        const Unpacked found = unpacked(lazFile(laz).bytes);
        ASSERT_EQ(found.records, joined(laz.records));
        EXPECT_THAT(found.doubts, IsEmpty());
      }
    }
  }
}

TEST(ReadLaz, ScannerChannelsAreKeptApartAsBothVersionsDo) {
  for (const int format : {6, 7, 8, 9, 10}) {
    for (const int version : {3, 4}) {
      for (const unsigned channels : {2U, 4U}) {
        SCOPED_TRACE(testing::Message() << format << ", " << version << ", " << channels);
        Laz laz = wandering(format, 3000, 1000, 4, channels);
        laz.how.version = version;
        ASSERT_EQ(unpacked(lazFile(laz).bytes).records, joined(laz.records));
      }
    }
  }
}

TEST(ReadLaz, ChunksOfAnyNumberOfPointsAndNoChunksAtAll) {
  for (const int format : {3, 7}) {
    Laz laz = wandering(format, 2000, kAnyChunks);
    laz.chunks = {1, 700, 2, 1297};
    EXPECT_EQ(unpacked(lazFile(laz).bytes).records, joined(laz.records)) << format;
    laz.chunk_points = 0;  // So some programs say it.
    EXPECT_EQ(unpacked(lazFile(laz).bytes).records, joined(laz.records)) << format;
  }
  Laz stream = wandering(1, 2000);
  stream.one_stream = true;
  const Unpacked found = unpacked(lazFile(stream).bytes);
  EXPECT_EQ(found.records, joined(stream.records));
  EXPECT_THAT(found.doubts, IsEmpty());
}

TEST(ReadLaz, TheListOfChunksMayBePointedAtFromTheEnd) {
  const Laz laz = wandering(2, 1200);
  LazBytes file = lazFile(laz);
  file.bytes.replace(file.points_at, 8, bytesOf(~std::uint64_t{0}));
  file.bytes += bytesOf(std::uint64_t{file.table_at});
  EXPECT_EQ(unpacked(file.bytes).records, joined(laz.records));
}

TEST(ReadLaz, FieldsThatNeverChangeTakeNoLayer) {
  Laz laz = wandering(8, 900, 300, 2);
  for (std::string& record : laz.records) record.replace(12, 28, laz.records[0].substr(12, 28));
  EXPECT_EQ(unpacked(lazFile(laz).bytes).records, joined(laz.records));
}

TEST(ReadLaz, WhatIsLeftOutChangesNothingElse) {
  const Laz laz = wandering(8, 1500, 500, 2, 4);
  const std::string bytes = lazFile(laz).bytes;
  const std::string all = unpacked(bytes).records;
  const std::size_t record_bytes = laz.records[0].size();
  // Which bytes of a record hold what can be left out.
  struct Case {
    LazWanted wanted;
    std::vector<std::pair<std::size_t, std::size_t>> missing;
  };
  LazWanted no_classes, no_flags, no_greys, no_colours, no_others;
  no_classes.classes = no_flags.flags = no_greys.intensities = false;
  no_colours.colours = no_others.others = false;
  const std::vector<Case> cases{{no_classes, {{16, 17}}},
                                {no_flags, {{15, 16}}},
                                {no_greys, {{12, 14}}},
                                {no_colours, {{30, 36}}},
                                {no_others, {{17, 30}, {36, 40}}},
                                {kLazCoordinates, {{12, 14}, {15, 40}}}};
  for (const Case& c : cases) {
    std::string expected = all;
    std::string found = unpacked(bytes, c.wanted).records;
    ASSERT_EQ(found.size(), all.size());
    EXPECT_NE(found, all);
    for (std::size_t at = 0; at < all.size(); at += record_bytes) {
      for (const auto& [from, to] : c.missing) {
        for (std::size_t i = from; i < to; ++i) expected[at + i] = found[at + i] = 0;
      }
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(ReadLaz, AnyNumberOfThreadsGivesTheSameRecordsInOrder) {
  for (const int format : {3, 8}) {
    const Laz laz = wandering(format, 20'000, 100, 1, format == 8 ? 4 : 1);
    const std::string bytes = lazFile(laz).bytes;
    for (const int threads : {1, 2, 3, 8, 0}) {
      EXPECT_EQ(unpacked(bytes, {}, threads).records, joined(laz.records)) << threads;
    }
  }
}

/// Points of a cut file, in the order of the file.
std::size_t pointsBeforeCut(const std::string& bytes, std::size_t size, const Laz& laz) {
  const std::string all = joined(laz.records);
  const Unpacked found = unpacked(std::string_view(bytes).substr(0, size));
  EXPECT_TRUE(all.starts_with(found.records)) << size;
  if (found.records.size() < all.size()) {
    EXPECT_THAT(found.doubts, ElementsAre(englishText(said<MessageId::laz_list_missing>())))
        << size;
  }
  return found.records.size() / laz.records[0].size();
}

TEST(ReadLaz, OfACutFileThePointsBeforeTheCutAreRead) {
  for (const int format : {1, 7}) {
    const Laz laz = wandering(format, 120, 50, 1);
    const LazBytes file = lazFile(laz);
    std::size_t before = 0;
    for (std::size_t size = file.points_at + 8; size < file.bytes.size(); ++size) {
      const std::size_t found = pointsBeforeCut(file.bytes, size, laz);
      ASSERT_GE(found, before) << size;
      before = found;
      // Layers come one after the other: nothing of a chunk is whole before all of it is.
      const auto whole = static_cast<std::size_t>(
          std::count_if(file.chunks_at.begin() + 1, file.chunks_at.end(),
                        [size](std::size_t next) { return next <= size; }));
      if (size >= file.chunks_at.back()) continue;
      ASSERT_GE(found, 50 * whole) << size;
      if (format == 7) {
        ASSERT_EQ(found, 50 * whole) << size;
      }
    }
    EXPECT_EQ(before, 120U);
  }
}

TEST(ReadLaz, CutChunksOfAnyNumberOfPointsAreFoundWhereTheySayIt) {
  Laz laz = wandering(7, 120, kAnyChunks, 1);
  laz.chunks = {50, 70};
  laz.levels = {0, 2};
  LazBytes file = lazFile(laz);
  EXPECT_EQ(pointsBeforeCut(file.bytes, file.chunks_at[1] + 20, laz), 50U);
  laz = wandering(1, 120, kAnyChunks);
  laz.chunks = {50, 70};
  file = lazFile(laz);
  EXPECT_EQ(pointsBeforeCut(file.bytes, file.table_at, laz), 0U);
}

TEST(ReadLaz, ChangedBytesAreRefusedOrUnpackedToAsManyRecords) {
  int refused = 0;
  int doubted = 0;
  int unnoticed = 0;
  for (const int format : {3, 8}) {
    Laz laz = tame(format, 300, format == 8 ? 2 : 1);
    laz.chunk_points = 100;
    const LazBytes file = lazFile(laz);
    std::mt19937 random(5);
    for (int i = 0; i < 400; ++i) {
      std::string bytes = file.bytes;
      const std::size_t at =
          file.packing_at + static_cast<std::size_t>(random()) % (bytes.size() - file.packing_at);
      bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1U << random() % 8));
      try {
        const Unpacked found = unpacked(bytes);
        EXPECT_EQ(found.records.size(), joined(laz.records).size());
        if (!found.doubts.empty()) {
          ++doubted;
        } else if (found.records != joined(laz.records)) {
          ++unnoticed;
        }
      } catch (const FileError& error) {
        EXPECT_THAT(error.what(), HasSubstr("Cannot read made.laz: "));
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(doubted, 20);
  EXPECT_LT(unnoticed, 250);
}

class LazFiles : public ::testing::Test {
 protected:
  Scan load(const std::string& bytes) { return importScan(folder_.write("made.laz", bytes)); }
  std::string refusal(const std::string& bytes) {
    return refusalOf([&] { load(bytes); }).words;
  }
  TemporaryFolder folder_;
};

TEST_F(LazFiles, TheImportReadsThePointsOfTheLasOfTheSameRecords) {
  for (const int format : {0, 3, 6, 8}) {
    const Laz laz = wandering(format, 3000, 700);
    const Scan packed = load(lazFile(laz).bytes);
    const Scan plain = importScan(folder_.write("plain.las", lasOf(laz)));
    EXPECT_EQ(packed.points, plain.points);
    EXPECT_EQ(packed.origin, plain.origin);
    EXPECT_EQ(packed.info.bounds, plain.info.bounds);
    EXPECT_EQ(packed.info.format, "LAZ" + plain.info.format.substr(3));
    // Withheld points alone; what a LAS file is asked twice for, packed records tell at once.
    EXPECT_EQ(englishTexts(packed.info.warnings), englishTexts(plain.info.warnings));
    EXPECT_EQ(packed.info.withheld, plain.info.withheld);
    EXPECT_EQ(packed.colours, plain.colours);
    EXPECT_EQ(packed.intensities, plain.intensities);
    EXPECT_EQ(packed.classes, plain.classes);
    EXPECT_EQ(packed.returns, plain.returns);
    EXPECT_FALSE(packed.returns.empty());
    EXPECT_EQ(packed.colours.empty(), format == 0 || format == 6);
  }
}

TEST_F(LazFiles, AStreamReadsAnyOfTheSamePoints) {
  const Laz laz = wandering(7, 20'000, 700, 0, 3);
  ImportOptions all_points;
  all_points.scan.keep_withheld = true;  // NaN would not equal NaN.
  const PointStream packed(folder_.write("made.laz", lazFile(laz).bytes), all_points);
  const PointStream plain(folder_.write("plain.las", lasOf(laz)), all_points);
  ASSERT_EQ(packed.info().points, 20'000U);
  EXPECT_EQ(packed.info().format, "LAZ 1.4 point format 7");
  EXPECT_EQ(packed.statedBounds(), plain.statedBounds());
  std::vector<FilePoint> all(20'000);
  ASSERT_EQ(plain.read(0, all), all.size());
  std::vector<FilePoint> found(all.size());
  ASSERT_EQ(packed.read(0, found), all.size());
  EXPECT_EQ(found, all);
  // Backward, across chunks, and beyond the end.
  for (const std::size_t first : {19'990U, 13'333U, 699U, 0U, 700U}) {
    std::vector<FilePoint> block(1500);
    const std::size_t got = packed.read(first, block);
    ASSERT_EQ(got, std::min<std::size_t>(1500, all.size() - first));
    for (std::size_t i = 0; i < got; ++i) ASSERT_EQ(block[i], all[first + i]);
  }
  std::vector<FilePoint> parts(all.size());
  {
    std::vector<std::jthread> threads;
    for (std::size_t part = 0; part < 4; ++part) {
      threads.emplace_back([&packed, &parts, part] {
        for (std::size_t i = 0; i < 50; ++i) {
          const std::size_t first = part * 5000 + i * 100;
          packed.read(first, std::span(parts).subspan(first, 100));
        }
      });
    }
  }
  EXPECT_EQ(parts, all);
  // Withheld points are the same ones.
  const PointStream some_packed(folder_.path() / "made.laz");
  const PointStream some_plain(folder_.path() / "plain.las");
  ASSERT_EQ(some_packed.read(0, found), all.size());
  ASSERT_EQ(some_plain.read(0, parts), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_EQ(isFinite(found[i]), isFinite(parts[i])) << i;
  }
}

TEST_F(LazFiles, ACutFileIsRefusedOrReadInPartAsACutLasIs) {
  const Laz laz = wandering(7, 1200, 500);
  const LazBytes whole = lazFile(laz);
  const auto file = folder_.write("made.laz", whole.bytes.substr(0, whole.chunks_at[2] + 5));
  const std::string refused = refusalOf([&] { importScan(file); }).words;
  EXPECT_EQ(refused,
            "Cannot read made.laz: header promises 1 200 points, file ends at 1 000. Nothing was "
            "loaded. Load the 1 000 complete points, or choose another file.");
  EXPECT_EQ(refusalOf([&] { const PointStream stream(file); }).words, refused);
  ImportOptions incomplete;
  incomplete.accept_incomplete = true;
  incomplete.scan.keep_withheld = true;
  const Scan scan = importScan(file, incomplete);
  EXPECT_EQ(scan.points.size(), 1000U);
  EXPECT_THAT(englishTexts(scan.info.warnings),
              ElementsAre(HasSubstr("promises 1 200 points, it ends at 1 000"),
                          HasSubstr("withheld"), englishText(said<MessageId::laz_list_missing>())));
  const PointStream stream(file, incomplete);
  EXPECT_EQ(stream.info().points, 1000U);
  const PointStream plain(folder_.write("plain.las", lasOf(laz)), incomplete);
  std::vector<FilePoint> found(1000), expected(1000);
  ASSERT_EQ(stream.read(0, found), 1000U);
  ASSERT_EQ(plain.read(0, expected), 1000U);
  EXPECT_EQ(found, expected);
  // Cut so that nothing is left, and so that nothing but the list is missing.
  const std::string none = whole.bytes.substr(0, whole.chunks_at[0] + 5);
  EXPECT_THAT(refusal(none), HasSubstr("file ends at 0. Nothing was loaded."));
  EXPECT_THAT(refusalOf([&] { importScan(folder_.write("made.laz", none), incomplete); }).words,
              HasSubstr("0 points"));
  const Scan listless = load(whole.bytes.substr(0, whole.table_at));
  EXPECT_EQ(listless.info.points, 1200U);
}

TEST_F(LazFiles, AStreamThatIsStoppedUnpacksNoMore) {
  std::stop_source stop;
  const PointStream packed(folder_.write("made.laz", lazFile(wandering(3, 5000)).bytes), {},
                           {.stop = stop.get_token(), .progress = {}});
  std::vector<FilePoint> block(10);
  EXPECT_EQ(packed.read(0, block), 10U);
  stop.request_stop();
  EXPECT_THROW(packed.read(4000, block), Cancelled);
}

TEST_F(LazFiles, WhatIsNotUnpackedHereIsSaid) {
  const LazBytes old = lazFile(wandering(1, 100));
  const LazBytes layered = lazFile(wandering(6, 100));
  const auto with = [](const LazBytes& file, std::size_t at, const std::string& value) {
    std::string bytes = file.bytes;
    return bytes.replace(file.packing_at + at, value.size(), value);
  };
  EXPECT_THAT(refusal(with(old, 38, "\5")), HasSubstr("version 5"));
  EXPECT_THAT(refusal(with(layered, 38, "\5")), HasSubstr("version 5"));
  EXPECT_THAT(refusal(with(old, 40, "\x09")), HasSubstr("fields of kind 9 with 8 bytes"));
  const LazBytes waves = lazFile(wandering(4, 100));
  EXPECT_THAT(refusal(with(waves, 50, "\2")), HasSubstr("version 2"));
  EXPECT_THAT(refusal(with(old, 40, "\x05")), HasSubstr("fields of kind 5"));
  EXPECT_THAT(refusal(with(old, 0, "\7")), HasSubstr("a way (7) that is not known here"));
  EXPECT_THAT(refusal(with(old, 2, "\1")), HasSubstr("not known here"));
  EXPECT_THAT(refusal(with(old, 0, "\3")), HasSubstr("do not exist there"));
  EXPECT_THAT(refusal(with(old, 32, "\1\0"s)), HasSubstr("28 bytes, its record of packing 20"));
  EXPECT_THAT(refusal(with(old, 32, "\xFF")), HasSubstr("record of packing is cut"));
  EXPECT_THAT(refusal(with(old, 12, bytesOf(0U))), HasSubstr("promises 100 points"));
}

TEST_F(LazFiles, ListsOfChunksThatCannotBeAreRefused) {
  const LazBytes good = lazFile(wandering(1, 1000));
  const auto with = [&good](std::size_t at, const std::string& value) {
    std::string bytes = good.bytes;
    return bytes.replace(at, value.size(), value);
  };
  const auto place = [&](std::uint64_t at) { return with(good.points_at, bytesOf(at)); };
  // As if it were cut off.
  for (const std::uint64_t beyond :
       {std::uint64_t{good.bytes.size()} - 7, std::uint64_t{1} << 63U}) {
    EXPECT_THAT(englishTexts(load(place(beyond)).info.warnings),
                ::testing::Contains(englishText(said<MessageId::laz_list_missing>())));
  }
  EXPECT_THAT(refusal(place(0)), HasSubstr("within its header"));
  EXPECT_THAT(refusal(with(good.table_at, "\1")), HasSubstr("is none"));
  EXPECT_THAT(refusal(with(good.table_at + 4, bytesOf(~std::uint32_t{0}))), HasSubstr("is none"));
  EXPECT_THAT(refusal(with(good.table_at + 4, bytesOf(0U))), HasSubstr("promises 1 000 points"));
  EXPECT_THAT(refusal(with(good.table_at + 8, "\xFF\xFF\xFF\xFF")), HasSubstr("no coder writes"));
  EXPECT_THAT(refusal(with(107, bytesOf(1001U))), HasSubstr("promises 1 001 points"));
  EXPECT_THAT(refusal(with(107, bytesOf(500U))), HasSubstr("promises 500 points"));
  EXPECT_THAT(refusal(with(107, bytesOf(0U))), HasSubstr("0 points"));
  std::string unnamed = good.bytes;
  unnamed[good.packing_at - 52] = 'x';
  EXPECT_THAT(refusal(unnamed), HasSubstr("no record in it says how its points are packed"));
}

TEST_F(LazFiles, DamagedChunksAreNamed) {
  const LazBytes file = lazFile(wandering(7, 1000));
  std::string bytes = file.bytes;
  bytes.replace(file.chunks_at[1] + 36, 4, bytesOf(499U));
  EXPECT_THAT(refusal(bytes), HasSubstr("block of points number 2 says another number of points"));
  bytes = file.bytes;
  bytes.replace(file.chunks_at[1] + 40, 4, bytesOf(~std::uint32_t{0}));
  EXPECT_THAT(refusal(bytes), HasSubstr("block of points number 2 is shorter than its layers"));
  bytes.replace(file.chunks_at[1] + 40, 4, bytesOf(0U));
  EXPECT_THAT(refusal(bytes), HasSubstr("block of points number 2 holds no coordinates"));
  std::vector<FilePoint> block(10);
  const PointStream stream(folder_.write("made.laz", bytes));
  EXPECT_EQ(stream.read(0, block), 10U);
  EXPECT_THAT(refusalOf([&] { stream.read(600, block); }).words, HasSubstr("number 2"));
}

TEST_F(LazFiles, WhatOnlyLooksRightIsDoubted) {
  Laz laz = tame(1, 1000);
  for (std::string& record : laz.records) record[15] &= 0x7F;  // Withheld points are said, too.
  std::string bytes = lazFile(laz).bytes;
  ASSERT_THAT(load(bytes).info.warnings, IsEmpty());
  const std::string good = bytes;
  // The largest x.
  const auto middle = numberOf<double>(&good[179]) / 2 + numberOf<double>(&good[187]) / 2;
  bytes.replace(179, 8, bytesOf(middle));
  EXPECT_THAT(englishTexts(load(bytes).info.warnings), ElementsAre(HasSubstr("outside the box")));
  bytes = good;
  bytes.replace(111, 8, good.substr(115, 4) + good.substr(111, 4));
  EXPECT_THAT(englishTexts(load(bytes).info.warnings),
              ElementsAre(HasSubstr("not of the returns")));
  laz.padding = kLazSlack;
  EXPECT_THAT(load(lazFile(laz).bytes).info.warnings, IsEmpty());
  laz.padding = kLazSlack + 1;
  EXPECT_THAT(englishTexts(load(lazFile(laz).bytes).info.warnings),
              ElementsAre(HasSubstr("hold bytes behind")));
}

/// Levels 0, 1 and 2 of 40, 4 x 100 and 4 x 300 points.
Laz pyramid() {
  Laz laz = wandering(7, 1640, kAnyChunks);
  laz.chunks = {300, 100, 40, 300, 100, 100, 300, 100, 300};
  laz.levels = {2, 1, 0, 2, 1, 1, 2, 1, 2};
  return laz;
}

TEST_F(LazFiles, CopcGivesItsCoarsestLevelsFirst) {
  const Laz laz = pyramid();
  const PointStream stream(folder_.write("made.laz", lazFile(laz).bytes));
  EXPECT_EQ(stream.info().points, 1640U);
  const PointRange root{400, 40};
  EXPECT_THAT(stream.cheapSample(40), ElementsAre(root));
  EXPECT_THAT(stream.cheapSample(439), ElementsAre(root));
  EXPECT_THAT(stream.cheapSample(440), ElementsAre(PointRange{300, 100}, root, PointRange{740, 100},
                                                   PointRange{840, 100}, PointRange{1240, 100}));
  EXPECT_EQ(stream.cheapSample(1640).size(), 9U);
  // Where even the root is too much, the beginning of each chunk.
  EXPECT_EQ(stream.cheapSample(18).size(), 9U);
  EXPECT_EQ(stream.cheapSample(18)[1], (PointRange{300, 2}));
}

TEST_F(LazFiles, CopcIsReadWhole) {
  const Laz laz = pyramid();
  const Scan scan = load(lazFile(laz).bytes);
  const Scan plain = importScan(folder_.write("plain.las", lasOf(laz)));
  EXPECT_EQ(scan.points, plain.points);
}

TEST_F(LazFiles, CopcWhoseRecordNamesNoSizeOfChunksIsReadWhole) {
  Laz laz = pyramid();
  const Scan plain = importScan(folder_.write("plain.las", lasOf(laz)));
  laz.chunk_points = 0;
  const std::filesystem::path file = folder_.write("made.laz", lazFile(laz).bytes);
  EXPECT_EQ(importScan(file).points, plain.points);
  EXPECT_THAT(PointStream(file).cheapSample(40), ElementsAre(PointRange{400, 40}));
}

TEST_F(LazFiles, HierarchiesThatCannotBeAreRefused) {
  const LazBytes good = lazFile(pyramid());
  constexpr std::size_t kRootPlace = 375 + 54 + 40;
  const auto with = [&good](std::size_t at, const std::string& value) {
    std::string bytes = good.bytes;
    return bytes.replace(at, value.size(), value);
  };
  // Entries: level, x, y, z at 0, 4, 8, 12; place at 16, bytes at 24, points at 28.
  const std::size_t page = good.root_at + 5 * 32;
  const auto refused = [&](const std::string& bytes, const std::string& words) {
    EXPECT_THAT(refusal(bytes), HasSubstr("its COPC hierarchy " + words));
    const auto file = folder_.write("made.laz", bytes);
    EXPECT_THAT(refusalOf([&] { const PointStream stream(file); }).words, HasSubstr(words));
  };
  refused(with(page + 16, bytesOf(std::uint64_t{good.root_at}) + bytesOf(6 * 32)),
          "leads in a circle");
  refused(
      with(good.child_at + 16, bytesOf(std::uint64_t{good.child_at}) + bytesOf(32) + bytesOf(-1)),
      "leads in a circle");
  refused(with(page + 16, bytesOf(std::uint64_t{good.bytes.size()})),
          "has a page outside the file");
  refused(with(page + 24, bytesOf(0)), "has a page outside the file");
  refused(with(page + 24, bytesOf(-32)), "has a page outside the file");
  refused(with(kRootPlace, bytesOf(~std::uint64_t{0})), "has a page outside the file");
  refused(with(kRootPlace + 8, bytesOf(std::uint64_t{33})), "has a page outside the file");
  refused(with(kRootPlace + 8, bytesOf(std::uint64_t{32})), "leaves out points");
  refused(with(good.root_at + 28, bytesOf(99)), "names points that are no block");
  refused(with(good.root_at + 24, bytesOf(1)), "names points that are no block");
  refused(with(good.root_at + 28, bytesOf(-2)), "names points that are no block");
  refused(with(good.root_at + 28, bytesOf(0)), "leaves out points");
  refused(with(good.root_at, bytesOf(-1)), "has a node outside its octree");
  refused(with(good.root_at, bytesOf(31)), "has a node outside its octree");
  refused(with(good.root_at + 4, bytesOf(2)), "has a node outside its octree");
  const std::string first = good.bytes.substr(good.root_at, 32);
  refused(with(good.root_at + 64, first), "names a block of points twice");
}

TEST(SharedLaz, HoldsTheRecordsOfItsLas) {
  const std::filesystem::path data = sharedData();
  if (data.empty()) GTEST_SKIP() << "the shared scans are not here";
  const MappedFile packed(data / "las" / "autzen_trim.laz");
  const MappedFile plain(data / "las" / "autzen_trim.las");
  EXPECT_EQ(unpacked(packed.bytes(), {}, 2).records, unpacked(plain.bytes()).records);
  EXPECT_THAT(unpacked(packed.bytes()).doubts, IsEmpty());
  const Scan scan = importScan(data / "las" / "autzen_trim.laz");
  EXPECT_EQ(scan.points, importScan(data / "las" / "autzen_trim.las").points);
  EXPECT_THAT(scan.info.warnings, IsEmpty());
}

}  // namespace
}  // namespace relievo
