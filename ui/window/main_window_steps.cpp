// SPDX-License-Identifier: BSD-3-Clause
// Edits of how the relief is painted, lit and seen, and showing them.
#include <QAction>

#include "core/relief/relief_image.h"
#include "ui/panels/stereo_panel.h"
#include "ui/panels/view_panel.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/window/main_window.h"

namespace relievo {

void MainWindow::tellLookRefused(ReliefKind wanted) {
  announce(wanted == ReliefKind::natural
               ? tr("This scan has no colours; it is shown as shaded relief")
               : tr("This scan has no intensities; it is shown as shaded relief"));
}

void MainWindow::chooseLook(const QString& name, const std::function<void(ReliefLook&)>& change,
                            int merge_id) {
  document_.edit(
      name, [&](Project& p) { change(p.look); }, merge_id);
  showLook();  // Also where nothing has changed: the command that was chosen may be another one.
}

void MainWindow::showLook() {
  const ReliefLook& look = document_.project().look;
  view_panel_->showLight(look.light);
  view_panel_->showShading(look.shading, showsOwnColours(look.kind));
  command("show_unmeasured")->setChecked(look.unmeasured);
  for (SurfaceView* view :
       {static_cast<SurfaceView*>(reference_), static_cast<SurfaceView*>(detail_)}) {
    view->setLight(look.light);
    view->setLook(look);
  }
  showLight();
  shareRange();
  warnOfRivalry();
  for (std::size_t i = 0; i < kReliefKindNames.size(); ++i) {
    const std::string name = "relief_" + std::string(kReliefKindNames[i]);
    command(name.c_str())->setChecked(static_cast<std::size_t>(look.kind) == i);
  }
  for (std::size_t i = 0; i < kColourMapNames.size(); ++i) {
    const std::string name = "colours_" + std::string(kColourMapNames[i]);
    command(name.c_str())->setChecked(static_cast<std::size_t>(look.colours) == i);
  }
}

void MainWindow::showView(const ViewState& view, const QString& name) {
  document_.edit(name, [&](Project& p) {
    p.look = view.look;
    p.stereo = view.stereo;
    p.chosen_eye_angle_deg.reset();
  });
  document_.setTurn(view.azimuth_deg, view.elevation_deg);
}

void MainWindow::chooseStereo(const StereoOptions& stereo) {
  const std::optional<double> chosen_deg = stereo_panel_->chosenAngleDeg();
  document_.edit(
      tr("Stereo"),
      [&](Project& p) {
        p.stereo = stereo;
        p.chosen_eye_angle_deg = chosen_deg;
      },
      kMergeStereo);
  document_.setDrawnEyeAngle(stereo.eye_angle_deg, chosen_deg);  // By the limit alone: no step.
}

void MainWindow::showStereo() {
  const Project& p = document_.project();
  stereo_panel_->show(p.stereo, p.chosen_eye_angle_deg);
  document_.setDrawnEyeAngle(stereo_panel_->options().eye_angle_deg,
                             stereo_panel_->chosenAngleDeg());
  reference_->setStereo(stereo_panel_->optionsFor(whole_shown_));
  detail_->setStereo(document_.project().stereo);
  command("stereo")->setChecked(document_.project().stereo.mode != StereoMode::off);
  warnOfRivalry();
}

}  // namespace relievo
