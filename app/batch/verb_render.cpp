// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <CLI/CLI.hpp>

#include "app/batch/json.h"
#include "app/batch/large.h"
#include "app/batch/look_arguments.h"
#include "app/batch/state.h"
#include "app/batch/verb.h"
#include "core/base/error.h"
#include "core/io/text_file.h"
#include "core/project/caption.h"
#include "core/session/tiled_surface.h"
#include "ui/figure/figure.h"
#include "ui/figure/view_picture.h"
#include "ui/vtk/offscreen.h"
#include "ui/vtk/picture_file.h"

namespace relievo::batch {
namespace {

struct RenderArguments {
  MapArguments map;
  RegionArguments region;
  std::string stereo = "off";
  double eye_angle_deg = StereoOptions{}.eye_angle_deg;
  std::optional<double> zero_plane_mm;
  LookArguments look;
  int pixels = 800;
  bool scale_bar = false, swap_eyes = false;
  std::string out, caption;
  CarrierArguments carrier;
};

StereoOptions stereoOptions(const RenderArguments& a) {
  if (a.stereo == name(StereoPrint::side_by_side) || a.stereo == name(StereoPrint::over_under)) {
    throw ArgumentError(
        "--stereo: two pictures make a figure. Use 'relievo figure --layout detail "
        "--stereo " +
        a.stereo + "'. Nothing was drawn.");
  }
  // Also by the word of `figure`.
  const auto mode =
      a.stereo == name(StereoPrint::grey) ? StereoMode::anaglyph : stereoMode(a.stereo);
  if (!mode) refuseWord("--stereo", a.stereo, listOf(kStereoModeNames));
  return {.mode = *mode,
          .eye_angle_deg = a.eye_angle_deg,
          .zero_plane_mm = a.zero_plane_mm,
          .swap_eyes = a.swap_eyes};
}

void checkEnding(const std::string& file) {
  if (pictureFormatOf(file)) return;
  throw ArgumentError("A picture's name ends in .png or .tif; '" +
                      std::filesystem::path(file).filename().string() +
                      "' does not. Nothing was drawn.");
}

Stored fromArguments(const RenderArguments& a, const Task& task) {
  checkEnding(a.out);
  const StereoOptions stereo = stereoOptions(a);
  const ReliefLook look = reliefLook(a.look);
  Stored state{.surface = openForVerb(a.map, task), .project = {}};
  const Region region = chosenRegion(state.surface, a.region);
  warnIfAliased(state.surface, region);
  Project& p = state.project;
  p = projectOfVerb(a.map, state.surface, region, a.region.gain, task);
  p.look = p.figure.look = look;
  p.stereo = stereo;
  p.picture = PictureChoice{.width_px = a.pixels, .height_px = a.pixels, .scale_bar = a.scale_bar};
  return state;
}

void writeCaptionIfAsked(const RenderArguments& a, const std::string& text, Outcome& outcome) {
  if (a.caption == "-") outcome.lines.push_back(text);
  if (!a.caption.empty() && a.caption != "-") writeTextFile(a.caption, text + "\n");
}

/// A figure that carries its project, drawn again as `figure` draws it.
Outcome drawFigureAgain(const RenderArguments& a, const Stored& stored, const Task& task) {
  const DisplayGuard display;
  const FigureSession session;
  const FigureFacts facts = writeFigure(stored.surface, stored.project, a.out, task);
  Json json;
  json["pixels"] = {facts.width_px, facts.height_px};
  json["mm_per_pixel"] = facts.mm_per_pixel;
  json["level"] = stored.project.region.level.value;
  json["region_mm"] = jsonOf(stored.project.region);
  json["caption"] = facts.caption;
  Outcome outcome{.json = json.dump(2),
                  .lines = {a.out + ": " + std::to_string(facts.width_px) + " x " +
                            std::to_string(facts.height_px) + " pixels, as the figure"},
                  .exit_code = exitCodeAfter(stored.surface)};
  writeCaptionIfAsked(a, facts.caption, outcome);
  return outcome;
}

Outcome runRender(const RenderArguments& a, const Task& task) {
  Stored state =
      a.carrier.given() ? loadStored(a.carrier, a.map.file, task) : fromArguments(a, task);
  if (!state.project.picture) return drawFigureAgain(a, state, task);
  checkEnding(a.out);
  const Surface& surface = state.surface;
  Project& p = state.project;
  const RegionWindow window = windowOf(surface, p.region, p.gain);
  if (p.stereo.zero_plane_mm) {
    checkZeroPlane(*p.stereo.zero_plane_mm, window.min_mm, window.max_mm, p.region.side_mm);
  }
  writeWindowIfAsked(a.region, surface, window);
  const DisplayGuard display;
  const ViewPictureFacts facts = writeViewPicture(surface, window, p, a.out, task);

  Json json;
  json["pixels"] = {facts.width_px, facts.height_px};
  json["mm_per_pixel"] = facts.mm_per_pixel;
  json["level"] = p.region.level.value;
  json["region_mm"] = jsonOf(p.region);
  json["gain"] = window.gain;
  json["stereo"] = name(p.stereo.mode);
  json["view"] = surface.view_name;
  json["view_from_file"] = jsonOf(surface.view_from_file);
  json["caption"] = facts.caption;
  Outcome outcome{
      .json = json.dump(2),
      .lines = {a.out + ": " + std::to_string(facts.width_px) + " x " +
                std::to_string(facts.height_px) + " pixels, " + shortNumber(json["mm_per_pixel"]) +
                " mm each, level " + std::to_string(p.region.level.value)},
      .exit_code = exitCodeAfter(surface)};
  writeCaptionIfAsked(a, facts.caption, outcome);
  return outcome;
}

/// What the image says must not be said again, differently.
void checkUse(const CLI::App& verb, const RenderArguments& a) {
  if (a.carrier.given()) {
    refuseBeside(verb, a.carrier, {});
  } else if (a.map.file.empty()) {
    throw CLI::RequiredError("FILE");
  }
}

}  // namespace

Verb renderVerb() {
  auto arguments = std::make_shared<RenderArguments>();
  return {
      .name = "render",
      .help = "Picture of a region at its level, as the detail view shows it",
      .declare =
          [arguments](CLI::App& verb) {
            addMapOptions(verb, arguments->map);
            addRegionOptions(verb, arguments->region);
            verb.add_option("--stereo", arguments->stereo, "Red/cyan: " + listOf(kStereoModeNames));
            verb.add_flag("--swap-eyes", arguments->swap_eyes, "Left and right eye change places");
            verb.add_option("--eye-angle", arguments->eye_angle_deg,
                            "Angle between the eyes' directions in degrees")
                ->check(CLI::Range(0.5, 10.0));
            verb.add_option("--zero-plane", arguments->zero_plane_mm,
                            "Height of zero parallax in mm; default mid height");
            addLookOptions(verb, arguments->look);
            verb.add_option("--pixels", arguments->pixels, "Width and height of the image")
                ->check(CLI::Range(16, 16384));
            verb.add_flag("--scale-bar", arguments->scale_bar, "Draw a scale bar");
            verb.add_option("-o,--output", arguments->out, "FIG.png or .tif")->required();
            verb.add_option("--caption", arguments->caption,
                            "Also write the text under the picture: FILE, or - for the report");
            addCarrierOptions(verb, arguments->carrier);
            verb.final_callback([arguments, &verb] { checkUse(verb, *arguments); });
          },
      .run = [arguments](const Task& task) { return runRender(*arguments, task); }};
}

}  // namespace relievo::batch
