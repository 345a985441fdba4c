// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/hand_signs.h"

#include <algorithm>
#include <array>
#include <QImage>
#include <QPainter>
#include <QRectF>
#include <QString>
#include <utility>

#include "ui/figure/figure_ink.h"
#include "ui/vtk/offscreen.h"

namespace relievo {
namespace {

const QColor kRim(23, 18, 20), kWhite(247, 247, 247);
const QColor kBall(92, 92, 96), kShine(176, 176, 180);
constexpr double kRowsAcross = 24;  // A picture's height in lines of the legend.

}  // namespace

void drawProxySign(QPainter& painter, const QRectF& place) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const double inset = 0.12 * place.width();
  const QRectF ball = place.adjusted(inset, inset, -inset, -inset);
  QRadialGradient light(ball.center() - 0.15 * QPointF(ball.width(), ball.height()),
                        0.6 * ball.width());
  light.setColorAt(0, kShine);
  light.setColorAt(1, kBall);
  painter.setPen(QPen(kRim, 0.06 * place.width()));
  painter.setBrush(light);
  painter.drawEllipse(ball);
  painter.restore();
}

void drawHipSign(QPainter& painter, const QRectF& place) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  const double inset = 0.16 * place.width();
  const QRectF ring = place.adjusted(inset, inset, -inset, -inset);
  const QPointF arm = 0.36 * QPointF(ring.width(), ring.height());
  for (const auto& [colour, part] : {std::pair{kRim, 0.22}, std::pair{kWhite, 0.12}}) {
    painter.setPen(QPen(colour, part * place.width()));
    painter.drawEllipse(ring);
    painter.drawLine(ring.center() - arm, ring.center() + arm);
    const QPointF other(arm.x(), -arm.y());
    painter.drawLine(ring.center() - other, ring.center() + other);
  }
  painter.restore();
}

void paintHandLegend(RgbaImage& picture, const QRect& box) {
  // The alpha of an opaque picture is 255: pixels are as they would be multiplied by it.
  QImage page(picture.rgba.data(), picture.width, picture.height, 4 * picture.width,
              QImage::Format_RGBA8888_Premultiplied);
  QPainter painter(&page);
  const double line = std::max(9.0, box.height() / kRowsAcross);
  constexpr double kDpi = 72, kTextOfLine = 0.62;
  FigureInk ink(painter, kDpi, kTextOfLine * line, FigureInk::Target::pixels);
  const std::array<QString, 2> words{QStringLiteral("ball: proxy, on the surface"),
                                     QStringLiteral("ring with a cross: HIP")};
  const double widest = std::max(ink.width(words[0]), ink.width(words[1]));
  const double pad = 0.4 * line;
  const QRectF plate(box.right() - widest - 1.3 * line - 3 * pad, box.top() + pad,
                     widest + 1.3 * line + 2 * pad, 2 * line + pad);
  painter.fillRect(plate, kPlate);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const QRectF sign(plate.left() + pad, plate.top() + 0.5 * pad + static_cast<double>(i) * line,
                      line, line);
    if (i == 0) {
      drawProxySign(painter, sign);
    } else {
      drawHipSign(painter, sign);
    }
    ink.text({sign.right() + 0.3 * line, sign.bottom() - 0.28 * line}, words.at(i));
  }
}

}  // namespace relievo
