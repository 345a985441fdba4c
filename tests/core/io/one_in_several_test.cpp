// SPDX-License-Identifier: BSD-3-Clause
// Clouds larger than the memory: refused before they are read, and read one point in several.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/import.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/io/refusal.h"
#include "tests/core/io/sample_files.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using namespace test;
using ::testing::HasSubstr;

const std::string kLe = "binary_little_endian";

ImportOptions oneIn(std::uint64_t every) {
  ImportOptions options;
  options.scan.every = every;
  return options;
}

std::vector<std::pair<std::string, std::string>> clouds() {
  PcdWords binary;
  binary.data = "binary";
  const Las las;
  return {{"a.ply", plyHeader(kLe, "10") + binaryRows<float>(10)},
          {"b.ply", plyHeader("ascii", "10") + textRows(10)},
          {"a.pcd", pcdHeader(binary) + binaryRows<float>(10)},
          {"b.pcd", pcdHeader({}) + textRows(10)},
          {"a.las", lasFile(las)},
          {"a.xyz", textRows(10)}};
}

TEST(OneInSeveral, TakesTheFirstOfEachInEveryFormat) {
  const TemporaryFolder folder;
  for (const auto& [name, content] : clouds()) {
    SCOPED_TRACE(name);
    const std::filesystem::path file = folder.write(name, content);
    const Scan all = importScan(file);
    const Scan some = importScan(file, oneIn(4));
    ASSERT_EQ(some.points.size(), 3U) << "0, 4, 8";
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(some.points[i], all.points[4 * i]);
    EXPECT_EQ(some.info.points, 10U) << "as many as the file stores";
    EXPECT_EQ(some.info.finite_points, 3U);
    EXPECT_EQ(some.info.bounds->max.x, 8) << "of those that are taken";
    EXPECT_THAT(englishTexts(some.info.warnings),
                testing::Contains(HasSubstr("One point in 4 was taken: 3 of 10.")));
  }
}

TEST(OneInSeveral, ColoursStayWithTheirPoints) {
  const TemporaryFolder folder;
  std::string rows;
  for (int i = 0; i < 9; ++i) {
    rows += std::to_string(i) + " 1 2 " + std::to_string(10 * i) + " 5 6\n";
  }
  const auto file = folder.write(
      "a.ply", plyHeader("ascii", "9", "float",
                         "property uchar red\nproperty uchar green\nproperty uchar blue\n") +
                   rows);
  const Scan some = importScan(file, oneIn(3));
  ASSERT_EQ(some.colours.size(), 3U);
  EXPECT_EQ(some.colours[1], (Rgba{30, 5, 6, 255}));
  EXPECT_EQ(some.colours[2], (Rgba{60, 5, 6, 255}));
}

TEST(OneInSeveral, AMeshIsRefusedBecauseItsFacesNeedAllPoints) {
  const TemporaryFolder folder;
  const auto ply =
      folder.write("a.ply", plyHeader(kLe, "10", "float", kPlyFaces) + binaryRows<float>(10) +
                                plyTriangles({0, 1, 2, 2, 3, 4}));
  EXPECT_THROW(importScan(ply, oneIn(2)), ArgumentError);
  EXPECT_THROW(importScan(folder.write("a.stl", binaryStl(4, 4)), oneIn(2)), ArgumentError);
  EXPECT_EQ(importScan(ply, oneIn(1)).triangles.size(), 2U);
}

TEST(OneInSeveral, WhatTheMemoryDoesNotHoldIsRefusedBeforeItIsReadAndOfferedThinned) {
  const TemporaryFolder folder;
  PcdWords binary;
  binary.data = "binary";
  binary.points = "100000";
  Las las;
  las.count = 100'000;
  las.legacy_promised = 100'000;
  const std::vector<std::pair<std::string, std::string>> large{
      {"a.ply", plyHeader(kLe, "100000") + binaryRows<float>(100'000)},
      {"a.pcd", pcdHeader(binary) + binaryRows<float>(100'000)},
      {"a.las", lasFile(las)},
      {"a.xyz", textRows(100'000)}};
  ImportOptions options;
  options.free_bytes = 4'000'000;
  for (const auto& [name, content] : large) {
    SCOPED_TRACE(name);
    const std::filesystem::path file = folder.write(name, content);
    const Refusal refused = refusalOf([&] { importScan(file, options); });
    EXPECT_EQ(refused.code, "E102");
    EXPECT_THAT(refused.words, HasSubstr("Nothing was loaded. Load one point in 4 (--every 4)"));
    ImportOptions thinned = options;
    thinned.scan.every = 4;
    EXPECT_EQ(importScan(file, thinned).points.size(), 25'000U) << "what is offered fits";
    ImportOptions roomy;
    roomy.free_bytes = 100'000'000;
    EXPECT_EQ(importScan(file, roomy).points.size(), 100'000U);
  }
  const auto mesh = folder.write("a.stl", binaryStl(40'000, 40'000));
  const Refusal refused = refusalOf([&] { importScan(mesh, options); });
  EXPECT_EQ(refused.code, "E102");
  EXPECT_THAT(refused.words, HasSubstr("simplify the mesh")) << "no offer that is refused then";
  EXPECT_THAT(refused.words, testing::Not(HasSubstr("--every")));
}

}  // namespace
}  // namespace relievo
