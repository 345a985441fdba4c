// SPDX-License-Identifier: BSD-3-Clause
// Maps that several processes make together: the files of one process, whoever made which part, and
// whatever became of one of them. Threads stand for the processes, each with an exchange of its
// own; programs that MPI starts: app/cli/tiles_by_mpi_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <mutex>
#include <random>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/io/raster/colour_raster.h"
#include "core/session/large/large_map.h"
#include "core/tiles/tile_raster.h"
#include "tests/core/base/thread_exchange.h"
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
constexpr int kCols = 1000, kRows = 900;  // Four rows of tiles of 1/4 mm.

/// No easy cloud: emptiness winds from the map's border through all rows of tiles to its middle, a
/// ring is closed across two of them, there are walls, a back that shows through the front, flyers,
/// and points in no order.
Raw hardCloud(int points) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> across(0, 0.25 * (kCols - 1)), up(0, 0.25 * (kRows - 1));
  Raw raw{{0, 0, 0}, {(kCols - 1) * 128, (kRows - 1) * 128, 0}};
  while (static_cast<int>(raw.size()) < points) {
    const double x = across(random), y = up(random);
    const double from_middle = std::hypot(x - 125, y - 112);
    const double turns = from_middle / 40 - std::atan2(y - 112, x - 125) / 6.283185307179586;
    if (from_middle > 15 && turns - std::floor(turns) < 0.12) continue;  // The spiral.
    const double from_ring = std::hypot(x - 215, y - 128);
    if (from_ring > 8 && from_ring < 14) continue;
    double z = 10 + 3 * std::sin(x / 17) * std::cos(y / 23) + (x > 180 ? 12 : 0);
    if (raw.size() % 9 == 0) z -= 30;
    if (raw.size() % 4001 == 0) z += 25;
    raw.push_back({static_cast<std::int32_t>(std::lround(x / kScale)),
                   static_cast<std::int32_t>(std::lround(y / kScale)),
                   static_cast<std::int32_t>(std::lround(z / kScale))});
  }
  return raw;
}

/// With a colour for each point and an intensity.
std::string colouredLasOf(const Raw& raw) {
  test::Las las;
  las.format = 2;
  las.scale = {kScale, kScale, kScale};
  las.raw = raw;
  las.promised = las.legacy_promised = static_cast<std::uint32_t>(raw.size());
  for (const auto& [x, y, z] : raw) {
    std::string rest = test::bytesOf(static_cast<std::uint16_t>(x + y)) + std::string(6, '\0');
    for (const std::int32_t channel : {x / 4, y / 4, z / 8}) {
      rest += test::bytesOf(static_cast<std::uint16_t>(channel));
    }
    las.rest.push_back(rest);
  }
  return test::lasFile(las);
}

/// A body: a sphere of 100 mm across, seen from one side, and its back behind it.
Raw closedCloud(int points) {
  Raw raw;
  for (int i = 0; i < points; ++i) {
    const double z = 1 - 2 * (i + 0.5) / points, turn = i * 2.399963229728653;
    const double across = std::sqrt(1 - z * z);
    const auto stored = [](double place) {
      return static_cast<std::int32_t>(std::lround((100 + 100 * place) / kScale));
    };
    raw.push_back({stored(across * std::cos(turn)), stored(across * std::sin(turn)), stored(z)});
  }
  return raw;
}

/// All files of a map, by name and content.
std::string bytesOfMap(const fs::path& finest) {
  std::string all;
  for (int level = 0; fs::exists(levelFile(finest, level)); ++level) {
    const fs::path heights = levelFile(finest, level);
    for (const fs::path& file :
         {heights, originFile(heights), colourFileOf(heights), intensityFileOf(heights)}) {
      std::ifstream in(file, std::ios::binary);
      all.append(std::istreambuf_iterator<char>(in), {});
    }
  }
  return all;
}

class Processes : public ::testing::Test {
 protected:
  static constexpr std::uint64_t kPart = 30'000;

