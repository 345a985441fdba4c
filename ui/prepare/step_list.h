// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <QGroupBox>

#include "ui/prepare/prepare_state.h"

class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace relievo {

class PrepareRunner;
class StepForm;

/// The steps of the dialog Prepare, the fields of the chosen one, and their history. Changes the
/// choices itself and tells of it. [GUI thread]
class StepList : public QGroupBox {
  Q_OBJECT
 public:
  StepList(PrepareState& state, const PrepareRunner& runner);

  std::optional<std::size_t> chosen() const;
  /// The chosen step, if it is of that kind.
  template <class Kind>
  const Kind* chosenAs() const {
    const auto step = chosen();
    return step ? std::get_if<Kind>(&state_.now().steps[*step].step) : nullptr;
  }
  void showSteps();
  /// The chosen step's fields.
  void showForm();
  /// How many points each step took away, if that is known of the choices as they are.
  void showResults();

 Q_SIGNALS:
  void changed();
  void chosenChanged();  ///< Or its fields are another's.
  void outlineAsked();   ///< To be drawn on the view.
  void undoAsked();
  void redoAsked();

 private:
  void layOut();
  void connectButtons();
  void makeMenu();
  void addSteps(const std::vector<Step>& steps);
  void removeChosen();
  void shiftChosen(int by);
  void useItem(QTreeWidgetItem* item);
  void changeChosen(const Step& step);
  FileBounds boxLeft() const;

  PrepareState& state_;
  const PrepareRunner& runner_;
  bool filling_ = false;
  QTreeWidget* steps_;
  QPushButton *add_, *remove_, *up_, *down_, *undo_, *redo_;
  StepForm* form_;
};

}  // namespace relievo
