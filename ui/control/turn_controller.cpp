// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/turn_controller.h"

#include <QAction>

#include "core/region/hand.h"
#include "ui/control/touch_controller.h"
#include "ui/views/detail_view.h"

namespace relievo {

TurnController::TurnController(const ControllerParts& parts, DetailView& detail,
                               const TouchController& touch)
    : Controller(parts), detail_(detail), touch_(touch) {
  commands_[Command::turn_relief].setChecked(
      settings_.choice(QStringLiteral("turn_relief"), false).toBool());
  commands_.onToggled(Command::turn_relief, this, [this](bool on) {
    settings_.setChoice(QStringLiteral("turn_relief"), on);
    if (on) follow();
  });
  const QAction* command = &commands_[Command::turn_relief];
  const auto note = [this, command] {
    document_.choices().setReliefFollows(command->isChecked() && command->isEnabled());
  };
  connect(command, &QAction::changed, this, note);
  note();
  // A view that is pasted, filmed or opened may be turned, too; its relief is the one it came with.
  connect(&detail_, &DetailView::turnedBySomebody, this, &TurnController::follow);
  // The document has taken it by now, and what was turned meanwhile is left. One that failed or was
  // stopped is not tried again.
  connect(&document_.loader(), &SurfaceLoader::made, this, [this](const LoadJob& job) {
    if (job.turn) follow();
  });
}

// Not where the command is not to be had: of rasters and maps by tiles, and in a replay, which
// another surface would close. One surface at a time: a newer one would stop it, and a view that
// turns on would have none.
void TurnController::follow() {
  if (!document_.choices().reliefFollows()) return;
  if (!detail_.isTurned() || document_.loader().busy()) return;
  const Project& shown = document_.project();
  document_.choices().turnTo(detail_.lookRotation(),
                             {shown.azimuth_deg, shown.elevation_deg, about()});
}

ViewMm TurnController::about() const {
  const StepAbout touched = touch_.about();
  const StepAbout at = touched.touching ? touched : document_.region().aboutCentre();
  return {at.x_mm, at.y_mm, windowHeightMm(*document_.window(), at.x_mm, at.y_mm)};
}

}  // namespace relievo
