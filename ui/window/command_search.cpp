// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/command_search.h"

#include <algorithm>
#include <QAction>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPointer>
#include <QVBoxLayout>

#include "ui/style/dialog_size.h"
#include "ui/style/mnemonic.h"
#include "ui/window/command_words.h"

namespace relievo {
namespace {

constexpr int kPlace = Qt::UserRole;  ///< Index into the commands.

QString nameOf(const QAction* command) {
  return withoutMnemonic(command->text()).remove(u'\u2026');
}

/// Of the menus that it stands in: "Measure".
QString menusOf(const QAction* command) {
  QString titles;
  for (const QWidget* widget : command->associatedWidgets()) {
    const auto* menu = qobject_cast<const QMenu*>(widget);
    if (menu != nullptr) titles += ' ' + withoutMnemonic(menu->title());
  }
  return titles;
}

/// All words occur: 3 in the name, 2 with other words for it, 1 with its explanation and menu, 0
/// not at all.
int match(const QAction* command, const QStringList& words) {
  const QString name = nameOf(command);
  const QString meant = name + ' ' + otherWords(command->objectName());
  const QString all = meant + ' ' + command->whatsThis() + menusOf(command);
  const auto in = [&words](const QString& text) {
    return std::all_of(words.begin(), words.end(), [&text](const QString& word) {
      return text.contains(word, Qt::CaseInsensitive);
    });
  };
  return in(name) ? 3 : in(meant) ? 2 : in(all) ? 1 : 0;
}

}  // namespace

CommandSearch::CommandSearch(const QList<QAction*>& commands, QWidget* parent)
    : QDialog(parent),
      words_(new QLineEdit),
      list_(new QListWidget),
      nothing_(
          new QLabel(tr("No command has these words. Try one word, or another for the same; F1 "
                        "lists all keys, Shift+F1 opens the manual."))) {
  setObjectName(QStringLiteral("command_search"));
  setWindowTitle(tr("Search commands"));
  for (QAction* command : commands) {
    const bool ours = !command->objectName().isEmpty() && !command->objectName().startsWith("_q_");
    if (ours && !command->isSeparator() && !command->text().isEmpty()) commands_ << command;
  }
  words_->setObjectName(QStringLiteral("command_words"));
  words_->setAccessibleName(tr("Words of a command"));
  words_->setToolTip(tr("Words of a command's name or explanation; Enter runs the first"));
  words_->setPlaceholderText(tr("What do you want to do?"));
  words_->setClearButtonEnabled(true);
  words_->installEventFilter(this);
  list_->setObjectName(QStringLiteral("command_list"));
  list_->setAccessibleName(tr("Commands"));
  list_->setWordWrap(true);
  list_->setResizeMode(QListView::Adjust);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* column = new QVBoxLayout(this);
  column->addWidget(words_);
  nothing_->setObjectName(QStringLiteral("command_nothing"));
  nothing_->setWordWrap(true);
  nothing_->hide();
  column->addWidget(nothing_);
  column->addWidget(list_, 1);
  connect(words_, &QLineEdit::textChanged, this, &CommandSearch::showMatches);
  connect(words_, &QLineEdit::returnPressed, this, &CommandSearch::run);
  connect(list_, &QListWidget::itemActivated, this, &CommandSearch::run);
  resizeToText(*this, {74, 22});
  showMatches();
}

// Arrows move through the list while one types.
bool CommandSearch::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
    if (step != 0 && list_->count() > 0) {
      list_->setCurrentRow(std::clamp(list_->currentRow() + step, 0, list_->count() - 1));
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

void CommandSearch::showMatches() {
  list_->clear();
  const QStringList words = words_->text().split(' ', Qt::SkipEmptyParts);
  for (const int wanted : {3, 2, 1}) {
    for (int i = 0; i < commands_.size(); ++i) {
      const QAction* command = commands_[i];
      if (match(command, words) != wanted) continue;
      QString text = nameOf(command);
      const QString explained = command->whatsThis();
      if (!explained.isEmpty() && explained != text) text += QStringLiteral(" \u2013 ") + explained;
      if (!command->shortcuts().isEmpty()) {
        text += QStringLiteral("  (%1)").arg(
            command->shortcuts().front().toString(QKeySequence::NativeText));
      }
      auto* item = new QListWidgetItem(text, list_);
      item->setData(kPlace, i);
      if (!command->isEnabled()) item->setFlags(Qt::ItemIsSelectable);
    }
  }
  list_->setCurrentRow(list_->count() > 0 ? 0 : -1);
  nothing_->setVisible(list_->count() == 0);
  list_->setAccessibleDescription(list_->count() == 0 ? nothing_->text() : QString());
}

void CommandSearch::run() {
  const QListWidgetItem* item = list_->currentItem();
  if (item == nullptr) return;
  const QPointer<QAction> command = commands_[item->data(kPlace).toInt()];
  if (!command || !command->isEnabled()) return;
  accept();  // First, so that a dialog the command opens does not stand behind this one.
  command->trigger();
}

}  // namespace relievo
