// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/figure.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "core/base/error.h"
#include "core/depth/rules/rasterize.h"
#include "core/io/raster/raster.h"
#include "core/provenance/embedded.h"
#include "core/relief/relief_image.h"
#include "tests/core/session/tiled_fixture.h"
#include "ui/vtk/files/picture_file.h"
#include "ui/vtk/scale_length.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

/// 120 x 90 mm, 0.5 mm apart: a dome, a plateau 40 mm wide and 5 mm high, a hole of 10 x 10 mm, and
/// nothing at all right of x = 100.
Scan makeScan() {
  Scan scan;
  for (int row = 0; row <= 180; ++row) {
    for (int col = 0; col <= 240; ++col) {
      const double x = 0.5 * col;
      const double y = 0.5 * row;
      if (x > 100 && y > 1) continue;
      if (x > 20 && x < 30 && y > 65 && y < 75) continue;
      const double d = std::hypot(x - 30, y - 35);
      const double dome = d < 20 ? 8 * (1 - d * d / 400) : 0;
      const double plateau = x >= 55 && x <= 95 && y >= 20 && y <= 70 ? 5 : 0;
      scan.points.push_back(
          {static_cast<float>(x), static_cast<float>(y), static_cast<float>(dome + plateau)});
    }
  }
  scan.info.points = scan.info.finite_points = scan.points.size();
  scan.info.format = "PLY";
  return scan;
}

class FigureTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    SurfaceOptions options;
    options.unit = LengthUnit::mm;
    options.view = ViewChoice{"top", {}};
    options.spacing_mm = 0.5;
    surface_ = std::make_unique<Surface>(makeSurface(makeScan(), options, rasterize));
  }
  static void TearDownTestSuite() { surface_.reset(); }
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("relievo_figure_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    project_.file = (folder_ / "relief.ply").string();
    project_.sha256 = std::string(64, 'a');
    project_.region = {.x_mm = 20, .y_mm = 10, .side_mm = 60, .level = {0}};
    project_.figure.width_mm = 85;
  }
  void TearDown() override { fs::remove_all(folder_); }

  Figure draw() { return drawFigure(*surface_, project_); }
  static std::string bytesOf(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }

  static std::unique_ptr<Surface> surface_;
  fs::path folder_;
  Project project_;
};
std::unique_ptr<Surface> FigureTest::surface_;

std::array<int, 4> pixel(const RgbaImage& image, int x, int y) {
  const std::size_t i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                             static_cast<std::size_t>(x));
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2], image.rgba[i + 3]};
}

bool isInk(const std::array<int, 4>& p) {
  return p[0] < 40 && p[1] < 40 && p[2] < 42;
}

