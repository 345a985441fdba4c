// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <CLI/CLI.hpp>

#include "app/batch/json.h"
#include "app/batch/large.h"
#include "app/batch/state.h"
#include "app/batch/verb.h"
#include "core/base/error.h"
#include "core/io/text_file.h"
#include "core/project/caption.h"
#include "core/provenance/embedded.h"
#include "core/provenance/program.h"
#include "core/relief/relief_image.h"
#include "core/session/tiled_surface.h"
#include "ui/figure/figure.h"
#include "ui/vtk/offscreen.h"
#include "ui/vtk/relief_scene.h"

namespace relievo::batch {
namespace {

struct RenderArguments {
  MapArguments map;
  RegionArguments region;
  std::string stereo = "off";
  double eye_angle_deg = StereoOptions{}.eye_angle_deg;
  std::optional<double> zero_plane_mm;
  std::string light;  ///< "AZIMUTH,ELEVATION"; empty: as in the window.
  int pixels = 800;
  bool scale_bar = false, swap_eyes = false;
  std::string out, caption;
  CarrierArguments carrier;
};

StereoOptions stereoOptions(const RenderArguments& a) {
  const auto mode = stereoMode(a.stereo);
  if (!mode) {
    throw ArgumentError("--stereo: '" + a.stereo + "' is none of off, anaglyph, half and dubois.");
  }
  return {.mode = *mode,
          .eye_angle_deg = a.eye_angle_deg,
          .zero_plane_mm = a.zero_plane_mm,
          .swap_eyes = a.swap_eyes};
}

LightOptions lightOptions(const RenderArguments& a) {
  if (a.light.empty()) return {};
  const std::vector<double> angles = numberList("--light", a.light, 2);
  if (angles[1] < -90 || angles[1] > 90) {
    throw ArgumentError("--light: the elevation must be between -90 and 90 degrees.");
  }
  return {.azimuth_deg = angles[0], .elevation_deg = angles[1]};
}

Stored fromArguments(const RenderArguments& a, const Task& task) {
  const StereoOptions stereo = stereoOptions(a);
  const LightOptions light = lightOptions(a);
  Stored state{.surface = openForVerb(a.map, task), .project = {}};
  const Region region = chosenRegion(state.surface, a.region);
  warnIfAliased(state.surface, region);
  Project& p = state.project;
  p = projectOfVerb(a.map, state.surface, region, a.region.gain, task);
  p.look.light = p.figure.look.light = light;
  p.stereo = stereo;
  p.picture = PictureChoice{.width_px = a.pixels, .height_px = a.pixels, .scale_bar = a.scale_bar};
  return state;
}

RgbImage draw(const RegionWindow& window, const Project& p) {
  const DisplayGuard display;
  ReliefScene scene;
  const DepthMap drawn = windowMap(window, 1);
  std::vector<std::uint8_t> colours;
  if (p.look.kind != ReliefKind::lit) colours = reliefColours(reliefValues(drawn, p.look), p.look);
  scene.setSurface({.frame = drawn.frame,
                    .heights_mm = &drawn.heights_mm,
                    .origins = &drawn.origins,
                    .colours = colours.empty() ? nullptr : &colours,
                    .lit = isLit(p.look.kind)});
  const Region& region = p.region;
  scene.setCamera({.rect = {.x_mm = region.x_mm,
                            .y_mm = region.y_mm,
                            .width_mm = region.side_mm,
                            .height_mm = region.side_mm},
                   .azimuth_deg = p.azimuth_deg,
                   .elevation_deg = p.elevation_deg});
  scene.setStereo(p.stereo);
  scene.setLight(p.look.light);
  scene.setScaleBar(p.picture->scale_bar);
  return renderOffscreen(scene, p.picture->width_px, p.picture->height_px);
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
  const Surface& surface = state.surface;
  Project& p = state.project;
  p.made = madeText(surface);
  const RegionWindow window = windowOf(surface, p.region, p.gain);
  writeWindowIfAsked(a.region, surface, window);
  const RgbImage image = draw(window, p);
  const double mm_per_pixel = p.region.side_mm / std::min(image.width, image.height);
  const std::string text = captionOf(p, surface, window, pictureFacts(p, mm_per_pixel));

  Json json;
  json["pixels"] = {image.width, image.height};
  json["mm_per_pixel"] = mm_per_pixel;
  json["level"] = p.region.level.value;
  json["region_mm"] = jsonOf(p.region);
  json["gain"] = window.gain;
  json["stereo"] = name(p.stereo.mode);
  json["view"] = surface.view_name;
  json["view_from_file"] = jsonOf(surface.view_from_file);
  json["caption"] = text;
  writePng(a.out, image,
           {{"Title", std::filesystem::path(p.file).filename().string()},
            {"Description", text},
            {"Software", "relievo " + std::string(programVersion())},
            {std::string(kStateKey), projectJson(relativeTo(p, a.out))}});
  Outcome outcome{
      .json = json.dump(2),
      .lines = {a.out + ": " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                " pixels, " + shortNumber(json["mm_per_pixel"]) + " mm each, level " +
                std::to_string(p.region.level.value)},
      .exit_code = exitCodeAfter(surface)};
  writeCaptionIfAsked(a, text, outcome);
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
            verb.add_option("--stereo", arguments->stereo, "Red/cyan: off anaglyph half dubois");
            verb.add_flag("--swap-eyes", arguments->swap_eyes, "Left and right eye change places");
            verb.add_option("--eye-angle", arguments->eye_angle_deg,
                            "Angle between the eyes' directions in degrees")
                ->check(CLI::Range(0.5, 10.0));
            verb.add_option("--zero-plane", arguments->zero_plane_mm,
                            "Height of zero parallax in mm; default mid height");
            verb.add_option("--light", arguments->light,
                            "AZIMUTH,ELEVATION in degrees; 315,45 is the upper left");
            verb.add_option("--pixels", arguments->pixels, "Width and height of the image")
                ->check(CLI::Range(16, 16384));
            verb.add_flag("--scale-bar", arguments->scale_bar, "Draw a scale bar");
            verb.add_option("-o,--output", arguments->out, "FIG.png")->required();
            verb.add_option("--caption", arguments->caption,
                            "Also write the text under the picture: FILE, or - for the report");
            addCarrierOptions(verb, arguments->carrier);
            verb.final_callback([arguments, &verb] { checkUse(verb, *arguments); });
          },
      .run = [arguments](const Task& task) { return runRender(*arguments, task); }};
}

}  // namespace relievo::batch
