// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>

#include "app/batch/json.h"
#include "app/batch/large.h"
#include "app/batch/verb.h"
#include "core/base/error.h"
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
  int pixels = 800;
  bool scale_bar = false;
  std::string from_image;
  std::string out;
};

StereoOptions stereoOptions(const RenderArguments& a) {
  if (a.stereo != "off" && a.stereo != "anaglyph") {
    throw ArgumentError("--stereo: '" + a.stereo + "' is neither off nor anaglyph.");
  }
  return {.mode = a.stereo == "anaglyph" ? StereoMode::anaglyph : StereoMode::off,
          .eye_angle_deg = a.eye_angle_deg,
          .zero_plane_mm = a.zero_plane_mm};
}

/// What a picture of ours shows, drawn again: its state is that of a figure.
Outcome runFromImage(const RenderArguments& a, const Task& task) {
  if (!a.map.file.empty()) {
    throw ArgumentError("Give FILE or --from-image, not both. Nothing was drawn.");
  }
  const Stored stored = loadFromImage(a.from_image, task);
  const DisplayGuard display;
  const FigureSession session;
  const FigureFacts facts = writeFigure(stored.surface, stored.project, a.out, task);
  Json json;
  json["pixels"] = {facts.width_px, facts.height_px};
  json["mm_per_pixel"] = facts.mm_per_pixel;
  json["level"] = stored.project.region.level.value;
  json["region_mm"] = jsonOf(stored.project.region);
  return {.json = json.dump(2),
          .lines = {a.out + ": " + std::to_string(facts.width_px) + " x " +
                    std::to_string(facts.height_px) + " pixels, as " + a.from_image},
          .exit_code = stored.input_changed ? 5 : 0};
}

Outcome runRender(const RenderArguments& a, const Task& task) {
  if (!a.from_image.empty()) return runFromImage(a, task);
  if (a.map.file.empty()) throw ArgumentError("FILE is missing. Nothing was drawn.");
  const StereoOptions stereo = stereoOptions(a);
  const Surface surface = openForVerb(a.map, task);
  const Region region = chosenRegion(surface, a.region);
  warnIfAliased(surface, region);
  const RegionWindow window = windowOf(surface, region, a.region.gain);
  writeWindowIfAsked(a.region, surface, window);

  const DisplayGuard display;
  ReliefScene scene;
  const DepthMap drawn = windowMap(window, 1);
  scene.setSurface(
      {.frame = drawn.frame, .heights_mm = &drawn.heights_mm, .origins = &drawn.origins});
  scene.setCamera({.rect = {.x_mm = region.x_mm,
                            .y_mm = region.y_mm,
                            .width_mm = region.side_mm,
                            .height_mm = region.side_mm}});
  scene.setStereo(stereo);
  scene.setScaleBar(a.scale_bar);
  const RgbImage image = renderOffscreen(scene, a.pixels, a.pixels);

  Json json;
  json["pixels"] = {image.width, image.height};
  json["mm_per_pixel"] = region.side_mm / image.width;
  json["level"] = region.level.value;
  json["region_mm"] = jsonOf(region);
  json["gain"] = window.gain;
  json["stereo"] = a.stereo;
  json["view"] = surface.view_name;
  json["view_from_file"] = jsonOf(surface.view_from_file);
  const std::string text = json.dump(2);
  writePng(a.out, image,
           {{"Title", std::filesystem::path(a.map.file).filename().string()},
            {"Software", std::string("relievo ") + RELIEVO_VERSION_STRING},
            {"relievo:state", text}});
  return {.json = text,
          .lines = {a.out + ": " + std::to_string(image.width) + " x " +
                    std::to_string(image.height) + " pixels, " + json["mm_per_pixel"].dump() +
                    " mm each, level " + std::to_string(region.level.value)},
          .exit_code = exitCodeAfter(surface)};
}

}  // namespace

Verb renderVerb() {
  auto arguments = std::make_shared<RenderArguments>();
  return {.name = "render",
          .help = "Picture of a region at its level, as the detail view shows it",
          .declare =
              [arguments](CLI::App& verb) {
                addMapOptions(verb, arguments->map);
                verb.get_option("FILE")->required(false);
                verb.add_option("--from-image", arguments->from_image,
                                "Draw again what a figure shows, from the state it carries");
                addRegionOptions(verb, arguments->region);
                verb.add_option("--stereo", arguments->stereo, "off or anaglyph (red/cyan)");
                verb.add_option("--eye-angle", arguments->eye_angle_deg,
                                "Angle between the eyes' directions in degrees")
                    ->check(CLI::Range(0.5, 10.0));
                verb.add_option("--zero-plane", arguments->zero_plane_mm,
                                "Height of zero parallax in mm; default mid height");
                verb.add_option("--pixels", arguments->pixels, "Width and height of the image")
                    ->check(CLI::Range(16, 16384));
                verb.add_flag("--scale-bar", arguments->scale_bar, "Draw a scale bar");
                verb.add_option("-o,--output", arguments->out, "FIG.png")->required();
              },
          .run = [arguments](const Task& task) { return runRender(*arguments, task); }};
}

}  // namespace relievo::batch
