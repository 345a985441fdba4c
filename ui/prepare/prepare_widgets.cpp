// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/prepare_widgets.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QTreeWidget>

#include "ui/style/mnemonic.h"

namespace relievo {
namespace {

constexpr int kListLines = 6;

}  // namespace

QPushButton* prepareButton(const QString& text, const char* name, const QString& tip) {
  auto* made = new QPushButton(text);
  made->setObjectName(QString::fromLatin1(name));
  made->setAccessibleName(withoutMnemonic(text).remove(u'\u2026'));
  made->setToolTip(tip);
  made->setAutoDefault(false);
  return made;
}

QTreeWidget* prepareList(const QString& name, const char* object, const QStringList& heads) {
  auto* tree = new QTreeWidget;
  tree->setObjectName(QString::fromLatin1(object));
  tree->setAccessibleName(name);
  tree->setHeaderLabels(heads);
  tree->setRootIsDecorated(false);
  tree->setUniformRowHeights(true);
  tree->setTabKeyNavigation(false);
  // As high as there is room, but never so that the buttons below are out of sight.
  tree->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  tree->setMinimumHeight(kListLines * tree->fontMetrics().height());
  tree->header()->setStretchLastSection(false);
  tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  tree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  return tree;
}

QLabel* prepareText(const char* name, const QString& title) {
  auto* label = new QLabel;
  label->setObjectName(QString::fromLatin1(name));
  label->setAccessibleName(title);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return label;
}

QComboBox* prepareChoice(const QString& title, const char* name, const QString& tip,
                         QBoxLayout* row, const QStringList& entries) {
  auto* box = new QComboBox;
  box->setObjectName(QString::fromLatin1(name));
  box->setAccessibleName(withoutMnemonic(title));
  box->setToolTip(tip);
  box->addItems(entries);
  box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* label = new QLabel(title);
  label->setBuddy(box);
  row->addWidget(label);
  row->addWidget(box);
  return box;
}

QBoxLayout* rowOf(std::initializer_list<QWidget*> widgets) {
  auto* row = new QHBoxLayout;
  for (QWidget* w : widgets) row->addWidget(w);
  row->addStretch(1);
  return row;
}

void addKeys(const char* keys, QWidget* where, Qt::ShortcutContext context,
             const std::function<void()>& run) {
  auto* shortcut = new QShortcut(QKeySequence(QLatin1String(keys)), where);
  shortcut->setContext(context);
  QObject::connect(shortcut, &QShortcut::activated, where, run);
}

int chosenRow(const QTreeWidget& list) {
  return list.indexOfTopLevelItem(list.currentItem());
}

void setRowCount(QTreeWidget& list, std::size_t rows) {
  const int count = static_cast<int>(rows);
  while (list.topLevelItemCount() > count) {
    delete list.takeTopLevelItem(list.topLevelItemCount() - 1);
  }
  while (list.topLevelItemCount() < count) new QTreeWidgetItem(&list);
}

}  // namespace relievo
