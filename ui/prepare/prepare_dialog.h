// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QDialog>

#include "ui/prepare/cloud_view.h"
#include "ui/prepare/prepare_state.h"
#include "ui/prepare/prepare_work.h"
#include "ui/work/latest_worker.h"

class QAction;
class QBoxLayout;
class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTimer;
class QTreeWidget;
class QTreeWidgetItem;

namespace relievo {

class StepForm;

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
/// and writes the same bytes. What is chosen is a PrepareState; the work is done by the child
/// process relievo-prepare. [GUI thread]
class PrepareDialog : public QDialog {
  Q_OBJECT
 public:
  explicit PrepareDialog(const PrepareStart& start, QWidget* parent = nullptr);
  ~PrepareDialog() override;

  PrepareState& state() { return state_; }
  /// What is on show is of other choices, or still being made.
  bool isStale() const { return stale_; }
  bool isBusy() const { return worker_.busy() || painter_.busy(); }
  /// Of the choices on show; null: no scan was read yet. As stored until the steps are done.
  const PrepareResult* result() const { return result_.get(); }
  void done(int result) override;

 Q_SIGNALS:
  /// The prepared cloud is written; the dialog closes.
  void prepared(const QString& file);
  void said(const QString& text);

 private:
  struct Pick {  ///< While pairs are picked.
    std::size_t input = 0;
    std::vector<FilePoint> on_scan, on_reference;
    std::vector<bool> order;  ///< As they were placed: was it on the reference?

    std::vector<PickedPair> pairs() const;  ///< The whole ones.
  };

  // prepare_layout.cpp
  void layOut();
  QWidget* scansPart();
  QWidget* stepsPart();
  QWidget* viewsPart();
  QBoxLayout* lookRow();
  QBoxLayout* bottomRow();
  void makeStepMenu();

  // prepare_dialog.cpp
  void choicesChanged();
  void compute();
  void readNext(std::size_t input);
  void prepareNow();
  void refuse(const QString& sentence);
  void showMade(const std::shared_ptr<const PrepareResult>& made);
  void showBusy(bool busy);
  void showPicture();
  void take();
  void write(const std::function<void(const Task&)>& work, const std::function<void()>& then);
  void saveRecipe();
  void copyCommand();
  void chooseFile();
  const ReadScan* readOf(const PrepareInput& input) const;
  std::shared_ptr<const ReadScan> heldReadOf(const PrepareInput& input) const;
  QString outputFile() const;
  /// As chosen or as its file says; mm if nobody does.
  LengthUnit unitOf(const PrepareInput& input) const;
  QString wordsOfWork(const QString& step) const;

  // prepare_lists.cpp
  void showLists();
  void showScans();
  void showSteps();
  void showForm();
  void showNumbers();
  void showWords();
  void scanItemChanged(QTreeWidgetItem* item);
  void stepItemChanged(QTreeWidgetItem* item);
  /// The file, and which of its scans if it is one of several.
  QString nameOf(const PrepareInput& input) const;
  std::size_t chosenScan() const;
  void showScanButtons();
  QStringList alignWords() const;
  std::optional<std::size_t> chosenStep() const;
  void addScans();
  void addSteps(const std::vector<Step>& steps);
  void undo();
  void redo();
  FileBounds boxLeft() const;

  // prepare_picks.cpp
  void beginPicking();
  void endPicking();
  void placePick(bool on_reference, const FilePoint& point);
  void takeBackPick();
  void removePair();
  QString nextPickText() const;
  QString pairsText() const;
  void showPicks();
  void showPairs();
  void sayNextPick();
  void drawOutline();
  void takeOutline(const CloudView::Outline& outline);
  void showOutline();

  PrepareState state_;
  std::vector<std::pair<PrepareInput, std::shared_ptr<const ReadScan>>> reads_;
  std::shared_ptr<const PrepareResult> result_;
  std::optional<Pick> pick_;
  bool stale_ = true, reading_ = false, take_when_made_ = false, filling_ = false;
  QString recipe_file_;  ///< Saved from the present choices; empty: they were not.

  QTreeWidget *scans_ = nullptr, *steps_ = nullptr, *pairs_ = nullptr;
  StepForm* form_ = nullptr;
  CloudView *view_ = nullptr, *other_view_ = nullptr;
  QLabel *view_title_ = nullptr, *other_title_ = nullptr;
  QWidget* other_box_ = nullptr;
  QComboBox *side_ = nullptr, *stage_ = nullptr, *colour_ = nullptr;
  QLabel *total_ = nullptr, *words_ = nullptr, *problem_ = nullptr, *step_name_ = nullptr,
         *file_note_ = nullptr;
  QLineEdit* file_ = nullptr;
  QCheckBox *live_ = nullptr, *withheld_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton *recompute_ = nullptr, *stop_ = nullptr, *ok_ = nullptr, *undo_ = nullptr,
              *redo_ = nullptr, *add_step_ = nullptr, *remove_step_ = nullptr, *up_ = nullptr,
              *down_ = nullptr, *add_scan_ = nullptr, *remove_scan_ = nullptr,
              *make_reference_ = nullptr, *split_ = nullptr, *pick_button_ = nullptr,
              *take_back_ = nullptr, *remove_pair_ = nullptr, *save_recipe_ = nullptr,
              *copy_command_ = nullptr;
  QTimer* delay_ = nullptr;
  LatestWorker painter_;
  LatestWorker worker_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