/// Longest run of ink in the rows given.
int longestRun(const RgbaImage& image, int y0, int y1) {
  int longest = 0;
  for (int y = y0; y < y1; ++y) {
    int run = 0;
    for (int x = 0; x < image.width; ++x) {
      run = isInk(pixel(image, x, y)) ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  return longest;
}

double meanDifference(const RgbaImage& a, const RgbaImage& b) {
  if (a.width != b.width || a.height != b.height) return 255;
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(a.rgba[i] - b.rgba[i]);
  return sum / static_cast<double>(a.rgba.size());
}

TEST_F(FigureTest, TheWidthOnPaperAtTheDensityIsTheWidthInPixels) {
  project_.figure.dpi = 300;
  const Figure figure = draw();
  EXPECT_EQ(figure.image.width, 1004);
  EXPECT_EQ(figure.facts.width_px, 1004);
  EXPECT_NEAR(figure.facts.width_mm, 85, 1e-9);
  project_.figure.layout = FigureLayout::detail;
  project_.figure.scale_1_to = 2;
  const Figure to_scale = draw();
  EXPECT_NEAR(to_scale.facts.width_mm, 30, 1e-9);
  EXPECT_NEAR(to_scale.facts.paper_per_mm, 0.5, 1e-12);
}

TEST_F(FigureTest, TheScaleBarIsAsLongAsTheObjectSaysAtEveryZoomAndDensity) {
  project_.figure.layout = FigureLayout::detail;
  project_.figure.height_bar = project_.figure.up_mark = project_.figure.legend = false;
  for (const double dpi : {150.0, 300.0}) {
    for (const double side : {120.0, 60.0, 120 / 3.7}) {
      project_.figure.dpi = dpi;
      project_.region = {
          .x_mm = 60 - 0.5 * side, .y_mm = 45 - 0.5 * side, .side_mm = side, .level = {0}};
      const Figure figure = draw();
      const double mm_per_px = side / figure.image.width;
      EXPECT_NEAR(figure.facts.mm_per_pixel, mm_per_px, 1e-12);
      const ScaleLength length = scaleLength(0.25 * side);
      const int bar = longestRun(figure.image, figure.image.height * 3 / 4, figure.image.height);
      EXPECT_NEAR(bar, length.mm / mm_per_px, 1) << dpi << " dpi, " << side << " mm";
    }
  }
}

TEST_F(FigureTest, AnObjectOfKnownSizeHasThatSizeInThePicture) {
  project_.figure.layout = FigureLayout::detail;
  project_.figure.look.kind = ReliefKind::slope;
  project_.figure.look.colours = ColourMap::grey;
  project_.figure.look.range = {{0, 80}};
  project_.figure.scale_bar = project_.figure.up_mark = project_.figure.height_bar = false;
  project_.region = {.x_mm = 50, .y_mm = 15, .side_mm = 48, .level = {0}};
  const Figure figure = draw();
  // The plateau's flanks are the two bright lines: from the middle between the samples at 54.5 and
  // 55 mm to that between 95 and 95.5 mm.
  const auto flank = [&](int from, int to) {
    double sum = 0;
    double weights = 0;
    for (int x = from; x < to; ++x) {
      const double bright = pixel(figure.image, x, figure.image.width / 2)[0];
      sum += bright * bright * x;
      weights += bright * bright;
    }
    return sum / weights;
  };
  const int half = figure.image.width / 2;
  const double pixels = flank(half, figure.image.width) - flank(0, half);
  EXPECT_NEAR(pixels, 40.5 / figure.facts.mm_per_pixel, 1);
}

TEST_F(FigureTest, TheSameRequestGivesTheSamePixelsAndAPreviewShowsTheSameCrop) {
  project_.figure.dpi = 200;
  const Figure one = draw();
  EXPECT_EQ(one.image.rgba, draw().image.rgba);
  const Figure preview = previewFigure(*surface_, project_, one.image.width / 2);
  ASSERT_NEAR(preview.image.width, one.image.width / 2.0, 1);
  RgbaImage small = preview.image;
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      const auto p = pixel(one.image, std::min(2 * x, one.image.width - 1),
                           std::min(2 * y, one.image.height - 1));
      for (std::size_t k = 0; k < 4; ++k) {
        small.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(small.width) +
                        static_cast<std::size_t>(x)) +
                   k] = static_cast<std::uint8_t>(p[k]);
      }
    }
  }
  EXPECT_LT(meanDifference(preview.image, small), 8);
}

TEST_F(FigureTest, APreviewSaysWhatTheFileWillSay) {
  project_.figure.dpi = 300;
  for (const FigureLayout layout : {FigureLayout::reference_detail, FigureLayout::levels}) {
    project_.figure.layout = layout;
    const FigureFacts shown = previewFigure(*surface_, project_, 300).facts;
    const FigureFacts written = writeFigure(*surface_, project_, folder_ / "a.png");
    EXPECT_EQ(shown.caption, written.caption);
    EXPECT_EQ(shown.width_px, written.width_px);
    EXPECT_EQ(shown.height_px, written.height_px);
    EXPECT_EQ(shown.mm_per_pixel, written.mm_per_pixel);
  }
}

TEST_F(FigureTest, TheStateInMarkupIsText) {
  project_.figure.dpi = 60;
  project_.file = (folder_ / "a <b> & 'c'.ply").string();
  const std::string key(kStateKey);
  for (const char* const name : {"a.svg", "a.pdf"}) {
    writeFigure(*surface_, project_, folder_ / name);
    const std::string bytes = bytesOf(folder_ / name);
    const std::size_t start = bytes.find('>', bytes.find("<" + key));
    const std::size_t end = bytes.find("</" + key);
    ASSERT_LT(start, end) << name;
    const std::string text = bytes.substr(start + 1, end - start - 1);
    EXPECT_EQ(text.find('<'), std::string::npos) << name << " is no markup any more";
    EXPECT_NE(text.find("a &lt;b&gt; &amp; "), std::string::npos) << name;
  }
}

