// SPDX-License-Identifier: BSD-3-Clause
// Colours of maps by tiles are those of the same map in memory, byte for byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "core/base/error.h"
#include "core/depth/rules/rasterize.h"
#include "core/io/import.h"
#include "core/io/raster/colour_raster.h"
#include "core/session/colours/surface_colours.h"
#include "core/session/large/crop_level.h"
#include "core/session/large/large_map.h"
#include "core/session/large/tiled_surface.h"
#include "core/tiles/level_files.h"
#include "core/tiles/tiled_map.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/io/laz_sample.h"
#include "tests/core/session/tiled_fixture.h"

namespace relievo {
namespace {

constexpr double kScale = 1.0 / 512;  // Exact in float and double.
constexpr int kSide = 600;            // Cells of 1/4 mm: three tiles each way, the last cut.
constexpr std::uint64_t kSmallBudget = 300'000'000;

/// A wavy relief with a hole, a bare corner without colours, and points behind the surface. Colours
/// are a board that is finer than a cell here and there.
struct Made {
  int x = 0, y = 0, z = 0;
  std::array<std::uint16_t, 3> colour{};
  std::uint16_t intensity = 0;
};

/// @param layers  whether there are points behind the surface; rules that merge keep them as
/// outliers
std::vector<Made> madePoints(int count, bool layers = true) {
  std::mt19937 random(77);
  std::uniform_int_distribution<int> place(0, (kSide - 1) * 128);
  std::uniform_int_distribution<int> any(0, 255);
  const auto height = [](int x, int y) {
    const double z = 10 + 2 * std::sin(x * kScale / 7) * std::cos(y * kScale / 9);
    return static_cast<int>(std::lround(z / kScale));
  };
  constexpr int kFar = (kSide - 1) * 128;  // The corners fix the frame.
  std::vector<Made> points{{0, 0, height(0, 0)}, {kFar, kFar, height(kFar, kFar), {9, 9, 9}, 3}};
  while (static_cast<int>(points.size()) < count) {
    Made p{place(random), place(random)};
    const double u = p.x * kScale;
    const double v = p.y * kScale;
    if (std::hypot(u - 90, v - 60) < 6) continue;
    const bool behind = layers && any(random) < 20;
    p.z = height(p.x, p.y) - (behind ? 6 * 512 : 0);
    const auto byte = static_cast<std::uint16_t>(any(random));
    p.colour = {byte, static_cast<std::uint16_t>(u), static_cast<std::uint16_t>(behind ? 255 : v)};
    p.intensity = static_cast<std::uint16_t>(100 * any(random) + byte);
    points.push_back(p);
  }
  return points;
}

void writeLas(const std::filesystem::path& file, const std::vector<Made>& points, int bits,
              bool packed = false) {
  test::Las las;
  test::Laz laz;
  laz.how.format = 2;
  laz.scale = kScale;
  laz.chunk_points = 5000;
  las.format = 2;
  las.scale = {kScale, kScale, kScale};
  las.promised = las.legacy_promised = static_cast<std::uint32_t>(points.size());
  for (const Made& p : points) {
    las.raw.push_back({p.x, p.y, p.z});
    std::string rest = test::bytesOf(p.intensity) + std::string(6, '\0');
    for (const std::uint16_t c : p.colour) {
      rest += test::bytesOf(static_cast<std::uint16_t>(bits == 16 ? 256 * c : c));
    }
    las.rest.push_back(rest);
    std::string record;
    for (const std::int32_t stored : las.raw.back()) record += test::bytesOf(stored);
    laz.records.push_back(record + rest);
  }
  std::ofstream(file, std::ios::binary) << (packed ? test::lazFile(laz).bytes : test::lasFile(las));
}

/// Colours as fractions, none (NaN) in a corner; intensities as fractions below 0 and above.
void writePly(const std::filesystem::path& file, const std::vector<Made>& points) {
  std::ofstream out(file, std::ios::binary);
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << points.size()
      << "\nproperty float x\nproperty float y\nproperty float z\nproperty float red\n"
         "property float green\nproperty float blue\nproperty float intensity\nend_header\n";
  for (const Made& p : points) {
    const bool bare = p.x < 3000 && p.y < 3000;
    const auto channel = [&](std::size_t k) {
      return bare ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(p.colour[k]) / 255;
    };
    const std::array numbers{static_cast<float>(p.x * kScale),
                             static_cast<float>(p.y * kScale),
                             static_cast<float>(p.z * kScale),
                             channel(0),
                             channel(1),
                             channel(2),
                             static_cast<float>(p.intensity) / 700 - 9};
    out.write(reinterpret_cast<const char*>(numbers.data()), sizeof(numbers));
  }
}

LargeMap largeMap(const test::TileFolder& folder, const std::string& name,
                  const SurfaceOptions& options, std::uint64_t memory = kSmallBudget) {
  return makeLargeMap(
      folder / name, options,
      {.file = folder / "map.tif", .memory_bytes = memory, .threads = 2, .on_view = {}});
}

LevelSamples allOf(GridSize size) {
  return {.left = 0, .right = size.cols - 1, .bottom = 0, .top = size.rows - 1};
}

/// Whole levels as they are kept, cut ones as they are drawn, and windows.
void expectTheSame(const Surface& whole, const Surface& tiled) {
  ASSERT_FALSE(whole.colours.empty());
  ASSERT_EQ(whole.colours.size(), tiled.tiles->frames().size());
  ASSERT_GE(whole.colours.size(), 2U);
  for (std::size_t l = 0; l < whole.colours.size(); ++l) {
    const Level level{static_cast<int>(l)};
    const GridSize size = tiled.tiles->frames()[l].size;
    const GridColours kept = whole.colours[l].all();
    const GridColours read = tiled.tiles->partColours(level, {}, size);
    ASSERT_EQ(read.colours.size(), kept.colours.size()) << "level " << l;
    ASSERT_EQ(read.intensities.size(), kept.intensities.size()) << "level " << l;
    EXPECT_TRUE(read.colours == kept.colours) << "level " << l;
    EXPECT_TRUE(read.intensities == kept.intensities) << "level " << l;
    EXPECT_TRUE(levelColours(tiled, level, allOf(size)) == levelColours(whole, level, allOf(size)));
  }
  const Region region{.x_mm = 61.3, .y_mm = 40.2, .side_mm = 55, .level = {0}};
  const RegionWindow window = windowOf(whole, region);
  EXPECT_TRUE(windowColours(tiled, windowOf(tiled, region), 1) == windowColours(whole, window, 1));
}

bool says(const std::vector<Message>& messages, const std::string& words) {
  return std::any_of(messages.begin(), messages.end(), [&](const Message& message) {
    return englishText(message).find(words) != std::string::npos;
  });
}

class LargeColours : public ::testing::TestWithParam<std::tuple<const char*, PointRule>> {};

TEST_P(LargeColours, AreThoseOfTheMapInMemory) {
  const auto [format, rule] = GetParam();
  const test::TileFolder folder;
  const std::string name = format;
  const bool merges = rule == PointRule::front || rule == PointRule::mean;
  const std::vector<Made> points = madePoints(900'000, !merges);
  if (name == "a.ply") {
    writePly(folder / name, points);
  } else {
    writeLas(folder / name, points, name == "8.las" ? 8 : 16, name == "a.laz");
  }
  const LargeMap large = largeMap(folder, name, test::topOptions(rule));
  EXPECT_TRUE(large.has_colours && large.has_intensities);
  EXPECT_TRUE(large.not_done.empty());
  const Surface whole = makeSurface(importScan(folder / name), test::topOptions(rule), rasterize);
  const Surface tiled = openTiledSurface(folder / "map.tif");
  ASSERT_EQ(tiled.tiles->levelMap({0}).heights_mm, whole.map.heights_mm);
  expectTheSame(whole, tiled);
  EXPECT_TRUE(canShow(tiled, ReliefKind::natural));
  EXPECT_TRUE(canShow(tiled, ReliefKind::intensity));
  for (const Message& message : whole.messages) {
    const std::string words = englishText(message);
    if (words.starts_with("The scan has")) {
      EXPECT_TRUE(says(large.messages, words)) << words;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(
    Every, LargeColours,
    ::testing::Values(std::tuple{"8.las", PointRule::median},
                      std::tuple{"16.las", PointRule::front},  // Merges; one point's colour.
                      std::tuple{"16.las", PointRule::mean},   // Merges; a mean.
                      std::tuple{"a.laz", PointRule::median},
                      std::tuple{"a.ply", PointRule::top_mean}),
    [](const auto& made) {
      std::string name =
          std::get<0>(made.param) + std::to_string(static_cast<int>(std::get<1>(made.param)));
      std::erase(name, '.');
      return name;
    });

TEST(LargeColours, AreLeftOutInWordsWhereTheMemoryIsTooSmall) {
  const test::TileFolder folder;
  writeLas(folder / "a.las", madePoints(200'000), 8);
  SurfaceOptions fine = test::topOptions(PointRule::median);
  fine.spacing_mm = 0.05;
  const LargeMap large = largeMap(folder, "a.las", fine, 185'000'000);
  EXPECT_FALSE(large.has_colours);
  EXPECT_TRUE(says(large.not_done, "The scan's colours were left out"));
  EXPECT_FALSE(std::filesystem::exists(colourFileOf(folder / "map.tif")));
}

TEST(LargeColours, OfAnotherMapAreLeftAsideInWords) {
  const test::TileFolder folder;
  writeLas(folder / "a.las", madePoints(300'000), 8);
  largeMap(folder, "a.las", test::topOptions(PointRule::median));
  std::filesystem::copy_file(colourFileOf(folder / "map.tif"), folder / "kept.tif");
  writeLas(folder / "b.las", madePoints(250'000), 8);
  largeMap(folder, "b.las", test::topOptions(PointRule::median));
  EXPECT_TRUE(openTiledSurface(folder / "map.tif").tiles->hasColours());
  std::filesystem::copy_file(folder / "kept.tif", colourFileOf(folder / "map.tif"),
                             std::filesystem::copy_options::overwrite_existing);
  const Surface surface = openTiledSurface(folder / "map.tif");
  EXPECT_FALSE(surface.tiles->hasColours());
  EXPECT_FALSE(canShow(surface, ReliefKind::natural));
  EXPECT_TRUE(says(surface.messages, "belongs to another map"));
  EXPECT_TRUE(says(surface.messages, "shown without colours"));
}

TEST(LargeColours, GoWhenTheMapIsMadeOfAScanWithoutAny) {
  const test::TileFolder folder;
  std::vector<Made> points = madePoints(300'000);
  writeLas(folder / "a.las", points, 8);
  largeMap(folder, "a.las", test::topOptions(PointRule::median));
  ASSERT_TRUE(std::filesystem::exists(colourFileOf(levelFile(folder / "map.tif", 1))));
  for (Made& p : points) p.colour = {};
  writeLas(folder / "a.las", points, 8);
  const LargeMap large = largeMap(folder, "a.las", test::topOptions(PointRule::median));
  EXPECT_FALSE(large.has_colours);
  EXPECT_TRUE(large.has_intensities);
  EXPECT_FALSE(std::filesystem::exists(colourFileOf(folder / "map.tif")));
  EXPECT_FALSE(std::filesystem::exists(colourFileOf(levelFile(folder / "map.tif", 1))));
  EXPECT_FALSE(openTiledSurface(folder / "map.tif").tiles->hasColours());
}

TEST(LargeColours, NeverReplaceAFileOfSomebodyElse) {
  const test::TileFolder folder;
  writeLas(folder / "a.las", madePoints(100'000), 8);
  std::ofstream(colourFileOf(folder / "map.tif")) << "a picture of somebody";
  EXPECT_THROW(largeMap(folder, "a.las", test::topOptions(PointRule::median)), WriteError);
  std::ifstream in(colourFileOf(folder / "map.tif"));
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "a picture of somebody");
}

}  // namespace
}  // namespace relievo
