// SPDX-License-Identifier: BSD-3-Clause
#include "ui/plots/strip_plot.h"

#include <qwt_legend.h>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_item.h>
#include <qwt_plot_marker.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_map.h>
#include <qwt_text.h>
#include <algorithm>
#include <array>
#include <QFont>
#include <QFontMetrics>
#include <QPainter>
#include <QPalette>
#include <QPolygonF>

namespace relievo {
namespace {

constexpr double kLabelSize = 0.85;      // Of the window's text.
constexpr double kLargeTextPoints = 14;  // From here on fewer heights fit beside the plot.
constexpr int kLeastLines = 5;
constexpr std::array<double, 2> kTicksEveryS{2, 5};  // The closest first; else one at each end.
constexpr double kApart = 1.3;                       // Middles of numbers, in their widths.
constexpr int kMostNumbers = 8;

/// Small triangles at the upper edge, as the axes in colour and size.
class EventMarks : public QwtPlotItem {
 public:
  QVector<double> times_s;

 private:
  void draw(QPainter* painter, const QwtScaleMap& x_map, const QwtScaleMap& /*y_map*/,
            const QRectF& canvas) const override {
    const double height = 0.5 * QFontMetrics(plot()->axisFont(QwtPlot::xBottom)).height();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(Qt::NoPen);
    painter->setBrush(plot()->palette().color(QPalette::Text));
    for (const double t : times_s) {
      const QPointF top(x_map.transform(t), canvas.top());
      painter->drawPolygon(QPolygonF({top - QPointF(0.5 * height, 0),
                                      top + QPointF(0.5 * height, 0), top + QPointF(0, height)}));
    }
  }
};

/// As many numbers of seconds below the curves as do not touch each other.
class NumberedPlot : public QwtPlot {
 public:
  explicit NumberedPlot(QWidget* parent) : QwtPlot(parent) {}

  void showLast(double seconds) { setTimes(-seconds, 0, true); }
  void showBetween(double low_s, double high_s) { setTimes(low_s, high_s, false); }
  void updateLayout() override {
    QwtPlot::updateLayout();
    fitNumbers();
  }

 private:
  void setTimes(double low_s, double high_s, bool is_last) {
    low_s_ = low_s;
    high_s_ = high_s;
    is_last_ = is_last;
    step_s_ = 0;
    setAxisScale(xBottom, low_s, high_s);
    fitNumbers();
  }
  double numberWidth() const {
    const QwtScaleDraw* draw = axisScaleDraw(xBottom);
    const QFont font = axisFont(xBottom);
    return std::max(draw->label(low_s_).textSize(font).width(),
                    draw->label(high_s_).textSize(font).width());
  }
  void fitNumbers() {
    const double between = canvas()->width() / std::max(1.0, kApart * numberWidth());
    if (!is_last_) {
      setAxisMaxMajor(xBottom, std::clamp(static_cast<int>(between), 1, kMostNumbers));
      return;
    }
    const double length_s = high_s_ - low_s_;
    const auto fits = [&](double step_s) { return length_s / step_s <= between; };
    const auto* const step = std::find_if(kTicksEveryS.begin(), kTicksEveryS.end(), fits);
    const double every_s = step == kTicksEveryS.end() ? length_s : *step;
    if (every_s == step_s_) return;
    step_s_ = every_s;
    setAxisScale(xBottom, low_s_, high_s_, every_s);
    updateAxes();
  }

