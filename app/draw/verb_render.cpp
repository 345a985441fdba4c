// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <CLI/CLI.hpp>

#include "app/cli/drawing.h"
#include "app/cli/json.h"
#include "app/cli/large.h"
#include "app/cli/options/eye_angle_range.h"
#include "app/cli/options/look_arguments.h"
#include "app/cli/options/number_option.h"
#include "app/cli/report_text.h"
#include "app/cli/state.h"
#include "app/cli/verb.h"
#include "app/draw/drawing_verbs.h"
#include "core/base/failure.h"
#include "core/base/replaceable.h"
#include "core/file/output_set.h"
#include "core/io/formats/text_file.h"
#include "core/project/shown_lengths.h"
#include "core/session/large/tiled_surface.h"
#include "ui/figure/figure.h"
#include "ui/figure/view_picture.h"
#include "ui/vtk/files/picture_file.h"
#include "ui/vtk/offscreen.h"

namespace relievo::batch {
namespace {

struct RenderArguments {
  MapArguments map;
  RegionArguments region;
  std::string stereo = "off";
  std::optional<double> eye_angle_deg, zero_plane_mm;
  double eyeAngleDeg() const { return eye_angle_deg.value_or(StereoOptions{}.eye_angle_deg); }
  LookArguments look;
  int pixels = 800;
  bool scale_bar = false, swap_eyes = false, both_eyes = false;
  std::string out, caption;
  HostFileArguments host_file;
  // Given beside a state, they take the place of what it says.
  bool stereo_given = false, pixels_given = false, look_given = false;
};

constexpr const char* kStereoWords = "off anaglyph half dubois sidebyside overunder interlaced";
constexpr const char* kEyesOfRender = "a kind of --stereo, or --both-eyes";
constexpr int kLeastPixelsOfTwo = 32, kMostPixelsOfTwo = 8192;

/// Two eyes' pictures in one file, each whole.
bool isTwoPictures(StereoPrint print) {
  return print == StereoPrint::side_by_side || print == StereoPrint::over_under;
}

/// They are a figure that has no marks, `pixels` by `pixels` each; its paper only carries them.
FigureRequest pairOf(const RenderArguments& a, StereoPrint print, const ReliefLook& look) {
  if (a.pixels < kLeastPixelsOfTwo || a.pixels > kMostPixelsOfTwo) {
    throw failure<MessageId::pixels_of_two>(kLeastPixelsOfTwo, kMostPixelsOfTwo);
  }
  constexpr double kPaperMm = 180, kLeastDpi = 30, kMostDpi = 2400;
  const int width_px = print == StereoPrint::side_by_side ? 2 * a.pixels : a.pixels;
  FigureRequest f;
  f.layout = FigureLayout::detail;
  f.dpi = std::clamp(width_px * 25.4 / kPaperMm, kLeastDpi, kMostDpi);
  f.width_mm = width_px * 25.4 / f.dpi;
  f.look = look;
  f.scale_bar = a.scale_bar;
  f.height_bar = f.up_mark = f.window_outline = f.legend = f.letters = f.measurements = false;
  f.stereo = print;
  f.eye_angle_deg = a.eyeAngleDeg();
  f.zero_plane_mm = a.zero_plane_mm;
  f.swap_eyes = a.swap_eyes;
  f.limit_parallax = false;  // What was asked for, as in the other modes.
  return f;
}

StereoOptions stereoOptions(const RenderArguments& a) {
  // Also by the word of `figure`.
  const auto mode =
      a.stereo == name(StereoPrint::grey) ? StereoMode::anaglyph : stereoMode(a.stereo);
  if (!mode) refuseWord("--stereo", a.stereo, kStereoWords);
  return {.mode = *mode,
          .eye_angle_deg = a.eyeAngleDeg(),
          .zero_plane_mm = a.zero_plane_mm,
          .swap_eyes = a.swap_eyes};
}

Stored fromArguments(const RenderArguments& a, const Task& task) {
  requirePictureName(a.out);
  const ReliefLook look = reliefLook(a.look);
  const StereoPrint print = stereoPrint(a.stereo).value_or(StereoPrint::off);
  const StereoOptions stereo = isTwoPictures(print) ? StereoOptions{} : stereoOptions(a);
  const bool eyes = isTwoPictures(print) || stereo.mode != StereoMode::off || a.both_eyes;
  requireUse("--eye-angle", a.eye_angle_deg.has_value(), eyes, kEyesOfRender);
  requireUse("--zero-plane", a.zero_plane_mm.has_value(), eyes, kEyesOfRender);
  requireUse("--swap-eyes", a.swap_eyes, eyes, kEyesOfRender);
  std::optional<FigureRequest> pair;
  if (isTwoPictures(print)) pair = pairOf(a, print, look);
  Stored state{.surface = openForVerb(a.map, task), .project = {}};
  const Region region = chosenRegion(state.surface, a.region);
  warnIfAliased(state.surface, region);
  Project& p = state.project;
  p = projectOfVerb(a.map, state.surface, region, a.region.gain, task);
  p.look = p.figure.look = look;
  if (pair) {
    p.figure = *pair;
    return state;
  }
  p.stereo = stereo;
  p.picture = PictureChoice{.width_px = a.pixels, .height_px = a.pixels, .scale_bar = a.scale_bar};
  return state;
}

/// What is asked for beside a state takes the place of what the state says; it is a picture of the
/// region then, and no figure.
Stored fromState(const RenderArguments& a, const Task& task) {
  Stored state = loadStored(a.host_file, a.map.file, task);
  Project& p = state.project;
  const Region before = p.region;
  const bool chosen = showChosen(state, a.host_file, a.map.view, a.region);
  if (!chosen && !a.stereo_given && !a.pixels_given && !a.look_given && !a.scale_bar) return state;
  requirePictureName(a.out);
  p.look = p.figure.look = reliefLook(a.look, p.look);
  const StereoPrint print = stereoPrint(a.stereo).value_or(StereoPrint::off);
  if (a.stereo_given && isTwoPictures(print)) {
    p.figure = pairOf(a, print, p.look);
    p.picture.reset();
    return state;
  }
  if (a.stereo_given) p.stereo = stereoOptions(a);
  if (a.stereo_given && p.picture) p.picture->eye = FigureEye::both;
  if (!p.picture || p.picture->source != PictureChoice{}.source) {
    p.picture = PictureChoice{.width_px = a.pixels, .height_px = a.pixels};
  }
  if (a.pixels_given) p.picture->width_px = p.picture->height_px = a.pixels;
  if (a.scale_bar) p.picture->scale_bar = true;
  if (p.region != before) p.picture->hand.reset();
  return state;
}

/// What lies beside the picture, then the picture.
void takePlaces(const RenderArguments& a, const std::string& caption, OutputSet& beside,
                OutputSet& picture, const Task& task) {
  if (!a.caption.empty() && a.caption != "-") writeTextFile({a.caption, &beside}, caption + "\n");
  beside.takes(picture);
  task.check();
  beside.commit();
}

/// Two eyes' pictures, or what a figure of ours shows, drawn as `figure` draws it.
CommandResult drawAsFigure(const RenderArguments& a, const Stored& stored, OutputSet& set,
                           const Task& task) {
  const DisplayGuard display;
  const FigureSession session;
  if (a.both_eyes) writeEyes(stored.surface, stored.project, set.file(a.out), task);
  OutputSet picture;
  const FigureFacts facts = writeFigure(stored.surface, stored.project, picture.file(a.out), task);
  takePlaces(a, facts.caption, set, picture, task);
  Json json;
  json["pixels"] = {facts.width_px, facts.height_px};
  json["mm_per_pixel"] = facts.mm_per_pixel;
  json["level"] = stored.project.region.level.value;
  json["region_mm"] = jsonOf(stored.project.region);
  json["gain"] = stored.project.gain;
  json["stereo"] = name(stored.project.figure.stereo);
  json["caption"] = facts.caption;
  CommandResult outcome{.json = reportText(json),
                        .lines = {a.out + ": " + std::to_string(facts.width_px) + " x " +
                                  std::to_string(facts.height_px) + " pixels, " +
                                  (a.host_file.given() ? "as the figure" : "two eyes' pictures")},
                        .exit_code = exitCodeAfter(stored.surface)};
  if (a.caption == "-") outcome.lines.push_back(facts.caption);
  return outcome;
}

CommandResult runRender(const RenderArguments& a, const Task& task) {
  requireReplaceable(a.out);
  if (a.caption != "-") requireReplaceable(a.caption);
  Stored state = a.host_file.given() ? fromState(a, task) : fromArguments(a, task);
  OutputSet set;
  if (!state.project.picture) {
    if (!a.region.window_out.empty()) {
      writeWindowIfAsked(a.region, state.surface,
                         windowOf(state.surface, state.project.region, state.project.gain), set);
    }
    return drawAsFigure(a, state, set, task);
  }
  requirePictureName(a.out);
  const Surface& surface = state.surface;
  Project& p = state.project;
  const RegionWindow window = windowOf(surface, p.region, p.gain);
  if (p.stereo.zero_plane_mm) {
    checkZeroPlane(*p.stereo.zero_plane_mm, window.min_mm, window.max_mm, p.region.side_mm);
  }
  writeWindowIfAsked(a.region, surface, window, set);
  tellRivalry(surface, window, p.look.kind, printed(p.stereo.mode));
  const DisplayGuard display;
  if (a.both_eyes) writeViewEyes(surface, window, p, set.file(a.out), task);
  OutputSet picture;
  const ViewPictureFacts facts = writeViewPicture(surface, window, p, picture.file(a.out), task);
  takePlaces(a, facts.caption, set, picture, task);

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
  CommandResult outcome{.json = reportText(json),
                        .lines = {a.out + ": " + std::to_string(facts.width_px) + " x " +
                                  std::to_string(facts.height_px) + " pixels, " +
                                  ShownLengths(surface).text(facts.mm_per_pixel) + " each, level " +
                                  std::to_string(p.region.level.value)},
                        .exit_code = exitCodeAfter(surface)};
  if (a.caption == "-") outcome.lines.push_back(facts.caption);
  return outcome;
}

VerbFiles filesOf(const RenderArguments& a) {
  VerbFiles files;
  files.readsStateOf(a.host_file, a.map.file);
  files.writes(a.out);
  if (a.both_eyes) {
    for (const auto& eye : viewEyeFiles(a.out)) files.writes(eye);
  }
  files.writes(a.caption);
  files.writesMap(a.region.window_out);
  files.namesMap("--window-out", a.region.window_out);
  return files;
}

/// What the image says must not be said again, differently.
void checkUse(const CLI::App& verb, RenderArguments& a) {
  requireHostFile(a.host_file);
  requireProject(a.host_file);
  const auto given = [&](const char* option) { return verb.get_option(option)->count() > 0; };
  a.stereo_given = given("--stereo");
  a.pixels_given = given("--pixels");
  for (const char* option :
       {"--relief", "--colours", "--light", "--radius", "--range", "--shading"}) {
    a.look_given = a.look_given || given(option);
  }
  if (a.host_file.given()) {
    const bool eyes = (a.stereo_given && a.stereo != name(StereoMode::off)) || a.both_eyes;
    for (const char* option : {"--eye-angle", "--zero-plane", "--swap-eyes"}) {
      requireUse(option, given(option), eyes, kEyesOfRender);
    }
    refuseBeside(verb, a.host_file,
                 {"place", "view", "region", "level", "gain", "window-out", "pixels", "scale-bar",
                  "relief", "colours", "light", "radius", "range", "shading", "stereo", "eye-angle",
                  "zero-plane", "swap-eyes", "both-eyes"});
  } else if (a.map.file.empty()) {
    throw CLI::RequiredError("FILE");
  }
}

}  // namespace

Verb renderVerb() {
  auto arguments = std::make_shared<RenderArguments>();
  return {
      .name = "render",
      .help = helpOfDrawingVerb("render"),
      .declare =
          [arguments](CLI::App& verb) {
            addMapOptions(verb, arguments->map);
            addRegionOptions(verb, arguments->region);
            verb.add_option(
                "--stereo", arguments->stereo,
                std::string("Red and cyan, two pictures, or rows by turns: ") + kStereoWords);
            verb.add_flag("--swap-eyes", arguments->swap_eyes, "Left and right eye change places");
            verb.add_flag("--both-eyes", arguments->both_eyes,
                          "Also write NAME.left.png and NAME.right.png");
            takes(verb.add_option("--eye-angle", arguments->eye_angle_deg,
                                  "Angle between the eyes' directions in degrees"),
                  kEyeAngles);
            takes(verb.add_option("--zero-plane", arguments->zero_plane_mm,
                                  "Height of zero parallax in mm; default mid height"),
                  {.low = -kFarMm, .high = kFarMm, .unit = "mm"});
            addLookOptions(verb, arguments->look);
            takes(verb.add_option("--pixels", arguments->pixels, "Width and height of the image"),
                  {.low = 16, .high = 16384});
            verb.add_flag("--scale-bar", arguments->scale_bar, "Draw a scale bar");
            verb.add_option("-o,--output", arguments->out, "FIG.png or .tif")->required();
            verb.add_option("--caption", arguments->caption,
                            "Also write the text under the picture: FILE, or - for the report");
            addHostFileOptions(verb, arguments->host_file);
            verb.final_callback([arguments, &verb] { checkUse(verb, *arguments); });
          },
      .files = [arguments] { return filesOf(*arguments); },
      .run = [arguments](const Task& task) { return runRender(*arguments, task); }};
}

}  // namespace relievo::batch
