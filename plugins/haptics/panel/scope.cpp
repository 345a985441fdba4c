// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/panel/scope.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <QAction>
#include <QFile>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/base/failure.h"
#include "core/io/formats/text_file.h"
#include "core/recording/force_curves.h"
#include "ui/message/message_text.h"

namespace relievo {

namespace {
const char* colourOf(const ForceCurve& curve) {
  constexpr std::array<const char*, 3> kColours{"#c0392b", "#1f5fa8", "#2e7d32"};
  return kColours.at(static_cast<std::size_t>(curve.ink));
}

QString nameOf(const ForceCurve& curve) {
  return QLatin1String(curve.window_name) +
         QLatin1String(curve.strip == ForceStrip::heights ? " z (mm)" : " (N)");
}

struct Range {
  double low = 0, high = 1;
};
/// Of the curves of one strip; never without height.
Range rangeOf(std::span<const ForcePoint> samples, ForceStrip strip) {
  Range range{1e300, -1e300};
  for (const ForceCurve& curve : kForceCurves) {
    if (curve.strip != strip) continue;
    for (const ForcePoint& sample : samples) {
      range.low = std::min(range.low, sample.*curve.value);
      range.high = std::max(range.high, sample.*curve.value);
    }
  }
  if (strip == ForceStrip::forces) range.low = std::min(0.0, range.low);
  if (!(range.low <= range.high)) return {};
  if (range.high - range.low < 1e-3) range.high = range.low + 1e-3;
  return range;
}

QString exact(double value) {
  return QString::number(value, 'g', 9);
}

/// Points of one curve within a box; time fills its width.
QPolygonF pointsOf(std::span<const ForcePoint> samples, const ForceCurve& curve, const Range& range,
                   const QRectF& box) {
  QPolygonF points;
  if (samples.empty()) return points;
  const double start = samples.front().t_s;
  const double length = std::max(1e-9, samples.back().t_s - start);
  for (const ForcePoint& sample : samples) {
    const double part = (sample.*curve.value - range.low) / (range.high - range.low);
    points << QPointF(box.left() + box.width() * (sample.t_s - start) / length,
                      box.bottom() - box.height() * part);
  }
  return points;
}
}  // namespace

QString scopeCsv(std::span<const ForcePoint> samples) {
  QString text = QStringLiteral("t_s");
  for (const ForceCurve& curve : kForceCurves) {
    text += ',' + QString::fromLatin1(curve.column.data(), static_cast<int>(curve.column.size()));
  }
  text += '\n';
  for (const ForcePoint& s : samples) {
    QStringList values{exact(s.t_s)};
    for (const ForceCurve& curve : kForceCurves) values += exact(s.*curve.value);
    text += values.join(',') + '\n';
  }
  return text;
}

QString scopeSvg(std::span<const ForcePoint> samples) {
  constexpr double kWidth = 900, kStrip = 200, kLeft = 70, kGap = 30;
  QString svg = QStringLiteral(
                    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%1\" height=\"%2\" "
                    "font-family=\"sans-serif\" font-size=\"12\">\n"
                    "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n")
                    .arg(kLeft + kWidth + kGap)
                    .arg(2 * kStrip + 4 * kGap);
  for (const ForceStrip strip : kForceStrips) {
    const bool lower = strip == ForceStrip::forces;
    const QRectF box(kLeft, kGap + (lower ? kStrip + kGap : 0), kWidth, kStrip);
    const Range range = rangeOf(samples, strip);
    svg += QStringLiteral(
               "<rect x=\"%1\" y=\"%2\" width=\"%3\" height=\"%4\" fill=\"none\" "
               "stroke=\"#888\"/>\n<text x=\"4\" y=\"%5\">%6</text>\n"
               "<text x=\"4\" y=\"%7\">%8</text>\n")
               .arg(box.x())
               .arg(box.y())
               .arg(box.width())
               .arg(box.height())
               .arg(box.top() + 12)
               .arg(QString::number(range.high, 'f', 3))
               .arg(box.bottom())
               .arg(QString::number(range.low, 'f', 3));
    int row = 0;
    for (const ForceCurve& curve : kForceCurves) {
      if (curve.strip != strip) continue;
      QStringList points;
      for (const QPointF& p : pointsOf(samples, curve, range, box)) {
        points << QString::number(p.x(), 'f', 2) + ',' + QString::number(p.y(), 'f', 2);
      }
      svg += QStringLiteral(
                 "<polyline fill=\"none\" stroke=\"%1\" points=\"%2\"/>\n"
                 "<text x=\"%3\" y=\"%4\" fill=\"%1\">%5</text>\n")
                 .arg(QLatin1String(colourOf(curve)), points.join(' '))
                 .arg(kLeft + 8)
                 .arg(box.top() + 16 + 14 * row++)
                 .arg(nameOf(curve));
    }
  }
  const double length = samples.empty() ? 0 : samples.back().t_s - samples.front().t_s;
  svg += QStringLiteral("<text x=\"%1\" y=\"%2\">%3 s</text>\n</svg>\n")
             .arg(kLeft)
             .arg(2 * kStrip + 3 * kGap)
             .arg(QString::number(length, 'f', 3));
  return svg;
}

ScopeView::ScopeView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("scopeView"));
  setAccessibleName(tr("Height of hand and proxy, and force"));
  setAccessibleDescription(tr("Left and Right move the cursor, plus and minus zoom."));
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(480, 320);
}

