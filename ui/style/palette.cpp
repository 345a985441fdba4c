// SPDX-License-Identifier: BSD-3-Clause
#include "ui/style/palette.h"

#include <algorithm>
#include <QApplication>
#include <QEvent>
#include <QFont>
#include <QWidget>
#include <utility>
#include <vector>

#include "ui/style/window_style.h"

namespace relievo {
namespace {

QColor rgb(QRgb value) {
  return QColor::fromRgb(value);
}

// window base text quiet button border highlight highlighted link viewport strip hip proxy force
// frame
const std::array<ThemeColours, 3>& table() {
  static const std::array<ThemeColours, 3> kTable{{
      {rgb(0xf4f4f2), rgb(0xffffff), rgb(0x1e2226), rgb(0x5c646b), rgb(0xececea), rgb(0xc9cbcc),
       rgb(0x2f6f9f), rgb(0xffffff), rgb(0x1f5f95), rgb(0x23262a), rgb(0xfff3d6), rgb(0xd62828),
       rgb(0x2563eb), rgb(0x2f7d4f), rgb(0x82888e)},
      {rgb(0x26292d), rgb(0x1d2023), rgb(0xe4e6e8), rgb(0xa4abb2), rgb(0x31353a), rgb(0x43484e),
       rgb(0x3f86b8), rgb(0xffffff), rgb(0x7fb8e6), rgb(0x1b1d20), rgb(0x4a3d1c), rgb(0xff6b6b),
       rgb(0x6ea0ff), rgb(0x6cc592), rgb(0x7f878f)},
      {rgb(0x000000), rgb(0x1c1c1c), rgb(0xffffff), rgb(0xe8e8e8), rgb(0x101010), rgb(0xffffff),
       rgb(0xffd400), rgb(0x000000), rgb(0x6fc3ff), rgb(0x000000), rgb(0x3a3000), rgb(0xff7a7a),
       rgb(0x8ab4ff), rgb(0x7dffb0), rgb(0xffffff)},
  }};
  return kTable;
}

Theme current_theme = Theme::light;
double text_scale = 1;

/// What the desktop showed before our own palette replaced it.
bool systemIsDark() {
  static const bool kDark = QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
  return kDark;
}

}  // namespace

const ThemeColours& colours(Theme theme) {
  switch (theme) {
    case Theme::dark:
      return table()[1];
    case Theme::contrast:
      return table()[2];
    default:
      return table()[0];
  }
}

Theme resolved(Theme theme) {
  if (theme != Theme::system) return theme;
  return systemIsDark() ? Theme::dark : Theme::light;
}

void applyTextSize(int percent) {
  static const QFont kSystem = QApplication::font();
  const double before = text_scale;
  text_scale = std::clamp(percent, kLeastTextPercent, kMostTextPercent) / 100.0;
  // Below a style sheet, widgets that are shown keep the font they were polished with.
  std::vector<std::pair<QWidget*, double>> shown;
  for (QWidget* widget : QApplication::allWidgets()) {
    shown.emplace_back(widget, widget->font().pointSizeF() * text_scale / before);
  }
  QFont font = kSystem;
  font.setPointSizeF(kSystem.pointSizeF() * text_scale);
  QApplication::setFont(font);
  for (const auto& [widget, points] : shown) {
    QFont own = widget->font();
    if (!(points > 0) || own.pointSizeF() == points) continue;
    own.setPointSizeF(points);
    widget->setFont(own);
  }
  if (text_scale == before) return;
  // The style's marks have grown, too.
  for (QWidget* widget : QApplication::allWidgets()) {
    QEvent changed(QEvent::StyleChange);
    QApplication::sendEvent(widget, &changed);
  }
}

double textScale() {
  return text_scale;
}

const ThemeColours& currentColours() {
  return colours(current_theme);
}

void applyTheme(QApplication& app, Theme theme) {
  systemIsDark();  // Asked before our palette hides the desktop's.
  current_theme = resolved(theme);
  const ThemeColours& c = colours(current_theme);
  QPalette p;
  p.setColor(QPalette::Window, c.window);
  p.setColor(QPalette::WindowText, c.text);
  p.setColor(QPalette::Base, c.base);
  p.setColor(QPalette::AlternateBase, c.window);
  p.setColor(QPalette::Text, c.text);
  p.setColor(QPalette::Button, c.button);
  p.setColor(QPalette::ButtonText, c.text);
  p.setColor(QPalette::BrightText, c.highlighted_text);
  p.setColor(QPalette::Highlight, c.highlight);
  p.setColor(QPalette::HighlightedText, c.highlighted_text);
  p.setColor(QPalette::Link, c.link);
  p.setColor(QPalette::Mid, c.border);
  p.setColor(QPalette::ToolTipBase, c.base);
  p.setColor(QPalette::ToolTipText, c.text);
  p.setColor(QPalette::PlaceholderText, c.quiet_text);
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    QColor faint = c.quiet_text;
    faint.setAlphaF(current_theme == Theme::contrast ? 0.8 : 0.55);
    p.setColor(QPalette::Disabled, role, faint);
  }
  app.setStyle(new WindowStyle);  // Which the application owns.
  app.setPalette(p);
  QString sheet = QStringLiteral("QToolTip { color: %1; background: %2; border: 1px solid %3; }")
                      .arg(c.text.name(), c.base.name(), c.border.name());
  if (current_theme == Theme::contrast) {
    // Fusion draws outlines darker than the window; darker than black there is nothing.
    sheet += QStringLiteral(
                 "QPushButton, QListWidget { border: 1px solid %1; padding: 3px 8px; }"
                 "QPushButton:focus, QListWidget:focus, QToolButton:focus { border: 2px solid %2; }"
                 "QPushButton:disabled { border-color: %3; }")
                 .arg(c.border.name(), c.highlight.name(), c.quiet_text.name());
  }
  app.setStyleSheet(sheet);
}

}  // namespace relievo
