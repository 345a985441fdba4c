// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <initializer_list>
#include <QStringList>

class QBoxLayout;
class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;
class QWidget;

// Widgets of the dialog Prepare: each has a name for tests and scripts, and one for speech.
namespace relievo {

QPushButton* prepareButton(const QString& text, const char* name, const QString& tip);
/// Two columns; the first is as wide as there is room.
QTreeWidget* prepareList(const QString& name, const char* object, const QStringList& heads);
/// A text that the program changes and a person may select.
QLabel* prepareText(const char* name, const QString& title);
/// A choice behind its title, both added to `row`.
QComboBox* prepareChoice(const QString& title, const char* name, const QString& tip,
                         QBoxLayout* row, const QStringList& entries);
/// Side by side, as narrow as they are.
QBoxLayout* rowOf(std::initializer_list<QWidget*> widgets);
/// Keys that run something while `where`, or its window, has the focus.
void addKeys(const char* keys, QWidget* where, Qt::ShortcutContext context,
             const std::function<void()>& run);

/// The row that is chosen; -1: none.
int chosenRow(const QTreeWidget& list);
/// As many rows as that; those that stay are as they were.
void setRowCount(QTreeWidget& list, std::size_t rows);

}  // namespace relievo
