// SPDX-License-Identifier: BSD-3-Clause
#include "ui/time_plot.h"

#include <qwt_legend.h>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>
#include <qwt_text.h>
#include <algorithm>
#include <QHBoxLayout>
#include <QPen>
#include <QTimer>

#include "ui/palette.h"

namespace relievo {
namespace {

constexpr double kShownS = 10;
constexpr int kRedrawMs = 40;
constexpr double kLeastForceN = 1;
constexpr int kMostDrawn = 1500;  // Points per curve; the strip is a thousand pixels wide.

QwtText small(const QString& text) {
  QwtText label(text);
  QFont font = label.font();
  font.setPointSizeF(8.5);
  font.setBold(false);
  label.setFont(font);
  return label;
}

QwtPlot* makePlot(const QString& name, const QString& unit, QWidget* parent) {
  auto* plot = new QwtPlot(parent);
  plot->setAccessibleName(name);
  plot->setToolTip(name);
  plot->setAxisTitle(QwtPlot::yLeft, small(unit));
  plot->setAxisScale(QwtPlot::xBottom, -kShownS, 0, 2);
  plot->setAxisMaxMajor(QwtPlot::yLeft, 4);
  auto* canvas = new QwtPlotCanvas(plot);
  canvas->setFrameStyle(QFrame::NoFrame);
  plot->setCanvas(canvas);
  for (const int axis : {QwtPlot::xBottom, QwtPlot::yLeft}) {
    QFont font = plot->axisFont(axis);
    font.setPointSizeF(8);
    plot->setAxisFont(axis, font);
    plot->axisScaleDraw(axis)->enableComponent(QwtAbstractScaleDraw::Backbone, false);
  }
  auto* grid = new QwtPlotGrid;
  grid->enableX(false);
  grid->attach(plot);
  return plot;
}

QwtPlotCurve* makeCurve(const QString& title, QwtPlot* plot) {
  auto* curve = new QwtPlotCurve(title);
  curve->setPaintAttribute(QwtPlotCurve::FilterPoints);
  curve->attach(plot);
  return curve;
}

}  // namespace

TimePlot::TimePlot(QWidget* parent)
    : QWidget(parent),
      heights_(
          makePlot(tr("Height of hand and proxy over the last ten seconds"), tr("z (mm)"), this)),
      forces_(makePlot(tr("Force over the last ten seconds"), tr("force (N)"), this)),
      timer_(new QTimer(this)) {
  setObjectName(QStringLiteral("time_plot"));
  setAccessibleName(tr("Plots of height and force"));
  setFocusPolicy(Qt::TabFocus);
  curves_ = {makeCurve(tr("hand"), heights_), makeCurve(tr("proxy"), heights_),
             makeCurve(tr("force"), forces_)};
  for (QwtPlot* plot : {heights_, forces_}) {
    auto* legend = new QwtLegend;
    legend->setMaxColumns(1);
    plot->insertLegend(legend, QwtPlot::RightLegend);
  }
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 2, 8, 2);
  row->setSpacing(12);
  row->addWidget(heights_, 1);
  row->addWidget(forces_, 1);
  timer_->setInterval(kRedrawMs);
  connect(timer_, &QTimer::timeout, this, [this] {
    if (stale_) redraw();
  });
  takeColours();
  redraw();
}

void TimePlot::takeColours() {
  const ThemeColours& c = currentColours();
  curves_[0]->setPen(QPen(c.hip, 1.5, Qt::DashLine));
  curves_[1]->setPen(QPen(c.proxy, 1.8));
  curves_[2]->setPen(QPen(c.force, 1.8));
  for (QwtPlot* plot : {heights_, forces_}) {
    plot->setCanvasBackground(c.base);
    plot->setAutoFillBackground(false);
    const auto items = plot->itemList(QwtPlotItem::Rtti_PlotGrid);
    for (QwtPlotItem* item : items) {
      static_cast<QwtPlotGrid*>(item)->setMajorPen(QPen(c.border, 0.5));
    }
    plot->replot();
  }
}

void TimePlot::add(std::span<const TouchPlotPoint> points) {
  // A loop that starts again starts its clock again.
  if (!points.empty() && !points_.empty() && points.front().t_s < points_.back().t_s) {
    points_.clear();
  }
  points_.insert(points_.end(), points.begin(), points.end());
  while (!points_.empty() && points_.front().t_s < points_.back().t_s - kShownS) {
    points_.pop_front();
  }
  stale_ = true;
}

void TimePlot::clear() {
  points_.clear();
  redraw();
}

void TimePlot::redraw() {
  stale_ = false;
  const std::size_t step = std::max<std::size_t>(1, points_.size() / kMostDrawn);
  QVector<QPointF> hand;
  QVector<QPointF> proxy;
  QVector<QPointF> force;
  double strongest = kLeastForceN;
  for (std::size_t i = 0; i < points_.size(); i += step) {
    const TouchPlotPoint& p = points_[i];
    const double t = p.t_s - points_.back().t_s;
    hand.append({t, p.hip_z_mm});
    proxy.append({t, p.proxy_z_mm});
    force.append({t, p.force_n});
    strongest = std::max(strongest, p.force_n);
  }
  curves_[0]->setSamples(hand);
  curves_[1]->setSamples(proxy);
  curves_[2]->setSamples(force);
  forces_->setAxisScale(QwtPlot::yLeft, 0, 1.05 * strongest);
  if (points_.empty()) heights_->setAxisScale(QwtPlot::yLeft, 0, 10);
  if (!points_.empty()) heights_->setAxisAutoScale(QwtPlot::yLeft, true);
  heights_->replot();
  forces_->replot();
}

void TimePlot::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  timer_->start();
}

void TimePlot::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  timer_->stop();
}

}  // namespace relievo
