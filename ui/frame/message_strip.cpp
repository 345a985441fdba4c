// SPDX-License-Identifier: BSD-3-Clause
#include "ui/frame/message_strip.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "ui/style/mnemonic.h"
#include "ui/style/palette.h"

namespace relievo {

namespace {

/// A text and its buttons beside it, or below it where they would leave it too little room: large
/// text in a narrow column would take the height of the views.
class TextAndButtons : public QBoxLayout {
 public:
  TextAndButtons(QWidget* strip, QLayout* buttons)
      : QBoxLayout(QBoxLayout::LeftToRight, strip), buttons_(buttons) {}
  bool hasHeightForWidth() const override {
    QBoxLayout::hasHeightForWidth();  // Looks at the widgets if any has changed.
    return true;
  }
  /// Asked for widths that it will never have, too: turning here would ask for a layout anew, which
  /// asks again, without an end.
  int heightForWidth(int width) const override {
    const QMargins around = contentsMargins();
    const int inside = width - around.left() - around.right();
    const QSize buttons = buttons_->sizeHint();
    QLayoutItem* text = itemAt(0);
    const int content =
        isBelowAt(width)
            ? text->heightForWidth(std::max(1, inside)) + spacing() + buttons.height()
            : std::max(text->heightForWidth(std::max(1, inside - spacing() - buttons.width())),
                       buttons.height());
    return content + around.top() + around.bottom();
  }
  int minimumHeightForWidth(int width) const override { return heightForWidth(width); }
  void setGeometry(const QRect& rect) override {
    const Direction wanted = isBelowAt(rect.width()) ? TopToBottom : LeftToRight;
    if (direction() != wanted) setDirection(wanted);
    QBoxLayout::setGeometry(rect);
  }

 private:
  bool isBelowAt(int width) const { return 2 * buttons_->sizeHint().width() > width; }

  QLayout* buttons_;
};

}  // namespace

MessageStrip::MessageStrip(QWidget* parent)
    : QFrame(parent),
      label_(new QLabel(this)),
      key_(new QLabel(this)),
      closer_(new QToolButton(this)),
      buttons_(new QHBoxLayout) {
  setObjectName(QStringLiteral("message_strip"));
  setAccessibleName(tr("Message"));
  setAutoFillBackground(true);
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);  // It tells names of files, which may look like HTML.
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  label_->setAccessibleName(tr("Message"));
  key_->setObjectName(QStringLiteral("message_key"));
  key_->setAccessibleName(tr("Key of the first button"));
  closer_->setText(QStringLiteral("\u00d7"));
  closer_->setAutoRaise(true);
  closer_->setToolTip(tr("Close this message"));
  closer_->setAccessibleName(tr("Close message"));
  connect(closer_, &QToolButton::clicked, this, [this] {
    close();
    Q_EMIT dismissed();
  });
  auto* right = new QHBoxLayout;
  right->setSpacing(8);
  right->addLayout(buttons_);
  right->addWidget(key_);
  right->addWidget(closer_);
  auto* row = new TextAndButtons(this, right);
  row->setContentsMargins(12, 6, 6, 6);
  row->setSpacing(8);
  row->addWidget(label_, 1);
  row->addLayout(right);
  hide();
}

void MessageStrip::show(const QString& text, const std::vector<Button>& buttons) {
  close();
  QPalette strip = palette();
  strip.setColor(QPalette::Window, currentColours().strip);
  strip.setColor(QPalette::WindowText, currentColours().text);
  setPalette(strip);
  label_->setText(text);
  QWidget* before = nullptr;
  for (const Button& b : buttons) {
    auto* button = new QPushButton(b.text, this);
    button->setAccessibleName(withoutMnemonic(b.text));
    button->setToolTip(button->accessibleName());
    if (!b.picture.isNull()) {
      button->setIcon(b.picture);
      button->setIconSize(b.picture.availableSizes().value(0));
      button->setText({});
    }
    connect(button, &QPushButton::clicked, this, [this, action = b.action] {
      close();
      if (action) action();
    });
    buttons_->addWidget(button);
    if (before != nullptr) setTabOrder(before, button);
    if (offer_ == nullptr) offer_ = button;
    before = button;
  }
  if (before != nullptr) setTabOrder(before, closer_);
  showOfferKey();
  Q_EMIT offerChanged(hasOffer());
  setVisible(true);
  Q_EMIT shown(accessibleDescription());
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
  if (offer_ == nullptr) return;
  offer_ = nullptr;
  Q_EMIT offerChanged(false);
}

void MessageStrip::setOfferKey(const QKeySequence& key) {
  key_->setText(key.toString(QKeySequence::NativeText));
  showOfferKey();
}

void MessageStrip::showOfferKey() {
  key_->setVisible(hasOffer() && !key_->text().isEmpty());
  if (!key_->isVisibleTo(this)) {
    setAccessibleDescription(label_->text());
    return;
  }
  const QString name = withoutMnemonic(offer_->text());
  offer_->setToolTip(QStringLiteral("%1 (%2)").arg(name, key_->text()));
  setAccessibleDescription(QStringLiteral("%1 %2: %3").arg(label_->text(), key_->text(), name));
}

bool MessageStrip::triggerDefaultAction() {
  if (offer_ == nullptr) return false;
  offer_->click();
  return true;
}

QWidget* MessageStrip::firstControl() const {
  return offer_ != nullptr ? static_cast<QWidget*>(offer_) : closer_;
}

}  // namespace relievo