  LargeMapOptions large(const std::string& map) const {
    return {.file = folder_ / map,
            .memory_bytes = 250'000'000,
            .threads = 2,
            .on_view = {},
            .job = {.folder = {}, .facts = {{"an option", "1"}}, .part_points = kPart}};
  }
  /// By one process, without a folder.
  std::string once(const fs::path& input, const SurfaceOptions& options) {
    one_ = makeLargeMap(input, options, large("once.tif"));
    return bytesOfMap(folder_ / "once.tif");
  }
  /// By so many; each has failed that says why.
  std::vector<std::string> together(
      int ranks, const fs::path& input, const SurfaceOptions& options,
      const std::function<void(Exchange&, LargeMapOptions&)>& change = {},
      const std::function<Task(int rank)>& task = {}) {
    std::vector<std::string> failures(static_cast<std::size_t>(ranks));
    test::inThreads(ranks, [&](Exchange& exchange) {
      LargeMapOptions options_here = large("map.tif");
      options_here.threads = 1;
      options_here.job.folder = folder_ / "job";
      options_here.processes = &exchange;
      if (change) change(exchange, options_here);
      std::string& failure = failures[static_cast<std::size_t>(exchange.rank())];
      try {
        LargeMap map =
            makeLargeMap(input, options, options_here, {}, task ? task(exchange.rank()) : Task{});
        if (exchange.isFirst()) {
          made_ = std::move(map);
          sent_bytes_ = exchange.sentBytes();
        }
      } catch (const OtherProcessStopped&) {
        failure = "another: " + exchange.stopped()->sentence;
      } catch (const Error& error) {
        failure = error.what();
        exchange.stop(1, error.what());
      }
    });
    return failures;
  }
  static bool areFine(const std::vector<std::string>& failures) {
    bool are_fine = true;
    for (const std::string& failure : failures) {
      if (failure.empty()) continue;
      ADD_FAILURE() << failure;
      are_fine = false;
    }
    return are_fine;
  }
  /// What is said of the map is the same, too.
  void expectSameReport() const {
    EXPECT_EQ(made_.rule, one_.rule);
    EXPECT_EQ(made_.shares, one_.shares);
    EXPECT_EQ(made_.holes.size(), one_.holes.size());
    EXPECT_EQ(made_.strays.points, one_.strays.points);
    EXPECT_EQ(made_.heights.max_mm, one_.heights.max_mm);
    ASSERT_EQ(made_.losses.has_value(), one_.losses.has_value());
    if (made_.losses) {
      EXPECT_EQ(made_.losses->hidden_share, one_.losses->hidden_share);
      EXPECT_EQ(made_.losses->outliers, one_.losses->outliers);
    }
    EXPECT_EQ(englishText(made_.messages), englishText(one_.messages));
  }

  test::TileFolder folder_;
  LargeMap one_, made_;
  std::uint64_t sent_bytes_ = 0;
};

SurfaceOptions optionsOf(std::optional<PointRule> rule) {
  SurfaceOptions options = test::topOptions(PointRule::median);
  options.rule = rule;
  return options;
}

