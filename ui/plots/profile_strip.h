// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "ui/plots/profile_curve.h"

class QLabel;
class QToolButton;

namespace relievo {

/// The heights along a profile under the views, with a cursor that says where on the surface it is,
/// and length and depth of a piece of it. A press puts the cursor, a drag chooses a piece; arrows
/// move the cursor (Page Up and Down by ten samples, Home, End), with Shift they choose a piece.
/// [GUI thread]
class ProfileStrip : public QWidget {
  Q_OBJECT
 public:
  explicit ProfileStrip(QWidget* parent = nullptr);

  /// No rows: nothing is shown. Cursor and piece stay while the rows do.
  void show(const QString& name, const std::vector<ProfileRow>& rows);
  bool isEmpty() const { return shown_.rows.empty(); }
  const ProfileShown& shown() const { return shown_; }
  /// Where the cursor is on the surface.
  std::optional<ViewMm> cursorAt() const;
  QString readout() const;
  /// As it is shown, on white. @pre !isEmpty()
  std::string drawing() const;
  void takeColours();

 Q_SIGNALS:
  void cursorMoved();
  void saveAsked();
  void closeAsked();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  class Canvas;
  void setCursorRow(std::size_t row, bool piece);
  void showReadout();
  void fitReadout();

  QString name_;
  ProfileShown shown_;
  QLabel* readout_;
  QToolButton *save_, *close_;
  Canvas* canvas_;
};

}  // namespace relievo
