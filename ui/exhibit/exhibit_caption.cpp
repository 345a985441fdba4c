// SPDX-License-Identifier: BSD-3-Clause
#include "ui/exhibit/exhibit_caption.h"

#include <QFont>
#include <QVBoxLayout>

namespace relievo {

ExhibitCaption::ExhibitCaption(QWidget* parent) : QFrame(parent), words_(new QLabel(this)) {
  constexpr int kLargePt = 28, kLines = 3;
  setObjectName(QStringLiteral("exhibit_caption"));
  setFrameShape(QFrame::NoFrame);
  auto* column = new QVBoxLayout(this);
  QFont large = words_->font();
  large.setPointSize(kLargePt);
  words_->setFont(large);
  words_->setWordWrap(true);
  words_->setAlignment(Qt::AlignCenter);
  words_->setTextFormat(Qt::PlainText);
  words_->setMinimumHeight(kLines * words_->fontMetrics().lineSpacing());
  column->addWidget(words_);
}

void ExhibitCaption::setSaid(const QString& text) {
  said_ = text;
  showWords();
}

void ExhibitCaption::setAsked(const QString& text, int dots) {
  asks_ = !text.isEmpty();
  asked_ = text + (dots > 0 ? QStringLiteral("\n") + QString(dots, QChar(0x25CF)) : QString());
  showWords();
}

void ExhibitCaption::showWords() {
  words_->setText(asks_ ? asked_ : said_);
}

}  // namespace relievo
