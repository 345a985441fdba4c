// SPDX-License-Identifier: BSD-3-Clause
// Marks, legends and plots where there is little room: boxes, not looks.
#include "ui/figure/mark_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <QImage>
#include <QPainter>

#include "core/base/error.h"
#include "core/depth/rules/rasterize.h"
#include "core/session/large/tiled_surface.h"
#include "core/session/map_facts.h"
#include "tests/core/scan_fixtures.h"
#include "ui/figure/figure_legend.h"
#include "ui/figure/figure_plot.h"
#include "ui/figure/label_place.h"

namespace relievo {
namespace {

using Kind = PlacedMark::Kind;

/// A dome on a plate of 120 x 90 mm with a hole.
Surface dome() {
  SurfaceOptions options;
  options.unit = LengthUnit::mm;
  options.view = ViewChoice{"top", {}};
  Scan scan = test::latticeScan(481, 361, 0.25, [](double x, double y) {
    const double r = std::hypot(x - 60, y - 45) / 30;
    return r < 1 ? 20 * (1 - r * r) : 0;
  });
  std::erase_if(scan.points, [](const std::array<float, 3>& p) {
    return p[0] > 32 && p[0] < 36 && p[1] > 60 && p[1] < 66;
  });
  test::finishScan(scan);
  return makeSurface(scan, options, rasterize);
}

class MarkPlaces : public ::testing::Test {
 protected:
  void SetUp() override {
    project_.file = "relief.ply";
    project_.region = {.x_mm = 30, .y_mm = 15, .side_mm = 60, .level = {0}};
    project_.figure.legend = false;
    project_.figure.recording = "run.csv";
  }
  std::vector<PanelMarks> placed() {
    const FigureSheet sheet = layOut(surface_, project_);
    const MapCells cells = mapCells(surface_);
    std::vector<Reading> measured;
    for (const Measurement& m : project_.measurements) measured.push_back(read(cells, m));
    const FigureInk ink = inkOf();
    boxes_.clear();
    for (const FigurePanel& panel : sheet.panels) boxes_.push_back(ink.pixels(panel.paper));
    return placeMarks(ink, {surface_, project_, sheet, measured});
  }
  FigureInk inkOf() {
    const FigureRequest& f = project_.figure;
    return {painter_, f.dpi, f.text_pt, FigureInk::Target::pixels};
  }
  /// Every mark is whole within its panel, its words within its plate, and none over another.
  void expectApart(const std::vector<PanelMarks>& panels, const std::string& where) {
    const FigureInk ink = inkOf();
    constexpr double kOff = 0.51;  // Bars lie on whole pixels.
    for (std::size_t p = 0; p < panels.size(); ++p) {
      const auto& marks = panels[p].marks;
      for (std::size_t i = 0; i < marks.size(); ++i) {
        const PlacedMark& mark = marks[i];
        EXPECT_TRUE(boxes_[p].adjusted(-kOff, -kOff, kOff, kOff).contains(mark.box)) << where;
        const QRectF box = mark.box.adjusted(-kOff, -kOff, kOff, kOff);
        EXPECT_TRUE(mark.bar.isEmpty() || box.contains(mark.bar)) << where;
        for (const MarkWords& w : mark.words) {
          const double width = ink.width(w.text, w.size);
          const double left = w.centred ? w.at.x() - 0.5 * width : w.at.x();
          const double em = ink.pt(w.size * ink.textPt());
          EXPECT_TRUE(box.contains(QRectF(left, w.at.y() - 0.73 * em, width, 0.73 * em)))
              << w.text.toStdString() << " " << where;
        }
        for (std::size_t j = 0; j < i; ++j) {
          EXPECT_FALSE(mark.box.intersects(marks[j].box)) << where << " " << i << ", " << j;
        }
      }
    }
  }
  static int count(const PanelMarks& panel, Kind kind) {
    return static_cast<int>(std::count_if(panel.marks.begin(), panel.marks.end(),
                                          [&](const PlacedMark& m) { return m.kind == kind; }));
  }

