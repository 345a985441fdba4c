// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/keys_sheet.h"

#include <algorithm>
#include <limits>
#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/language/core_text.h"
#include "ui/style/dialog_size.h"
#include "ui/style/mnemonic.h"

namespace relievo {
namespace {

constexpr double kMostOfKeys = 0.42;  // Of the table's width, for the keys.

struct Row {
  QString group, keys, what;
  int place = 0;  ///< Of the group.
};

/// Both columns wrap: keys have what they need, but leave room for what they do.
class KeyTable : public QTableWidget {
 public:
  explicit KeyTable(int rows) : QTableWidget(rows, 2) {
    setWordWrap(true);
    setTextElideMode(Qt::ElideNone);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setStretchLastSection(true);
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    verticalHeader()->hide();
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QTableWidget::resizeEvent(event);
    const int most = static_cast<int>(kMostOfKeys * viewport()->width());
    setColumnWidth(0, std::min(sizeHintForColumn(0) + fontMetrics().averageCharWidth(), most));
    resizeRowsToContents();
  }
};

struct Group {
  int place;  ///< Of its menu in the bar.
  QString title;
};

/// The menu that a command stands in, or the one around its submenu: "Surface".
Group groupOf(const QAction* command) {
  for (const QWidget* widget : command->associatedWidgets()) {
    const auto* menu = qobject_cast<const QMenu*>(widget);
    if (menu == nullptr) continue;
    while (const auto* around = qobject_cast<const QMenu*>(menu->parentWidget())) menu = around;
    const QWidget* bar = menu->parentWidget();
    if (qobject_cast<const QMenuBar*>(bar) == nullptr) continue;  // Of a button.
    return {static_cast<int>(bar->actions().indexOf(menu->menuAction())),
            withoutMnemonic(menu->title())};
  }
  return {std::numeric_limits<int>::max(), KeysSheet::tr("Other commands")};
}

/// What mouse and keys do in the views; the buttons as preferences say.
QList<Row> rowsOfViews(const PointerBindings& bindings) {
  QList<Row> rows;
  const QString views = KeysSheet::tr("In the views, by mouse and keys");
  const auto add = [&](const QString& keys, const QString& what) {
    rows.append({views, keys, what, 0});
  };
  const auto button = [&](const QString& keys, const QString& to_look, const QString& to_touch) {
    add(keys, KeysSheet::tr("Look: %1. Touch: %2").arg(to_look, to_touch));
  };
  add(KeysSheet::tr("Esc"), KeysSheet::tr("Stop forces, then cancel, then leave the mode"));
  add(KeysSheet::tr("Detail view: arrows, Shift+arrows"),
      KeysSheet::tr("Move the hand by 1 or by 10 cells"));
  add(KeysSheet::tr("Detail view: Page Down, Page Up"), KeysSheet::tr("Press in, lift"));
  button(KeysSheet::tr("Detail view: left button"), actText(bindings.look_left),
         KeysSheet::tr("press the hand in"));
  button(KeysSheet::tr("Detail view: middle button"), actText(bindings.look_middle),
         actText(bindings.touch_middle));
  button(KeysSheet::tr("Detail view: right button"), actText(bindings.look_right),
         actText(bindings.touch_right));
  add(KeysSheet::tr("Detail view: Ctrl+wheel"), KeysSheet::tr("Change the press depth"));
  add(KeysSheet::tr("Detail view: wheel"),
      bindings.forward_is_closer ? KeysSheet::tr("Zoom about the pointer; away from you is closer")
                                 : KeysSheet::tr("Zoom about the pointer; towards you is closer"));
  add(KeysSheet::tr("Overview: drag"), KeysSheet::tr("Draw, move or resize the window"));
  add(KeysSheet::tr("Overview: arrows, Shift+arrows"), KeysSheet::tr("Move, resize the window"));
  add(KeysSheet::tr("Overview: Space, arrows, Enter"), KeysSheet::tr("Draw a window"));
  add(KeysSheet::tr("Overview: +, \u2212, wheel"), KeysSheet::tr("Finer, coarser"));
  return rows;
}

QList<Row> rowsOf(const QList<QAction*>& commands, const PointerBindings& bindings) {
  QList<Row> rows;
  for (const QAction* command : commands) {
    if (command->shortcuts().isEmpty() || !command->isVisible()) continue;
    QStringList keys;
    for (const QKeySequence& key : command->shortcuts()) {
      keys << key.toString(QKeySequence::NativeText);
    }
    QString what = command->whatsThis();
    if (what.isEmpty()) what = withoutMnemonic(command->text());
    // Siblings share their explanation; their names tell them apart.
    const auto shares = [&what](const QAction* other) { return other->whatsThis() == what; };
    if (std::count_if(commands.begin(), commands.end(), shares) > 1) {
      what = KeysSheet::tr("%1: %2").arg(withoutMnemonic(command->text()), what);
    }
    const Group group = groupOf(command);
    rows.append({group.title, keys.join(QLatin1String(", ")), what, group.place});
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.place < b.place; });
  rows << rowsOfViews(bindings);
  return rows;
}

/// Hides all others, and groups of which none is left. @return some are left
bool showRowsWith(QTableWidget& table, const QStringList& words) {
  int group = -1;
  bool any = false, any_of_group = false;
  const auto end_group = [&] {
    if (group >= 0) table.setRowHidden(group, !any_of_group);
  };
  for (int row = 0; row < table.rowCount(); ++row) {
    if (table.item(row, 1) == nullptr) {
      end_group();
      group = row;
      any_of_group = false;
      continue;
    }
    const QString text = table.item(row, 0)->text() + ' ' + table.item(row, 1)->text();
    const bool fits = std::all_of(words.begin(), words.end(), [&text](const QString& word) {
      return text.contains(word, Qt::CaseInsensitive);
    });
    table.setRowHidden(row, !fits);
    any_of_group = any_of_group || fits;
    any = any || fits;
  }
  end_group();
  return any;
}

}  // namespace

