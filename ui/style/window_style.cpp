// SPDX-License-Identifier: BSD-3-Clause
#include "ui/style/window_style.h"

#include <algorithm>
#include <array>
#include <QApplication>
#include <QPaintDevice>
#include <QPainter>
#include <QScrollBar>
#include <QStyleFactory>
#include <QStyleOption>
#include <QWidget>

#include "ui/style/palette.h"

namespace relievo {
namespace {

constexpr double kCornerPx = 2, kDisabledAlpha = 0.5;
constexpr int kToolBarIconPx = 20;  // At the system's text size.

constexpr std::array kMarks{QStyle::PM_IndicatorWidth,          QStyle::PM_IndicatorHeight,
                            QStyle::PM_ExclusiveIndicatorWidth, QStyle::PM_ExclusiveIndicatorHeight,
                            QStyle::PM_ButtonIconSize,          QStyle::PM_SmallIconSize,
                            QStyle::PM_ListViewIconSize,        QStyle::PM_MenuButtonIndicator,
                            QStyle::PM_SliderThickness,         QStyle::PM_SliderLength,
                            QStyle::PM_SliderControlThickness,  QStyle::PM_ToolBarExtensionExtent,
                            QStyle::PM_CheckBoxLabelSpacing,    QStyle::PM_RadioButtonLabelSpacing};

/// Nothing is painted on it: it says how many dots an inch has.
class Density : public QPaintDevice {
 public:
  explicit Density(int dpi) : dpi_(dpi) {}
  QPaintEngine* paintEngine() const override { return nullptr; }

 protected:
  int metric(PaintDeviceMetric metric) const override {
    return metric == PdmDpiX || metric == PdmDpiY ? dpi_ : QPaintDevice::metric(metric);
  }

 private:
  int dpi_;
};

/// The same pixels of text as the widget has.
QFontMetrics dense(const QWidget* widget) {
  QFont font = widget != nullptr ? widget->font() : QApplication::font();
  const int dpi = static_cast<int>(QFontMetrics(font).fontDpi());
  if (font.pointSizeF() > 0) font.setPointSizeF(font.pointSizeF() / textScale());
  const Density density(qRound(dpi * textScale()));
  return QFontMetrics(font, &density);
}

/// Calls `use` with a copy of the option that says the density, if it is one of these kinds.
template <class Option, class... Others, class Given, class Use>
auto withDensity(const Given* option, const QWidget* widget, const Use& use) {
  if (const auto* known = qstyleoption_cast<const Option*>(option)) {
    Option copy = *known;
    copy.fontMetrics = dense(widget);
    return use(static_cast<const Given*>(&copy));
  }
  if constexpr (sizeof...(Others) > 0) {
    return withDensity<Others...>(option, widget, use);
  } else {
    return use(option);
  }
}

template <class Given, class Use>
auto controlWithDensity(const Given* option, const QWidget* widget, const Use& use) {
  const bool scroll_bar = qobject_cast<const QScrollBar*>(widget) != nullptr;
  if (textScale() == 1 || scroll_bar) return use(option);
  return withDensity<QStyleOptionComboBox, QStyleOptionSpinBox, QStyleOptionSlider,
                     QStyleOptionToolButton>(option, widget, use);
}

/// Fusion's outlines are the window's colour made darker: darker than a dark window nobody sees
/// them. The same line again, in the palette's colour.
void drawFrame(QPainter* painter, const QStyleOption& option, bool round) {
  const ThemeColours& c = currentColours();
  QColor line = (option.state & QStyle::State_HasFocus) != 0 ? c.highlight : c.frame;
  if ((option.state & QStyle::State_Enabled) == 0) line.setAlphaF(kDisabledAlpha);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(line);
  painter->setBrush(Qt::NoBrush);
  const QRectF rect = QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5);
  if (round) {
    painter->drawEllipse(rect);
  } else {
    painter->drawRoundedRect(rect, kCornerPx, kCornerPx);
  }
  painter->restore();
}

bool hasFrame(QStyle::ComplexControl control, const QStyleOptionComplex* option) {
  if (control == QStyle::CC_ComboBox) {
    const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
    return box != nullptr && box->frame;
  }
  const auto* box = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
  return control == QStyle::CC_SpinBox && box != nullptr && box->frame;
}

}  // namespace

WindowStyle::WindowStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

int WindowStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                             const QWidget* widget) const {
  if (metric == PM_ToolBarIconSize) return qRound(kToolBarIconPx * textScale());
  if (metric == PM_ScrollBarExtent) {  // Half as much: it takes room from the text.
    return qRound(QProxyStyle::pixelMetric(metric, nullptr, widget) * 0.5 * (1 + textScale()));
  }
  if (textScale() == 1 || std::find(kMarks.begin(), kMarks.end(), metric) == kMarks.end()) {
    return QProxyStyle::pixelMetric(metric, option, widget);
  }
  QStyleOption plain;
  plain.fontMetrics = dense(widget);
  return QProxyStyle::pixelMetric(metric, &plain, widget);
}

QSize WindowStyle::sizeFromContents(ContentsType type, const QStyleOption* option,
                                    const QSize& contents, const QWidget* widget) const {
  return controlWithDensity(option, widget, [&](const QStyleOption* dense_option) {
    return QProxyStyle::sizeFromContents(type, dense_option, contents, widget);
  });
}

QRect WindowStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option,
                                  SubControl part, const QWidget* widget) const {
  return controlWithDensity(option, widget, [&](const QStyleOptionComplex* dense_option) {
    return QProxyStyle::subControlRect(control, dense_option, part, widget);
  });
}

void WindowStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                QPainter* painter, const QWidget* widget) const {
  const bool arrow = element >= PE_IndicatorArrowDown && element <= PE_IndicatorArrowUp;
  if (!arrow || textScale() == 1 || option == nullptr) {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool round = element == PE_IndicatorRadioButton;
    if (round || element == PE_IndicatorCheckBox || element == PE_FrameLineEdit ||
        element == PE_IndicatorItemViewItemCheck) {
      drawFrame(painter, *option, round);
    }
    return;
  }
  QStyleOption plain = *option;
  plain.fontMetrics = dense(widget);
  QProxyStyle::drawPrimitive(element, &plain, painter, widget);
}

void WindowStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                     QPainter* painter, const QWidget* widget) const {
  controlWithDensity(option, widget, [&](const QStyleOptionComplex* dense_option) {
    QProxyStyle::drawComplexControl(control, dense_option, painter, widget);
  });
  if (hasFrame(control, option)) drawFrame(painter, *option, false);
  // Fusion shows it by a frame that a flat button does not have.
  const bool focused = option != nullptr && (option->state & State_HasFocus) != 0;
  if (control == CC_ToolButton && focused) drawFrame(painter, *option, false);
}

}  // namespace relievo