TEST_F(FigureTest, AStateReadFromTheFileDrawsTheSamePixelsAgain) {
  project_.figure.dpi = 150;
  project_.measurements = {{"step", MeasureKind::depth, {{45, 45}, {70, 45}}, 0}};
  project_.gain = 1.3;
  const ReliefLook lit{.light = {.azimuth_deg = 120, .elevation_deg = 30}};
  const ReliefLook open{.kind = ReliefKind::openness,
                        .colours = ColourMap::cividis,
                        .radius_mm = 3,
                        .range = {{60, 95}}};
  project_.file = (folder_ / "a <b> & 'c'.ply").string();
  for (const auto& [name, look] : {std::pair{"a.png", lit}, std::pair{"a.tif", open},
                                   std::pair{"a.pdf", open}, std::pair{"a.svg", lit}}) {
    project_.figure.look = look;
    writeFigure(*surface_, project_, folder_ / name);
    const auto state = embeddedState(folder_ / name);
    ASSERT_TRUE(state) << name;
    const Project back = projectFromJson(*state, name);
    EXPECT_EQ(back.file, "a <b> & 'c'.ply") << "as found from the figure's folder";
    EXPECT_EQ(drawFigure(*surface_, back).image.rgba, draw().image.rgba) << name;
  }
  writePng(folder_ / "plain.png", RgbaImage{1, 1, {1, 2, 3, 255}}, 300, {});
  EXPECT_FALSE(embeddedState(folder_ / "plain.png"));
  std::ofstream(folder_ / "text.png") << "no picture";
  EXPECT_FALSE(embeddedState(folder_ / "text.png"));
  EXPECT_THROW(embeddedState(folder_ / "missing.png"), FileError);
}

TEST_F(FigureTest, VectorsKeepTextAsTextAroundThePictures) {
  project_.figure.dpi = 150;
  writeFigure(*surface_, project_, folder_ / "a.svg");
  const std::string svg = bytesOf(folder_ / "a.svg");
  EXPECT_NE(svg.find("<title>relief.ply</title>"), std::string::npos);
  EXPECT_EQ(svg.find(folder_.string()), std::string::npos) << "no path of this computer";
  EXPECT_NE(svg.find("<text"), std::string::npos);
  EXPECT_NE(svg.find("<image"), std::string::npos);
  EXPECT_NE(svg.find("20 mm"), std::string::npos) << "the scale bar's words";
  writeFigure(*surface_, project_, folder_ / "a.pdf");
  const std::string pdf = bytesOf(folder_ / "a.pdf");
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_NE(pdf.find("/FontFile"), std::string::npos) << "fonts are embedded";
  EXPECT_THROW(writeFigure(*surface_, project_, folder_ / "a.jpg"), ArgumentError);
  EXPECT_THROW(writeFigure(*surface_, project_, folder_ / "missing" / "a.svg"), WriteError);
}

TEST_F(FigureTest, TheLegendStatesTheSharesThatTheCaptionStates) {
  project_.figure.dpi = 60;
  project_.region = {.x_mm = 5, .y_mm = 50, .side_mm = 40, .level = {0}};
  for (const FigureLayout layout :
       {FigureLayout::before_after, FigureLayout::levels, FigureLayout::detail}) {
    project_.figure.layout = layout;
    const std::string caption = writeFigure(*surface_, project_, folder_ / "a.svg").caption;
    const std::size_t end = caption.find(" % holes on the base plane");
    ASSERT_NE(end, std::string::npos) << caption;
    const std::size_t start = caption.rfind(' ', end - 1) + 1;
    EXPECT_NE(bytesOf(folder_ / "a.svg")
                  .find("hole, on the base plane, " + caption.substr(start, end - start) +
                        " % of the region<"),
              std::string::npos)
        << name(layout) << ": " << caption;
  }
  // Beside the hole there is nothing to explain.
  project_.region = {.x_mm = 50, .y_mm = 10, .side_mm = 40, .level = {0}};
  writeFigure(*surface_, project_, folder_ / "b.svg");
  EXPECT_EQ(bytesOf(folder_ / "b.svg").find("base plane, "), std::string::npos);
  project_.figure.layout = FigureLayout::reference_detail;
  writeFigure(*surface_, project_, folder_ / "c.svg");
  EXPECT_NE(bytesOf(folder_ / "c.svg").find(" % of the object<"), std::string::npos);
}

