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
    const char* name;
    QString text, keys, tip;
    int clockwise, higher;
  };
  const std::array<Step, 4> steps{
      {{"light_counterclockwise", tr("Turn &counterclockwise"), "Alt+Shift+Left",
        tr("Turn the light by 5 degrees, counterclockwise"), -1, 0},
       {"light_clockwise", tr("Turn cloc&kwise"), "Alt+Shift+Right",
        tr("Turn the light by 5 degrees, clockwise"), 1, 0},
       {"light_higher", tr("&Higher"), "Alt+Shift+Up", tr("The light 5 degrees higher"), 0, 1},
       {"light_lower", tr("Lo&wer"), "Alt+Shift+Down",
        tr("The light 5 degrees lower: worn detail comes out"), 0, -1}}};
  for (const Step& s : steps) {
    make({s.name,
          s.text,
          {QKeySequence(s.keys)},
          s.tip,
          [this, clockwise = s.clockwise, higher = s.higher] { stepLight(clockwise, higher); },
          {}});
  }
  struct Preset {
    const char* name;
    QString text, tip;
    LightOptions light;
  };
  const QString raking = tr("Light almost along the surface, 10 degrees above it");
  const std::array<Preset, 5> presets{
      {{"light_usual", tr("&Usual light"), tr("From the upper left, 45 degrees high"), {}},
       {"light_rake_left", tr("Raking from the &left"), raking, {270, kRakingDeg}},
       {"light_rake_right", tr("Raking from the &right"), raking, {90, kRakingDeg}},
       {"light_rake_above", tr("Raking from &above"), raking, {0, kRakingDeg}},
       {"light_rake_below", tr("Raking from &below"), raking, {180, kRakingDeg}}}};
  for (const Preset& p : presets) {
    make({p.name, p.text, {}, p.tip, [this, light = p.light] { chooseLight(light, -1); }, {}});
  }
}

void MainWindow::connectLight() {
  light_ball_ = new LightBall(detail_);
  connect(light_ball_, &LightBall::dragged, this, [this](const LightOptions& light, int drag) {
    chooseLight(light, kMergeDraggedLight + drag);
  });
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
