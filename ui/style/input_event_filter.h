// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

namespace relievo {

/// What fields of all windows of a program leave to others. The wheel: it scrolls a form, and
/// changes a value only where the keyboard is. Ctrl+E: X11's "end of line" is our figure.
/// [GUI thread]
class InputEventFilter : public QObject {
  Q_OBJECT
 public:
  /// For all windows, once; ends with `parent`.
  explicit InputEventFilter(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace relievo
