// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QSize>

class QWidget;

namespace relievo {

/// Resizes a dialog to so many characters and lines of its text, so that it grows with the text; at
/// most to the screen that its parent is on, so that its buttons stay there. [GUI thread]
void resizeToText(QWidget& dialog, QSize characters_by_lines);

}  // namespace relievo
