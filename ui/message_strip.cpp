// SPDX-License-Identifier: BSD-3-Clause
#include "ui/message_strip.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "ui/palette.h"

namespace relievo {

MessageStrip::MessageStrip(QWidget* parent)
    : QFrame(parent), label_(new QLabel(this)), buttons_(new QHBoxLayout) {
  setObjectName(QStringLiteral("message_strip"));
  setAccessibleName(tr("Message"));
  setAutoFillBackground(true);
  label_->setWordWrap(true);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  label_->setAccessibleName(tr("Message"));
  auto* closer = new QToolButton(this);
  closer->setText(QStringLiteral("\u00d7"));
  closer->setAutoRaise(true);
  closer->setToolTip(tr("Close this message"));
  closer->setAccessibleName(tr("Close message"));
  connect(closer, &QToolButton::clicked, this, &MessageStrip::close);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 6, 6, 6);
  row->setSpacing(8);
  row->addWidget(label_, 1);
  row->addLayout(buttons_);
  row->addWidget(closer);
  hide();
}

void MessageStrip::show(const QString& text, const std::vector<Button>& buttons) {
  close();
  QPalette strip = palette();
  strip.setColor(QPalette::Window, currentColours().strip);
  strip.setColor(QPalette::WindowText, currentColours().text);
  setPalette(strip);
  label_->setText(text);
  for (const Button& b : buttons) {
    auto* button = new QPushButton(b.text, this);
    button->setAccessibleName(b.text);
    button->setToolTip(b.text);
    connect(button, &QPushButton::clicked, this, [this, action = b.action] {
      close();
      if (action) action();
    });
    buttons_->addWidget(button);
  }
  setVisible(true);
  QAccessibleEvent event(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&event);
}

QString MessageStrip::text() const {
  return isHidden() ? QString() : label_->text();
}

void MessageStrip::close() {
  hide();
  while (QLayoutItem* item = buttons_->takeAt(0)) {
    // The click that closes the strip is still being delivered to its button.
    if (item->widget() != nullptr) {
      item->widget()->hide();
      item->widget()->deleteLater();
    }
    delete item;
  }
}

}  // namespace relievo
