// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>

class QAction;
class QLabel;
class QLineEdit;
class QListWidget;

namespace relievo {

/// Finds a command by words of its name or its explanation, or by other words for it, and runs it:
/// type, arrows, Enter. Commands that cannot run now are listed grey; where none is found a
/// sentence says so. [GUI thread]
class CommandSearch : public QDialog {
  Q_OBJECT
 public:
  explicit CommandSearch(const QList<QAction*>& commands, QWidget* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showMatches();
  void run();

  QList<QAction*> commands_;
  QLineEdit* words_;
  QListWidget* list_;
  QLabel* nothing_;
};

}  // namespace relievo
