// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QScrollArea>
#include <vector>

class QToolButton;
class QVBoxLayout;

namespace relievo {

/// The column of panels at the right: titled sections that fold. [GUI thread]
class SidePanels : public QScrollArea {
  Q_OBJECT
 public:
  explicit SidePanels(QWidget* parent = nullptr);
  void add(const QString& title, QWidget* panel);  ///< Takes ownership; goes to the end.
  void insert(int index, const QString& title, QWidget* panel);
  void remove(QWidget* panel);  ///< And deletes it, if it is one of these.
  QStringList titles() const;
  /// Unfolds the section of a panel and scrolls to it.
  void reveal(QWidget* panel);
  /// As wide as its text asks for, and never more than half of the window.
  void fitTo(int window_width);

 private:
  QVBoxLayout* column_;
  std::vector<QToolButton*> headers_;
  int window_width_ = 0;  ///< Pixels; 0: not yet told.
};

}  // namespace relievo
