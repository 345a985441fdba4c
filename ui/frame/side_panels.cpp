// SPDX-License-Identifier: BSD-3-Clause
#include "ui/frame/side_panels.h"

#include <algorithm>
#include <QApplication>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/frame/accessible_widgets.h"
#include "ui/style/palette.h"

namespace relievo {
namespace {
constexpr int kWidth = 292;
}

SidePanels::SidePanels(QWidget* parent) : QScrollArea(parent) {
  setObjectName(QStringLiteral("side_panels"));
  setAccessibleName(tr("Panels"));
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  setFrameShape(QFrame::NoFrame);
  setFixedWidth(kWidth);
  setFocusPolicy(Qt::NoFocus);
  auto* content = new QWidget(this);
  column_ = new QVBoxLayout(content);
  column_->setContentsMargins(4, 2, 4, 2);
  column_->setSpacing(0);
  column_->addStretch(1);
  setWidget(content);
  // Wherever the keyboard goes in here, by whatever command, is seen.
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    if (now != nullptr && widget()->isAncestorOf(now)) ensureWidgetVisible(now);
  });
}

void SidePanels::add(const QString& title, QWidget* panel) {
  insert(static_cast<int>(headers_.size()), title, panel);
}

void SidePanels::insert(int index, const QString& title, QWidget* panel) {
  auto* header = new QToolButton(widget());
  header->setProperty(kUnfolded, true);  // Before anybody is told of it.
  header->setText(title);
  header->setToolTip(tr("Show or hide %1").arg(title));
  header->setAccessibleName(tr("%1 panel").arg(title));
  header->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  header->setAutoRaise(true);
  header->setArrowType(Qt::DownArrow);
  header->setFocusPolicy(Qt::StrongFocus);
  header->setStyleSheet(
      QStringLiteral("QToolButton { border: 1px solid transparent; padding: 0px; }"
                     "QToolButton:hover { border: 1px solid palette(mid); }"
                     "QToolButton:focus { border: 1px solid palette(highlight); }"));
  QFont font = header->font();
  font.setBold(true);
  header->setFont(font);
  header->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(header, &QToolButton::clicked, panel, [this, panel] {
    const bool folded = !panel->isHidden();
    fold(panel, folded);
    if (!panel->objectName().isEmpty()) folded_[panel->objectName()] = folded;
  });
  column_->insertWidget(2 * index, header);  // Headers and panels alternate.
  column_->insertWidget(2 * index + 1, panel);
  headers_.insert(headers_.begin() + index, header);
  fold(panel, folded_.value(panel->objectName(), panel->property(kFoldedAtFirst).toBool()));
  if (window_width_ > 0) fitTo(window_width_);
}

void SidePanels::addAtPlace(const QString& title, QWidget* panel) {
  insert(place_++, title, panel);
}

void SidePanels::fold(QWidget* panel, bool folded) {
  QToolButton* header = headers_[static_cast<std::size_t>(column_->indexOf(panel) / 2)];
  header->setArrowType(folded ? Qt::RightArrow : Qt::DownArrow);
  header->setProperty(kUnfolded, !folded);
  header->setAccessibleDescription(folded ? tr("folded") : tr("open"));
  panel->setVisible(!folded);
}

QStringList SidePanels::folds() const {
  QStringList folds;
  for (auto one = folded_.begin(); one != folded_.end(); ++one) {
    folds << (one.value() ? '-' : '+') + one.key();
  }
  return folds;
}

void SidePanels::setFolds(const QStringList& folds) {
  folded_.clear();
  for (const QString& one : folds) folded_[one.mid(1)] = one.startsWith('-');
  for (std::size_t i = 0; i < headers_.size(); ++i) {
    QWidget* panel = column_->itemAt(static_cast<int>(2 * i + 1))->widget();
    const auto known = folded_.constFind(panel->objectName());
    if (known != folded_.constEnd()) fold(panel, *known);
  }
}

void SidePanels::remove(QWidget* panel) {
  const int index = column_->indexOf(panel);
  if (index < 1) return;
  if (index / 2 < place_) --place_;
  const auto header = headers_.begin() + index / 2;
  delete *header;
  headers_.erase(header);
  delete panel;
  if (window_width_ > 0) fitTo(window_width_);
}

void SidePanels::reveal(QWidget* panel) {
  const int index = column_->indexOf(panel);
  if (index < 1) return;
  fold(panel, false);
  column_->activate();
  widget()->adjustSize();
  ensureWidgetVisible(panel);
}

void SidePanels::fitTo(int window_width) {
  window_width_ = window_width;
  const int wanted = static_cast<int>(kWidth * textScale());
  // What cannot wrap, such as a check box's text, may take half of the window.
  const int needed = widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width();
  const int most = std::clamp(needed, window_width * 2 / 5, window_width / 2);
  setFixedWidth(std::max(kWidth, std::min(wanted, most)));
}

QStringList SidePanels::titles() const {
  QStringList titles;
  for (const QToolButton* header : headers_) titles << header->text();
  return titles;
}

}  // namespace relievo
