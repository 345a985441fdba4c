// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>

#include "ui/panels/stereo_panel.h"
#include "ui/window/controller.h"

namespace relievo {

class DetailView;
class LightBall;
class ReferenceView;
class ViewPanel;

/// How the relief is painted, lit and seen in stereo: edits of that, and showing it in both views.
/// [GUI thread]
class LookController : public Controller {
  Q_OBJECT
 public:
  LookController(const ControllerParts& parts, DetailView& detail, ReferenceView& reference,
                 ViewPanel& panel, StereoPanel& stereo);

  /// One step to a view's look and stereo; its turn comes with it.
  void showView(const ViewState& view, const QString& name);
  void takeStereoPreferences();
  void placeLight();  ///< In the detail view, which has another size.
  /// Once for each surface: whoever has been told and goes on knows.
  void warnOfRivalry();

 private:
  void makeCommands();
  void makeLightCommands();
  /// One step that changes how the relief is painted.
  void choose(const QString& name, const std::function<void(ReliefLook&)>& change,
              int merge_id = -1);
  void show();
  void tellRefused(ReliefKind wanted);
  void stepLight(int clockwise, int higher);
  void chooseLight(const LightOptions& light, int merge_id);
  void chooseStereo(const StereoOptions& stereo);
  void showStereo();
  void showHeights();
  void showParallax();
  /// The same colour for the same value in both views.
  void shareRange();

  DetailView& detail_;
  ReferenceView& reference_;
  ViewPanel& panel_;
  StereoPanel& stereo_panel_;
  StereoOptions overviewStereo() const;

  LightBall* light_ball_;           ///< The detail view owns it.
  StereoPanel::Shown whole_shown_;  ///< By the reference view.
  std::shared_ptr<const Surface> warned_of_rivalry_;
};

}  // namespace relievo