void ScopeView::add(std::span<const ForcePoint> samples) {
  // A loop that starts again starts its clock again.
  if (!samples.empty() && !samples_.empty() && samples.front().t_s < samples_.back().t_s) {
    samples_.clear();
  }
  samples_.insert(samples_.end(), samples.begin(), samples.end());
  // What is shown while paused must not run away.
  const double keep_from = samples_.empty() ? 0 : samples_.back().t_s - kMostSpanS;
  while (!samples_.empty() && samples_.front().t_s < keep_from) samples_.pop_front();
  if (paused_ || samples_.empty()) return;
  end_s_ = samples_.back().t_s;
  take();
}

void ScopeView::setPaused(bool paused) {
  paused_ = paused;
  if (!paused_ && !samples_.empty()) {
    end_s_ = samples_.back().t_s;
    take();
  }
}

void ScopeView::take() {
  const double from_end = shown_.empty() ? 0 : static_cast<double>(shown_.size() - 1 - cursor_);
  shown_.clear();
  for (const ForcePoint& sample : samples_) {
    if (sample.t_s >= end_s_ - span_s_ && sample.t_s <= end_s_) shown_.push_back(sample);
  }
  const double last = shown_.empty() ? 0 : static_cast<double>(shown_.size() - 1);
  cursor_ = static_cast<std::size_t>(std::max(0.0, last - from_end));
  update();
  Q_EMIT cursorMoved();
}

void ScopeView::zoom(double factor) {
  const double at = shown_.empty() ? end_s_ : shown_[cursor_].t_s;
  const double span = std::clamp(span_s_ * factor, kLeastSpanS, kMostSpanS);
  const double newest = samples_.empty() ? end_s_ : samples_.back().t_s;
  // The cursor keeps its place on the screen.
  if (paused_) end_s_ = std::min(newest, at + (end_s_ - at) * span / span_s_);
  span_s_ = span;
  take();
  const auto nearest = std::lower_bound(shown_.begin(), shown_.end(), at,
                                        [](const ForcePoint& s, double t) { return s.t_s < t; });
  if (paused_ && nearest != shown_.end()) {
    cursor_ = static_cast<std::size_t>(nearest - shown_.begin());
    Q_EMIT cursorMoved();
  }
}

void ScopeView::moveCursor(int by) {
  if (shown_.empty()) return;
  const auto last = static_cast<std::int64_t>(shown_.size()) - 1;
  cursor_ = static_cast<std::size_t>(
      std::clamp<std::int64_t>(static_cast<std::int64_t>(cursor_) + by, 0, last));
  update();
  Q_EMIT cursorMoved();
}

QString ScopeView::cursorText() const {
  if (shown_.empty()) return tr("Nothing measured yet.");
  const ForcePoint& s = shown_[cursor_];
  return tr("At %1 s: HIP %2 mm, proxy %3 mm, force %4 N")
      .arg(s.t_s, 0, 'f', 3)
      .arg(s.hip_z_mm, 0, 'f', 3)
      .arg(s.proxy_z_mm, 0, 'f', 3)
      .arg(s.force_n, 0, 'f', 3);
}

void ScopeView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  painter.setRenderHint(QPainter::Antialiasing);
  constexpr double kMargin = 8;
  const double strip_height = 0.5 * (height() - 3 * kMargin);
  for (const ForceStrip strip : kForceStrips) {
    const bool lower = strip == ForceStrip::forces;
    const QRectF box(kMargin, kMargin + (lower ? strip_height + kMargin : 0), width() - 2 * kMargin,
                     strip_height);
    const Range range = rangeOf(shown_, strip);
    painter.setPen(palette().mid().color());
    painter.drawRect(box);
    painter.setPen(palette().text().color());
    painter.drawText(box.adjusted(4, 2, -4, -2), Qt::AlignTop | Qt::AlignRight,
                     QString::number(range.high, 'f', 2));
    painter.drawText(box.adjusted(4, 2, -4, -2), Qt::AlignBottom | Qt::AlignRight,
                     QString::number(range.low, 'f', 2));
    for (const ForceCurve& curve : kForceCurves) {
      if (curve.strip != strip) continue;
      painter.setPen(QPen(QColor(QLatin1String(colourOf(curve))), 1.6));
      painter.drawPolyline(pointsOf(shown_, curve, range, box));
    }
    if (shown_.size() < 2) continue;
    const double length = std::max(1e-9, shown_.back().t_s - shown_.front().t_s);
    const double x = box.left() + box.width() * (shown_[cursor_].t_s - shown_.front().t_s) / length;
    painter.setPen(QPen(palette().text().color(), 1, Qt::DashLine));
    painter.drawLine(QPointF(x, box.top()), QPointF(x, box.bottom()));
  }
}