  double low_s_ = 0, high_s_ = 1;
  double step_s_ = 0;  ///< Between numbers; 0: not known yet.
  bool is_last_ = false;
};

QwtText labelIn(const QFont& font, QwtText label) {
  label.setFont(font);
  return label;
}

}  // namespace

StripPlot::StripPlot(const QString& name, const QString& axis, const QStringList& curves,
                     double seconds, QWidget* parent)
    : plot_(new NumberedPlot(parent)) {
  plot_->setAccessibleName(name);
  plot_->setToolTip(name);
  plot_->setAxisTitle(QwtPlot::yLeft, axis);
  auto* canvas = new QwtPlotCanvas(plot_);
  canvas->setFrameStyle(QFrame::NoFrame);
  canvas->setFocusPolicy(Qt::NoFocus);
  plot_->setCanvas(canvas);
  for (const int which : {QwtPlot::xBottom, QwtPlot::yLeft}) {
    plot_->axisScaleDraw(which)->enableComponent(QwtAbstractScaleDraw::Backbone, false);
  }
  auto* grid = new QwtPlotGrid;
  grid->enableX(false);
  grid->attach(plot_);
  for (const QString& title : curves) {
    auto* curve = new QwtPlotCurve(title);
    curve->setPaintAttribute(QwtPlotCurve::FilterPoints);
    curve->setRenderHint(QwtPlotItem::RenderAntialiased);
    curve->setLegendAttribute(QwtPlotCurve::LegendShowLine);
    curve->attach(plot_);
    curves_.append(curve);
  }
  auto* legend = new QwtLegend;
  legend->setMaxColumns(1);
  plot_->insertLegend(legend, QwtPlot::RightLegend);
  static_cast<NumberedPlot*>(plot_)->showLast(seconds);
  takeFont(plot_->font());
}

void StripPlot::takeFont(const QFont& text) {
  QFont font = text;
  font.setPointSizeF(kLabelSize * text.pointSizeF());
  font.setBold(false);
  for (const int which : {QwtPlot::xBottom, QwtPlot::yLeft}) plot_->setAxisFont(which, font);
  plot_->setAxisTitle(QwtPlot::yLeft, labelIn(font, plot_->axisTitle(QwtPlot::yLeft)));
  for (QwtPlotCurve* curve : curves_) {
    curve->setTitle(labelIn(font, curve->title()));
    const int line = QFontMetrics(font).height();
    curve->setLegendIconSize(QSize(line, line / 2));
  }
  // Two numbers beside the plot, and the row of numbers below it.
  plot_->setMinimumHeight(kLeastLines * QFontMetrics(font).height());
  const bool large = text.pointSizeF() >= kLargeTextPoints;
  plot_->setAxisMaxMajor(QwtPlot::yLeft, large ? 2 : 4);
  plot_->updateLayout();
}

QWidget* StripPlot::widget() const {
  return plot_;
}

void StripPlot::setColours(const QColor& background, const QColor& grid, const QColor& text,
                           const QVector<QPen>& pens) {
  plot_->setCanvasBackground(background);
  QPalette palette = plot_->palette();
  palette.setColor(QPalette::WindowText, text);
  palette.setColor(QPalette::Text, text);
  plot_->setPalette(palette);
  for (QwtPlotItem* item : plot_->itemList(QwtPlotItem::Rtti_PlotGrid)) {
    static_cast<QwtPlotGrid*>(item)->setMajorPen(QPen(grid, 0.5));
  }
  for (int i = 0; i < curves_.size(); ++i) curves_[i]->setPen(pens[i]);
  plot_->replot();
}

void StripPlot::setCurve(int index, const QVector<QPointF>& points) {
  curves_[index]->setSamples(points);
}

void StripPlot::setTimes(double low_s, double high_s) {
  static_cast<NumberedPlot*>(plot_)->showBetween(low_s, high_s);
}

void StripPlot::setCursor(double x_s) {
  if (cursor_ == nullptr) setCursorColour(plot_->palette().color(QPalette::Text));
  cursor_->setXValue(x_s);
}

void StripPlot::setCursorColour(const QColor& colour) {
  if (cursor_ == nullptr) {
    cursor_ = new QwtPlotMarker;
    cursor_->setLineStyle(QwtPlotMarker::VLine);
    cursor_->attach(plot_);
  }
  cursor_->setLinePen(QPen(colour, 1.5));
}

void StripPlot::setEvents(const QVector<double>& times_s) {
  if (events_ == nullptr) {
    events_ = new EventMarks;
    events_->attach(plot_);
  }
  static_cast<EventMarks*>(events_)->times_s = times_s;
}

void StripPlot::setRange(double low, double high) {
  plot_->setAxisScale(QwtPlot::yLeft, low, high);
}

void StripPlot::setRangeFromCurves(double least) {
  QRectF all;
  for (const QwtPlotCurve* curve : curves_) {
    const QRectF box = curve->boundingRect();
    if (curve->dataSize() > 0) all = all.isNull() ? box : all.united(box);
  }
  if (all.height() >= least) {
    plot_->setAxisAutoScale(QwtPlot::yLeft, true);
  } else {
    setRange(all.center().y() - 0.5 * least, all.center().y() + 0.5 * least);
  }
}

void StripPlot::replot() {
  plot_->replot();
}

}  // namespace relievo
