// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFrame>
#include <QLabel>

namespace relievo {

/// What is said, large below the view, for who does not hear it; in its place what the staff is
/// asked (EN 301 549, 5.1.5). [GUI thread]
class ExhibitCaption : public QFrame {
  Q_OBJECT
 public:
  explicit ExhibitCaption(QWidget* parent);
  void setSaid(const QString& text);
  /// Empty: nothing is asked. @param dots  one for each digit that was entered
  void setAsked(const QString& text, int dots = 0);
  bool asks() const { return asks_; }
  QString text() const { return words_->text(); }

 private:
  void showWords();

  QLabel* words_;
  QString said_, asked_;
  bool asks_ = false;
};

}  // namespace relievo
