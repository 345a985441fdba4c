// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/firmness.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>

#include "core/base/error.h"
#include "core/region/window.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

/// 200 x 100 mm, its lower left corner not at 0.
const DetailLadder kMap{
    .left_mm = 10, .bottom_mm = 20, .width_mm = 200, .height_mm = 100, .spacings_mm = {0.5, 1}};

std::string grid(const char* name, int cols, int rows, const std::string& values) {
  std::string file = test::ownPath(name).string();
  std::ofstream(file) << "ncols " << cols << "\nnrows " << rows
                      << "\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9\n"
                      << values << "\n";
  return file;
}

std::string problemOf(const std::function<void()>& what) {
  try {
    what();
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return {};
}

TEST(Firmness, IsThatOfTheCellUnderEachSampleOfAWindow) {
  // The file has its highest row first: the lower right quarter is soft.
  const FirmnessMap firmness =
      readFirmness(grid("quarter.asc", 4, 2, "1 0.75 0.5 1\n1 0.25 0.125 0"));
  ASSERT_EQ(firmness.size, (GridSize{4, 2}));
  const Region region{60, 20, 100, Level{0}};  // The two columns in the middle, both rows.
  const std::vector<float> parts = firmnessUnder(firmness, kMap, region);
  ASSERT_EQ(parts.size(), kWindowCount);
  for (int row = 0; row < kWindowSamples; ++row) {
    for (int col = 0; col < kWindowSamples; ++col) {
      const float expected = row < 100 ? (col < 100 ? 0.25F : 0.125F) : (col < 100 ? 0.75F : 0.5F);
      ASSERT_EQ(parts[static_cast<std::size_t>(row * kWindowSamples + col)], expected)
          << col << " " << row;
    }
  }
}

TEST(Firmness, GoesOnBeyondTheMapAndIsSoftWhereTheFileHasNoValue) {
  const FirmnessMap firmness = readFirmness(grid("missing.asc", 2, 2, "1 -9\n1 -9"));
  const std::vector<float> parts = firmnessUnder(firmness, kMap, {-90, -80, 400, Level{1}});
  EXPECT_EQ(parts.front(), 1) << "left of the map as at its left edge";
  EXPECT_EQ(parts.back(), 0) << "no value";
}

TEST(Firmness, ARasterOfAnotherOutlineIsRefusedAndOneCellIsNoMatter) {
  const auto use = [](int cols, int rows) {
    FirmnessMap firmness{"folder/f.tif", {}, {cols, rows}, {}};
    firmness.parts.resize(firmness.size.count(), 1);
    return problemOf([&] { firmnessUnder(firmness, kMap, {60, 20, 100, Level{0}}); });
  };
  for (const auto& [cols, rows] :
       {std::pair{400, 200}, {401, 201}, {400, 201}, {399, 200}, {2, 1}, {4, 2}}) {
    EXPECT_EQ(use(cols, rows), "") << cols << " x " << rows;
  }
  for (const auto& [cols, rows] : {std::pair{400, 198}, {200, 200}, {200, 400}, {40, 26}}) {
    EXPECT_NE(use(cols, rows).find("'f.tif' has " + std::to_string(cols) + " x "),
              std::string::npos)
        << cols << " x " << rows;
  }
}

TEST(Firmness, ValuesOutsideZeroToOneAreRefusedWithOneOfThem) {
  for (const char* values : {"0.5 2\n1 1", "-0.1 1\n1 1"}) {
    const std::string problem = problemOf([&] { readFirmness(grid("outside.asc", 2, 2, values)); });
    EXPECT_NE(
        problem.find("outside 0 to 1, such as " + std::string(values[0] == '0' ? "2" : "-0.1")),
        std::string::npos)
        << problem;
  }
  EXPECT_THROW(readFirmness("/nowhere/firm.tif"), FileError);
}

}  // namespace
}  // namespace relievo
