// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/overlays/cell_legend.h"

#include <algorithm>
#include <QBrush>
#include <QPainter>
#include <QStringList>

#include "ui/figure/hand_signs.h"
#include "ui/style/text.h"
#include "ui/views/overlays/corner.h"
#include "ui/vtk/relief_scene.h"

namespace relievo {
namespace {
constexpr double kLeastPercent = 0.1;  // Less is said as "less than".

QString percentText(std::ptrdiff_t part, std::ptrdiff_t all) {
  const double percent = 100.0 * static_cast<double>(part) / static_cast<double>(all);
  if (percent >= kLeastPercent) return CellLegend::tr("%1 %").arg(numberText(percent, 1));
  return CellLegend::tr("less than %1 %").arg(numberText(kLeastPercent, 1));
}
}  // namespace

CellLegend::CellLegend(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("cell_legend"));
  setAccessibleName(tr("Legend of marks"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void CellLegend::show(const std::vector<CellStatus>* origins, bool hand, StereoPrint print) {
  print_ = print;
  rows_.clear();
  if (origins != nullptr) addCells(*origins);
  if (hand) {
    rows_.push_back({Sign::proxy, tr("ball: proxy, on the surface")});
    rows_.push_back({Sign::hip, tr("ring with a cross: HIP")});
  }
  QStringList texts;
  for (const Row& row : rows_) texts << row.text;
  setAccessibleDescription(texts.join(QStringLiteral(", ")));
  setVisible(!rows_.empty());
  place();
  update();
}

void CellLegend::addCells(const std::vector<CellStatus>& origins) {
  const auto count = [&](CellStatus origin) {
    return std::count(origins.begin(), origins.end(), origin);
  };
  const auto all = static_cast<std::ptrdiff_t>(origins.size()) - count(CellStatus::outside);
  if (const auto cells = count(CellStatus::interpolated); cells > 0) {
    rows_.push_back({Sign::interpolated, tr("interpolated: %1").arg(percentText(cells, all))});
  }
  if (const auto cells = count(CellStatus::base_plane); cells > 0) {
    rows_.push_back({Sign::hole, tr("hole, on base plane: %1").arg(percentText(cells, all))});
  }
  if (rows_.empty()) rows_.push_back({Sign::none, tr("All cells in view were measured")});
}

void CellLegend::place() {
  const int line = fontMetrics().height();
  int widest = 0;
  for (const Row& row : rows_) {
    const int sign = row.sign == Sign::none ? 0 : line + kCornerPadding;
    widest = std::max(widest, fontMetrics().horizontalAdvance(row.text) + sign);
  }
  const int lines = std::max(1, static_cast<int>(rows_.size()));
  const QSize wanted(widest + 2 * kCornerPadding, lines * (line + kCornerPadding) + kCornerPadding);
  const int width = std::min(wanted.width(), parentWidget()->width() - 2 * kCornerMargin);
  setGeometry(parentWidget()->width() - width - kCornerMargin, kCornerMargin, width,
              wanted.height());
}

void CellLegend::paintSign(QPainter& painter, Sign sign, const QRect& place) const {
  switch (sign) {
    case Sign::none:
      return;
    case Sign::interpolated: {
      const auto [red, green, blue] = mixedColour(print_, kUnmeasuredColour);
      painter.fillRect(place, QColor(red, green, blue));
      return;
    }
    case Sign::hole:
      painter.fillRect(place, QColor(170, 172, 178));
      painter.fillRect(place, QBrush(QColor(26, 30, 43), Qt::DiagCrossPattern));
      return;
    case Sign::proxy:
      drawProxySign(painter, place);
      return;
    case Sign::hip:
      drawHipSign(painter, place);
      return;
  }
}

void CellLegend::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor(18, 18, 20, 150));
  const int line = fontMetrics().height();
  painter.setPen(QColor(245, 245, 245));
  QRect row(kCornerPadding, kCornerPadding, width() - 2 * kCornerPadding, line);
  for (const Row& entry : rows_) {
    const int sign = entry.sign == Sign::none ? 0 : line + kCornerPadding;
    paintSign(painter, entry.sign, QRect(row.topLeft(), QSize(line, line)));
    painter.drawText(row.adjusted(sign, 0, 0, 0), Qt::AlignLeft, entry.text);
    row.translate(0, line + kCornerPadding);
  }
}

}  // namespace relievo
