// SPDX-License-Identifier: BSD-3-Clause
// The key light: by the sphere in the detail view, by keys, and as presets.
#include <array>
#include <cmath>
#include <QAction>

#include "core/relief/relief_image.h"
#include "ui/views/detail_view.h"
#include "ui/views/light_ball.h"
#include "ui/window/main_window.h"

namespace relievo {
namespace {

constexpr double kStepDeg = 5;
constexpr double kRakingDeg = 10;

}  // namespace

void MainWindow::makeLightCommands() {
  struct Step {
    Command command;
    int clockwise, higher;
  };
  for (const Step& step :
       {Step{Command::light_counterclockwise, -1, 0}, Step{Command::light_clockwise, 1, 0},
        Step{Command::light_higher, 0, 1}, Step{Command::light_lower, 0, -1}}) {
    commands_.on(step.command, this, [this, step] { stepLight(step.clockwise, step.higher); });
  }
  struct Preset {
    Command command;
    LightOptions light;
  };
  for (const Preset& preset :
       {Preset{Command::light_usual, {}}, Preset{Command::light_rake_left, {270, kRakingDeg}},
        Preset{Command::light_rake_right, {90, kRakingDeg}},
        Preset{Command::light_rake_above, {0, kRakingDeg}},
        Preset{Command::light_rake_below, {180, kRakingDeg}}}) {
    commands_.on(preset.command, this, [this, light = preset.light] { chooseLight(light, -1); });
  }
}

void MainWindow::connectLight() {
  light_ball_ = new LightBall(detail_);
  connect(light_ball_, &LightBall::dragged, this,
          [this](const LightOptions& light) { chooseLight(light, kMergeDraggedLight); });
  connect(light_ball_, &LightBall::stepped, this, &MainWindow::stepLight);
  connect(detail_, &SurfaceView::sized, light_ball_, &LightBall::place);
}

void MainWindow::stepLight(int clockwise, int higher) {
  const LightOptions& now = document_.project().look.light;
  chooseLight(turnedLight(now, kStepDeg * clockwise, kStepDeg * higher), kMergeDraggedLight);
}

void MainWindow::chooseLight(const LightOptions& light, int merge_id) {
  if (!document_.isOpen()) return;
  chooseLook(
      tr("Light"), [&light](ReliefLook& look) { look.light = light; }, merge_id);
  announce(hasKeyLight(document_.project().look)
               ? light_ball_->accessibleDescription()
               : tr("%1. This relief image has no lamp: the light shows in others.")
                     .arg(light_ball_->accessibleDescription()));
}

void MainWindow::showLight() {
  const ReliefLook& look = document_.project().look;
  light_ball_->show(look.light);
  light_ball_->setUsable(hasKeyLight(look));
}

}  // namespace relievo
