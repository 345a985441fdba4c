// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <CLI/CLI.hpp>

#include "app/batch/json.h"
#include "app/batch/large.h"
#include "app/batch/state.h"
#include "app/batch/verb.h"
#include "core/base/error.h"
#include "core/io/text_file.h"
#include "core/project/carried_state.h"
#include "core/provenance/caption.h"
#include "core/provenance/embedded.h"
#include "core/provenance/program.h"
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
  bool scale_bar = false;
  std::string out, caption, from_image;
  bool changed_input = false;
};

StereoOptions stereoOptions(const RenderArguments& a) {
  if (a.stereo != "off" && a.stereo != "anaglyph") {
    throw ArgumentError("--stereo: '" + a.stereo + "' is neither off nor anaglyph.");
  }
  return {.mode = a.stereo == "anaglyph" ? StereoMode::anaglyph : StereoMode::off,
          .eye_angle_deg = a.eye_angle_deg,
          .zero_plane_mm = a.zero_plane_mm};
}

LightOptions lightOptions(const RenderArguments& a) {
  if (a.light.empty()) return {};
  const std::vector<double> angles = numberList("--light", a.light, 2);
  if (angles[1] < -90 || angles[1] > 90) {
    throw ArgumentError("--light: the elevation must be between -90 and 90 degrees.");
  }
  return {.azimuth_deg = angles[0], .elevation_deg = angles[1]};
}

/// A surface, and everything that decides its picture.
struct RenderJob {
  Surface surface;
  Provenance provenance;  ///< Has a view and a picture.
};

RenderJob jobFromArguments(const RenderArguments& a, const Task& task) {
  ViewState view{.stereo = stereoOptions(a)};
  view.look.light = lightOptions(a);
  RenderJob job{.surface = openForVerb(a.map, task), .provenance = {}};
  view.region = chosenRegion(job.surface, a.region);
  view.gain = a.region.gain;
  warnIfAliased(job.surface, view.region);
  job.provenance = provenanceOfVerb(a.map, job.surface, a.out, task);
  job.provenance.view = view;
  job.provenance.picture =
      PictureChoice{.width_px = a.pixels, .height_px = a.pixels, .scale_bar = a.scale_bar};
  return job;
}

/// The picture of a stored view, with the state it carries on.
RenderJob jobFromState(const RenderArguments& a, const StoredState& state,
                       const PictureChoice& picture, const Task& task) {
  const Provenance& stored = state.provenance;
  if (stored.view->look.kind != ReliefKind::lit) {
    throw FileError("The view shows the relief as '" + std::string(name(stored.view->look.kind)) +
                    "', which 'render' does not draw. Nothing was made. Open it in the window.");
  }
  RenderJob job{.surface = loadStored(state, task), .provenance = {}};
  job.provenance = provenanceOf(job.surface, stored.options);
  const std::filesystem::path folder = std::filesystem::path(a.out).parent_path();
  job.provenance.input = inputFile(state.input, folder.empty() ? "." : folder, task);
  job.provenance.accept_incomplete = stored.accept_incomplete;
  job.provenance.view = stored.view;
  job.provenance.picture = picture;
  return job;
}

RenderJob jobFromImage(const RenderArguments& a, const Task& task) {
  const StoredState state = storedState(a.from_image, a.map.file, a.changed_input, task);
  const Provenance& stored = state.provenance;
  if (!stored.view || !stored.picture || !stored.figure.empty()) {
    throw FileError(std::filesystem::path(a.from_image).filename().string() +
                    " is not a picture of 'render'. Nothing was made.");
  }
  return jobFromState(a, state, *stored.picture, task);
}

RgbImage draw(const RegionWindow& window, const ViewState& view, const PictureChoice& picture) {
  const DisplayGuard display;
  ReliefScene scene;
  const DepthMap drawn = windowMap(window, 1);
  scene.setSurface(
      {.frame = drawn.frame, .heights_mm = &drawn.heights_mm, .origins = &drawn.origins});
  const Region& region = view.region;
  scene.setCamera({.rect = {.x_mm = region.x_mm,
                            .y_mm = region.y_mm,
                            .width_mm = region.side_mm,
                            .height_mm = region.side_mm},
                   .azimuth_deg = view.azimuth_deg,
                   .elevation_deg = view.elevation_deg});
  scene.setStereo(view.stereo);
  scene.setLight(view.look.light);
  scene.setScaleBar(picture.scale_bar);
  return renderOffscreen(scene, picture.width_px, picture.height_px);
}

bool isFigure(const std::string& picture) {
  const auto state = carriedState(picture);
  return state && isProject(*state);
}