  Surface surface_ = dome();
  Project project_;
  std::vector<QRectF> boxes_;
  QImage unit_{1, 1, QImage::Format_ARGB32_Premultiplied};
  QPainter painter_{&unit_};
};

TEST_F(MarkPlaces, NoMarkIsOverAnotherOrCutAtAnyWidthTextSizeAndLayout) {
  project_.measurements = {{"depth of the ear over the ground plate by hand",
                            MeasureKind::depth,
                            {{40, 40}, {80, 40}},
                            0},
                           {"low", MeasureKind::depth, {{84, 16}, {89, 16}}, 0},
                           {"contour", MeasureKind::section, {}, 10}};
  for (std::size_t layout = 0; layout < kFigureLayoutNames.size(); ++layout) {
    project_.figure.layout = static_cast<FigureLayout>(layout);
    for (const double width_mm : {20.0, 40.0, 60.0, 85.0, 120.0, 180.0}) {
      for (const double text_pt : {4.0, 8.0, 10.0, 12.0, 36.0}) {
        if (project_.figure.layout == FigureLayout::plot && width_mm < 3.2 * text_pt) continue;
        project_.figure.width_mm = width_mm;
        project_.figure.text_pt = text_pt;
        const std::string where = std::string(kFigureLayoutNames[layout]) + " " +
                                  std::to_string(width_mm) + " mm, " + std::to_string(text_pt) +
                                  " pt";
        const std::vector<PanelMarks> panels = placed();
        expectApart(panels, where);
        for (const PanelMarks& panel : panels) {
          EXPECT_EQ(count(panel, Kind::scale_bar), 1) << where << ": in every picture";
        }
      }
    }
  }
}

TEST_F(MarkPlaces, TheHeightBarStandsAboveTheScaleBarWhereTheyHaveNoRoomBesideEachOther) {
  project_.figure.layout = FigureLayout::detail;
  const auto bottom_and_top = [&](double width_mm) {
    project_.figure.width_mm = width_mm;
    const PanelMarks panel = placed().front();
    std::map<Kind, QRectF> boxes;
    for (const PlacedMark& mark : panel.marks) boxes[mark.kind] = mark.box;
    EXPECT_EQ(boxes.count(Kind::height_bar), 1U) << width_mm;
    return std::pair{boxes[Kind::height_bar].bottom(), boxes[Kind::scale_bar].top()};
  };
  const auto [beside, scale_top] = bottom_and_top(85);
  EXPECT_GT(beside, scale_top);
  const auto [above, narrow_top] = bottom_and_top(30);
  EXPECT_LT(above, narrow_top);
  // And where not even that fits a sentence says so.
  project_.figure.width_mm = 20;
  project_.figure.text_pt = 12;
  EXPECT_EQ(leftOutText(placed()).rfind("No room in the picture for: height bar", 0), 0U)
      << leftOutText(placed());
  project_.figure.width_mm = 85;
  EXPECT_EQ(leftOutText(placed()), "");
}

/// The first number of a bar's words, "height 5 mm" or "2 cm", in mm.
double lengthInWords(const QString& words) {
  const QStringList parts = words.split(' ');
  for (int i = 0; i + 1 < parts.size(); ++i) {
    bool is_number = false;
    const double number = parts[i].toDouble(&is_number);
    if (!is_number) continue;
    if (parts[i + 1].startsWith("cm")) return 10 * number;
    if (parts[i + 1].startsWith("mm")) return number;
    if (parts[i + 1].startsWith(QChar(0xb5))) return 1e-3 * number;
  }
  return 0;
}

TEST_F(MarkPlaces, BothBarsAreAsLongAsTheirWordsSayAtOneScale) {
  int judged = 0;
  for (const FigureLayout layout : {FigureLayout::detail, FigureLayout::reference_detail}) {
    project_.figure.layout = layout;
    for (const double width_mm : {60.0, 85.0, 120.0, 180.0}) {
      project_.figure.width_mm = width_mm;
      const FigureSheet sheet = layOut(surface_, project_);
      const std::vector<PanelMarks> panels = placed();
      for (std::size_t i = 0; i < panels.size(); ++i) {
        // From the sheet's own millimetres: paper and object.
        const double px_per_mm = boxes_[i].width() / sheet.panels[i].shown.width_mm;
        for (const PlacedMark& mark : panels[i].marks) {
          if (mark.kind != Kind::height_bar && mark.kind != Kind::scale_bar) continue;
          const bool upright = mark.kind == Kind::height_bar;
          const double drawn_px = upright ? mark.bar.height() : mark.bar.width();
          const double said_mm = lengthInWords(mark.words.front().text);
          ASSERT_GT(said_mm, 0) << mark.words.front().text.toStdString();
          EXPECT_NEAR(drawn_px, said_mm * px_per_mm, 1.01)
              << mark.words.front().text.toStdString() << " on " << width_mm << " mm";
          judged += upright ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GE(judged, 4);
}

TEST_F(MarkPlaces, APanelsTitleIsWholeBesideTheUpMark) {
  project_.figure.layout = FigureLayout::levels;
  for (const double width_mm : {85.0, 120.0, 180.0}) {
    project_.figure.width_mm = width_mm;
    const FigureSheet sheet = layOut(surface_, project_);
    const std::vector<PanelMarks> panels = placed();
    ASSERT_GT(panels.size(), 2U);
    for (std::size_t i = 0; i < panels.size(); ++i) {
      const auto letter = std::find_if(panels[i].marks.begin(), panels[i].marks.end(),
                                       [](const PlacedMark& m) { return m.kind == Kind::letter; });
      ASSERT_NE(letter, panels[i].marks.end());
      QString title;
      for (std::size_t w = 1; w < letter->words.size(); ++w) {
        title += (title.isEmpty() ? "" : " ") + letter->words[w].text;
        EXPECT_EQ(letter->words[w].size, 1);
      }
      EXPECT_EQ(title, sheet.panels[i].title) << width_mm;
      EXPECT_EQ(count(panels[i], Kind::up), 1) << width_mm;
    }
  }
}

TEST_F(MarkPlaces, AMeasuredValueIsWholeAndItsNameIsShortenedFirst) {
  project_.figure.layout = FigureLayout::detail;
  const std::string name = "depth of the elephant ear over the ground plate by hand";
  project_.measurements = {{name, MeasureKind::depth, {{40, 40}, {80, 50}}, 0}};
  const auto lines = [&](double width_mm) {
    project_.figure.width_mm = width_mm;
    const std::vector<PanelMarks> panels = placed();
    std::vector<QString> texts;
    for (const MarkWords& w : panels.front().marks.back().words) texts.push_back(w.text);
    return texts;
  };
  const std::vector<QString> wide = lines(180);
  ASSERT_EQ(wide.size(), 1U);
  const QString value = wide[0].mid(static_cast<int>(name.size()) + 2);
  EXPECT_TRUE(value.contains(QChar(0xb1)) && value.endsWith("mm")) << value.toStdString();
  const std::vector<QString> narrow = lines(60);
  ASSERT_EQ(narrow.size(), 2U);
  EXPECT_TRUE(narrow[0].startsWith("depth of the ")) << narrow[0].toStdString();
  EXPECT_TRUE(narrow[0].endsWith(QString(QChar(0x2026)) + ':')) << narrow[0].toStdString();
  EXPECT_EQ(narrow[1], value);
}

TEST_F(MarkPlaces, ALegendKeepsTheTextsSizeAndTheFiguresWidth) {
  project_.figure.layout = FigureLayout::detail;
  project_.figure.legend = true;
  project_.figure.look.kind = ReliefKind::height;
  ReliefValues values;
  values.title = "height";
  values.unit = "mm";
  values.low = 0;
  values.high = 37.5;
  double last = 0;
  for (const double width_mm : {180.0, 60.0, 40.0}) {
    project_.figure.width_mm = width_mm;
    const FigureInk ink = inkOf();
    const double room = ink.px(width_mm);
    const FigureLegend legend(ink, surface_, project_, values, room);
    EXPECT_LE(legend.width(), room + 1e-6) << width_mm;
    EXPECT_EQ(legend.textSize(), 1) << width_mm;
    EXPECT_GE(legend.height(), last) << "as many rows as it needs";
    last = legend.height();
  }
}

TEST_F(MarkPlaces, ForcePlotsHaveRoomForTheirNumbers) {
  project_.figure.layout = FigureLayout::plot;
  std::vector<ForcePoint> rows;
  for (int i = 0; i <= 200; ++i) rows.push_back({0.01 * i, 0.01 * i, 1, 0.6});
  for (const double width_mm : {60.0, 85.0, 180.0}) {
    for (const double text_pt : {4.0, 8.0, 16.0}) {
      project_.figure.width_mm = width_mm;
      project_.figure.text_pt = text_pt;
      const FigureSheet sheet = layOut(surface_, project_);
      FigureInk ink = inkOf();
      const ForcePlots boxes = drawForcePlots(ink, rows, {sheet.heights_plot, sheet.force_plot});
      EXPECT_GE(ink.px(sheet.width_mm - boxes.forces.right()),
                0.5 * ink.width(text_pt > 8 ? "2" : "2.0") - 1e-6)
          << "half the last time's number beside the plot";
      EXPECT_EQ(boxes.forces.right(), boxes.heights.right()) << "one axis of time";
      EXPECT_EQ(boxes.forces.left(), boxes.heights.left());
      // A number at the end of either axis stands out by half its height.
      EXPECT_GE(boxes.forces.top() - boxes.heights.bottom(), text_pt * kMmPerPoint);
      EXPECT_GE(ink.px(boxes.heights.left()), ink.width("0.00") + ink.pt(text_pt))
          << "numbers and the upright title";
    }
  }
}

}  // namespace
}  // namespace relievo
