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
  connect(&document_, &Document::turnChanged, this, &TurnController::follow);
  connect(&document_.loader(), &SurfaceLoader::busyChanged, this, [this](bool busy) {
    if (!busy) goOn();
  });
}

// One surface at a time: a newer one would stop it, and a view that turns on would have none.
void TurnController::follow() {
  if (!commands_[Command::turn_relief].isChecked() || !document_.isOpen()) return;
  const std::shared_ptr<const Surface> surface = document_.surface();
  if (surface->is_raster || !detail_.isTurned() || document_.loader().busy()) return;
  turned_ = surface;
  const Project& shown = document_.project();
  document_.choices().turnTo(detail_.lookRotation(),
                             {shown.azimuth_deg, shown.elevation_deg, about()});
}

void TurnController::goOn() {
  if (turned_.lock() != document_.surface()) follow();
}

ViewMm TurnController::about() const {
  const StepAbout touched = touch_.about();
  const StepAbout at = touched.touching ? touched : document_.region().aboutCentre();
  return {at.x_mm, at.y_mm, windowHeightMm(*document_.window(), at.x_mm, at.y_mm)};
}

}  // namespace relievo
