// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <QColor>
#include <QPalette>
#include <QString>

class QApplication;

namespace relievo {

enum class Theme { system, light, dark, contrast };

/// Every colour of the window, one row per theme; nothing else names colours but the scene.
struct ThemeColours {
  QColor window, base, text, quiet_text, button, border, highlight, highlighted_text, link;
  QColor viewport;  ///< Behind the surface.
  QColor strip;     ///< Behind a message.
  QColor hip, proxy, force;
  QColor frame;  ///< Of fields and boxes: at least 3 : 1 to window and base (WCAG 2.1, 1.4.11).
};
const ThemeColours& colours(Theme theme);  ///< theme other than system.

/// The theme that `system` stands for now.
Theme resolved(Theme theme);
/// WindowStyle with our palette.
void applyTheme(QApplication& app, Theme theme);
/// Percent of the system's text size.
inline constexpr int kLeastTextPercent = 100;
inline constexpr int kMostTextPercent = 300;
/// Of all text from now on, and of what is as wide as its text. @param percent  is clamped
void applyTextSize(int percent);
/// 1 .. 3, as applied last.
double textScale();

/// Of the theme applied last.
const ThemeColours& currentColours();

}  // namespace relievo