void ScopeView::wheelEvent(QWheelEvent* event) {
  constexpr double kStep = 120;
  zoom(std::pow(0.8, event->angleDelta().y() / kStep));
  event->accept();
}

void ScopeView::mousePressEvent(QMouseEvent* event) {
  if (shown_.empty()) return;
  const double part = std::clamp(event->localPos().x() / width(), 0.0, 1.0);
  const auto wanted = static_cast<int>(part * static_cast<double>(shown_.size() - 1));
  moveCursor(wanted - static_cast<int>(cursor_));
}

void ScopeView::keyPressEvent(QKeyEvent* event) {
  const int step = (event->modifiers() & Qt::ShiftModifier) != 0 ? 20 : 1;
  switch (event->key()) {
    case Qt::Key_Left:
      return moveCursor(-step);
    case Qt::Key_Right:
      return moveCursor(step);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(0.8);
    case Qt::Key_Minus:
      return zoom(1.25);
    default:
      QWidget::keyPressEvent(event);
  }
}

ScopeDialog::ScopeDialog(QWidget* parent)
    : QDialog(parent), view_(new ScopeView), values_(new QLabel) {
  setObjectName(QStringLiteral("scope"));
  setWindowTitle(tr("Force and height against time"));
  values_->setObjectName(QStringLiteral("scopeValues"));
  values_->setAccessibleName(tr("Values at the cursor"));
  values_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* row = new QHBoxLayout;
  const auto button = [&](QAction* action) {
    auto* tool = new QToolButton;
    tool->setDefaultAction(action);
    tool->setAccessibleName(action->toolTip());
    row->addWidget(tool);
  };
  QAction* pause = command("scopePause", tr("&Pause"), tr("Hold the plots still"));
  pause->setCheckable(true);
  connect(pause, &QAction::toggled, view_, &ScopeView::setPaused);
  QAction* in = command("scopeZoomIn", tr("Zoom &in"), tr("Show a shorter time (plus, wheel)"));
  connect(in, &QAction::triggered, view_, [this] { view_->zoom(0.5); });
  QAction* out = command("scopeZoomOut", tr("Zoom &out"), tr("Show a longer time (minus, wheel)"));
  connect(out, &QAction::triggered, view_, [this] { view_->zoom(2); });
  QAction* svg = command("scopeSvg", tr("&SVG…"), tr("Save what is shown as a drawing"));
  connect(svg, &QAction::triggered, this, [this] { ask(tr("Drawings (*.svg)"), ".svg"); });
  QAction* csv = command("scopeCsv", tr("&CSV…"), tr("Save what is shown as a table"));
  connect(csv, &QAction::triggered, this, [this] { ask(tr("Tables (*.csv)"), ".csv"); });
  for (QAction* action : {pause, in, out, svg, csv}) button(action);
  row->addStretch(1);
  auto* column = new QVBoxLayout(this);
  column->addWidget(view_, 1);
  column->addWidget(values_);
  column->addLayout(row);
  connect(view_, &ScopeView::cursorMoved, values_,
          [this] { values_->setText(view_->cursorText()); });
  values_->setText(view_->cursorText());
}

QAction* ScopeDialog::command(const char* name, const QString& text, const QString& tip) {
  auto* action = new QAction(text, this);
  action->setObjectName(QString::fromLatin1(name));
  action->setToolTip(tip);
  action->setStatusTip(tip);
  addAction(action);
  return action;
}

void ScopeDialog::add(std::span<const ForcePoint> samples) {
  view_->add(samples);
}

QString ScopeDialog::exportTo(const QString& file) const {
  const bool table = file.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive);
  const QString text = table ? scopeCsv(view_->shown()) : scopeSvg(view_->shown());
  try {
    writeTextFile(QFile::encodeName(file).toStdString(), text.toStdString());
  } catch (const WriteError& error) {
    return messageText(messageOf(error));
  }
  return {};
}

void ScopeDialog::ask(const QString& filter, const QString& ending) {
  auto* dialog = new QFileDialog(this, tr("Save the plots"), {}, filter);
  dialog->setObjectName(QStringLiteral("scope_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  // Before the question whether a file may be replaced.
  dialog->setDefaultSuffix(ending.mid(1));
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    const QString wrong = exportTo(file);
    values_->setText(wrong.isEmpty() ? tr("Saved: %1").arg(file) : wrong);
  });
  dialog->open();
}

}  // namespace relievo
