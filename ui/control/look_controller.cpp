// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/look_controller.h"

#include <algorithm>
#include <cmath>
#include <QAction>
#include <QScreen>

#include "core/relief/relief_image.h"
#include "core/session/colours/surface_colours.h"
#include "core/session/map_facts.h"
#include "ui/panels/view_panel.h"
#include "ui/style/mnemonic.h"
#include "ui/style/text.h"
#include "ui/views/detail_view.h"
#include "ui/views/overlays/light_ball.h"
#include "ui/views/reference_view.h"

namespace relievo {
namespace {

constexpr double kLightStepDeg = 5;
constexpr double kRakingDeg = 10;
// Of steps that merge while a slider is dragged; the document's own ids are below.
constexpr int kMergeStereo = 101, kMergeLight = 102, kMergeShading = 103;
constexpr int kMergeDraggedLight = 1000;  // By keys; a drag adds its number.

}  // namespace

LookController::LookController(const ControllerParts& parts, DetailView& detail,
                               ReferenceView& reference, ViewPanel& panel, StereoPanel& stereo)
    : Controller(parts),
      detail_(detail),
      reference_(reference),
      panel_(panel),
      stereo_panel_(stereo),
      light_ball_(new LightBall(&detail)) {
  makeCommands();
  connect(&panel_, &ViewPanel::lightChanged, this, [this](const LightOptions& light) {
    choose(
        tr("Light"), [&](ReliefLook& look) { look.light = light; }, kMergeLight);
  });
  connect(&panel_, &ViewPanel::shadingChanged, this, [this](double shading) {
    choose(
        tr("Shading of colours"), [&](ReliefLook& look) { look.shading = shading; }, kMergeShading);
  });
  connect(light_ball_, &LightBall::dragged, this, [this](const LightOptions& light, int drag) {
    chooseLight(light, kMergeDraggedLight + drag);
  });
  connect(light_ball_, &LightBall::stepped, this, &LookController::stepLight);
  connect(&detail_, &SurfaceView::sized, light_ball_, &LightBall::place);
  connect(&stereo_panel_, &StereoPanel::changed, this, &LookController::chooseStereo);
  // The window may be another one before the panel has heard of another stereo.
  connect(&stereo_panel_, &StereoPanel::drawnChanged, this, &LookController::showStereo);
  connect(&document_, &Document::lookChanged, this, &LookController::show);
  connect(&document_, &Document::lookRefused, this, &LookController::tellRefused);
  connect(&document_, &Document::stereoChanged, this, &LookController::showStereo);
  connect(&document_, &Document::surfaceChanged, this, &LookController::showHeights);
  connect(&document_, &Document::windowChanged, this, [this] {
    showParallax();
    shareRange();
  });
  for (SurfaceView* view :
       {static_cast<SurfaceView*>(&reference_), static_cast<SurfaceView*>(&detail_)}) {
    connect(view, &SurfaceView::sized, this, &LookController::showParallax);
  }
  connect(&reference_, &SurfaceView::painted, this, &LookController::shareRange);
}

void LookController::makeCommands() {
  for (std::size_t i = 0; i < kReliefKindNames.size(); ++i) {
    const auto kind = static_cast<ReliefKind>(i);
    const Command command = commandAfter(Command::relief_lit, i);
    commands_.on(command, this, [this, kind, command] {
      announce(withoutMnemonic(commands_[command].text()));
      choose(tr("Relief image"), [kind](ReliefLook& look) {
        look.kind = kind;
        look.range.reset();  // They were values of another kind.
      });
    });
    commands_[command].setChecked(kind == ReliefKind::lit);
  }
  commands_.on(Command::show_unmeasured, this, [this] {
    choose(tr("Unmeasured cells"), [this](ReliefLook& look) {
      look.unmeasured = commands_[Command::show_unmeasured].isChecked();
    });
  });
  for (std::size_t i = 0; i < kColourMapNames.size(); ++i) {
    const auto map = static_cast<ColourMap>(i);
    const Command command = commandAfter(Command::colours_grey, i);
    commands_.on(command, this, [this, map, command] {
      announce(withoutMnemonic(commands_[command].text()));
      choose(tr("Relief image"), [map](ReliefLook& look) { look.colours = map; });
    });
    commands_[command].setChecked(map == ReliefLook{}.colours);
  }
  commands_.onToggled(Command::stereo, this, [this](bool on) { stereo_panel_.setOn(on); });
  makeLightCommands();
}

void LookController::makeLightCommands() {
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

void LookController::tellRefused(ReliefKind wanted) {
  announce(wanted == ReliefKind::natural
               ? tr("This scan has no colours; it is shown as shaded relief")
               : tr("This scan has no intensities; it is shown as shaded relief"));
}

void LookController::choose(const QString& name, const std::function<void(ReliefLook&)>& change,
                            int merge_id) {
  document_.edit(
      name, [&](Project& p) { change(p.look); }, merge_id);
  show();  // Also where nothing has changed: the command that was chosen may be another one.
}

void LookController::show() {
  const ReliefLook& look = document_.project().look;
  panel_.showLight(look.light);
  panel_.showShading(look.shading, showsOwnColours(look.kind));
  commands_[Command::show_unmeasured].setChecked(look.unmeasured);
  for (SurfaceView* view :
       {static_cast<SurfaceView*>(&reference_), static_cast<SurfaceView*>(&detail_)}) {
    view->setLight(look.light);
    view->setLook(look);
  }
  light_ball_->show(look.light);
  placeLight();
  shareRange();
  warnOfRivalry();
  for (std::size_t i = 0; i < kReliefKindNames.size(); ++i) {
    const bool is_shown = static_cast<std::size_t>(look.kind) == i;
    commands_[commandAfter(Command::relief_lit, i)].setChecked(is_shown);
  }
  for (std::size_t i = 0; i < kColourMapNames.size(); ++i) {
    const bool is_shown = static_cast<std::size_t>(look.colours) == i;
    commands_[commandAfter(Command::colours_grey, i)].setChecked(is_shown);
  }
}

void LookController::showView(const ViewState& view, const QString& name) {
  document_.edit(name, [&](Project& p) {
    p.look = view.look;
    p.stereo = view.stereo;
    p.chosen_eye_angle_deg.reset();
    p.azimuth_deg = view.azimuth_deg;
    p.elevation_deg = view.elevation_deg;
  });
}

void LookController::chooseStereo(const StereoOptions& stereo) {
  const std::optional<double> chosen_deg = stereo_panel_.chosenAngleDeg();
  document_.edit(
      tr("Stereo"),
      [&](Project& p) {
        p.stereo = stereo;
        p.chosen_eye_angle_deg = chosen_deg;
      },
      kMergeStereo);
  document_.setDrawnEyeAngle(stereo.eye_angle_deg, chosen_deg);  // By the limit alone: no step.
}

void LookController::showStereo() {
  const Project& p = document_.project();
  stereo_panel_.show(p.stereo, p.chosen_eye_angle_deg);
  document_.setDrawnEyeAngle(stereo_panel_.options().eye_angle_deg, stereo_panel_.chosenAngleDeg());
  reference_.setStereo(overviewStereo());
  detail_.setStereo(document_.project().stereo);
  placeLight();
  commands_[Command::stereo].setChecked(document_.project().stereo.mode != StereoMode::off);
  warnOfRivalry();
}

void LookController::stepLight(int clockwise, int higher) {
  const LightOptions& now = document_.project().look.light;
  chooseLight(turnedLight(now, kLightStepDeg * clockwise, kLightStepDeg * higher),
              kMergeDraggedLight);
}

void LookController::chooseLight(const LightOptions& light, int merge_id) {
  if (!document_.isOpen()) return;
  choose(
      tr("Light"), [&light](ReliefLook& look) { look.light = light; }, merge_id);
  announce(hasKeyLight(document_.project().look)
               ? light_ball_->accessibleDescription()
               : tr("%1. This relief image has no lamp: the light shows in others.")
                     .arg(light_ball_->accessibleDescription()));
}

void LookController::takeStereoPreferences() {
  const auto mode =
      stereoMode(settings_.choice(QStringLiteral("stereo_kind"), QStringLiteral("anaglyph"))
                     .toString()
                     .toStdString());
  StereoOptions stereo = document_.project().stereo;
  stereo_panel_.setKind(mode.value_or(StereoMode::anaglyph));
  if (stereo.mode != StereoMode::off) stereo.mode = mode.value_or(StereoMode::anaglyph);
  stereo.eye_angle_deg =
      settings_.choice(QStringLiteral("stereo_angle"), StereoOptions{}.eye_angle_deg).toDouble();
  stereo.automatic_depth = settings_.choice(QStringLiteral("stereo_automatic"), true).toBool();
  stereo.swap_eyes = settings_.choice(QStringLiteral("stereo_swap"), false).toBool();
  stereo_panel_.setComfort(settings_.choice(QStringLiteral("stereo_comfort"), true).toBool());
  document_.edit(
      tr("Stereo"),
      [&](Project& p) {
        p.stereo = stereo;
        p.chosen_eye_angle_deg.reset();
      },
      kMergeStereo);
}

void LookController::showHeights() {
  if (!document_.isOpen()) return;
  const HeightRange heights = mapFacts(*document_.surface()).heights;
  stereo_panel_.setHeights(heights.min_mm, heights.max_mm);
  whole_shown_.low_mm = heights.min_mm;
  whole_shown_.high_mm = heights.max_mm;
}

void LookController::placeLight() {
  const Project& p = document_.project();
  light_ball_->setUsable(hasKeyLight(p.look) && !showsHalves(printed(p.stereo.mode)));
}

/// The overview is no place for two halves: full screen shows the detail view alone.
StereoOptions LookController::overviewStereo() const {
  StereoOptions stereo = stereo_panel_.optionsFor(whole_shown_);
  if (showsHalves(printed(stereo.mode))) stereo.mode = StereoMode::off;
  return stereo;
}

// As it is seen at the views' sizes on this screen.
void LookController::showParallax() {
  const auto window = document_.window();
  if (!window) return;
  constexpr double kMmPerInch = 25.4;
  const double screen_mm = kMmPerInch / std::max(window_.screen()->physicalDotsPerInch(), 1.0);
  whole_shown_.screen_per_mm = screen_mm / reference_.mmPerPixel();
  stereo_panel_.setShown({window->min_mm, window->max_mm, screen_mm / detail_.mmPerPixel()});
  reference_.setStereo(overviewStereo());
}

void LookController::warnOfRivalry() {
  const auto window = document_.window();
  if (!document_.isOpen() || !window || document_.surface() == warned_of_rivalry_) return;
  const Project& shown = document_.project();
  const double share =
      rivalShare(*document_.surface(), *window, shown.look.kind, printed(shown.stereo.mode));
  if (share <= kMostRivalShare) return;
  warned_of_rivalry_ = document_.surface();
  announce(tr("%1 % of this picture is a strong red or cyan, which one eye sees dark through the "
              "glasses. Grey stereo shows it to both")
               .arg(std::lround(100 * share)));
}

void LookController::shareRange() {
  // Heights that are exaggerated have values of their own.
  const bool alike = document_.isOpen() && document_.project().gain == 1;
  detail_.setRange(alike ? reference_.shownRange() : std::nullopt);
}
}  // namespace relievo
