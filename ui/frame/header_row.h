// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

class QBoxLayout;
class QLabel;

namespace relievo {

/// Title and note above a view; the note goes below the title where both are longer than the view
/// is wide, and comes back when both fit with a little room to spare, so that the view does not
/// jump with its text.
class HeaderRow : public QWidget {
 public:
  HeaderRow(QLabel* title, QLabel* note);  ///< Takes ownership.

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void fit();

  QBoxLayout* row_;
  QLabel *title_, *note_;
};

}  // namespace relievo
