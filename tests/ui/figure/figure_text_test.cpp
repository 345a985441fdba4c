// SPDX-License-Identifier: BSD-3-Clause
// What figures say in numbers: legends, lengths, pages.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "core/base/error.h"
#include "core/depth/rules/rasterize.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/core/scan_fixtures.h"
#include "ui/figure/figure.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

/// A dome on a plate of 100 x 80 lattice cells.
Surface surfaceOf(double step, double rise, LengthUnit unit) {
  SurfaceOptions options;
  options.unit = unit;
  options.view = ViewChoice{"top", {}};
  const Scan scan = test::latticeScan(101, 81, step, [=](double x, double y) {
    const double r = std::hypot(x / step - 50, y / step - 40) / 30;
    return r < 1 ? rise * (1 - r * r) : 0;
  });
  return makeSurface(scan, options, rasterize);
}

class FigureText : public ::testing::Test {
 protected:
  void use(const Surface& surface) {
    project_.file = "relief.ply";
    project_.region = wholeRegion(surface.ladder);
    project_.figure.layout = FigureLayout::detail;
    project_.figure.dpi = 100;
  }
  std::string bytesOf(const Surface& surface, const char* name) {
    const fs::path file = folder_.path() / name;
    facts_ = writeFigure(surface, project_, file);
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }
  /// Every text of a figure as SVG, and where it starts, pixels.
  std::vector<std::pair<std::string, double>> textsOf(const Surface& surface) {
    const std::string svg = bytesOf(surface, "a.svg");
    const std::regex element(
        "matrix\\([^,]*,[^,]*,[^,]*,[^,]*,([^,]*),[^)]*\\)\"[^>]*>\\s*<text[^>]*>([^<]*)<");
    std::vector<std::pair<std::string, double>> texts;
    for (auto it = std::sregex_iterator(svg.begin(), svg.end(), element);
         it != std::sregex_iterator(); ++it) {
      texts.emplace_back((*it)[2], std::stod((*it)[1]));
    }
    return texts;
  }
  static bool has(const std::vector<std::pair<std::string, double>>& texts,
                  const std::string& text) {
    return std::any_of(texts.begin(), texts.end(), [&](const auto& t) { return t.first == text; });
  }

  test::TemporaryFolder folder_;
  Project project_;
  FigureFacts facts_;
};

TEST_F(FigureText, TheColourBarHasRoundNumbersWithTheSameDecimals) {
  const Surface surface = surfaceOf(1, 8, LengthUnit::mm);
  use(surface);
  project_.figure.look.kind = ReliefKind::height;
  project_.figure.scale_bar = project_.figure.up_mark = project_.figure.height_bar = false;
  using Range = std::array<double, 2>;
  const std::vector<std::pair<Range, std::vector<std::string>>> cases{
      {{12.00012, 12.00108}, {"12.0002", "12.0004", "12.0006", "12.0008", "12.0010"}},
      {{0.0889, 37.5}, {"10", "20", "30"}},
      {{-3, 3}, {"\u22122", "0", "2"}},
      {{-0.31, 0.31}, {"\u22120.2", "0.0", "0.2"}},
      {{0, 1e6}, {"0", "200000", "400000", "600000", "800000", "1000000"}}};
  for (const double width_mm : {40.0, 180.0}) {
    project_.figure.width_mm = width_mm;
    for (const auto& [range, numbers] : cases) {
      project_.figure.look.range = range;
      const auto texts = textsOf(surface);
      // All of them on a wide sheet, as many as fit beside each other on a narrow one.
      ASSERT_GE(texts.size(), 3U) << range[0];
      const bool wide = width_mm == 180;
      ASSERT_EQ(texts.size(), wide ? numbers.size() + 1 : texts.size()) << range[0];
      EXPECT_EQ(texts.back().first, "height (mm)");
      const double em_px = 0.3 * project_.figure.text_pt * 100 / 72;
      for (std::size_t i = 0; i + 1 < texts.size(); ++i) {
        const std::string& number = texts[i].first;
        EXPECT_EQ(number, wide ? numbers[i] : number);
        EXPECT_EQ(number.size() - std::min(number.size(), number.find('.')),
                  texts[0].first.size() - std::min(texts[0].first.size(), texts[0].first.find('.')))
            << "the same decimals";
        EXPECT_GE(texts[i].second, -1e-9) << "on the paper";
        if (i == 0) continue;
        const auto letters = static_cast<double>(texts[i - 1].first.size());
        EXPECT_GT(texts[i].second - texts[i - 1].second, letters * em_px) << "beside each other";
      }
    }
  }
}