TEST_F(FigureTest, TheHatchOfWhatWasNotMeasuredIsLeftOutByChoice) {
  project_.figure.layout = FigureLayout::detail;
  project_.figure.dpi = 100;
  project_.region = {.x_mm = 5, .y_mm = 50, .side_mm = 40, .level = {0}};
  ASSERT_TRUE(project_.figure.hatch);
  const Figure hatched = draw();
  project_.figure.hatch = false;
  const Figure plain = draw();
  EXPECT_GT(meanDifference(hatched.image, plain.image), 0.2);
  // Where there is no hole nothing differs.
  project_.region = {.x_mm = 55, .y_mm = 20, .side_mm = 40, .level = {0}};
  const Figure without = draw();
  project_.figure.hatch = true;
  EXPECT_EQ(meanDifference(draw().image, without.image), 0);
}

TEST_F(FigureTest, LabelsOfMeasurementsAtOnePlaceStandBelowEachOther) {
  project_.figure.dpi = 100;
  for (const char* name : {"one", "two", "three"}) {
    project_.measurements.push_back({name, MeasureKind::depth, {{45, 45}, {70, 45}}, 0});
  }
  writeFigure(*surface_, project_, folder_ / "a.svg");
  const std::string svg = bytesOf(folder_ / "a.svg");
  std::vector<double> lines;
  for (const char* label : {">one:", ">two:", ">three:"}) {
    const std::size_t at = svg.find(label);
    ASSERT_NE(at, std::string::npos) << label;
    // The text's place is the end of the matrix before it: matrix(a,b,c,d,x,y).
    const std::size_t end = svg.find(')', svg.rfind("matrix(", at));
    lines.push_back(std::stod(svg.substr(svg.rfind(',', end) + 1)));
  }
  const double text_px = project_.figure.text_pt * project_.figure.dpi / 72;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    EXPECT_GE(lines[i], lines[i - 1] + 0.9 * text_px) << i;
  }
}

TEST_F(FigureTest, ALabelOfAMeasurementStandsBesideTheHeightBar) {
  project_.figure.dpi = 100;
  project_.figure.layout = FigureLayout::detail;
  // Ends in the lower right corner, where the height bar stands.
  project_.measurements.push_back({"low", MeasureKind::depth, {{74, 11}, {79, 11}}, 0});
  writeFigure(*surface_, project_, folder_ / "a.svg");
  const std::string svg = bytesOf(folder_ / "a.svg");
  const auto line = [&](const char* label) {
    const std::size_t at = svg.find(label);
    if (at == std::string::npos) throw std::runtime_error(label);
    const std::size_t end = svg.find(')', svg.rfind("matrix(", at));
    return std::stod(svg.substr(svg.rfind(',', end) + 1));
  };
  const double text_px = project_.figure.text_pt * project_.figure.dpi / 72;
  EXPECT_LT(line(">low: "), line(">height ") - text_px);
}

TEST_F(FigureTest, TransparentPaperLetsThePageThrough) {
  project_.figure.dpi = 100;
  project_.figure.layout = FigureLayout::detail;
  project_.figure.transparent = true;
  project_.figure.legend = false;
  project_.region = {.x_mm = 70, .y_mm = 20, .side_mm = 48, .level = {0}};
  const Figure figure = draw();
  EXPECT_EQ(pixel(figure.image, figure.image.width * 8 / 10, figure.image.height / 2)[3], 0);
  EXPECT_EQ(pixel(figure.image, figure.image.width / 4, figure.image.height / 2)[3], 255);
}

