// SPDX-License-Identifier: BSD-3-Clause
// Real scans against figures found by other programs; skipped where they are absent.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/io/import.h"
#include "core/io/input_facts.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

struct Expected {
  std::string file;
  std::uint64_t points = 0, finite = 0;
  std::optional<FileBounds> bounds;  ///< Nothing: not compared.
};

std::vector<Expected> readTable(const std::filesystem::path& table) {
  std::ifstream lines(table);
  std::string line;
  std::getline(lines, line);
  std::vector<Expected> rows;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    Expected row;
    std::string x0;
    words >> row.file >> row.points >> row.finite >> x0;
    if (x0 == "nan") {
      rows.push_back(row);
      continue;
    }
    row.bounds.emplace().min.x = std::stod(x0);
    words >> row.bounds->min.y >> row.bounds->min.z >> row.bounds->max.x >> row.bounds->max.y >>
        row.bounds->max.z;
    rows.push_back(row);
  }
  return rows;
}

bool isReadable(const std::string& file) {
  for (const char* folder : {"3ds/", "e57/", "las/", "obj/", "pcd/", "ply/", "stl/", "text/"}) {
    if (file.starts_with(folder)) return true;
  }
  return false;
}

double longestSide(const FileBounds& b) {
  return std::max({b.max.x - b.min.x, b.max.y - b.min.y, b.max.z - b.min.z});
}

void expectSameBox(const FileBounds& found, const FileBounds& expected) {
  // 2e-7 of the box; the table itself has 12 digits.
  const auto near = [&](double a, double b) {
    EXPECT_NEAR(a, b, 2e-7 * longestSide(expected) + 1e-11 * std::abs(b));
  };
  near(found.min.x, expected.min.x);
  near(found.min.y, expected.min.y);
  near(found.min.z, expected.min.z);
  near(found.max.x, expected.max.x);
  near(found.max.y, expected.max.y);
  near(found.max.z, expected.max.z);
}

FileBounds boxOfPoints(const Scan& scan) {
  FileBounds box{scan.point(0), scan.point(0)};
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const FilePoint p = scan.point(i);
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
  return box;
}

TEST(SharedScans, PointsAndBoxAreThoseOfIndependentPrograms) {
  const std::filesystem::path data = test::sharedData();
  if (data.empty()) GTEST_SKIP() << "the shared scans are not here";
  int read = 0;
  for (const Expected& row : readTable(data / "EXPECTED.tsv")) {
    if (!isReadable(row.file)) continue;
    SCOPED_TRACE(row.file);
    Scan scan;
    ASSERT_NO_THROW(scan = importScan(data / row.file));
    EXPECT_EQ(scan.info.points, row.points);
    EXPECT_EQ(scan.info.finite_points, row.finite);
    EXPECT_EQ(scan.points.size(), row.finite);
    ASSERT_TRUE(scan.info.bounds.has_value());
    ++read;
    if (!row.bounds) continue;
    expectSameBox(*scan.info.bounds, *row.bounds);
    expectSameBox(boxOfPoints(scan), *row.bounds);
  }
  EXPECT_GE(read, 30);
}

TEST(SharedScans, ThePtxHoldsThePointsOfTheLasItWasMadeFrom) {
  const std::filesystem::path data = test::sharedData();
  if (data.empty()) GTEST_SKIP() << "the shared scans are not here";
  const Scan ptx = importScan(data / "text" / "1.2-with-color.ptx");
  const Scan las = importScan(data / "las" / "1.2-with-color.las");
  EXPECT_EQ(ptx.info.points, las.info.points);
  EXPECT_EQ(ptx.info.finite_points, las.info.finite_points);
  expectSameBox(*ptx.info.bounds, *las.info.bounds);
}

TEST(SharedScans, ARasterIsNamedAndRefused) {
  const std::filesystem::path data = test::sharedData();
  if (data.empty()) GTEST_SKIP() << "the shared scans are not here";
  try {
    importScan(data / "dem" / "synthetic_dem15_0.50.tif");
    ADD_FAILURE() << "a raster was loaded as a scan";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("TIFF raster"), std::string::npos) << error.what();
  }
  EXPECT_TRUE((inputFacts(data / "dem" / "synthetic_dem15_0.50.tif").kind == InputKind::raster));
  EXPECT_FALSE((inputFacts(data / "las" / "autzen_trim.las").kind == InputKind::raster));
}

}  // namespace
}  // namespace relievo
