// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>

#include "core/base/failure.h"
#include "core/io/pipe_or_file.h"
#include "core/project/caption.h"
#include "core/project/embedded_state.h"
#include "core/session/large/tiled_surface.h"
#include "core/session/map_facts.h"
#include "ui/figure/figure_legend.h"
#include "ui/figure/figure_marks.h"
#include "ui/figure/figure_plot.h"
#include "ui/figure/figure_sheet.h"

namespace relievo {

namespace fs = std::filesystem;

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
                     .eye = f.eye,
                     .swap_eyes = f.swap_eyes,
                     .eye_angle_deg = facts.eye_angle_deg,
                     .paper_mm_per_mm = facts.paper_per_mm};
  if (facts.mm_per_pixel > 0) drawn.mm_per_pixel = facts.mm_per_pixel;
  if (facts.measured) drawn.measurements = project.measurements;
  const std::string caption =
      captionOf(project, surface, windowOf(surface, project.region, project.gain), drawn);
  return facts.left_out.empty() ? caption : caption + " " + facts.left_out;
}

namespace {

/// What the layout alone decides.
FigureFacts sizesOf(const FigureSheet& layout, const FigureInk& ink, double dpi, bool measured) {
  FigureFacts facts;
  facts.width_mm = layout.width_mm;
  facts.height_mm = layout.height_mm;
  facts.width_px = static_cast<int>(std::lround(facts.width_mm / 25.4 * dpi));
  facts.height_px = static_cast<int>(std::lround(facts.height_mm / 25.4 * dpi));
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

/// A recording says which scan was touched; of another one its heights and forces mean nothing
/// here.
std::vector<ForcePoint> curveOf(const Project& project, const Task& task) {
  const std::string& file = project.figure.recording;
  requirePipeOrFile(file);  // One that is not there is told as any other file.
  std::vector<ForcePoint> rows = readForceCurve(file, task);
  const std::optional<Project> touched = embeddedProject(file);
  if (touched && !touched->sha256.empty() && !project.sha256.empty() &&
      touched->sha256 != project.sha256) {
    throw failure<MessageId::recording_of_another_file>(fs::path(file).filename(),
                                                        fs::path(project.file).filename());
  }
  return rows;
}

/// Its rows follow from its numbers, and the sheet's height from its rows.
void fitLegend(const FigureInk& ink, const Surface& surface, const Project& project,
               DrawnSheet& drawn) {
  FigureSheet& sheet = drawn.layout;
  if (sheet.legend.isEmpty()) return;
  const FigureLegend legend(ink, surface, project, drawn.pictures.back().values,
                            ink.px(sheet.legend).width());
  sheet.legend.setHeight(legend.height() / ink.px(1.0));
  sheet.height_mm = sheet.legend.bottom();
}

/// What the figure's facts say of its size and marks.
FigureFacts factsOf(const Surface& surface, const Project& project, const DrawnSheet& drawn,
                    double dpi) {
  QImage unit(1, 1, QImage::Format_ARGB32_Premultiplied);
  QPainter painter(&unit);
  const FigureInk ink(painter, dpi, project.figure.text_pt, FigureInk::Target::pixels);
  FigureFacts facts = sizesOf(drawn.layout, ink, dpi, project.figure.measurements);
  const PanelPicture& picture = drawn.pictures.back();
  facts.eye_angle_deg = picture.eye_angle_deg;
  facts.parallax_deg = picture.parallax_deg;
  facts.zero_plane_mm = picture.zero_plane_mm;
  if (hasLegend(project.figure.look.kind)) {
    facts.range = {{picture.values.low, picture.values.high}};
    facts.range_unit = picture.values.unit;
  }
  facts.left_out = leftOutText(placeMarks(ink, {surface, project, drawn.layout, drawn.measured}));
  facts.caption = figureCaption(surface, project, facts);
  return facts;
}

}  // namespace

DrawnSheet drawPictures(const Surface& surface, const Project& project, double dpi,
                        const Task& task) {
  const FigureRequest& f = project.figure;
  check(f);
  DrawnSheet drawn;
  drawn.layout = layOut(surface, project);
  drawn.dpi = dpi;
  if (f.layout == FigureLayout::plot) drawn.recording = curveOf(project, task);
  // Before the pictures: one place beside the object and there is no figure.
  if (f.measurements) drawn.measured = readAll(surface, project);
  QImage unit(1, 1, QImage::Format_ARGB32_Premultiplied);
  QPainter painter(&unit);
  const FigureInk ink(painter, dpi, f.text_pt, FigureInk::Target::pixels);
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
  fitLegend(ink, surface, project, drawn);
  drawn.marks = placeMarks(ink, {surface, project, drawn.layout, drawn.measured});
  drawn.facts = factsOf(surface, project, drawn, dpi);
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
    drawForcePlots(ink, sheet.recording, {sheet.layout.heights_plot, sheet.layout.force_plot});
  }
  if (!sheet.layout.legend.isEmpty()) {
    const QRectF legend = ink.px(sheet.layout.legend);
    FigureLegend(ink, surface, project, sheet.pictures.back().values, legend.width())
        .draw(ink, legend.topLeft());
  }
}

namespace {

Figure onPixels(const Surface& surface, const Project& project, const DrawnSheet& sheet) {
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
  const DrawnSheet sheet = drawPictures(surface, project, project.figure.dpi, task);
  task.check();
  return onPixels(surface, project, sheet);
}

Figure previewFigure(const Surface& surface, const Project& project, int longest_px,
                     const Task& task) {
  check(project.figure);
  const double dpi = project.figure.dpi;
  const auto fitting = [&](const FigureSheet& sheet) {
    return std::min(dpi, longest_px / (std::max(sheet.width_mm, sheet.height_mm) / 25.4));
  };
  DrawnSheet sheet = drawPictures(surface, project, fitting(layOut(surface, project)), task);
  // Its legend has more rows than one: only now is it known how long the sheet is.
  if (const double fits = fitting(sheet.layout); fits < sheet.dpi) {
    sheet = drawPictures(surface, project, fits, task);
  }
  task.check();
  Figure figure = onPixels(surface, project, sheet);
  figure.facts = factsOf(surface, project, sheet, dpi);  // Of the figure, not of the preview.
  return figure;
}

}  // namespace relievo