TEST_F(Processes, WriteTheFilesOfOneForEveryRuleAndFormat) {
  const Raw raw = hardCloud(400'000);
  write(folder_ / "scan.las", lasOf(raw));
  write(folder_ / "scan.laz", lazOf(raw));
  std::string of_median;
  for (const auto rule : {std::optional<PointRule>{}, std::optional(PointRule::median),
                          std::optional(PointRule::top_mean), std::optional(PointRule::splat),
                          std::optional(PointRule::mean)}) {
    SCOPED_TRACE(rule ? static_cast<int>(*rule) : -1);
    const std::string once = this->once(folder_ / "scan.las", optionsOf(rule));
    ASSERT_GT(once.size(), 1'000'000U);
    for (const int ranks : rule ? std::vector{3} : std::vector{2, 3, 5}) {
      SCOPED_TRACE(ranks);
      ASSERT_TRUE(areFine(together(ranks, folder_ / "scan.las", optionsOf(rule))));
      EXPECT_TRUE(bytesOfMap(folder_ / "map.tif") == once);
      EXPECT_FALSE(fs::exists(folder_ / "job")) << "the work is done";
      expectSameReport();
    }
    if (rule == PointRule::median) of_median = once;
  }
  ASSERT_TRUE(areFine(together(3, folder_ / "scan.laz", optionsOf(PointRule::median))));
  EXPECT_TRUE(bytesOfMap(folder_ / "map.tif") == of_median);
  const double heights = 4.0 * kCols * kRows;
  std::printf("told to each other: %llu bytes, %.1f %% of the heights\n",
              static_cast<unsigned long long>(sent_bytes_),
              100 * static_cast<double>(sent_bytes_) / heights);
}

TEST_F(Processes, WriteTheColoursOfOne) {
  write(folder_ / "scan.las", colouredLasOf(hardCloud(200'000)));
  SurfaceOptions options = optionsOf(std::nullopt);
  options.spacing_mm = 0.5;
  const std::string once = this->once(folder_ / "scan.las", options);
  EXPECT_TRUE(one_.has_colours && one_.has_intensities);
  EXPECT_TRUE(fs::exists(colourFileOf(folder_ / "once.tif")));
  ASSERT_TRUE(areFine(together(3, folder_ / "scan.las", options)));
  EXPECT_TRUE(bytesOfMap(folder_ / "map.tif") == once);
  expectSameReport();
}

TEST_F(Processes, WriteTheFilesOfOneForABodyWithABack) {
  write(folder_ / "scan.las", lasOf(closedCloud(300'000)));
  SurfaceOptions options = optionsOf(std::nullopt);
  const std::string once = this->once(folder_ / "scan.las", options);
  ASSERT_TRUE(one_.losses);
  EXPECT_GT(one_.losses->hidden_share, 0.3) << "the back is not in the map";
  for (const int ranks : {2, 3}) {
    SCOPED_TRACE(ranks);
    ASSERT_TRUE(areFine(together(ranks, folder_ / "scan.las", options)));
    EXPECT_TRUE(bytesOfMap(folder_ / "map.tif") == once);
    expectSameReport();
  }
}

TEST_F(Processes, WriteTheFilesOfOneForARaster) {
  DepthMap map = test::reliefMap({.cols = 700, .rows = 900});
  for (std::size_t i = 0; i < map.heights_mm.size(); ++i) {
    if (map.origins[i] != CellStatus::measured) {
      map.heights_mm[i] = std::numeric_limits<float>::quiet_NaN();
    }
  }
  {
    TileRasterWriter writer(folder_ / "raster.tif", map.frame, {.nan_is_nodata = true});
    for (int row = 0; row < map.frame.size.rows; ++row) {
      const void* const bands[] = {&map.heights_mm[map.frame.size.index({.col = 0, .row = row})]};
      writer.add(bands);
    }
    writer.close({}, nullptr);
    writer.commit();
  }
  SurfaceOptions options;
  options.unit = LengthUnit::mm;
  const std::string once = this->once(folder_ / "raster.tif", options);
  ASSERT_GT(once.size(), 1'000'000U);
  EXPECT_FALSE(one_.holes.empty());
  for (const int ranks : {2, 4}) {
    SCOPED_TRACE(ranks);
    ASSERT_TRUE(areFine(together(ranks, folder_ / "raster.tif", options)));
    EXPECT_TRUE(bytesOfMap(folder_ / "map.tif") == once);
    expectSameReport();
  }
}

TEST_F(Processes, GoOnInAnyNumberWhereOneWasStopped) {
  write(folder_ / "scan.las", lasOf(hardCloud(400'000)));
  const SurfaceOptions options = optionsOf(std::nullopt);
  const std::string once = this->once(folder_ / "scan.las", options);
  // One of three is stopped when so many points, rows or filled rows are there.
  for (const char* const where :
       {"points/000000005.part", "heights/000000001.part", "filled/000000002.part"}) {
    SCOPED_TRACE(where);
    const auto task = [&](int rank) {
      if (rank != 2) return Task{};
      std::stop_source stop;
      return Task{.stop = stop.get_token(),
                  .progress = [&, stop](std::string_view, double) mutable {
                    if (fs::exists(folder_ / "job" / where)) stop.request_stop();
                  }};
    };
    std::vector<std::string> failures = together(3, folder_ / "scan.las", options, {}, task);
    for (int tries = 0; tries < 5 && failures[2].empty(); ++tries) {
      failures = together(3, folder_ / "scan.las", options, {}, task);  // It was too quick.
    }
    EXPECT_THAT(failures[2], HasSubstr("Cancelled")) << "by its own";
    EXPECT_THAT(failures[0], HasSubstr("another: Cancelled")) << "with it";
    EXPECT_THAT(failures[1], HasSubstr("another: Cancelled"));
    ASSERT_TRUE(fs::exists(folder_ / "job" / where)) << "what was finished stays";
    ASSERT_TRUE(areFine(together(2, folder_ / "scan.las", options)));
    EXPECT_TRUE(bytesOfMap(folder_ / "map.tif") == once);
    ASSERT_TRUE(made_.taken_over);
    EXPECT_GT(made_.taken_over->points + static_cast<std::uint64_t>(made_.taken_over->rows), 0U);
    EXPECT_EQ(made_.taken_over->filled > 0, std::string_view(where).starts_with("filled"));
    EXPECT_EQ(made_.taken_over->damaged, 0);
  }
}

TEST_F(Processes, RefuseWhatTheyCannotDoTogether) {
  write(folder_ / "scan.las", lasOf(hardCloud(20'000)));
  const SurfaceOptions options = optionsOf(PointRule::median);
  const auto without_folder = [](Exchange&, LargeMapOptions& large) { large.job.folder.clear(); };
  for (const std::string& failure : together(2, folder_ / "scan.las", options, without_folder)) {
    EXPECT_THAT(failure, HasSubstr("--job"));
  }
  const auto other_work = [](Exchange& exchange, LargeMapOptions& large) {
    if (exchange.rank() == 2) large.job.facts = {{"an option", "2"}};
  };
  const std::vector<std::string> failures = together(3, folder_ / "scan.las", options, other_work);
  EXPECT_THAT(failures[2],
              HasSubstr("Process 3 of 3 has other work than the first: an option differs"));
  EXPECT_THAT(failures[0], HasSubstr("another: Process 3 of 3"));
  const auto other_folder = [this](Exchange& exchange, LargeMapOptions& large) {
    if (exchange.rank() == 1) large.job.folder = folder_ / "elsewhere";
  };
  fs::remove_all(folder_ / "job");
  EXPECT_THAT(together(2, folder_ / "scan.las", options, other_folder)[1],
              HasSubstr("the folder of --job differs"));
  EXPECT_FALSE(fs::exists(folder_ / "map.tif"));
}

}  // namespace
}  // namespace relievo
