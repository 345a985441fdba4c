// SPDX-License-Identifier: BSD-3-Clause
// One scan in several files, and maps whose making was stopped: the same files as of one file, made
// at once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/session/input_names.h"
#include "core/session/large/large_map.h"
#include "tests/core/session/raw_clouds.h"
#include "tests/core/session/tiled_fixture.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using test::lasOf;
using test::lazOf;
using test::Raw;
using test::write;
using ::testing::HasSubstr;

constexpr double kScale = test::kRawScale;

/// A relief of 1000 x 900 cells of 1/4 mm with a hole, a wall and a back, in rows as a scan has it.
Raw relief(int points) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> place(0, 999 * 128);
  Raw raw{{0, 0, 0}, {999 * 128, 899 * 128, 0}};
  while (static_cast<int>(raw.size()) < points) {
    const int x = place(random);
    const auto y = static_cast<int>(static_cast<double>(raw.size()) / points * 899 * 128);
    const double u = x * kScale, v = y * kScale;
    if (std::hypot(u - 120, v - 130) < 15) continue;
    double z = 10 + 3 * std::sin(u / 17) * std::cos(v / 23) + (u > 180 ? 12 : 0);
    if (raw.size() % 7 == 0) z -= 30;
    raw.push_back({x, y, static_cast<std::int32_t>(std::lround(z / kScale))});
  }
  return raw;
}

std::string plyOf(const Raw& raw) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(raw.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
  for (const auto& point : raw) {
    for (const std::int32_t stored : point) bytes += test::bytesOf(stored * kScale);
  }
  return bytes;
}

