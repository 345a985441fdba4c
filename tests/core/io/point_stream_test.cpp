// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/point_stream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/io/refusal.h"
#include "tests/core/io/sample_files.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using namespace test;
using namespace std::string_literals;
using ::testing::HasSubstr;

/// 100 000 points in UTM's numbers: more than one buffer of the stream.
Las largeLas() {
  Las las;
  las.format = 3;
  las.scale = {0.001, 0.001, 0.001};
  las.offset = {512000.1, 5403000.3, 200};
  for (std::int32_t i = 0; i < 100'000; ++i) las.raw.push_back({i * 7, i * -3, i % 977});
  las.legacy_promised = 100'000;
  return las;
}

class PointStreams : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& bytes) {
    return folder_.write(name, bytes);
  }
  static std::vector<FilePoint> readAll(const PointStream& stream, std::size_t block_size) {
    std::vector<FilePoint> points;
    std::vector<FilePoint> block(block_size);
    while (const std::size_t got = stream.read(points.size(), block)) {
      points.insert(points.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(got));
    }
    return points;
  }
  TemporaryFolder folder_;
};

TEST_F(PointStreams, LasPointsAreStoredTimesScalePlusOffsetInBlocksOfAnySize) {
  const Las las = largeLas();
  const auto file = write("large.las", lasFile(las));
  ASSERT_TRUE(PointStream::canStream(file));
  const PointStream stream(file);
  EXPECT_EQ(stream.info().points, 100'000U);
  EXPECT_EQ(stream.info().format, "LAS 1.2 point format 3");
  for (const std::size_t block_size : {1'000'000U, 4096U, 77'777U}) {
    const std::vector<FilePoint> points = readAll(stream, block_size);
    ASSERT_EQ(points.size(), las.raw.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& raw = las.raw[i];
      const FilePoint wanted{raw[0] * las.scale[0] + las.offset[0],
                             raw[1] * las.scale[1] + las.offset[1],
                             raw[2] * las.scale[2] + las.offset[2]};
      ASSERT_EQ(points[i], wanted) << i;
    }
  }
}

TEST_F(PointStreams, HoldsThePointsThatTheImportReads) {
  const auto file = write("large.las", lasFile(largeLas()));
  const Scan scan = importScan(file);
  const PointStream stream(file);
  const std::vector<FilePoint> points = readAll(stream, 5000);
  ASSERT_EQ(points.size(), scan.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const FilePoint p = points[i] - scan.origin;
    ASSERT_EQ(scan.points[i], (std::array{static_cast<float>(p.x), static_cast<float>(p.y),
                                          static_cast<float>(p.z)}));
  }
}

TEST_F(PointStreams, SeveralThreadsReadOneStream) {
  const PointStream stream(write("large.las", lasFile(largeLas())));
  const std::vector<FilePoint> whole = readAll(stream, 100'000);
  std::vector<FilePoint> parts(whole.size());
  {
    std::vector<std::jthread> threads;
    for (std::size_t part = 0; part < 4; ++part) {
      threads.emplace_back([&stream, &parts, part] {
        for (std::size_t i = 0; i < 10; ++i) {
          const std::size_t first = part * 25'000 + i * 2500;
          stream.read(first, std::span(parts).subspan(first, 2500));
        }
      });
    }
  }
  EXPECT_EQ(parts, whole);
}

TEST_F(PointStreams, BinaryPlyOfBothByteOrdersAndOfDoubles) {
  const auto file = write(
      "camera_first.ply",
      "ply\nformat binary_big_endian 1.0\ncomment unit cm\nelement camera 3\nproperty short a\n"
      "element vertex 4\nproperty uchar red\nproperty double z\nproperty double y\n"
      "property double x\nend_header\n" +
          "abcdef"s + "r" + bytesOf(3.5, true) + bytesOf(2.5, true) + bytesOf(1e7 + 0.125, true) +
          "r" + bytesOf(0.0, true) + bytesOf(std::nan(""), true) + bytesOf(1.0, true) + "r" +
          bytesOf(0.0, true) + bytesOf(0.0, true) + bytesOf(2e38, true) + "r" + bytesOf(6.0, true) +
          bytesOf(5.0, true) + bytesOf(4.0, true));
  const PointStream stream(file);
  EXPECT_EQ(stream.info().unit, LengthUnit::cm);
  EXPECT_EQ(stream.info().format, "PLY binary_big_endian");
  const std::vector<FilePoint> points = readAll(stream, 3);
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points[0], (FilePoint{1e7 + 0.125, 2.5, 3.5}));
  for (const std::size_t i : {1U, 2U}) {
    EXPECT_TRUE(std::isnan(points[i].x) && std::isnan(points[i].y) && std::isnan(points[i].z));
  }
  EXPECT_EQ(points[3], (FilePoint{4, 5, 6}));

  const PointStream floats(
      write("floats.ply", plyHeader("binary_little_endian", "10") + binaryRows<float>(10)));
  EXPECT_EQ(readAll(floats, 4).at(9), (FilePoint{9, 4.5, 2.25}));
}

TEST_F(PointStreams, ReadingBeyondTheEndGivesWhatIsThere) {
  const PointStream stream(write("ten.las", lasFile({})));
  std::vector<FilePoint> block(8);
  EXPECT_EQ(stream.read(6, block), 4U);
  EXPECT_EQ(block[3], (FilePoint{9, 4.5, 2.25}));
  EXPECT_EQ(stream.read(10, block), 0U);
  EXPECT_EQ(stream.read(~std::uint64_t{0}, block), 0U);
}

TEST_F(PointStreams, TheBoxOfALasHeaderIsPassedOnIfItIsOne) {
  std::string bytes = lasFile({});
  EXPECT_FALSE(PointStream(write("none.las", bytes)).statedBounds().has_value());
  const std::array<double, 6> box{9, 0, 4.5, 0, 2.25, 0};
  for (std::size_t i = 0; i < 6; ++i) bytes.replace(179 + 8 * i, 8, bytesOf(box[i]));
  const FileBounds wanted{{0, 0, 0}, {9, 4.5, 2.25}};
  EXPECT_EQ(PointStream(write("box.las", bytes)).statedBounds(), wanted);
  bytes.replace(179, 8, bytesOf(-1.0));
  EXPECT_FALSE(PointStream(write("odd.las", bytes)).statedBounds().has_value());
}

TEST_F(PointStreams, ACutFileIsE101UnlessAccepted) {
  const std::string bytes = lasFile({});
  const auto file = write("cut.las", bytes.substr(0, bytes.size() - 30));
  const Refusal refusal = refusalOf([&] { const PointStream stream(file); });
  EXPECT_EQ(refusal.code, "E101");
  EXPECT_THAT(refusal.words, HasSubstr("promises 10 points, file ends at 8"));
  ImportOptions options;
  options.accept_incomplete = true;
  const PointStream stream(file, options);
  EXPECT_EQ(stream.info().points, 8U);
  EXPECT_EQ(stream.info().warnings.size(), 1U);
}

TEST_F(PointStreams, AFileCutWhileItIsReadIsAnErrorNotACrash) {
  const auto file = write("shrinks.las", lasFile(largeLas()));
  const PointStream stream(file);
  std::filesystem::resize_file(file, 2000);
  std::vector<FilePoint> block(1000);
  const Refusal refusal = refusalOf([&] { stream.read(50'000, block); });
  EXPECT_THAT(refusal.words, HasSubstr("became shorter"));
}

TEST_F(PointStreams, OnlyFixedRecordsAreStreamed) {
  EXPECT_FALSE(PointStream::canStream(write("a.xyz", textRows(10))));
  EXPECT_FALSE(PointStream::canStream(write("a.ply", plyHeader("ascii", "10") + textRows(10))));
  const auto lists = write("l.ply", plyHeader("binary_little_endian", "10", "float",
                                              "property list uchar int neighbours\n") +
                                        std::string(200, '\0'));
  EXPECT_FALSE(PointStream::canStream(lists));
  EXPECT_THROW(PointStream{lists}, FileError);
  const auto huge = write(
      "huge.ply", "ply\nformat binary_little_endian 1.0\nelement camera 1099511627776\n" +
                      [] {
                        std::string lines;
                        for (int i = 0; i < 4000; ++i) {
                          lines += "property double p" + std::to_string(i) + "\n";
                        }
                        return lines;
                      }() +
                      "element vertex 4\nproperty float x\nproperty float y\n"
                      "property float z\nend_header\n");
  const Refusal refusal = refusalOf([&] { const PointStream stream(huge); });
  EXPECT_THAT(refusal.words, HasSubstr("promises 4 points, file ends at 0"));
}

}  // namespace
}  // namespace relievo