TEST_F(FigureText, TerrainIsToldInMetres) {
  const Surface surface = surfaceOf(20, 300, LengthUnit::m);
  use(surface);
  project_.figure.look.kind = ReliefKind::height;
  project_.figure.measurements = true;
  project_.measurements = {
      {"way", MeasureKind::distance, {{1e5, 1e5}, {3e5, 1e5}}, 0},
      {"hill", MeasureKind::area, {{8e5, 6e5}, {12e5, 6e5}, {12e5, 10e5}}, 1e4},
      {"contour", MeasureKind::section, {}, 150e3}};
  const auto texts = textsOf(surface);
  for (const char* text : {"height (m)", "0", "100", "200", "500 m", "height 200 m"}) {
    EXPECT_TRUE(has(texts, text)) << text;
  }
  std::map<std::string, std::string> labels;
  for (const auto& [text, x] : texts) {
    if (text.find(": ") == std::string::npos) continue;
    labels[text.substr(0, text.find(':'))] = text;
  }
  EXPECT_EQ(labels["way"].rfind("way: 200 \u00b1 ", 0), 0U) << labels["way"];
  EXPECT_TRUE(labels["way"].ends_with(" m")) << labels["way"];
  EXPECT_TRUE(labels["hill"].ends_with(" m\u00b2")) << labels["hill"];
  for (const char* part :
       {"2.02 \u00d7 1.62 km \u00d7 300 m (unit m", "20 m apart",
        "2.02 \u00d7 2.02 km from x 0, y ",
        "Planes: volume of hill, level at 10 m; section contour, level at 150 m."}) {
    EXPECT_NE(facts_.caption.find(part), std::string::npos) << part << " in: " << facts_.caption;
  }
  EXPECT_EQ(facts_.caption.find(" mm"), std::string::npos) << facts_.caption;
}

TEST_F(FigureText, APlaneThatIsNotDrawnIsNotNamed) {
  const Surface surface = surfaceOf(1, 8, LengthUnit::mm);
  use(surface);
  project_.measurements = {{"cut", MeasureKind::section, {}, 4, {0.6, 0.8, 0}},
                           {"dip", MeasureKind::depth, {{10, 10}, {50, 40}}, 0}};
  project_.measurements[0].plane_mm = 62;
  EXPECT_NE(
      drawFigure(surface, project_)
          .facts.caption.find(" Planes: section cut, upright: 0.6 x + 0.8 y = 62 mm. Of the cells"),
      std::string::npos);
  project_.figure.measurements = false;
  EXPECT_EQ(drawFigure(surface, project_).facts.caption.find("Planes"), std::string::npos);
}

TEST_F(FigureText, APdfPageIsAsLargeAsThePaper) {
  const Surface surface = surfaceOf(1, 8, LengthUnit::mm);
  use(surface);
  const std::regex media("/MediaBox \\[ *(\\S+) +(\\S+) +(\\S+) +(\\S+) *\\]");
  for (const double width_mm : {180.0, 85.0, 100.01}) {
    project_.figure.width_mm = width_mm;
    const std::string pdf = bytesOf(surface, "a.pdf");
    std::smatch box;
    ASSERT_TRUE(std::regex_search(pdf, box, media));
    const auto side = [&](std::size_t low, std::size_t high) {
      return std::stod(box[high]) - std::stod(box[low]);
    };
    EXPECT_NEAR(side(1, 3), width_mm / 25.4 * 72, 0.05);
    EXPECT_NEAR(side(2, 4), facts_.height_mm / 25.4 * 72, 0.05);
    // Readers find every object by its offset.
    const std::size_t table = pdf.rfind("startxref");
    ASSERT_NE(table, std::string::npos);
    EXPECT_EQ(pdf.compare(std::stoul(pdf.substr(table + 10)), 4, "xref"), 0);
  }
}

