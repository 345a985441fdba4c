// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/keys_sheet.h"

#include <algorithm>
#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/language/core_words.h"
#include "ui/style/dialog_size.h"
#include "ui/style/mnemonic.h"

namespace relievo {
namespace {

constexpr double kMostOfKeys = 0.42;  // Of the table's width, for the keys.

struct Row {
  QString keys, what;
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

QList<Row> rowsOf(const QList<QAction*>& commands) {
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
    rows.append({keys.join(QLatin1String(", ")), what});
  }
  const auto add = [&rows](const QString& keys, const QString& what) { rows.append({keys, what}); };
  add(KeysSheet::tr("Esc"), KeysSheet::tr("Stop forces, then cancel, then leave the mode"));
  add(KeysSheet::tr("Detail view: arrows, Shift+arrows"),
      KeysSheet::tr("Move the hand by 1 or by 10 cells"));
  add(KeysSheet::tr("Detail view: Page Down, Page Up"), KeysSheet::tr("Press in, lift"));
  add(KeysSheet::tr("Detail view: left button"),
      KeysSheet::tr("To look: turn the view; to touch: press the hand in"));
  add(KeysSheet::tr("Detail view: Ctrl+wheel"), KeysSheet::tr("Change the press depth"));
  add(KeysSheet::tr("Detail view: wheel"), KeysSheet::tr("Zoom about the pointer"));
  add(KeysSheet::tr("Detail view: middle, right button"),
      KeysSheet::tr("Turn the view, move the window"));
  add(KeysSheet::tr("Reference view: drag"), KeysSheet::tr("Draw, move or resize the window"));
  add(KeysSheet::tr("Reference view: arrows, Shift+arrows"),
      KeysSheet::tr("Move, resize the window"));
  add(KeysSheet::tr("Reference view: Space, arrows, Enter"), KeysSheet::tr("Draw a window"));
  add(KeysSheet::tr("Reference view: +, \u2212, wheel"), KeysSheet::tr("Finer, coarser"));
  return rows;
}

}  // namespace

KeysSheet::KeysSheet(const QList<QAction*>& commands, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("keys_sheet"));
  setWindowTitle(tr("Keys"));
  resizeToText(*this, {92, 36});
  const QList<Row> rows = rowsOf(commands);
  auto* table = new KeyTable(rows.size());
  table->setAccessibleName(tr("Keys"));
  table->setHorizontalHeaderLabels({tr("Keys"), tr("What they do")});
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setShowGrid(false);
  table->setAlternatingRowColors(true);
  for (int i = 0; i < rows.size(); ++i) {
    table->setItem(i, 0, new QTableWidgetItem(rows[i].keys));
    table->setItem(i, 1, new QTableWidgetItem(rows[i].what));
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  nameButtons(*buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(table);
  column->addWidget(buttons);
}

}  // namespace relievo
