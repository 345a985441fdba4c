// SPDX-License-Identifier: BSD-3-Clause
#include "ui/style/dialog_size.h"

#include <QEvent>
#include <QFontMetrics>
#include <QScreen>
#include <QTimer>
#include <QWidget>

namespace relievo {
namespace {

const QSize kFrame(16, 48);  // What a window manager adds, pixels.

QSize fitted(const QWidget& dialog, const QSize& wanted) {
  const QWidget* on_screen = dialog.parentWidget() != nullptr ? dialog.parentWidget() : &dialog;
  return wanted.boundedTo(on_screen->screen()->availableGeometry().size() - kFrame);
}

/// Makes the dialog grow or shrink with a text size that changes while it is open. A child of it.
class SizeFollower : public QObject {
 public:
  explicit SizeFollower(QWidget& dialog)
      : QObject(&dialog), dialog_(dialog), line_(dialog.fontMetrics().height()) {
    dialog.installEventFilter(this);
  }
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == &dialog_ && event->type() == QEvent::FontChange) {
      // After the widgets in it, which hear of the change one by one.
      QTimer::singleShot(0, this, [this] { follow(); });
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  void follow() {
    const int line = dialog_.fontMetrics().height();
    if (line == line_) return;
    dialog_.resize(fitted(dialog_, dialog_.size() * line / line_));
    line_ = line;
  }

  QWidget& dialog_;
  int line_;  ///< Height of a line that the present size is for, pixels.
};

}  // namespace

void resizeToText(QWidget& dialog, QSize characters_by_lines) {
  const QFontMetrics text = dialog.fontMetrics();
  const QSize wanted(characters_by_lines.width() * text.averageCharWidth(),
                     characters_by_lines.height() * text.height());
  dialog.resize(fitted(dialog, wanted));
  new SizeFollower(dialog);
}

}  // namespace relievo
