// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/plot_strip.h"

#include <QImage>
#include <QPainter>

#include "ui/figure/figure_plot.h"

namespace relievo {
namespace {

constexpr double kTextPt = 8;
constexpr double kLinesAcross = 22;  // The strip's height in lines of text: text grows with it.
constexpr double kLeftPt = 40, kRightPt = 8, kTopPt = 18, kBottomPt = 26;
constexpr double kGapPt = kPlotGapEm * kTextPt;
const QColor kCursor(0x16, 0x16, 0x18);

double dpiFor(int height_px) {
  return height_px / (kLinesAcross * 1.3 * kTextPt) * 72;
}

}  // namespace

struct PlotStrip::Impl {
  double dpi;
  double first_s = 0, last_s = 0;
  ForcePlots plots_mm;
  QImage curves;
};

PlotStrip::PlotStrip(const std::vector<ForcePoint>& rows, int width_px, int height_px)
    : impl_(std::make_unique<Impl>()) {
  impl_->dpi = dpiFor(height_px);
  impl_->first_s = rows.front().t_s;
  impl_->last_s = rows.back().t_s;
  impl_->curves = QImage(width_px, height_px, QImage::Format_ARGB32_Premultiplied);
  impl_->curves.fill(Qt::white);
  QPainter painter(&impl_->curves);
  FigureInk ink(painter, impl_->dpi, kTextPt, FigureInk::Target::pixels);
  constexpr double kMmPerPt = 25.4 / 72;
  const double width = width_px * 25.4 / impl_->dpi, height = height_px * 25.4 / impl_->dpi;
  const double across = width - kRightPt * kMmPerPt;
  const double room = height - (kTopPt + kBottomPt + kGapPt) * kMmPerPt;
  const QRectF heights(0, kTopPt * kMmPerPt, across, 0.6 * room);
  const QRectF forces(0, heights.bottom() + kGapPt * kMmPerPt, across, 0.4 * room);
  impl_->plots_mm = drawForcePlots(ink, rows, {heights, forces});
}

PlotStrip::~PlotStrip() = default;

RgbaImage PlotStrip::draw(double t_s, const std::string& words) const {
  QImage page = impl_->curves;
  QPainter painter(&page);
  FigureInk ink(painter, impl_->dpi, kTextPt, FigureInk::Target::pixels);
  ink.text({ink.pt(kLeftPt), ink.pt(0.7 * kTopPt)}, QString::fromStdString(words));
  if (impl_->last_s > impl_->first_s) {
    const double part = (t_s - impl_->first_s) / (impl_->last_s - impl_->first_s);
    painter.setPen(ink.pen(kCursor, 1));
    for (const QRectF& box : {impl_->plots_mm.heights, impl_->plots_mm.forces}) {
      const QRectF p = ink.px(box);
      const double x = p.left() + part * p.width();
      painter.drawLine(QPointF(x, p.top()), QPointF(x, p.bottom()));
    }
  }
  painter.end();
  page = page.convertToFormat(QImage::Format_RGBA8888_Premultiplied);
  RgbaImage image{page.width(), page.height(), {}};
  for (int row = 0; row < page.height(); ++row) {
    const uchar* line = page.constScanLine(row);
    image.rgba.insert(image.rgba.end(), line, line + 4 * static_cast<std::ptrdiff_t>(page.width()));
  }
  return image;
}

}  // namespace relievo
