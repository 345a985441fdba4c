// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QDialog>

#include "ui/prepare/prepare_runner.h"
#include "ui/prepare/prepare_state.h"

class QVBoxLayout;

namespace relievo {

class PairPicking;
class PreparedFileRow;
class PrepareReport;
class PrepareViews;
class PrepareWorkRow;
class ScanList;
class StepList;

/// What the dialog begins with.
struct PrepareStart {
  std::vector<PrepareInput> inputs;
  /// The first of them, if it is in memory, with its file's checksum.
  std::shared_ptr<const Scan> scan = nullptr;
  std::string sha256 = {};
  /// From where the scans are seen at first: file -> view.
  Rotation view = *standardRotation("front");
};

/// "Prepare...": scans lose what is no part of the object, are laid on each other, joined and
/// thinned, seen in space before and after. Does what `relievo prepare` does, by the same record,
/// and writes the same bytes. What is chosen is a PrepareState, which the lists change; the work is
/// PrepareRunner's, in the child process relievo-prepare. The dialog brings changes to those who
/// show them, and results to the views. [GUI thread]
class PrepareDialog : public QDialog {
  Q_OBJECT
 public:
  explicit PrepareDialog(const PrepareStart& start, QWidget* parent = nullptr);
  ~PrepareDialog() override;

  PrepareState& state() { return state_; }
  /// What is on show is of other choices, or still being made.
  bool isStale() const { return runner_.isStale(); }
  bool isBusy() const;
  /// Of the choices on show; null: no scan was read yet. As stored until the steps are done.
  const PrepareResult* result() const { return runner_.result().get(); }
  void done(int result) override;

 Q_SIGNALS:
  /// The prepared cloud is written; the dialog closes.
  void prepared(const QString& file);
  void said(const QString& text);

 private:
  void layOut();
  void connectLists();
  void connectViews();
  void connectRunner();
  void connectWork();

  void choicesChanged();
  void undo();
  void redo();
  void showLists();
  void showNumbers();
  void showReport();
  void showChosenStep();
  void showOutline();
  void drawOutline();
  void takeOutline(const Rotation& view, const std::vector<std::array<double, 2>>& corners);
  void refuse(const QString& sentence);
  void showMade();
  void take();
  void saveRecipe();
  void copyCommand();

  PrepareState state_;
  bool take_when_made_ = false;
  QString recipe_file_;  ///< Saved from the present choices; empty: they were not.

  ScanList* scans_ = nullptr;
  StepList* steps_ = nullptr;
  PrepareReport* report_ = nullptr;
  PrepareViews* views_ = nullptr;
  PreparedFileRow* file_ = nullptr;
  PrepareWorkRow* work_ = nullptr;
  std::unique_ptr<PairPicking> picking_;
  PrepareRunner runner_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
