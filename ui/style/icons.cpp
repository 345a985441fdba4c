// SPDX-License-Identifier: BSD-3-Clause
#include "ui/style/icons.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

namespace relievo {
namespace {

QPainterPath lines(std::initializer_list<std::initializer_list<QPointF>> strokes) {
  QPainterPath path;
  for (const auto& stroke : strokes) {
    bool first = true;
    for (const QPointF& p : stroke) {
      if (first) {
        path.moveTo(p);
      } else {
        path.lineTo(p);
      }
      first = false;
    }
  }
  return path;
}

QPainterPath magnifier() {
  QPainterPath path;
  path.addEllipse(QPointF(10.5, 10.5), 6.5, 6.5);
  path.addPath(lines({{{15.3, 15.3}, {20.5, 20.5}}}));
  return path;
}

QPainterPath eye() {
  QPainterPath path;
  path.moveTo(2.5, 12);
  path.quadTo(12, 2.5, 21.5, 12);
  path.quadTo(12, 21.5, 2.5, 12);
  path.addEllipse(QPointF(12, 12), 3.2, 3.2);
  return path;
}

QPainterPath fingerOnSurface() {
  QPainterPath path = lines({{{9, 16.5}, {9, 6}}, {{14, 6}, {14, 16.5}}, {{3, 20}, {21, 20}}});
  path.moveTo(9, 6);
  path.arcTo(QRectF(9, 3.5, 5, 5), 180, -180);
  path.moveTo(9, 16.5);
  path.arcTo(QRectF(9, 14, 5, 5), 180, 180);
  return path;
}

/// Stroked outline on the 24 px grid.
QPainterPath shape(Icon which) {
  QPainterPath path;
  switch (which) {
    case Icon::open:
      path = lines({{{3.5, 19}, {3.5, 5.5}, {9, 5.5}, {11, 8}, {18.5, 8}, {18.5, 10.5}},
                    {{3.5, 19}, {6.5, 10.5}, {21.5, 10.5}, {18.5, 19}, {3.5, 19}}});
      break;
    case Icon::view:  // A cube, seen from its corner.
      path = lines({{{12, 3}, {20, 7.5}, {20, 16.5}, {12, 21}, {4, 16.5}, {4, 7.5}, {12, 3}},
                    {{4, 7.5}, {12, 12}, {20, 7.5}},
                    {{12, 12}, {12, 21}}});
      break;
    case Icon::fit:
      path = lines({{{4, 9}, {4, 4}, {9, 4}},
                    {{15, 4}, {20, 4}, {20, 9}},
                    {{20, 15}, {20, 20}, {15, 20}},
                    {{9, 20}, {4, 20}, {4, 15}}});
      path.addRect(9, 9, 6, 6);
      break;
    case Icon::finer:
      path = magnifier();
      path.addPath(lines({{{7.5, 10.5}, {13.5, 10.5}}, {{10.5, 7.5}, {10.5, 13.5}}}));
      break;
    case Icon::coarser:
      path = magnifier();
      path.addPath(lines({{{7.5, 10.5}, {13.5, 10.5}}}));
      break;
    case Icon::whole:
      path.addRect(3.5, 5.5, 17, 13);
      path.addPath(lines({{{3.5, 15.5}, {9, 10.5}, {13, 14}, {16, 11.5}, {20.5, 15.5}}}));
      break;
    case Icon::forces:  // A hand's force against a surface.
      path =
          lines({{{3, 19.5}, {21, 19.5}}, {{12, 16}, {12, 4}}, {{7.5, 8.5}, {12, 4}, {16.5, 8.5}}});
      break;
    case Icon::camera:
      path.addRoundedRect(3, 7, 18, 12.5, 2, 2);
      path.addEllipse(QPointF(12, 13.2), 3.6, 3.6);
      path.addPath(lines({{{8.5, 7}, {9.8, 4.5}, {14.2, 4.5}, {15.5, 7}}}));
      break;
    case Icon::record:
      path.addEllipse(QPointF(12, 12), 8.5, 8.5);
      path.addEllipse(QPointF(12, 12), 3.5, 3.5);
      break;
    case Icon::stereo:
      path.addRoundedRect(2.5, 8, 8, 7.5, 2, 2);
      path.addRoundedRect(13.5, 8, 8, 7.5, 2, 2);
      path.addPath(lines({{{10.5, 10.5}, {13.5, 10.5}}}));
      break;
    case Icon::look:
      path = eye();
      break;
    case Icon::touch:
      path = fingerOnSurface();
      break;
  }
  return path;
}

class StrokeEngine : public QIconEngine {
 public:
  explicit StrokeEngine(Icon which) : which_(which) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const QPalette palette = QGuiApplication::palette();
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    const auto role = mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::ButtonText;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(rect.topLeft());
    painter->scale(rect.width() / 24.0, rect.height() / 24.0);
    painter->setPen(
        QPen(palette.color(group, role), 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->drawPath(shape(which_));
    painter->restore();
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return pixmap;
  }
  QIconEngine* clone() const override { return new StrokeEngine(which_); }

 private:
  Icon which_;
};

}  // namespace

QIcon icon(Icon which) {
  return QIcon(new StrokeEngine(which));
}

}  // namespace relievo
