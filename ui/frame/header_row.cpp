// SPDX-License-Identifier: BSD-3-Clause
#include "ui/frame/header_row.h"

#include <QBoxLayout>
#include <QEvent>
#include <QLabel>

namespace relievo {
namespace {
constexpr int kSpareDigits = 3;

int textWidth(const QLabel& label) {
  const QMargins margins = label.contentsMargins();
  return label.fontMetrics().horizontalAdvance(label.text()) + margins.left() + margins.right();
}

// Setting it asks for a layout anew even if nothing changes, and that comes back to fit().
void wrap(QLabel& label, bool on) {
  if (label.wordWrap() != on) label.setWordWrap(on);
}

}  // namespace

HeaderRow::HeaderRow(QLabel* title, QLabel* note)
    : row_(new QBoxLayout(QBoxLayout::LeftToRight, this)), title_(title), note_(note) {
  row_->setContentsMargins(0, 0, 0, 0);
  row_->setSpacing(0);
  row_->addWidget(title);
  row_->addStretch(1);
  row_->addWidget(note);
}

void HeaderRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

void HeaderRow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
}

bool HeaderRow::event(QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) fit();
  return QWidget::event(event);
}

void HeaderRow::fit() {
  const int title = textWidth(*title_);
  // A number that gets a digit more and less under a drag must not make the row jump.
  const int spare =
      note_->wordWrap() ? note_->fontMetrics().horizontalAdvance('0') * kSpareDigits : 0;
  const bool below = title + textWidth(*note_) + spare > width();
  wrap(*note_, below);
  wrap(*title_, title > width());
  row_->setDirection(below ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

}  // namespace relievo