TEST_F(FigureTest, BeforeLeavesOutWhatIsNotMeasuredAndAfterShowsIt) {
  project_.figure.dpi = 150;
  project_.figure.layout = FigureLayout::before_after;
  project_.figure.up_mark = project_.figure.scale_bar = project_.figure.letters = false;
  project_.region = {.x_mm = 5, .y_mm = 50, .side_mm = 40, .level = {0}};
  const Figure figure = draw();
  // The hole's middle, (25, 70), is in the middle of either picture.
  const int y = figure.image.width / 4;
  const auto before = pixel(figure.image, figure.image.width / 4 - 2, y);
  const auto after = pixel(figure.image, figure.image.width * 3 / 4 + 2, y);
  EXPECT_EQ(before, (std::array<int, 4>{255, 255, 255, 255}));
  EXPECT_LT(after[0], 240);
}

TEST_F(FigureTest, EveryLayoutAndReliefImageIsDrawn) {
  project_.figure.dpi = 60;
  std::ofstream(folder_ / "run.csv")
      << "t_s,hip_z_mm,proxy_z_mm,f_x_N,f_y_N,f_z_N\n0,1,2,0,0,1\n1,0,2,0,0,2\n";
  project_.figure.recording = (folder_ / "run.csv").string();
  for (const FigureLayout layout :
       {FigureLayout::detail, FigureLayout::reference_detail, FigureLayout::before_after,
        FigureLayout::levels, FigureLayout::plot}) {
    project_.figure.layout = layout;
    const Figure figure = draw();
    EXPECT_EQ(figure.image.width, 201) << name(layout);
    EXPECT_GT(figure.image.height, 60) << name(layout);
  }
  project_.figure.layout = FigureLayout::detail;
  RgbaImage last;
  for (std::size_t i = 0; i < kReliefKindNames.size(); ++i) {
    project_.figure.look.kind = static_cast<ReliefKind>(i);
    if (showsOwnColours(project_.figure.look.kind)) {
      EXPECT_THROW(draw(), ArgumentError);  // This relief has none.
      continue;
    }
    const Figure figure = draw();
    EXPECT_GT(meanDifference(figure.image, last), 1) << kReliefKindNames[i];
    last = figure.image;
  }
}

TEST_F(FigureTest, TheFirstRadiusIsTheSameLengthInEveryPanel) {
  project_.figure.dpi = 60;
  project_.figure.look.kind = ReliefKind::local_relief;
  project_.region.level = {1};
  for (const FigureLayout layout : {FigureLayout::reference_detail, FigureLayout::levels}) {
    project_.figure.layout = layout;
    project_.figure.look.radius_mm = 0;
    const Figure first = draw();
    EXPECT_NE(first.facts.caption.find("radius 10 mm"), std::string::npos) << first.facts.caption;
    project_.figure.look.radius_mm = 10;
    EXPECT_EQ(draw().image.rgba, first.image.rgba) << name(layout);
  }
}

TEST_F(FigureTest, StereoKeepsToTheComfortLimitAndSwapsEyes) {
  project_.figure.dpi = 100;
  project_.figure.layout = FigureLayout::detail;
  project_.figure.eye_angle_deg = 15;
  project_.gain = 10;
  project_.figure.stereo = StereoPrint::grey;
  const Figure limited = draw();
  EXPECT_LE(limited.facts.parallax_deg, kComfortDeg + 1e-9);
  EXPECT_LT(limited.facts.eye_angle_deg, 15);
  project_.figure.limit_parallax = false;
  const Figure wide = draw();
  EXPECT_EQ(wide.facts.eye_angle_deg, 15);
  EXPECT_GT(wide.facts.parallax_deg, kComfortDeg);
  project_.figure.swap_eyes = true;
  EXPECT_GT(meanDifference(draw().image, wide.image), 0.5);
  project_.figure.swap_eyes = false;
  project_.figure.stereo = StereoPrint::side_by_side;
  const Figure pair = draw();
  EXPECT_LT(pair.image.height, wide.image.height);
  const auto files = writeEyes(*surface_, project_, folder_ / "e.png").files;
  ASSERT_EQ(files.size(), 2U);
  EXPECT_NE(bytesOf(files[0]), bytesOf(files[1]));
}

