// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/point_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using namespace test;
using ::testing::HasSubstr;

class PointFilesTest : public ::testing::Test {
 protected:
  /// So many files; the k-th has points of the numbers that follow those before.
  std::vector<std::filesystem::path> write(int files, int points_each) {
    std::vector<std::filesystem::path> names;
    for (int k = 0; k < files; ++k) {
      Las las;
      for (int i = 0; i < points_each + k; ++i) las.raw.push_back({all_ + i, -(all_ + i), k});
      all_ += points_each + k;
      las.promised = las.legacy_promised = static_cast<std::uint32_t>(las.raw.size());
      names.push_back(folder_.write("part" + std::to_string(100 + k) + ".las", lasFile(las)));
    }
    return names;
  }
  std::string refusal(const std::vector<std::filesystem::path>& files) {
    try {
      const PointFiles read(files);
    } catch (const FileError& error) {
      return error.what();
    }
    return "nothing was refused";
  }
  TemporaryFolder folder_;
  int all_ = 0;
};

TEST_F(PointFilesTest, SeveralFilesHaveOneNumbering) {
  const PointFiles files(write(25, 300));  // More than are open at once.
  ASSERT_EQ(files.info().points, static_cast<std::uint64_t>(all_));
  ASSERT_EQ(files.info().parts.size(), 25U);
  EXPECT_EQ(files.info().parts[3].points, 303U);
  std::vector<FilePoint> points(static_cast<std::size_t>(all_) + 10);
  EXPECT_EQ(files.read(0, points), static_cast<std::size_t>(all_));
  for (int i = 0; i < all_; ++i) {
    ASSERT_EQ(points[static_cast<std::size_t>(i)].x, 0.25 * i);
    ASSERT_EQ(points[static_cast<std::size_t>(i)].y, -0.25 * i);
  }
  std::vector<FilePoint> few(7);
  EXPECT_EQ(files.read(298, few), 7U);  // Across the end of the first.
  EXPECT_EQ(few[0].x, 0.25 * 298);
  EXPECT_EQ(few[6].x, 0.25 * 304);
  EXPECT_EQ(files.read(static_cast<std::uint64_t>(all_) - 2, few), 2U);
  EXPECT_EQ(files.read(static_cast<std::uint64_t>(all_), few), 0U);
  const std::vector<PointRange> ranges{{10, 5}, {299, 400}, {5000, 1}};
  std::vector<FilePoint> some(406);
  files.read(ranges, some);
  EXPECT_EQ(some[0].x, 0.25 * 10);
  EXPECT_EQ(some[5].x, 0.25 * 299);
  EXPECT_EQ(some[404].x, 0.25 * 698);
  EXPECT_EQ(some[405].x, 0.25 * 5000);
}

TEST_F(PointFilesTest, ThreadsThatEndDoNotEndTheFilesTheyOpened) {
  const PointFiles files(write(30, 200));
  for (int round = 0; round < 3; ++round) {
    std::vector<std::jthread> readers;
    std::vector<int> wrong(6, 0);
    for (int k = 0; k < 6; ++k) {
      readers.emplace_back([&, k] {
        std::vector<FilePoint> block(500);
        const int first = k * all_ / 6, end = (k + 1) * all_ / 6;
        for (int at = first; at < end; at += 500) {
          const std::size_t got = files.read(static_cast<std::uint64_t>(at), block);
          for (std::size_t i = 0; i < got; ++i) {
            wrong[static_cast<std::size_t>(k)] +=
                block[i].x == 0.25 * (at + static_cast<int>(i)) ? 0 : 1;
          }
        }
      });
    }
    readers.clear();
    EXPECT_EQ(wrong, std::vector<int>(6, 0));
  }
}

TEST_F(PointFilesTest, FilesOfDifferentSystemsAreRefusedByTheirNames) {
  std::vector<std::filesystem::path> files = write(2, 10);
  const auto with_system = [&](const std::string& name, const std::string& text) {
    Las las;
    const std::string record = std::string(2, '\0') + std::string("LASF_Projection") + '\0' +
                               bytesOf(std::uint16_t{2112}) +
                               bytesOf(static_cast<std::uint16_t>(text.size())) +
                               std::string(32, '\0') + text;
    las.variable_records = record;
    las.variable_count = 1;
    return folder_.write(name, lasFile(las));
  };
  const std::string metre = R"(PROJCS["a",UNIT["metre",1]])";
  files.push_back(with_system("metre.las", metre));
  const std::string unit = refusal(files);
  EXPECT_THAT(unit, HasSubstr("part100.las"));
  EXPECT_THAT(unit, HasSubstr("metre.las"));
  EXPECT_THAT(unit, HasSubstr("not of one unit"));
  const auto other = with_system("other.las", R"(PROJCS["b",UNIT["metre",1]])");
  const std::string system = refusal({files.back(), other});
  EXPECT_THAT(system, HasSubstr("different reference systems"));
  EXPECT_THAT(system, HasSubstr("other.las"));
  EXPECT_EQ(refusal({files.back(), with_system("same.las", metre)}), "nothing was refused");
}

TEST_F(PointFilesTest, AFileThatIsNoneIsNamed) {
  std::vector<std::filesystem::path> files = write(2, 10);
  files.push_back(folder_.write("broken.las", "LASF and no more"));
  EXPECT_THAT(refusal(files), HasSubstr("broken.las"));
}

}  // namespace
}  // namespace relievo
