// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QMap>
#include <QScrollArea>
#include <vector>

class QToolButton;
class QVBoxLayout;

namespace relievo {

/// The column of panels at the right: titled sections that fold. A panel whose property
/// `kFoldedAtFirst` is true is folded until somebody opens it; what somebody folds or opens stays
/// so, by the panel's object name. [GUI thread]
class SidePanels : public QScrollArea {
  Q_OBJECT
 public:
  static constexpr const char* kFoldedAtFirst = "foldedAtFirst";

  explicit SidePanels(QWidget* parent = nullptr);
  void add(const QString& title, QWidget* panel);  ///< Takes ownership; goes to the end.
  void insert(int index, const QString& title, QWidget* panel);
  /// Those of modules stand where this was called, one after the other.
  void keepPlaceHere() { place_ = static_cast<int>(headers_.size()); }
  void addAtPlace(const QString& title, QWidget* panel);
  void remove(QWidget* panel);  ///< And deletes it, if it is one of these.
  QStringList titles() const;
  /// What somebody folded or opened, as kept for the next start: "-stereo_panel", "+places_panel".
  QStringList folds() const;
  /// Holds for panels that come later, too.
  void setFolds(const QStringList& folds);
  /// Unfolds the section of a panel and scrolls to it.
  void reveal(QWidget* panel);
  /// As wide as its text asks for, and never more than half of the window.
  void fitTo(int window_width);

 private:
  void fold(QWidget* panel, bool folded);

  QVBoxLayout* column_;
  std::vector<QToolButton*> headers_;
  QMap<QString, bool> folded_;  ///< By somebody.
  int place_ = 0;
  int window_width_ = 0;  ///< Pixels; 0: not yet told.
};

}  // namespace relievo
