// SPDX-License-Identifier: BSD-3-Clause
#include "ui/frame/overview_inset.h"

#include <algorithm>
#include <QPainter>

#include "ui/vtk/window_pink.h"

namespace relievo {
namespace {

constexpr QSize kSize(150, 110);
constexpr int kMargin = 16;  // From the view's corner.
constexpr double kPadding = 8;

}  // namespace

OverviewInset::OverviewInset(Document& document, QWidget* parent)
    : QWidget(parent), document_(document) {
  setObjectName(QStringLiteral("overview_inset"));
  setAccessibleName(tr("Place of the window on the object"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setGeometry({{kMargin, kMargin}, kSize});
  connect(&document_, &Document::windowChanged, this, qOverload<>(&QWidget::update));
  hide();
}

void OverviewInset::paintEvent(QPaintEvent* /*event*/) {
  if (!document_.isOpen()) return;
  const DetailLadder& map = document_.surface()->ladder;
  const Region& region = document_.project().region;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), QColor(0, 0, 0, 150));
  const double scale =
      std::min((width() - 2 * kPadding) / map.width_mm, (height() - 2 * kPadding) / map.height_mm);
  // View y grows upwards, the widget's downwards.
  painter.translate(0.5 * width(), 0.5 * height());
  painter.scale(scale, -scale);
  painter.translate(-map.left_mm - 0.5 * map.width_mm, -map.bottom_mm - 0.5 * map.height_mm);
  const auto pen = [](const QColor& colour, double pixels) {
    QPen made(colour, pixels);
    made.setCosmetic(true);
    return made;
  };
  painter.setPen(pen(QColor(200, 200, 195), 1));
  painter.setBrush(QColor(200, 197, 190, 60));
  painter.drawRect(QRectF(map.left_mm, map.bottom_mm, map.width_mm, map.height_mm));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(pen(QColor(kPink[0], kPink[1], kPink[2]), 2));
  painter.drawRect(QRectF(region.x_mm, region.y_mm, region.side_mm, region.side_mm));
}

}  // namespace relievo
