// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>

#include "core/project/caption.h"
#include "core/session/map_facts.h"
#include "core/session/tiled_surface.h"
#include "ui/figure/figure_marks.h"
#include "ui/figure/figure_plot.h"
#include "ui/figure/figure_sheet.h"

namespace relievo {

struct FigureSession::Impl {
  int argc = 3;
  std::array<char, 8> program{"relievo"};
  std::array<char, 10> option{"-platform"};
  std::array<char, 10> platform{"offscreen"};
  std::array<char*, 4> argv{program.data(), option.data(), platform.data(), nullptr};
  QGuiApplication app{argc, argv.data()};
};

FigureSession::FigureSession() {
  if (QCoreApplication::instance() == nullptr) impl_ = std::make_unique<Impl>();
}
FigureSession::~FigureSession() = default;

std::string figureCaption(const Surface& surface, const Project& project,
                          const FigureFacts& facts) {
  const FigureRequest& f = project.figure;
  CaptionFacts drawn{.look = figureLook(surface, project),
                     .stereo = f.stereo,
                     .swap_eyes = f.swap_eyes,
                     .eye_angle_deg = facts.eye_angle_deg,
                     .paper_mm_per_mm = facts.paper_per_mm};
  if (facts.mm_per_pixel > 0) drawn.mm_per_pixel = facts.mm_per_pixel;
  if (facts.measured) drawn.measurements = project.measurements;
  return captionOf(project, surface, windowOf(surface, project.region, project.gain), drawn);
}

namespace {

/// What the layout alone decides.
FigureFacts sizesOf(const FigureSheet& layout, const FigureInk& ink, double dpi, bool measured) {
  FigureFacts facts;
  facts.width_mm = layout.width_mm;
  facts.height_mm = layout.height_mm;
  facts.width_px = static_cast<int>(std::lround(facts.width_mm / 25.4 * dpi));
  facts.height_px = static_cast<int>(std::ceil(facts.height_mm / 25.4 * dpi - 1e-6));
  facts.paper_per_mm = layout.paper_per_mm;
  facts.measured = measured;
  for (const FigurePanel& panel : layout.panels) {
    if (!panel.whole) facts.mm_per_pixel = panel.shown.width_mm / ink.pixels(panel.paper).width();
  }
  return facts;
}

std::vector<Reading> readAll(const Surface& surface, const Project& project) {
  std::vector<Reading> readings;
  const MapCells cells = mapCells(surface);
  for (const Measurement& m : project.measurements) readings.push_back(read(cells, m));
  return readings;
}

}  // namespace

DrawnSheet drawPictures(const Surface& surface, const Project& project, double dpi,
                        const Task& task) {
  const FigureRequest& f = project.figure;
  check(f);
  DrawnSheet drawn;
  drawn.layout = layOut(surface, project);
  drawn.dpi = dpi;
  if (f.layout == FigureLayout::plot) drawn.recording = readForceCurve(f.recording);
  // Before the pictures: one place beside the object and there is no figure.
  if (f.measurements) drawn.measured = readAll(surface, project);
  QImage unit(1, 1, QImage::Format_ARGB32_Premultiplied);
  QPainter painter(&unit);
  const FigureInk ink(painter, dpi, f.text_pt, FigureInk::Target::pixels);
  FigureFacts& facts = drawn.facts;
  facts = sizesOf(drawn.layout, ink, dpi, f.measurements);
  // The region's first: where its colours end they end in the others, which its bar explains, too.
  Project alike = project;
  alike.figure.look = figureLook(surface, project);
  drawn.pictures.resize(drawn.layout.panels.size());
  for (std::size_t i = drawn.pictures.size(); i-- > 0;) {
    const FigurePanel& panel = drawn.layout.panels[i];
    PanelPicture& picture = drawn.pictures[i];
    picture =
        drawPanel(surface, alike, panel, drawn.layout, ink.pixels(panel.paper).size(), dpi, task);
    if (hasLegend(f.look.kind))
      alike.figure.look.range = {{picture.values.low, picture.values.high}};
  }
  facts.eye_angle_deg = drawn.pictures.back().eye_angle_deg;
  facts.parallax_deg = drawn.pictures.back().parallax_deg;
  facts.zero_plane_mm = drawn.pictures.back().zero_plane_mm;
  if (hasLegend(f.look.kind)) {
    const ReliefValues& values = drawn.pictures.back().values;
    facts.range = {{values.low, values.high}};
    facts.range_unit = values.unit;
  }
  facts.caption = figureCaption(surface, project, facts);
  return drawn;
}

void paintSheet(QPainter& painter, const Surface& surface, const Project& project,
                const DrawnSheet& sheet, FigureInk::Target target) {
  const FigureRequest& f = project.figure;
  FigureInk ink(painter, sheet.dpi, f.text_pt, target);
  for (std::size_t i = 0; i < sheet.layout.panels.size(); ++i) {
    painter.drawImage(ink.pixels(sheet.layout.panels[i].paper), sheet.pictures[i].image);
  }
  for (std::size_t i = 0; i < sheet.layout.panels.size(); ++i) {
    drawMarks(ink, surface, project, sheet, static_cast<int>(i));
  }
  if (!sheet.recording.empty()) {
    drawForcePlots(ink, sheet.recording, sheet.layout.heights_plot, sheet.layout.force_plot);
  }
  if (!sheet.layout.legend.isEmpty()) {
    drawLegend(ink, surface, project, sheet.layout.legend, sheet.pictures.back().values);
  }
}

namespace {

Figure onPixels(const Surface& surface, const Project& project, double dpi, const Task& task) {
  const DrawnSheet sheet = drawPictures(surface, project, dpi, task);
  task.check();
  QImage page(sheet.facts.width_px, sheet.facts.height_px, QImage::Format_ARGB32_Premultiplied);
  page.fill(project.figure.transparent ? Qt::transparent : Qt::white);
  QPainter painter(&page);
  paintSheet(painter, surface, project, sheet, FigureInk::Target::pixels);
  painter.end();
  page = page.convertToFormat(QImage::Format_RGBA8888_Premultiplied);
  Figure figure{{page.width(), page.height(), {}}, sheet.facts};
  const std::size_t row_bytes = 4 * static_cast<std::size_t>(page.width());
  figure.image.rgba.reserve(row_bytes * static_cast<std::size_t>(page.height()));
  for (int row = 0; row < page.height(); ++row) {
    const uchar* line = page.constScanLine(row);
    figure.image.rgba.insert(figure.image.rgba.end(), line, line + row_bytes);
  }
  return figure;
}

}  // namespace

Figure drawFigure(const Surface& surface, const Project& project, const Task& task) {
  return onPixels(surface, project, project.figure.dpi, task);
}

Figure previewFigure(const Surface& surface, const Project& project, int longest_px,
                     const Task& task) {
  check(project.figure);
  const FigureSheet sheet = layOut(surface, project);
  const double longest_inch = std::max(sheet.width_mm, sheet.height_mm) / 25.4;
  const double dpi = project.figure.dpi;
  Figure figure = onPixels(surface, project, std::min(dpi, longest_px / longest_inch), task);
  // Said of the figure, not of the preview.
  QImage unit(1, 1, QImage::Format_ARGB32_Premultiplied);
  QPainter painter(&unit);
  const FigureInk ink(painter, dpi, project.figure.text_pt, FigureInk::Target::pixels);
  FigureFacts facts = sizesOf(sheet, ink, dpi, project.figure.measurements);
  facts.eye_angle_deg = figure.facts.eye_angle_deg;
  facts.parallax_deg = figure.facts.parallax_deg;
  facts.zero_plane_mm = figure.facts.zero_plane_mm;
  facts.range = figure.facts.range;
  facts.range_unit = figure.facts.range_unit;
  facts.caption = figureCaption(surface, project, facts);
  figure.facts = facts;
  return figure;
}

}  // namespace relievo
