// SPDX-License-Identifier: BSD-3-Clause
#include "ui/plots/time_plot.h"

#include <algorithm>
#include <cmath>
#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QPen>
#include <QTimer>

#include "ui/style/palette.h"

namespace relievo {
namespace {

constexpr double kShownS = 10;
constexpr int kRedrawMs = 40;
constexpr double kLeastForceN = 1;
constexpr double kLeastHeightMm = 0.05;
// Less than a tenth of a pixel of the least ranges.
constexpr double kSameForceN = 1e-3, kSameHeightMm = 5e-5;
constexpr double kNearlyShownS = kShownS - 0.1;
constexpr int kMostDrawn = 1500;  // Points per curve; the strip is a thousand pixels wide.

bool looksAlike(const ForcePoint& a, const ForcePoint& b) {
  return std::abs(a.hip_z_mm - b.hip_z_mm) < kSameHeightMm &&
         std::abs(a.proxy_z_mm - b.proxy_z_mm) < kSameHeightMm &&
         std::abs(a.force_n - b.force_n) < kSameForceN;
}

}  // namespace

TimePlot::TimePlot(QWidget* parent)
    : QWidget(parent),
      heights_(tr("Height of hand and proxy over the last ten seconds"), tr("z (mm)"),
               {tr("hand"), tr("proxy")}, kShownS, this),
      forces_(tr("Force over the last ten seconds"), tr("force (N)"), {tr("force")}, kShownS, this),
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
  heights_.setColours(c.base, c.border, c.quiet_text,
                      {QPen(c.hip, 1.5, Qt::DashLine), QPen(c.proxy, 1.8)});
  forces_.setColours(c.base, c.border, c.quiet_text, {QPen(c.force, 1.8)});
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
  QVector<QPointF> hand;
  QVector<QPointF> proxy;
  QVector<QPointF> force;
  double strongest = kLeastForceN;
  for (std::size_t i = 0; i < points_.size(); i += step) {
    const ForcePoint& p = points_[i];
    const double t = p.t_s - points_.back().t_s;
    hand.append({t, p.hip_z_mm});
    proxy.append({t, p.proxy_z_mm});
    force.append({t, p.force_n});
    strongest = std::max(strongest, p.force_n);
  }
  heights_.setCurve(0, hand);
  heights_.setCurve(1, proxy);
  forces_.setCurve(0, force);
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