TEST_F(FigureText, AnSvgPageIsAsLargeAsThePaperAndWhite) {
  const Surface surface = surfaceOf(1, 8, LengthUnit::mm);
  use(surface);
  const std::regex head(
      "<svg width=\"([0-9.]+)mm\" height=\"([0-9.]+)mm\"\\s+viewBox=\"0 0 ([0-9.]+) ([0-9.]+)\"");
  for (const double width_mm : {180.0, 173.0, 100.01}) {
    project_.figure.width_mm = width_mm;
    project_.figure.transparent = false;
    const std::string svg = bytesOf(surface, "a.svg");
    std::smatch page;
    ASSERT_TRUE(std::regex_search(svg, page, head)) << svg.substr(0, 400);
    EXPECT_NEAR(std::stod(page[1]), width_mm, 1e-6);
    EXPECT_NEAR(std::stod(page[2]), facts_.height_mm, 1e-5);
    EXPECT_NEAR(std::stod(page[3]), width_mm / 25.4 * 100, 1e-2);
    EXPECT_NEAR(std::stod(page[4]), facts_.height_mm / 25.4 * 100, 1e-2);
    // White paper before anything else is drawn, unless it is to be transparent.
    const auto first_white = [](const std::string& text) {
      const std::size_t drawn = text.find("<g fill=\"#ffffff\"");
      return drawn != std::string::npos && drawn < text.find("<image");
    };
    EXPECT_TRUE(first_white(svg)) << svg.substr(0, 3000);
    project_.figure.transparent = true;
    EXPECT_FALSE(first_white(bytesOf(surface, "b.svg")));
  }
}

TEST_F(FigureText, OnlyAMapHasNorth) {
  Surface surface = surfaceOf(1, 8, LengthUnit::mm);
  use(surface);
  struct Case {
    const char* format;
    std::optional<LengthUnit> unit;
    const char* up;
  };
  for (const Case& c :
       {Case{"LAS 1.4 point format 6", LengthUnit::m, "N"},
        Case{"GeoTIFF Float32", LengthUnit::m, "N"},
        Case{"ESRI ASCII grid Float32", LengthUnit::m, "N"}, Case{"GeoTIFF Float32", {}, "y"},
        Case{"GeoTIFF Float32", LengthUnit::mm, "y"}, Case{"PLY ascii", LengthUnit::m, "y"}}) {
    surface.info.format = c.format;
    surface.info.unit = c.unit;
    EXPECT_TRUE(has(textsOf(surface), c.up)) << c.format;
  }
}

TEST_F(FigureText, AMeasurementBesideTheObjectIsRefusedBeforeAnythingIsDrawn) {
  const Surface surface = surfaceOf(1, 8, LengthUnit::mm);
  use(surface);
  project_.measurements = {{"off", MeasureKind::point, {{999, 999}}, 0}};
  testing::internal::CaptureStderr();
  EXPECT_THROW(writeFigure(surface, project_, folder_.path() / "a.png"), ArgumentError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_FALSE(fs::exists(folder_.path() / "a.png"));
}

TEST_F(FigureText, TwoEyesPicturesTouchWithoutTheirNames) {
  const Surface surface = surfaceOf(1, 8, LengthUnit::mm);
  use(surface);
  project_.figure.legend = false;
  project_.figure.width_mm = 101.6;
  project_.figure.stereo = StereoPrint::side_by_side;
  const Figure named = drawFigure(surface, project_);
  EXPECT_LT(named.image.height, 200) << "a gap between them";
  project_.figure.letters = false;
  const Figure pair = drawFigure(surface, project_);
  EXPECT_EQ(pair.image.width, 400);
  EXPECT_EQ(pair.image.height, 200);
  project_.figure.width_mm = 50.8;
  project_.figure.stereo = StereoPrint::over_under;
  const Figure stacked = drawFigure(surface, project_);
  EXPECT_EQ(stacked.image.width, 200);
  EXPECT_EQ(stacked.image.height, 400);
}

}  // namespace
}  // namespace relievo
