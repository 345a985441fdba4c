// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/strays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "core/base/error.h"
#include "core/cloud/part_of_scan.h"
#include "core/depth/rules/rasterize.h"
#include "core/io/import.h"
#include "core/io/input_facts.h"
#include "core/session/large/large_map.h"
#include "core/session/surface.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/core/scan_fixtures.h"

namespace relievo {
namespace {

double wave(double x, double y) {
  return 4 * std::sin(x / 9) * std::cos(y / 7);
}

/// 150 x 120 with 8 of relief, and points of one's own.
Scan reliefWith(const std::vector<std::array<float, 3>>& more) {
  Scan scan = test::latticeScan(151, 121, 1, wave);
  scan.points.insert(scan.points.end(), more.begin(), more.end());
  test::finishScan(scan);
  return scan;
}

SurfaceOptions fromTop(int cells, StrayRule rule = StrayRule::drop) {
  SurfaceOptions options;
  options.view = ViewChoice{.name = "top", .rotation = std::nullopt};
  options.cells = cells;
  options.strays = rule;
  return options;
}

std::vector<std::array<float, 3>> twelve() {
  std::vector<std::array<float, 3>> points;
  for (int i = 0; i < 12; ++i) {
    points.push_back({static_cast<float>(1e4 + 400 * i), static_cast<float>(-5e3 + 700 * i), 3});
  }
  return points;
}

TEST(Strays, ASurfaceIsThatOfTheObjectAlone) {
  const Surface clean = makeSurface(reliefWith({}), fromTop(150), rasterize);
  const Surface surface = makeSurface(reliefWith(twelve()), fromTop(150), rasterize);
  EXPECT_EQ(clean.strays.points, 0U);
  EXPECT_EQ(surface.strays.points, 12U);
  EXPECT_EQ(surface.strays.all, 151U * 121 + 12);
  EXPECT_FALSE(surface.strays.kept);
  EXPECT_GT(surface.strays.share_of_box, 0.98);
  EXPECT_EQ(surface.map.heights_mm, clean.map.heights_mm);
  EXPECT_EQ(surface.map.origins, clean.map.origins);
  EXPECT_EQ(surface.view_from_file, clean.view_from_file);
  EXPECT_NE(std::find_if(surface.messages.begin(), surface.messages.end(),
                         [](const Message& m) {
                           return englishText(m).starts_with(
                               "12 of 18 283 points lie 98.9 % of the box away");
                         }),
            surface.messages.end())
      << englishText(surface.messages);
}

TEST(Strays, AreKeptOnRequestAndStillTold) {
  const Surface surface =
      makeSurface(reliefWith(twelve()), fromTop(150, StrayRule::keep), rasterize);
  EXPECT_EQ(surface.strays.points, 12U);
  EXPECT_TRUE(surface.strays.kept);
  EXPECT_GT(surface.map.widthMm(), 14'000);
}

/// 12 by 10 points, 0.65 % of reliefWith, far beside it.
std::vector<std::array<float, 3>> clump() {
  std::vector<std::array<float, 3>> points;
  for (int i = 0; i < 120; ++i) {
    points.push_back({1000 + static_cast<float>(i % 12), 60 + static_cast<float>(i / 12), 3});
  }
  return points;
}

TEST(Strays, InAClumpAreKeptAndTold) {
  const Surface surface = makeSurface(reliefWith(clump()), fromTop(150), rasterize);
  EXPECT_EQ(surface.strays.points, 0U);
  EXPECT_EQ(surface.strays.grouped, 120U);
  EXPECT_TRUE(surface.strays.groups_kept);
  EXPECT_NEAR(surface.strays.share_of_box_grouped, 0.85, 0.01);
  EXPECT_GT(surface.map.widthMm(), 1000);
  const std::string words = englishText(strayWords(surface.strays));
  EXPECT_EQ(words,
            "120 of 18 391 points lie together 85.1 % of the box away from all others; they were "
            "kept, as they may belong to the object.");
  EXPECT_EQ(std::count_if(surface.messages.begin(), surface.messages.end(),
                          [&](const Message& m) { return englishText(m) == words; }),
            1)
      << englishText(surface.messages);
}

TEST(Strays, InAClumpAreLeftOutOnRequest) {
  const Surface clean = makeSurface(reliefWith({}), fromTop(150), rasterize);
  std::vector<std::array<float, 3>> more = clump();
  const std::vector<std::array<float, 3>> single = twelve();
  more.insert(more.end(), single.begin(), single.end());
  const Scan scan = reliefWith(more);
  const Surface surface = makeSurface(scan, fromTop(150, StrayRule::drop_groups), rasterize);
  EXPECT_EQ(surface.strays.points, 12U);
  EXPECT_EQ(surface.strays.grouped, 120U);
  EXPECT_FALSE(surface.strays.kept);
  EXPECT_FALSE(surface.strays.groups_kept);
  EXPECT_EQ(surface.map.heights_mm, clean.map.heights_mm);
  EXPECT_EQ(surface.view_from_file, clean.view_from_file);
  EXPECT_TRUE(englishText(strayWords(surface.strays).back()).ends_with("they were left out."));
  // Each rule says the same of both.
  const Surface drop = makeSurface(scan, fromTop(150), rasterize);
  EXPECT_EQ(drop.strays.points, 12U);
  EXPECT_EQ(drop.strays.grouped, 120U);
  EXPECT_FALSE(drop.strays.kept);
  EXPECT_TRUE(drop.strays.groups_kept);
  const Surface keep = makeSurface(scan, fromTop(150, StrayRule::keep), rasterize);
  EXPECT_EQ(keep.strays.points, 12U);
  EXPECT_EQ(keep.strays.grouped, 120U);
  EXPECT_TRUE(keep.strays.kept);
  EXPECT_TRUE(keep.strays.groups_kept);
}

TEST(Strays, InAClumpAlongATurnedViewAreToldOnce) {
  SurfaceOptions options = fromTop(150);
  options.view->turn_deg = {0, 0, 30};
  const Scan scan = reliefWith(clump());
  const Surface kept = makeSurface(scan, options, rasterize);
  EXPECT_EQ(kept.strays.grouped, 120U);
  options.strays = StrayRule::drop_groups;
  const Surface dropped = makeSurface(scan, options, rasterize);
  EXPECT_EQ(dropped.strays.grouped, 120U);
  EXPECT_LT(dropped.map.widthMm(), 200);
}

TEST(Strays, OneFlippedBitDoesNotEmptyTheMap) {
  for (const float far : {3.1e6F, 1e30F, -1e38F}) {
    Scan scan = reliefWith({{far, 60, 0}});
    SurfaceOptions options;
    options.cells = 100;
    const Surface surface = makeSurface(scan, options, rasterize);
    EXPECT_EQ(surface.strays.points, 1U);
    EXPECT_NEAR(surface.map.widthMm(), 150, 3) << far;
    EXPECT_EQ(surface.view_name, "top");
  }
}

TEST(Strays, AlongTheAxesOfATurnedViewAreLeftOutToo) {
  // A long strip along a diagonal; the stray lies within its box but far beside the strip.
  Scan scan;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (int i = 0; i < 20'000; ++i) {
    const float along = 1000 * uniform(random);
    const float across = 10 * uniform(random);
    scan.points.push_back({along - across, along + across, 0});
  }
  scan.points.push_back({990, 20, 0});
  test::finishScan(scan);
  EXPECT_EQ(straysOf(scan).points, 0U);
  SurfaceOptions options = fromTop(200);
  options.view->turn_deg = {0, 0, 45};
  const Surface surface = makeSurface(scan, options, rasterize);
  EXPECT_EQ(surface.strays.points, 0U) << "half of the strip's length does not stretch it";
  scan.points.back() = {999, 1, 700};
  test::finishScan(scan);
  EXPECT_EQ(straysOf(scan).points, 1U);
}

TEST(Strays, VerticesThatNoFaceUsesDoNotStretchTheBox) {
  Scan mesh = test::latticeMesh(60, 40, 1, wave);
  const Surface clean = makeSurface(mesh, fromTop(100), rasterize);
  mesh.info.bounds->max.z += 1e-7;  // The file's numbers, not rounded to float.
  EXPECT_EQ(straysOf(mesh).share_of_box, 0);
  for (const float far : {70.0F, 1e5F}) {
    Scan loose = mesh;
    loose.points.push_back({far, 20, 0});
    test::finishScan(loose);
    const Surface surface = makeSurface(loose, fromTop(100), rasterize);
    EXPECT_EQ(surface.strays.points, 1U);
    EXPECT_EQ(surface.strays.unused, 1U);
    EXPECT_EQ(englishText(strayWords(surface.strays)),
              "1 vertex belongs to no face and lies outside of the object; it was left out.");
    EXPECT_EQ(surface.map.heights_mm, clean.map.heights_mm) << far;
  }
}

TEST(Strays, OfMeshesAreSmallPiecesAndSpikesButNoPlanesAndSpires) {
  const Scan mesh = test::latticeMesh(80, 80, 1, wave);
  const auto with = [&mesh](const std::vector<std::array<float, 3>>& points) {
    Scan scan = mesh;
    const auto first = static_cast<std::uint32_t>(scan.points.size());
    scan.points.insert(scan.points.end(), points.begin(), points.end());
    scan.triangles.push_back({first, first + 1, first + 2});
    test::finishScan(scan);
    return scan;
  };
  const Surface piece =
      makeSurface(with({{900, 0, 0}, {901, 0, 0}, {900, 1, 0}}), fromTop(80), rasterize);
  EXPECT_EQ(piece.strays.points, 3U);
  EXPECT_NEAR(piece.map.widthMm(), 80, 1.1);
  EXPECT_EQ(straysOf(with({{-900, -900, -9}, {900, -900, -9}, {0, 900, -9}})).points, 0U)
      << "a plane under the object";
  Scan spire = mesh;
  spire.points[40 * 80 + 40][2] = 300;
  test::finishScan(spire);
  EXPECT_EQ(straysOf(spire).points, 0U);
  spire.points[40 * 80 + 40][2] = 3.1e6F;
  test::finishScan(spire);
  EXPECT_EQ(straysOf(spire).points, 1U);
  const Surface surface = makeSurface(spire, fromTop(80), rasterize);
  EXPECT_LT(surface.map.heightExtentMm(), 100);
}

TEST(Strays, HeightsThatStandForNoneAreLeftOutFirst) {
  Scan scan = reliefWith({});
  for (std::size_t i = 0; i < scan.points.size(); i += 10) scan.points[i][2] = -9999;
  test::finishScan(scan);
  SurfaceOptions options = fromTop(100);
  const Surface asked = makeSurface(scan, options, rasterize);
  ASSERT_TRUE(asked.suspect_height.has_value());
  EXPECT_EQ(asked.suspect_height->value, -9999);
  EXPECT_EQ(asked.missing, (scan.points.size() + 9) / 10);
  EXPECT_LT(heightRange(asked.map).max_mm - heightRange(asked.map).min_mm, 10)
      << "left out though nobody said so";
  options.nodata = NodataChoice{.value = -9999};
  const Surface surface = makeSurface(scan, options, rasterize);
  EXPECT_FALSE(surface.suspect_height.has_value());
  EXPECT_EQ(surface.missing, (scan.points.size() + 9) / 10);
  EXPECT_EQ(surface.map.heights_mm, asked.map.heights_mm);
  const HeightRange range = heightRange(surface.map);
  EXPECT_LT(range.max_mm - range.min_mm, 10);
  options.nodata = NodataChoice{};
  const Surface kept = makeSurface(scan, options, rasterize);
  EXPECT_FALSE(kept.suspect_height.has_value());
  EXPECT_EQ(kept.missing, 0U);
}

TEST(Strays, ThePartOfAScanKeepsWhatBelongsToEachPoint) {
  Scan scan = test::latticeMesh(3, 2, 1, [](double, double) { return 0.0; });
  for (std::uint8_t i = 0; i < 6; ++i) {
    scan.colours.push_back({i, i, i, 255});
    scan.intensities.push_back(i);
    scan.classes.push_back(i);
  }
  for (std::size_t t = 0; t < scan.triangles.size(); ++t) {
    scan.texture_of.push_back(static_cast<std::uint16_t>(t));
  }
  const Scan part = partOf(scan, {0, 1, 1, 0, 1, 1});
  ASSERT_EQ(part.points.size(), 4U);
  EXPECT_EQ(part.colours[2][0], 4);
  EXPECT_EQ(part.intensities[3], 5);
  EXPECT_EQ(part.classes[0], 1);
  ASSERT_EQ(part.triangles.size(), 2U);
  EXPECT_EQ(part.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 3}));
  EXPECT_EQ(part.texture_of, (std::vector<std::uint16_t>{2, 3}));
  EXPECT_DOUBLE_EQ(part.info.bounds->min.x, 1);
  EXPECT_TRUE(part.parts.empty());
}

TEST(Strays, OfAMapByTilesAreThoseOfTheMapInMemory) {
  const test::TemporaryFolder folder;
  std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 18403\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n";
  std::vector<std::array<float, 3>> more = clump();
  const std::vector<std::array<float, 3>> single = twelve();
  more.insert(more.end(), single.begin(), single.end());
  const Scan scan = reliefWith(more);
  ASSERT_EQ(scan.points.size(), 18403U);
  ply.append(reinterpret_cast<const char*>(scan.points.data()), scan.points.size() * 12);
  const auto file = folder.write("strays.ply", ply);
  for (const StrayRule rule : {StrayRule::drop, StrayRule::keep, StrayRule::drop_groups}) {
    const SurfaceOptions options = fromTop(120, rule);
    const Surface surface = makeSurface(importScan(file), options, rasterize);
    const LargeMap map =
        makeLargeMap(file, options, {.file = folder.path() / "map.tif", .on_view = {}});
    EXPECT_EQ(map.strays.points, 12U);
    EXPECT_EQ(map.strays.kept, rule == StrayRule::keep);
    EXPECT_NEAR(map.strays.share_of_box, surface.strays.share_of_box, 1e-9);
    EXPECT_EQ(map.strays.grouped, 120U);
    EXPECT_EQ(map.strays.groups_kept, rule != StrayRule::drop_groups);
    EXPECT_NEAR(map.strays.share_of_box_grouped, surface.strays.share_of_box_grouped, 1e-9);
    EXPECT_EQ(map.frames.front(), surface.map.frame);
    for (std::size_t i = 0; i < 16; ++i) {
      EXPECT_NEAR(map.view_from_file.m[i], surface.view_from_file.m[i], 1e-6);
    }
  }
}

TEST(SharedScans, LoseNoPointThatBelongsToThem) {
  const std::filesystem::path data = test::sharedData();
  if (data.empty()) GTEST_SKIP() << "the shared scans are not here";
  int read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(data)) {
    const std::filesystem::path& file = entry.path();
    if (!entry.is_regular_file() || file.extension() == ".md" || file.extension() == ".tsv" ||
        file.extension() == ".laz" || inputFacts(file).kind == InputKind::raster) {
      continue;
    }
    const Strays strays = straysOf(importScan(file));
    EXPECT_EQ(strays.points, 0U) << file.filename() << ": " << englishText(strayWords(strays));
    EXPECT_EQ(strays.grouped, 0U) << file.filename() << ": " << englishText(strayWords(strays));
    ++read;
  }
  EXPECT_GE(read, 29);
}

}  // namespace
}  // namespace relievo