void writeCaptionIfAsked(const RenderArguments& a, const std::string& text, Outcome& outcome) {
  if (a.caption == "-") outcome.lines.push_back(text);
  if (!a.caption.empty() && a.caption != "-") writeTextFile(a.caption, text + "\n");
}

/// A figure that carries its project, drawn again as `figure` draws it.
Outcome runFigure(const RenderArguments& a, const Task& task) {
  const std::filesystem::path picture(a.from_image);
  Project project = projectFromJson(*carriedState(picture), picture.filename().string());
  const FoundInput input = findInput(picture, {.file = project.file, .sha256 = project.sha256},
                                     a.map.file, a.changed_input, task);
  project.file = input.file.string();
  if (input.changed) project.sha256 = sha256OfFile(input.file, task);
  const Stored stored = loadStored(project, task);
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
                            std::to_string(facts.height_px) + " pixels, as " + a.from_image},
                  .exit_code = exitCodeAfter(stored.surface)};
  writeCaptionIfAsked(a, facts.caption, outcome);
  return outcome;
}

Outcome runRender(const RenderArguments& a, const Task& task) {
  if (!a.from_image.empty() && isFigure(a.from_image)) return runFigure(a, task);
  const RenderJob job = a.from_image.empty() ? jobFromArguments(a, task) : jobFromImage(a, task);
  const Surface& surface = job.surface;
  const ViewState& view = *job.provenance.view;
  const Region& region = view.region;
  const RegionWindow window = windowOf(surface, region, view.gain);
  writeWindowIfAsked(a.region, surface, window);
  const RgbImage image = draw(window, view, *job.provenance.picture);
  const std::string text = caption(job.provenance, surface, view, window,
                                   {.mm_per_pixel = region.side_mm / image.width});

  Json json;
  json["pixels"] = {image.width, image.height};
  json["mm_per_pixel"] = region.side_mm / image.width;
  json["level"] = region.level.value;
  json["region_mm"] = jsonOf(region);
  json["gain"] = window.gain;
  json["stereo"] = view.stereo.mode == StereoMode::anaglyph ? "anaglyph" : "off";
  json["view"] = surface.view_name;
  json["view_from_file"] = jsonOf(surface.view_from_file);
  json["caption"] = text;
  writePng(a.out, image,
           {{"Title", std::filesystem::path(job.provenance.input.file).filename().string()},
            {"Description", text},
            {"Software", "relievo " + std::string(programVersion())},
            {std::string(kStateKey), toJson(job.provenance)}});
  Outcome outcome{
      .json = json.dump(2),
      .lines = {a.out + ": " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                " pixels, " + json["mm_per_pixel"].dump() + " mm each, level " +
                std::to_string(region.level.value)},
      .exit_code = exitCodeAfter(surface)};
  writeCaptionIfAsked(a, text, outcome);
  return outcome;
}

/// What the image says must not be said again, differently.
void checkUse(const CLI::App& verb, const RenderArguments& a) {
  if (a.from_image.empty()) {
    if (a.map.file.empty()) throw CLI::RequiredError("FILE");
    return;
  }
  const std::vector<std::string> allowed{"FILE",   "output",        "caption",
                                         "report", "changed-input", "from-image"};
  for (const CLI::Option* option : verb.get_options()) {
    if (option->count() == 0) continue;
    const std::string name = option->get_lnames().empty() ? "FILE" : option->get_lnames()[0];
    if (std::find(allowed.begin(), allowed.end(), name) != allowed.end()) continue;
    throw CLI::ValidationError(
        "--" + name, "the image says this already. Leave it out, or leave out --from-image.");
  }
}

}  // namespace

Verb renderVerb() {
  auto arguments = std::make_shared<RenderArguments>();
  return {.name = "render",
          .help = "Picture of a region at its level, as the detail view shows it",
          .declare =
              [arguments](CLI::App& verb) {
                addMapOptions(verb, arguments->map);
                addRegionOptions(verb, arguments->region);
                verb.add_option("--stereo", arguments->stereo, "off or anaglyph (red/cyan)");
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
                verb.add_option("--from-image", arguments->from_image,
                                "Draw again what this picture of relievo shows; FILE is then found "
                                "by itself, or given");
                verb.add_flag("--changed-input", arguments->changed_input,
                              "With --from-image: take an input whose checksum differs");
                verb.get_option("FILE")->required(false);
                verb.final_callback([arguments, &verb] { checkUse(verb, *arguments); });
              },
          .run = [arguments](const Task& task) { return runRender(*arguments, task); }};
}

}  // namespace relievo::batch
