// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/surface_controller.h"

#include <QAction>
#include <QDialog>
#include <QUndoView>
#include <QVBoxLayout>

#include "ui/control/touch_controller.h"
#include "ui/dialogs/depth_map_dialog.h"
#include "ui/style/mnemonic.h"
#include "ui/style/text.h"
#include "ui/views/detail_view.h"
#include "ui/views/scan_view.h"

namespace relievo {
namespace {

constexpr double kMoveStep = 0.25;  // Of the window's side.
constexpr double kTurnStepDeg = 15;

}  // namespace

SurfaceController::SurfaceController(const ControllerParts& parts, DetailView& detail,
                                     const ScanView& scan, const TouchController& touch)
    : Controller(parts), detail_(detail), scan_(scan), touch_(touch) {
  makeCommands();
  showHistory();
  for (const auto signal : {&QUndoStack::undoTextChanged, &QUndoStack::redoTextChanged}) {
    connect(&document_.history(), signal, this, &SurfaceController::showHistory);
  }
}

void SurfaceController::makeCommands() {
  commands_.on(Command::undo, this, [this] {
    const QString step = document_.history().undoText();
    document_.history().undo();
    announce(tr("Undone: %1").arg(step));  // What was said of the step holds no more.
  });
  commands_.on(Command::redo, this, [this] {
    const QString step = document_.history().redoText();
    document_.history().redo();
    announce(tr("Done again: %1").arg(step));
  });
  commands_.on(Command::history, this, [this] { showSteps(); });
  commands_.on(Command::fit, this, [this] { detail_.straighten(); });
  commands_.on(Command::finer, this, [this] { stepDetail(true); });
  commands_.on(Command::coarser, this, [this] { stepDetail(false); });
  connect(&detail_, &DetailView::resolutionAsked, this, &SurfaceController::stepDetail);
  commands_.on(Command::whole, this, [this] {
    if (document_.region().whole()) tell(Step::whole, tr("Whole object"));
  });
  commands_.on(Command::move_left, this, [this] { moveWindow(-kMoveStep, 0, tr("Left")); });
  commands_.on(Command::move_right, this, [this] { moveWindow(kMoveStep, 0, tr("Right")); });
  commands_.on(Command::move_up, this, [this] { moveWindow(0, kMoveStep, tr("Up")); });
  commands_.on(Command::move_down, this, [this] { moveWindow(0, -kMoveStep, tr("Down")); });
  commands_.on(Command::depth_map, this, [this] { chooseDepthMap(); });
  for (const Command side : {Command::front, Command::back, Command::left, Command::right,
                             Command::top, Command::bottom, Command::automatic}) {
    const std::string view = commands_[side].objectName().toStdString();
    commands_.on(side, this, [this, view] { document_.choices().setView({view, {}}); });
  }
  // Named after where the near side goes, as under a middle drag.
  commands_.on(Command::turn_left, this, [this] { detail_.turnBy(kTurnStepDeg, 0); });
  commands_.on(Command::turn_right, this, [this] { detail_.turnBy(-kTurnStepDeg, 0); });
  commands_.on(Command::turn_up, this, [this] { detail_.turnBy(0, -kTurnStepDeg); });
  commands_.on(Command::turn_down, this, [this] { detail_.turnBy(0, kTurnStepDeg); });
  commands_.on(Command::use_view, this, [this] { useThisView(); });
  commands_.on(Command::relief_from_scan, this, [this] { useScanView(); });
  commands_.on(Command::engine_cpu, this,
               [this] { document_.choices().setEngine(QStringLiteral("cpu")); });
  commands_.on(Command::engine_depthbuffer, this,
               [this] { document_.choices().setEngine(QStringLiteral("depthbuffer")); });
}

void SurfaceController::stepDetail(bool finer) {
  const bool done =
      finer ? document_.region().finer(touch_.about()) : document_.region().coarser(touch_.about());
  if (done) {
    tell(finer ? Step::closer : Step::wider,
         tr("Resolution %1 of %2").arg(document_.detail()).arg(document_.details()));
  } else {
    announce(finer ? tr("This is the finest resolution") : tr("This is the whole object"));
  }
}

void SurfaceController::tell(Step step, const QString& words) {
  if (tell_) {
    tell_(step);
  } else {
    announce(words);
  }
}

void SurfaceController::moveWindow(double dx, double dy, const QString& moved) {
  if (!document_.region().move(dx, dy)) {
    announce(tr("Edge"));
    return;
  }
  const Region& region = document_.project().region;
  announce(tr("%1. Window at %2, %3 mm")
               .arg(moved, numberText(region.x_mm, 1), numberText(region.y_mm, 1)));
}

void SurfaceController::useThisView() {
  if (!document_.isOpen() || !detail_.isTurned()) return;
  document_.choices().setView({"free", detail_.lookRotation()});
}

void SurfaceController::useScanView() {
  if (!document_.isOpen() || scan_.turnedDeg() == 0) return;
  // A side that has a name is chosen by it.
  for (const std::string_view side : kViewNames) {
    if (standardRotation(side) != scan_.rotation()) continue;
    document_.choices().setView({std::string(side), {}});
    return;
  }
  document_.choices().setView({"free", scan_.rotation()});
}

void SurfaceController::chooseDepthMap() {
  if (document_.loader().busy() || !document_.canRemake()) return;
  auto* dialog = new DepthMapDialog(document_, &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &DepthMapDialog::unitChosen, this, [this](LengthUnit unit) {
    settings_.rememberUnit(document_.file(), unit);
    messages_.close();
  });
  dialog->setModal(true);  // The document must not change below a preview of it.
  dialog->show();
}

void SurfaceController::showHistory() {
  const QUndoStack& history = document_.history();
  const auto show = [](QAction& action, const QString& verb, const QString& what, bool can,
                       const QString& key) {
    action.setEnabled(can);
    action.setText(what.isEmpty() ? verb : tr("%1 %2", "undo, step").arg(verb, what));
    action.setToolTip(QStringLiteral("%1 (%2)").arg(withoutMnemonic(action.text()), key));
  };
  show(commands_[Command::undo], tr("&Undo"), history.undoText(), history.canUndo(),
       QStringLiteral("Ctrl+Z"));
  show(commands_[Command::redo], tr("&Redo"), history.redoText(), history.canRedo(),
       QStringLiteral("Ctrl+Y"));
}

void SurfaceController::showSteps() {
  auto* dialog = new QDialog(&window_);
  dialog->setObjectName(QStringLiteral("history_dialog"));
  dialog->setWindowTitle(tr("History"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  auto* steps = new QUndoView(&document_.history());
  steps->setObjectName(QStringLiteral("history_steps"));
  steps->setAccessibleName(tr("Steps"));
  steps->setEmptyLabel(tr("As opened"));
  auto* column = new QVBoxLayout(dialog);
  column->addWidget(steps);
  dialog->resize(320, 400);
  dialog->show();
}

}  // namespace relievo
