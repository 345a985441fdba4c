// SPDX-License-Identifier: BSD-3-Clause
// From two coloured scans with strays to a project that opens elsewhere, by command line.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>

#include "core/io/import.h"
#include "core/io/raster/colour_raster.h"
#include "core/io/raster/raster.h"
#include "tests/app/command_test.h"
#include "tests/core/prepare/align_objects.h"

namespace relievo::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using Words = std::vector<std::string>;

constexpr int kStrays = 25;

/// Red on the left, blue on the right, in bands of 10 mm across.
std::array<int, 3> colourAt(const Place& p) {
  const bool band = static_cast<int>(std::floor((p[1] + 200) / 10)) % 2 == 0;
  return p[0] < 0 ? std::array{220, band ? 40 : 120, 30} : std::array{20, band ? 60 : 140, 210};
}

class ColouredJourney : public CommandTest {
 protected:
  /// A part of the gargoyle with colours, 25 strays in front, turned and moved.
  std::string part(const std::string& name, double from_x, double to_x, std::uint64_t seed,
                   double turn_degrees, const Place& shift) const {
    const MadeObject gargoyle = ballsObject("gargoyle", gargoyleBalls());
    Random random(seed);
    const double turn = turn_degrees * std::numbers::pi / 180;
    std::ostringstream text;
    text.precision(7);
    int points = 0;
    const auto add = [&](const Place& p, const std::array<int, 3>& c) {
      text << std::cos(turn) * p[0] - std::sin(turn) * p[1] + shift[0] << ' '
           << std::sin(turn) * p[0] + std::cos(turn) * p[1] + shift[1] << ' ' << p[2] + shift[2]
           << ' ' << c[0] << ' ' << c[1] << ' ' << c[2] << '\n';
      ++points;
    };
    for (int i = 0; i < kStrays; ++i) add({30.0 * i - 400, 300.0 - 20 * i, 900.0 + i}, {0, 255, 0});
    while (points < 40'000) {
      const Place p = gargoyle.sample(random);
      if (p[0] > from_x && p[0] < to_x) add(p, colourAt(p));
    }
    return write(name, "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points) +
                           "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar "
                           "red\nproperty uchar green\nproperty uchar blue\nend_header\n" +
                           text.str());
  }
};

TEST_F(ColouredJourney, FromTwoPartialScansToAProjectThatOpensElsewhere) {
  const std::string left = part("left.ply", -200, 25, 5, 0, {0, 0, 0});
  const std::string right = part("right.ply", -25, 200, 6, 25, {40, -15, 8});

  // Clean, align, join.
  fs::create_directories(path("work"));
  const Words prepare{"prepare", left, right, "--unit", "mm", "--clean", "--align", "auto"};
  const json joined_report =
      reportOf(runRelievo(joined(prepare, {"-o", path("work/joined.ply"), "--report", "json"})));
  ASSERT_EQ(joined_report["scans"].size(), 2U);
  EXPECT_EQ(joined_report["not_done"], json::array());
  EXPECT_GT(joined_report["colours"], 0);
  const Scan scan = importScan(path("work/joined.ply"));
  EXPECT_GT(scan.points.size(), 0.995 * 2 * (40'000 - kStrays));
  EXPECT_LT(scan.info.bounds->max.z, 200) << "a stray is left";
  for (const Rgba& colour : scan.colours) ASSERT_NE(colour, (Rgba{0, 255, 0, 255}));

  // The map: colours lie where they were, on both sides of the joint; the same bytes again.
  const Words look{"--unit", "mm", "--view", "top"};
  for (const char* const name : {"work/map.tif", "work/again.tif"}) {
    const json map = reportOf(runRelievo(
        joined({"depthmap", path("work/joined.ply"), "-o", path(name), "--report", "json"}, look)));
    EXPECT_TRUE(map["colour_file"].is_string());
  }
  EXPECT_TRUE(bytesOf(path("work/map.tif")).size() > 10'000);
  EXPECT_EQ(heightsChecksum(importRaster(path("work/map.tif")).values),
            heightsChecksum(importRaster(path("work/again.tif")).values));
  EXPECT_TRUE(bytesOf(path("work/map.colour.tif")) == bytesOf(path("work/again.colour.tif")));
  const RasterMap map = importRaster(path("work/map.tif"));
  std::size_t right_ones = 0;
  std::size_t own = 0;
  const double middle = 0.5 * map.size.cols;
  for (std::size_t i = 0; i < map.colours.colours.size(); ++i) {
    const Rgba& colour = map.colours.colours[i];
    const double off = static_cast<double>(i % static_cast<std::size_t>(map.size.cols)) - middle;
    if (colour[3] != 255 || std::abs(off) < 0.05 * map.size.cols) continue;
    ++own;
    right_ones += (colour[0] > colour[2]) == (off < 0) ? 1 : 0;
  }
  EXPECT_GT(own, 1000U);
  EXPECT_GT(static_cast<double>(right_ones), 0.98 * static_cast<double>(own));

  // Touch, figure, project.
  write("stroke.csv", "t_s,x_mm,y_mm,z_mm\n0,60,60,90\n0.2,60,60,20\n0.4,80,60,20\n");
  ASSERT_EQ(runRelievo(joined({"touch", path("work/joined.ply"), "--stroke", path("stroke.csv"),
                               "-o", path("work/touch.csv")},
                              look))
                .exit_code,
            0);
  EXPECT_GT(bytesOf(path("work/touch.csv")).size(), 5000U);
  const CommandResult figure =
      runRelievo(joined({"figure", path("work/joined.ply"), "--relief", "natural", "--shading",
                         "0.4", "--width-mm", "60", "-o", path("work/figure.png")},
                        look));
  ASSERT_EQ(figure.exit_code, 0) << figure.err;
  ASSERT_EQ(runRelievo({"project", "new", path("work/figure.png"), "--recording",
                        path("work/touch.csv"), "-o", path("work/p.relievo.json")})
                .exit_code,
            0);

  // Reopened elsewhere: the figure drawn from there is the same.
  fs::rename(path("work"), path("elsewhere"));
  EXPECT_EQ(runRelievo({"project", "check", path("elsewhere/p.relievo.json")}).exit_code, 0);
  const CommandResult again =
      runRelievo({"figure", path("elsewhere/joined.ply"), "--project",
                  path("elsewhere/p.relievo.json"), "--relief", "natural", "--shading", "0.4",
                  "--width-mm", "60", "-o", path("elsewhere/again.png")});
  ASSERT_EQ(again.exit_code, 0) << again.err;
}

}  // namespace
}  // namespace relievo::test
