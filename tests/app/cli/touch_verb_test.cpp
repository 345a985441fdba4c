// SPDX-License-Identifier: BSD-3-Clause
// relievo touch, tried from outside: Hooke's law, the surface's normal, the paper's proxies.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "core/io/raster/raster.h"
#include "tests/app/command_test.h"

namespace relievo {
namespace {

using nlohmann::json;
using test::CommandResult;
using test::reportOf;
using test::runRelievo;
using testing::HasSubstr;

using TouchVerb = test::CommandTest;

/// Rows of a log by column name.
struct Log {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  double number(std::size_t row, const std::string& column) const {
    const auto at = std::find(columns.begin(), columns.end(), column);
    if (at == columns.end()) throw std::runtime_error("no column " + column);
    return std::stod(rows.at(row).at(static_cast<std::size_t>(at - columns.begin())));
  }
};

Log readLog(const std::string& file) {
  Log log;
  std::ifstream stream(file);
  std::string line;
  while (std::getline(stream, line)) {
    if (line.starts_with('#')) continue;
    std::vector<std::string> fields;
    std::stringstream parts(line);
    for (std::string field; std::getline(parts, field, ',');) fields.push_back(field);
    if (log.columns.empty()) {
      log.columns = fields;
    } else {
      log.rows.push_back(fields);
    }
  }
  return log;
}

TEST_F(TouchVerb, TouchFollowsHookesLawInEveryContactRow) {
  // Down into the plane z = 5 + x/10 at (50, 50), along it, and up again.
  const std::string stroke = write("s.csv",
                                   "t_s,x_mm,y_mm,z_mm\n0,50,50,9\n0.2,50,50,2\n"
                                   "0.4,60,55,2\n0.5,60,55,9\n");
  const std::string file = path("log.csv");
  const json report =
      reportOf(runRelievo({"touch", plane(), "--unit", "mm", "--stroke", stroke, "-o", file,
                           "--region", "25,25,50,50", "--report", "json"}));
  EXPECT_EQ(report["ticks"], 501);
  EXPECT_EQ(report["region_mm"], json({25, 25, 50, 50}));
  EXPECT_DOUBLE_EQ(report["scale_device_per_view"], 1.6);
  const Log log = readLog(file);
  ASSERT_EQ(log.rows.size(), 501U);
  int touched = 0;
  for (std::size_t i = 0; i < log.rows.size(); ++i) {
    EXPECT_EQ(log.number(i, "tick"), static_cast<double>(i));
    EXPECT_NEAR(log.number(i, "t_s"), 0.001 * static_cast<double>(i), 1e-12);
    const bool contact = log.number(i, "contact") == 1;
    touched += contact ? 1 : 0;
    for (const char* axis : {"x", "y", "z"}) {
      const std::string a = axis;
      const double d =
          log.number(i, "dev_proxy_" + a + "_mm") - log.number(i, "dev_hip_" + a + "_mm");
      const double expected = contact ? 0.5 * d : 0;
      EXPECT_NEAR(log.number(i, "f_" + a + "_N"), expected,
                  1e-9 * std::max(1.0, std::abs(expected)));
    }
  }
  EXPECT_GT(touched, 300);
  EXPECT_LT(touched, 500);
}

TEST_F(TouchVerb, TouchOnAPlaneFindsTheFootOfThePerpendicular) {
  const std::string stroke =
      write("s.csv", "t_s,x_mm,y_mm,z_mm\n0,50,50,20\n0.1,50,50,2\n0.2,50,50,2\n");
  const std::string file = path("log.csv");
  reportOf(runRelievo({"touch", plane(), "--unit", "mm", "--stroke", stroke, "-o", file, "--region",
                       "25,25,50,50", "--report", "json"}));
  const Log log = readLog(file);
  const std::size_t last = log.rows.size() - 1;
  // The base plane lies at the lowest z, 5; the map's lower left edge half a cell outside, so that
  // file x is view x - half a cell of 1 mm: the surface at view x = 50 lies at 4.95.
  const double n = std::sqrt(1 + 0.01);
  const double depth = (4.95 - 2) / n;
  EXPECT_NEAR(log.number(last, "proxy_x_mm"), 50 - 0.1 * depth / n, 1e-4);
  EXPECT_NEAR(log.number(last, "proxy_z_mm"), 2 + depth / n, 1e-4);
  EXPECT_NEAR(log.number(last, "nx"), -0.1 / n, 1e-5);
  EXPECT_NEAR(log.number(last, "nz"), 1 / n, 1e-5);
}

TEST_F(TouchVerb, SaysWhichPartOfAForceADeviceCouldGive) {
  const std::string deep = write("s.csv", "t_s,x_mm,y_mm,z_mm\n0,50,50,9\n0.2,50,50,-20\n");
  const std::string shallow = write("t.csv", "t_s,x_mm,y_mm,z_mm\n0,50,50,9\n0.2,50,50,3\n");
  const std::string plot = path("p.svg");
  const auto touched = [&](const std::string& stroke) {
    return reportOf(
        runRelievo({"touch", plane(), "--unit", "mm", "--stroke", stroke, "-o", path("log.csv"),
                    "--region", "25,25,50,50", "--plot", plot, "--report", "json"}));
  };
  const json report = touched(deep);
  EXPECT_GT(report["largest_force_n"], 10);
  EXPECT_EQ(report["device_limit"]["device"], "Falcon");
  EXPECT_EQ(report["largest_device_force_n"], report["device_limit"]["force_n"]);
  EXPECT_GT(report["beyond_device_ticks"], 10);
  EXPECT_THAT(test::bytesOf(plot), HasSubstr("Falcon at most 5"));
  const json gentle = touched(shallow);
  EXPECT_EQ(gentle["beyond_device_ticks"], 0);
  EXPECT_EQ(gentle["largest_device_force_n"], gentle["largest_force_n"]);
  EXPECT_THAT(test::bytesOf(plot), testing::Not(HasSubstr("at most")));
}

TEST_F(TouchVerb, ThePapersEquationIsSelectableAndChatters) {
  const std::string stroke =
      write("s.csv", "t_s,x_mm,y_mm,z_mm\n0,50,50,9\n0.1,50,50,4\n0.4,60,50,4\n");
  for (const char* proxy : {"equation", "successive", "converged"}) {
    const json report =
        reportOf(runRelievo({"touch", plane(), "--unit", "mm", "--stroke", stroke, "-o",
                             path("log.csv"), "--proxy", proxy, "--report", "json"}));
    EXPECT_EQ(report["proxy"], proxy);
    EXPECT_GT(report["largest_force_n"], 0.5);
  }
}

TEST_F(TouchVerb, DampingOpposesPressingInAndAWrongOneIsRefused) {
  const std::string stroke = write("s.csv", "t_s,x_mm,y_mm,z_mm\n0,50,50,9\n0.5,50,50,2\n");
  const std::vector<std::string> arguments{"touch",    plane(), "--unit",   "mm",
                                           "--stroke", stroke,  "-o",       path("log.csv"),
                                           "--report", "json",  "--damping"};
  const auto largest = [&](const std::string& damping) {
    std::vector<std::string> with = arguments;
    with.push_back(damping);
    return reportOf(runRelievo(with))["largest_force_n"].get<double>();
  };
  EXPECT_GT(largest("0.01"), largest("0") + 0.01);
  std::vector<std::string> negative = arguments;
  negative.emplace_back("-1");
  EXPECT_EQ(runRelievo(negative).exit_code, 1);
}

TEST_F(TouchVerb, AStrokeWhoseTimesDoNotIncreaseIsRefusedWithItsRow) {
  const std::string stroke = write("s.csv", "t_s,x_mm,y_mm,z_mm\n0,1,1,1\n0.1,1,1,1\n0.1,2,2,2\n");
  const CommandResult result =
      runRelievo({"touch", plane(), "--stroke", stroke, "-o", path("log.csv")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("3"));
}

TEST_F(TouchVerb, TouchOnAMapEqualsTouchOnItsScan) {
  const std::string map_file = path("map.tif");
  reportOf(runRelievo({"depthmap", plane(), "--unit", "mm", "-o", map_file, "--report", "json"}));
  const std::string stroke =
      write("s.csv", "t_s,x_mm,y_mm,z_mm\n0,50,50,9\n0.1,50,50,4\n0.2,60,50,4\n");
  reportOf(runRelievo({"touch", plane(), "--unit", "mm", "--stroke", stroke, "-o", path("a.csv"),
                       "--window-out", path("wa.tif"), "--report", "json"}));
  reportOf(runRelievo({"touch", map_file, "--stroke", stroke, "-o", path("b.csv"), "--window-out",
                       path("wb.tif"), "--report", "json"}));
  EXPECT_EQ(readLog(path("a.csv")).rows, readLog(path("b.csv")).rows);
  EXPECT_EQ(readRaster(path("wa.tif")).values, readRaster(path("wb.tif")).values);
}

}  // namespace
}  // namespace relievo
