// SPDX-License-Identifier: BSD-3-Clause
#include "ui/plots/time_plot.h"

#include <algorithm>
#include <cmath>
#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QPen>
#include <QTimer>

#include "core/recording/force_curves.h"
#include "ui/plots/curve_pens.h"
#include "ui/plots/least_ranges.h"
#include "ui/style/palette.h"

namespace relievo {
namespace {

constexpr double kShownS = 10;
// As often as curves are read: each time costs as much as a picture of a view does.
constexpr int kRedrawMs = 100;
// Less than a tenth of a pixel of the least ranges.
constexpr double kSameForceN = 1e-3, kSameHeightMm = 5e-5;
constexpr double kNearlyShownS = kShownS - 0.1;
constexpr int kMostDrawn = 1500;  // Points per curve; the strip is a thousand pixels wide.

bool looksAlike(const ForcePoint& a, const ForcePoint& b) {
  return std::all_of(kForceCurves.begin(), kForceCurves.end(), [&](const ForceCurve& curve) {
    const double same = curve.strip == ForceStrip::heights ? kSameHeightMm : kSameForceN;
    return std::abs(a.*curve.value - b.*curve.value) < same;
  });
}

}  // namespace

TimePlot::TimePlot(QWidget* parent)
    : QWidget(parent),
      heights_(tr("Height of hand and proxy over the last ten seconds"), tr("z (mm)"),
               curveNames(ForceStrip::heights), kShownS, this),
      forces_(tr("Force over the last ten seconds"), tr("force (N)"),
              curveNames(ForceStrip::forces), kShownS, this),
      timer_(new QTimer(this)) {
  setObjectName(QStringLiteral("time_plot"));
  setAccessibleName(tr("Plots of height and force"));
  setFocusPolicy(Qt::TabFocus);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 2, 8, 2);
  row->setSpacing(12);
  row->addWidget(heights_.widget(), 1);
  row->addWidget(forces_.widget(), 1);
  timer_->setInterval(kRedrawMs);
  connect(timer_, &QTimer::timeout, this, [this] {
    if (stale_) redraw();
  });
  takeColours();
  redraw();
}

void TimePlot::takeColours() {
  const ThemeColours& c = currentColours();
  heights_.setColours(c.base, c.border, c.quiet_text, curvePens(ForceStrip::heights, c));
  forces_.setColours(c.base, c.border, c.quiet_text, curvePens(ForceStrip::forces, c));
}

void TimePlot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::FontChange) return;
  for (StripPlot* plot : {&heights_, &forces_}) plot->takeFont(font());
}

void TimePlot::add(std::span<const ForcePoint> points) {
  // A loop that starts again starts its clock again.
  if (!points.empty() && !points_.empty() && points.front().t_s < points_.back().t_s) {
    points_.clear();
  }
  points_.insert(points_.end(), points.begin(), points.end());
  while (!points_.empty() && points_.front().t_s < points_.back().t_s - kShownS) {
    points_.pop_front();
  }
  stale_ = stale_ || !drawn_rest_ || points_.empty() ||
           !std::all_of(points.begin(), points.end(),
                        [&](const ForcePoint& p) { return looksAlike(p, *drawn_rest_); });
}

/// Curves that are level over all of the time shown stay as they are while time goes on.
std::optional<ForcePoint> TimePlot::restingAt() const {
  if (points_.empty() || points_.back().t_s - points_.front().t_s < kNearlyShownS) return {};
  const ForcePoint& last = points_.back();
  const bool rests = std::all_of(points_.begin(), points_.end(),
                                 [&](const ForcePoint& p) { return looksAlike(p, last); });
  return rests ? std::optional(last) : std::nullopt;
}

void TimePlot::clear() {
  points_.clear();
  redraw();
}

void TimePlot::redraw() {
  stale_ = false;
  drawn_rest_ = restingAt();
  const std::size_t step = std::max<std::size_t>(1, points_.size() / kMostDrawn);
  double strongest = kLeastForceN;
  int heights = 0, forces = 0;
  for (const ForceCurve& curve : kForceCurves) {
    const bool is_force = curve.strip == ForceStrip::forces;
    QVector<QPointF> drawn;
    for (std::size_t i = 0; i < points_.size(); i += step) {
      const double value = points_[i].*curve.value;
      drawn.append({points_[i].t_s - points_.back().t_s, value});
      if (is_force) strongest = std::max(strongest, value);
    }
    is_force ? forces_.setCurve(forces++, drawn) : heights_.setCurve(heights++, drawn);
  }
  forces_.setRange(0, 1.05 * strongest);
  if (points_.empty()) {
    heights_.setRange(0, 10);
  } else {
    heights_.setRangeFromCurves(kLeastHeightMm);
  }
  heights_.replot();
  forces_.replot();
}

void TimePlot::paintEvent(QPaintEvent* /*event*/) {
  if (!hasFocus()) return;
  QPainter painter(this);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
  painter.drawRect(rect().adjusted(1, 1, -1, -1));
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
