// SPDX-License-Identifier: BSD-3-Clause
// Steps of the history that change no region: how the relief is painted and lit, stereo, places,
// measurements.
#include <functional>
#include <QScopedValueRollback>
#include <QUndoCommand>
#include <utility>

#include "ui/detail_view.h"
#include "ui/main_window.h"
#include "ui/measure_panel.h"
#include "ui/places_panel.h"
#include "ui/view_panel.h"

namespace relievo {
namespace {

class WorkCommand : public QUndoCommand {
 public:
  using Show = std::function<void(const ShownWork&)>;
  /// @param merge_id  -1: a step of its own; else one step with those of the same id before it
  WorkCommand(Show show, ShownWork before, ShownWork after, const QString& name, int merge_id)
      : QUndoCommand(name),
        show_(std::move(show)),
        before_(std::move(before)),
        after_(std::move(after)),
        merge_id_(merge_id) {}

  void undo() override { show_(before_); }
  void redo() override {
    if (std::exchange(done_, false)) return;  // When it is noted it has just happened.
    show_(after_);
  }
  int id() const override { return merge_id_; }
  bool mergeWith(const QUndoCommand* later) override {
    after_ = static_cast<const WorkCommand*>(later)->after_;
    return true;
  }

 private:
  Show show_;
  ShownWork before_, after_;
  int merge_id_;
  bool done_ = true;
};

}  // namespace

ShownWork MainWindow::shownWork() const {
  ShownWork work{.look = detail_->sceneState().look,
                 .stereo = detail_->sceneState().stereo,
                 .places = places_panel_->places(),
                 .measurements = measure_panel_->measurements()};
  work.look.light = detail_->sceneState().light;
  // It follows the heights: nobody chose it.
  if (work.stereo.automatic_depth) work.stereo.eye_angle_deg = StereoOptions{}.eye_angle_deg;
  return work;
}

void MainWindow::noteStep(const QString& name, int merge_id) {
  if (stepping_ || !document_.isOpen()) return;
  ShownWork now = shownWork();
  if (now == noted_) return;
  document_.history().push(new WorkCommand([this](const ShownWork& work) { showWork(work); },
                                           std::exchange(noted_, now), now, name, merge_id));
}

void MainWindow::showWork(const ShownWork& work) {
  const QScopedValueRollback<bool> no_steps(stepping_, true);
  showStereo(work.stereo);
  showLook(work.look);
  view_panel_->showLight(work.look.light);
  places_panel_->setPlaces(work.places);
  measure_panel_->setMeasurements(work.measurements);
  showMeasurements();
  noted_ = work;
}

}  // namespace relievo
