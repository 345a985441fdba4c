// SPDX-License-Identifier: BSD-3-Clause
// The scale bar of an exported figure against things of known size in the same picture: both are
// read off the file's pixels, and what the bar stands for off its words. Nothing here knows how a
// figure is laid out.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <opencv2/imgcodecs.hpp>
#include <regex>
#include <sstream>

#include "core/depth/rules/rasterize.h"
#include "data/generate/relief_f.h"
#include "tests/core/io/temporary_folder.h"
#include "ui/figure/figure.h"

namespace relievo {
namespace {

using samples::kReliefFCap;
using samples::kReliefFCorner;

Surface reliefF() {
  Scan scan;
  for (const auto& p : samples::makeReliefF().points) {
    scan.points.push_back(
        {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  }
  scan.info.points = scan.info.finite_points = scan.points.size();
  scan.info.format = "PLY";
  SurfaceOptions options;
  options.unit = LengthUnit::mm;
  options.view = ViewChoice{"top", {}};
  options.spacing_mm = samples::kReliefFSpacingMm;
  return makeSurface(scan, options, rasterize);
}

/// One row of a grey picture.
using Row = std::vector<double>;

Row row(const cv::Mat& grey, int y) {
  Row values;
  for (int x = 0; x < grey.cols; ++x) values.push_back(grey.at<std::uint8_t>(y, x));
  return values;
}

/// Where a row first passes `level` on the way from one end, between two pixels.
double firstPass(const Row& row, double level, bool from_right) {
  const int n = static_cast<int>(row.size());
  const int step = from_right ? -1 : 1;
  for (int x = from_right ? n - 1 : 0; x + step >= 0 && x + step < n; x += step) {
    const double here = row[static_cast<std::size_t>(x)];
    const int beside = x + step;
    const double next = row[static_cast<std::size_t>(beside)];
    if ((here < level) != (next < level)) return x + step * ((level - here) / (next - here));
  }
  ADD_FAILURE() << "no edge";
  return std::nan("");
}

/// Length of the bar: the longest dark stretch of the lower left quarter and what its ends cover of
/// the two pixels beside it.
double barPixels(const cv::Mat& grey) {
  constexpr double kInk = 64;
  double longest = 0;
  for (int y = grey.rows * 3 / 4; y < grey.rows; ++y) {
    const Row values = row(grey, y);
    for (std::size_t from = 2, to = 0; from < values.size() / 2; from = to + 1) {
      for (to = from; values[to] < kInk && to + 2 < values.size();) ++to;
      if (to - from < 3) continue;
      const double ink = values[from + 1];
      const auto cover = [&](std::size_t x, std::size_t beside) {
        return (values[beside] - values[x]) / (values[beside] - ink);
      };
      longest = std::max(
          longest, static_cast<double>(to - from) + cover(from - 1, from - 2) + cover(to, to + 1));
    }
  }
  return longest;
}

/// What is written at the bar: the only length in a figure of nothing else.
double writtenMm(const std::filesystem::path& svg) {
  std::ostringstream text;
  text << std::ifstream(svg).rdbuf();
  const std::string page = text.str();
  std::smatch words;
  EXPECT_TRUE(std::regex_search(page, words, std::regex(">\\s*([0-9.]+) (mm|cm)\\s*<")));
  return std::stod(words[1]) * (words[2] == "cm" ? 10 : 1);
}

/// A thing of known size, and a window around it.
struct Known {
  const char* name;
  Region region;
  double mm;
  std::function<double(const std::function<Row(double y_mm)>&)> pixels;
};

// Flat ground is painted 128, the steepest 255, the paper beside the plate 255.
constexpr double kPlateEdge = 191;
const double kCapRim =
    255 * (0.5 + std::atan(0.5 * 60 / 45) * 180 / M_PI / 120);  // Half as steep as just inside.

const std::array<Known, 3> kKnown{{
    {"the plate",
     {.x_mm = -15, .y_mm = -65, .side_mm = 330, .level = {0}},
     samples::kReliefFWidthMm,
     [](const auto& at) {
       return firstPass(at(185), kPlateEdge, true) - firstPass(at(185), kPlateEdge, false);
     }},
    {"the cap",
     {.x_mm = kReliefFCap.x_mm - 65, .y_mm = kReliefFCap.y_mm - 65, .side_mm = 130, .level = {0}},
     2 * kReliefFCap.radius_mm,
     [](const auto& at) {
       return firstPass(at(kReliefFCap.y_mm), kCapRim, true) -
              firstPass(at(kReliefFCap.y_mm), kCapRim, false);
     }},
    {"the missing corner",
     {.x_mm = 265, .y_mm = -15, .side_mm = 45, .level = {0}},
     kReliefFCorner.side_mm,
     [](const auto& at) {
       return firstPass(at(25), kPlateEdge, true) - firstPass(at(10), kPlateEdge, true);
     }},
}};

TEST(ScaleBar, IsAsLongAsThingsOfKnownSizeInTheSamePictureSay) {
  const Surface surface = reliefF();
  const test::TemporaryFolder folder;
  Project project;
  project.file = "relief_f.ply";
  project.sha256 = std::string(64, 'a');
  FigureRequest& figure = project.figure;
  figure.layout = FigureLayout::detail;
  figure.width_mm = 85;
  figure.height_bar = figure.up_mark = figure.legend = false;
  figure.look.kind = ReliefKind::slope;
  figure.look.colours = ColourMap::grey;
  figure.look.range = {{-60, 60}};
  for (const Known& known : kKnown) {
    project.region = known.region;
    for (const double dpi : {300.0, 600.0}) {
      figure.dpi = dpi;
      const auto file = folder.path() / "figure.png";
      writeFigure(surface, project, file);
      writeFigure(surface, project, folder.path() / "figure.svg");
      const cv::Mat grey = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
      ASSERT_FALSE(grey.empty());
      const double object_px = known.pixels([&](double y_mm) {
        const Region& r = known.region;
        return row(grey, static_cast<int>(grey.rows * (r.y_mm + r.side_mm - y_mm) / r.side_mm));
      });
      const double bar_mm = writtenMm(folder.path() / "figure.svg");
      const double bar_px = barPixels(grey);
      const double off_px = bar_px - object_px * bar_mm / known.mm;
      EXPECT_NEAR(off_px, 0, 1) << known.name << " at " << dpi << " dpi: " << object_px
                                << " px, bar " << bar_px << " px for " << bar_mm << " mm";
    }
  }
}

}  // namespace
}  // namespace relievo
