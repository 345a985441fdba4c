// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPainter>
#include <QString>

namespace relievo {

/// Draws marks and text on paper; all sizes in points, places in millimetres. Into pixels, text is
/// drawn as outlines, which no desktop's font settings change; into PDF and SVG it stays text.
class FigureInk {
 public:
  enum class Target { pixels, vectors };
  /// @param painter  whose unit is 1/dpi inch
  FigureInk(QPainter& painter, double dpi, double text_pt, Target target);

  QPainter& painter() { return painter_; }
  double px(double mm) const { return mm * dpi_ / 25.4; }
  double pt(double points) const { return points * dpi_ / 72; }  ///< In pixels.
  double textPt() const { return text_pt_; }
  QRectF px(const QRectF& mm) const {
    return {px(mm.x()), px(mm.y()), px(mm.width()), px(mm.height())};
  }
  /// Whole pixels, as pictures are drawn into.
  QRect pixels(const QRectF& mm) const;

  QPen pen(const QColor& colour, double points) const;
  /// Width of a line of text, pixels.
  double width(const QString& text, double size = 1) const;
  double lineHeight(double size = 1) const { return pt(1.3 * size * text_pt_); }
  /// @param at  the baseline's left end, middle or right end, pixels
  /// @param size  times the figure's text size
  void text(QPointF at, const QString& text, Qt::Alignment alignment = Qt::AlignLeft,
            double size = 1, bool bold = false);
  /// The same upright, reading from below.
  void uprightText(QPointF at, const QString& text);

 private:
  QPainter& painter_;
  double dpi_, text_pt_;
  Target target_;
};

inline const QColor kInk(0x16, 0x16, 0x18);
inline const QColor kPlate(255, 255, 255, 205);  ///< Behind marks in a picture.

}  // namespace relievo
