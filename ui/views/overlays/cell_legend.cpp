// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/overlays/cell_legend.h"

#include <algorithm>
#include <QBrush>
#include <QPainter>
#include <QStringList>

#include "ui/style/text.h"
#include "ui/vtk/relief_scene.h"

namespace relievo {
namespace {
constexpr int kMargin = 14;
constexpr int kPadding = 8;
constexpr double kLeastPercent = 0.1;  // Less is said as "less than".

QString percentText(std::ptrdiff_t part, std::ptrdiff_t all) {
  const double percent = 100.0 * static_cast<double>(part) / static_cast<double>(all);
  if (percent >= kLeastPercent) return CellLegend::tr("%1 %").arg(numberText(percent, 1));
  return CellLegend::tr("less than %1 %").arg(numberText(kLeastPercent, 1));
}
}  // namespace

CellLegend::CellLegend(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("cell_legend"));
  setAccessibleName(tr("Legend of unmeasured cells"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void CellLegend::show(const std::vector<CellStatus>& origins, StereoPrint print) {
  const auto count = [&](CellStatus origin) {
    return std::count(origins.begin(), origins.end(), origin);
  };
  const auto all = static_cast<std::ptrdiff_t>(origins.size()) - count(CellStatus::outside);
  print_ = print;
  rows_.clear();
  if (const auto cells = count(CellStatus::interpolated); cells > 0) {
    rows_.push_back({false, tr("interpolated: %1").arg(percentText(cells, all))});
  }
  if (const auto cells = count(CellStatus::base_plane); cells > 0) {
    rows_.push_back({true, tr("hole, on base plane: %1").arg(percentText(cells, all))});
  }
  QStringList texts;
  for (const Row& row : rows_) texts << row.text;
  if (rows_.empty()) texts << tr("All cells in view were measured");
  setAccessibleDescription(texts.join(QStringLiteral(", ")));
  setVisible(true);
  place();
  update();
}

void CellLegend::place() {
  const int line = fontMetrics().height();
  int widest = fontMetrics().horizontalAdvance(accessibleDescription());
  if (!rows_.empty()) widest = 0;
  for (const Row& row : rows_) {
    widest = std::max(widest, fontMetrics().horizontalAdvance(row.text) + line + kPadding);
  }
  const int lines = std::max(1, static_cast<int>(rows_.size()));
  const QSize wanted(widest + 2 * kPadding, lines * (line + kPadding) + kPadding);
  const int width = std::min(wanted.width(), parentWidget()->width() - 2 * kMargin);
  setGeometry(parentWidget()->width() - width - kMargin, kMargin, width, wanted.height());
}

void CellLegend::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor(18, 18, 20, 150));
  const int line = fontMetrics().height();
  const QColor words(245, 245, 245);
  QRect row(kPadding, kPadding, width() - 2 * kPadding, line);
  painter.setPen(words);
  if (rows_.empty()) painter.drawText(row, Qt::AlignLeft, accessibleDescription());
  for (const Row& entry : rows_) {
    const QRect swatch(row.topLeft(), QSize(line, line));
    if (entry.hatched) {
      painter.fillRect(swatch, QColor(170, 172, 178));
      painter.fillRect(swatch, QBrush(QColor(26, 30, 43), Qt::DiagCrossPattern));
    } else {
      const auto [red, green, blue] = mixedColour(print_, kUnmeasuredColour);
      painter.fillRect(swatch, QColor(red, green, blue));
    }
    painter.drawText(row.adjusted(line + kPadding, 0, 0, 0), Qt::AlignLeft, entry.text);
    row.translate(0, line + kPadding);
  }
}

}  // namespace relievo