TEST_F(FigureTest, TheEyesFilesKeepToTheScale) {
  project_.figure.dpi = 100;
  project_.figure.scale_1_to = 0.5;
  project_.region = {.x_mm = 60, .y_mm = 30, .side_mm = 30, .level = {0}};
  const auto files = writeEyes(*surface_, project_, folder_ / "e.png").files;
  const std::string png = bytesOf(files[0]);
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(png.at(at)); };
  EXPECT_EQ(256 * byte(18) + byte(19), 236) << "60 mm of paper, in IHDR";
}

TEST_F(FigureTest, HeightsInSixteenBitsAreTheReliefsHeights) {
  project_.figure.dpi = 100;
  project_.region = {.x_mm = 60, .y_mm = 30, .side_mm = 30, .level = {0}};
  writeHeightsTiff(*surface_, project_, folder_ / "h.tif", folder_ / "h.png");
  const RasterMap back = readRaster(folder_ / "h.tif");
  const auto [low, high] = std::minmax_element(back.values.begin(), back.values.end());
  // All of it lies on the plateau: one height.
  EXPECT_EQ(*low, *high);
  project_.region = {.x_mm = 40, .y_mm = 30, .side_mm = 30, .level = {0}};
  writeHeightsTiff(*surface_, project_, folder_ / "h.tif", folder_ / "h.png");
  const RasterMap step = readRaster(folder_ / "h.tif");
  EXPECT_EQ(*std::min_element(step.values.begin(), step.values.end()), 1);
  EXPECT_EQ(*std::max_element(step.values.begin(), step.values.end()), 65535);
}

TEST_F(FigureTest, TheCaptionNamesWhatTheFigureRestsOn) {
  const std::string caption = draw().facts.caption;
  for (const char* word :
       {"relief.ply", "unit mm", "top", "cells, 0.5 mm apart", "measured", "enclosed hole",
        "Resolution", "pyramid factor 2", "light from 315", "Scale 1:", "SHA-256", "level 0"}) {
    EXPECT_NE(caption.find(word), std::string::npos) << word << " in: " << caption;
  }
}

TEST_F(FigureTest, ARegionBesideTheObjectIsRefused) {
  project_.region = {.x_mm = 500, .y_mm = 500, .side_mm = 10, .level = {0}};
  EXPECT_THROW(draw(), ArgumentError);
}

TEST_F(FigureTest, OfAMapByTilesIsThatOfTheMapInMemory) {
  const test::BothWays both({.cols = 1400, .rows = 900});
  project_.region = {.x_mm = 20, .y_mm = 10, .side_mm = 60, .level = {1}};
  project_.figure.dpi = 60;
  project_.measurements = {{"step", MeasureKind::depth, {{40, 30}, {70, 60}}, 0},
                           {"cut", MeasureKind::profile, {{25, 20}, {75, 65}}, 0},
                           {"contour", MeasureKind::section, {}, 3.1}};
  for (const FigureLayout layout : {FigureLayout::reference_detail, FigureLayout::levels}) {
    project_.figure.layout = layout;
    const Figure tiled = drawFigure(both.tiled, project_);
    const Figure whole = drawFigure(both.whole, project_);
    EXPECT_EQ(tiled.image.rgba, whole.image.rgba);
    EXPECT_NE(tiled.facts.caption.find("1400"), std::string::npos) << tiled.facts.caption;
  }
  project_.figure.layout = FigureLayout::detail;
  project_.region.level = {0};
  EXPECT_EQ(drawFigure(both.tiled, project_).image.rgba,
            drawFigure(both.whole, project_).image.rgba);
  writeHeightsTiff(both.tiled, project_, folder_ / "tiled.tif", folder_ / "figure.png");
  writeHeightsTiff(both.whole, project_, folder_ / "whole.tif", folder_ / "figure.png");
  EXPECT_EQ(readRaster(folder_ / "tiled.tif").values, readRaster(folder_ / "whole.tif").values);
}

}  // namespace
}  // namespace relievo
