// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QGroupBox>

#include "ui/prepare/prepare_state.h"

class QCheckBox;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace relievo {

class ReadScans;

/// The scans of the dialog Prepare: which are used, where they were found to lie, and the pairs
/// that are picked on one of them. Changes the choices itself and tells of it. [GUI thread]
class ScanList : public QGroupBox {
  Q_OBJECT
 public:
  ScanList(PrepareState& state, const ReadScans& reads);

  std::size_t chosen() const;  ///< An input; the first if none is chosen.
  void showInputs();
  /// Where the scans lie, and what can be done with the chosen one.
  void showPoses();
  void setPicking(bool on);
  /// @param errors  of each pair, in units of `mm`; empty: the pairs say no pose yet
  /// @param mm      per unit of the file
  void showPairs(std::size_t pairs, const std::vector<double>& errors, double mm);
  int chosenPair() const;  ///< -1: none.

 Q_SIGNALS:
  void changed();
  void chosenChanged();
  void pickToggled();
  void takeBackAsked();
  void removePairAsked();

 private:
  void layOut();
  void connectButtons();
  QString poseText(std::size_t input, const std::vector<std::size_t>& used) const;
  void showButtons();
  void useItem(QTreeWidgetItem* item);
  void addScans();
  void makeReference();
  void split();
  void keepWithheld(bool on);

  PrepareState& state_;
  const ReadScans& reads_;
  bool filling_ = false, picking_ = false;
  QTreeWidget *scans_, *pairs_;
  QPushButton *add_, *remove_, *make_reference_, *pick_, *take_back_, *remove_pair_, *split_;
  QCheckBox* withheld_;
};

}  // namespace relievo
