// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QProxyStyle>

namespace relievo {

/// Fusion whose marks (check boxes, arrows, icons, slider handles) grow with the text. Spaces
/// between widgets stay: a window with text three times as large needs its room for the text.
///
/// Fusion measures marks in dots per inch, which it takes from the font metrics it is asked with.
/// It is asked with metrics of the same text at a density that is textScale() times as high.
class WindowStyle : public QProxyStyle {
 public:
  WindowStyle();

  int pixelMetric(PixelMetric metric, const QStyleOption* option,
                  const QWidget* widget) const override;
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                         const QWidget* widget) const override;
  QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                       const QWidget* widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                          QPainter* painter, const QWidget* widget) const override;
};

}  // namespace relievo