KeysSheet::KeysSheet(const QList<QAction*>& commands, const PointerBindings& bindings,
                     QWidget* parent)
    : QDialog(parent) {
  setObjectName(QStringLiteral("keys_sheet"));
  setWindowTitle(tr("Keys"));
  resizeToText(*this, {92, 36});
  const QList<Row> rows = rowsOf(commands, bindings);
  QStringList groups;
  for (const Row& row : rows) {
    if (!groups.contains(row.group)) groups << row.group;
  }
  auto* table = new KeyTable(rows.size() + groups.size());
  table->setObjectName(QStringLiteral("keys_table"));
  table->setAccessibleName(tr("Keys"));
  table->setHorizontalHeaderLabels({tr("Keys"), tr("What they do")});
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setShowGrid(false);
  table->setAlternatingRowColors(true);
  int at = 0;
  QString group;
  for (const Row& row : rows) {
    if (row.group != group) {
      group = row.group;
      auto* title = new QTableWidgetItem(group);
      QFont bold = table->font();
      bold.setBold(true);
      title->setFont(bold);
      table->setItem(at, 0, title);
      table->setSpan(at, 0, 1, 2);
      table->setRowHeight(at, 2 * fontMetrics().height());
      ++at;
    }
    table->setItem(at, 0, new QTableWidgetItem(row.keys));
    table->setItem(at, 1, new QTableWidgetItem(row.what));
    ++at;
  }
  auto* words = new QLineEdit;
  words->setObjectName(QStringLiteral("keys_words"));
  words->setAccessibleName(tr("Search keys"));
  words->setToolTip(tr("Words of what a key does, or the key itself"));
  words->setPlaceholderText(tr("Search keys"));
  words->setClearButtonEnabled(true);
  auto* nothing =
      new QLabel(tr("No key has these words. Ctrl+K finds commands without a key, too."));
  nothing->setObjectName(QStringLiteral("keys_nothing"));
  nothing->setWordWrap(true);
  nothing->hide();
  connect(words, &QLineEdit::textChanged, this, [table, nothing](const QString& text) {
    const bool any = showRowsWith(*table, text.split(' ', Qt::SkipEmptyParts));
    nothing->setVisible(!any);
  });
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  nameButtons(*buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(words);
  column->addWidget(nothing);
  column->addWidget(table, 1);
  column->addWidget(buttons);
}

}  // namespace relievo