std::string bytesOfFile(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// All files of a map.
std::string bytesOfMap(const fs::path& finest) {
  std::string all;
  for (const char* end : {".tif", ".origin.tif", ".L1.tif", ".L1.origin.tif", ".L2.tif",
                          ".L2.origin.tif", ".L3.tif"}) {
    fs::path file = finest;
    all += bytesOfFile(file.replace_extension(end));
  }
  return all;
}

TEST(MapOfParts, IsTheMapOfOneFileForEveryFormatAndOrderOfNames) {
  const test::TileFolder folder;
  const Raw raw = relief(60'000);
  const auto piece = [&](std::size_t first, std::size_t end) {
    return Raw(raw.begin() + static_cast<std::ptrdiff_t>(first),
               raw.begin() + static_cast<std::ptrdiff_t>(end));
  };
  SurfaceOptions options = test::topOptions(PointRule::median);
  options.rule.reset();  // Chosen from all files.
  options.spacing_mm = 1;
  const auto made = [&](const std::vector<fs::path>& names, const char* map) {
    makeLargeMap(filesNamed(names), options,
                 {.file = folder / map, .memory_bytes = 400'000'000, .threads = 2, .on_view = {}});
    return bytesOfMap(folder / map);
  };
  struct Format {
    const char* ending;
    std::string (*of)(const Raw&);
  };
  std::string of_las;
  for (const Format& format : {Format{".las", lasOf}, {".laz", lazOf}, {".ply", plyOf}}) {
    SCOPED_TRACE(format.ending);
    const auto file = [&](const std::string& name) { return folder / (name + format.ending); };
    fs::create_directories(folder / format.ending);
    write(file("whole"), format.of(raw));
    std::vector<fs::path> parts;
    const std::size_t cuts[] = {0, 1, 777, 20'000, 43'210, raw.size()};
    for (std::size_t k = 0; k + 1 < std::size(cuts); ++k) {
      parts.push_back(file(std::string(format.ending) + "/" + std::to_string(k)));
      write(parts.back(), format.of(piece(cuts[k], cuts[k + 1])));
    }
    const std::string whole = made({file("whole")}, "whole.tif");
    EXPECT_GT(whole.size(), 100'000U);
    if (of_las.empty()) of_las = whole;
    EXPECT_TRUE(whole == of_las);
    EXPECT_TRUE(made(parts, "parts.tif") == whole);
    std::shuffle(parts.begin(), parts.end(), std::mt19937(5));
    EXPECT_TRUE(made(parts, "shuffled.tif") == whole);
    EXPECT_TRUE(made({folder / format.ending}, "folder.tif") == whole);
  }
}

TEST(MapOfParts, RefusesWhatIsNoCloudByItsName) {
  const test::TileFolder folder;
  write(folder / "a.las", lasOf(relief(100)));
  write(folder / "b.las", "no scan at all, and no points");
  try {
    makeLargeMap(std::vector{folder / "a.las", folder / "b.las"},
                 test::topOptions(PointRule::median), {.file = folder / "m.tif", .on_view = {}});
    FAIL() << "was accepted";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("b.las"));
  }
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

/// Makes one map again and again in processes of their own that are killed.
class StoppedMap : public ::testing::Test {
 protected:
  static constexpr const char* kFolder = "RELIEVO_TEST_STOPPED_MAP";
  static constexpr std::uint64_t kPart = 40'000;

  static LargeMapOptions large(const fs::path& folder, const fs::path& map, bool with_job) {
    LargeMapOptions options{.file = map, .memory_bytes = 250'000'000, .threads = 2, .on_view = {}};
    if (with_job) {
      options.job = {.folder = folder / "job", .facts = {{"an option", "1"}}, .part_points = kPart};
    }
    return options;
  }
  static SurfaceOptions options() {
    SurfaceOptions options = test::topOptions(PointRule::median);
    options.rule.reset();
    return options;
  }
  static int filesIn(const fs::path& folder) {
    std::error_code unknown;
    int count = 0;
    for (auto at = fs::recursive_directory_iterator(folder, unknown);
         !unknown && at != fs::recursive_directory_iterator(); at.increment(unknown)) {
      count += at->path().extension() == ".part" ? 1 : 0;
    }
    return count;
  }
  /// Starts this test in a process that makes the map, and kills it when so many more parts are
  /// there and some time has gone. @return  whether it ended by itself before
  static bool killedAfter(const fs::path& folder, int parts, std::chrono::microseconds then) {
    const int before = filesIn(folder / "job");
    const std::string self = fs::read_symlink("/proc/self/exe").string();
    const pid_t child = ::fork();
    if (child == 0) {
      ::setenv(kFolder, folder.c_str(), 1);
      ::execl(self.c_str(), self.c_str(), "--gtest_filter=StoppedMap.IsTheSameAfterKills*",
              nullptr);
      ::_exit(127);
    }
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
      if (filesIn(folder / "job") - before >= parts) {
        std::this_thread::sleep_for(then);
        ::kill(child, SIGKILL);
        ::waitpid(child, &status, 0);
        break;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return WIFEXITED(status);
  }
};

TEST_F(StoppedMap, IsTheSameAfterKillsAtRandomMoments) {
  if (const char* const given = std::getenv(kFolder)) {  // In a process that is to be killed.
    const fs::path there = given;
    makeLargeMap(there / "scan.las", options(), large(there, there / "map.tif", true));
    return;
  }
  const test::TileFolder folder;
  write(folder / "scan.las", lasOf(relief(400'000)));  // Ten parts, four rows of tiles.
  makeLargeMap(folder / "scan.las", options(), large(folder.path(), folder / "once.tif", false));
  const std::string once = bytesOfMap(folder / "once.tif");
  ASSERT_GT(once.size(), 1'000'000U);
  const unsigned seed = 20;
  std::mt19937 random(seed);
  std::uint64_t points = 0;
  int rows = 0;
  for (int round = 0; round < 4; ++round) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round));
    int kills = 0;
    for (; kills < 3; ++kills) {
      const auto then = std::chrono::microseconds(random() % 60'000);
      if (killedAfter(folder.path(), static_cast<int>(1 + random() % 5), then)) break;
    }
    const LargeMap map = makeLargeMap(folder / "scan.las", options(),
                                      large(folder.path(), folder / "map.tif", true));
    ASSERT_TRUE(map.taken_over);
    EXPECT_EQ(map.taken_over->damaged, 0);
    points += map.taken_over->points;
    rows += map.taken_over->rows;
    if (map.taken_over->parts > 0 || map.taken_over->rows > 0) {
      EXPECT_THAT(englishText(map.messages), HasSubstr("Went on with earlier work"));
    }
    std::printf("%d kills; taken over: %llu points in %llu parts, %d rows\n", kills,
                static_cast<unsigned long long>(map.taken_over->points),
                static_cast<unsigned long long>(map.taken_over->parts), map.taken_over->rows);
    EXPECT_TRUE(bytesOfMap(folder / "map.tif") == once);
    EXPECT_FALSE(fs::exists(folder / "job")) << "the work is done";
  }
  EXPECT_GT(points + static_cast<std::uint64_t>(rows), 0U) << "nothing was ever taken over";
}

TEST_F(StoppedMap, MakesDamagedPartsAnewAndTakesTheOthers) {
  const test::TileFolder folder;
  write(folder / "scan.las", lasOf(relief(400'000)));
  makeLargeMap(folder / "scan.las", options(), large(folder.path(), folder / "once.tif", false));
  // Stopped when half of its points are in tiles; and once when rows have their heights.
  for (const char* const where : {"points/000000002.part", "heights/000000001.part"}) {
    std::stop_source stop;
    const Task task{.stop = stop.get_token(), .progress = [&](std::string_view, double) {
                      if (fs::exists(folder / "job" / where)) stop.request_stop();
                    }};
    EXPECT_THROW(makeLargeMap(folder / "scan.las", options(),
                              large(folder.path(), folder / "map.tif", true), {}, task),
                 Cancelled);
    std::string bytes = bytesOfFile(folder / "job" / where);
    ASSERT_GT(bytes.size(), 1000U) << where;
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
    write(folder / "job" / where, bytes);
    const LargeMap map = makeLargeMap(folder / "scan.las", options(),
                                      large(folder.path(), folder / "map.tif", true));
    EXPECT_EQ(map.taken_over->damaged, 1) << where;
    EXPECT_GT(map.taken_over->points, 0U) << where;
    EXPECT_TRUE(bytesOfMap(folder / "map.tif") == bytesOfMap(folder / "once.tif")) << where;
  }
}

#endif

}  // namespace
}  // namespace relievo
