// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialog_size.h"

#include <QFontMetrics>
#include <QScreen>
#include <QWidget>

namespace relievo {
namespace {

const QSize kFrame(16, 48);  // What a window manager adds, pixels.

}  // namespace

void resizeToText(QWidget& dialog, QSize characters_by_lines) {
  const QFontMetrics text = dialog.fontMetrics();
  const QSize wanted(characters_by_lines.width() * text.averageCharWidth(),
                     characters_by_lines.height() * text.height());
  const QWidget* on_screen = dialog.parentWidget() != nullptr ? dialog.parentWidget() : &dialog;
  dialog.resize(wanted.boundedTo(on_screen->screen()->availableGeometry().size() - kFrame));
}

}  // namespace relievo
