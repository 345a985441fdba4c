// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>

#include "app/cli/drawing.h"
#include "app/cli/json.h"
#include "app/cli/large.h"
#include "app/cli/options/figure_arguments.h"
#include "app/cli/report_text.h"
#include "app/cli/state.h"
#include "app/cli/verb.h"
#include "app/draw/compare_figure.h"
#include "app/draw/drawing_verbs.h"
#include "core/base/failure.h"
#include "core/file/output_set.h"
#include "core/project/caption.h"
#include "core/session/large/tiled_surface.h"
#include "core/session/map_facts.h"
#include "ui/figure/figure.h"

namespace relievo::batch {
namespace {

struct Arguments {
  MapArguments map;
  RegionArguments region;
  FigureArguments figure;
  HostFileArguments host_file;
  std::string out, caption, heights;
  std::string compare;  ///< A picture that is drawn again; empty: one is made.
};

Stored fromArguments(const Arguments& a, const Task& task) {
  const FigureRequest request = figureRequest(a.figure);  // Refused before the work.
  Stored state{.surface = openForVerb(a.map, task), .project = {}};
  state.project = projectOfVerb(a.map, state.surface, chosenRegion(state.surface, a.region),
                                a.region.gain, task);
  state.project.figure = request;
  state.project.measurements = measurements(a.figure);
  return state;
}

/// What is asked for beside a state takes the place of what the state says.
Stored fromState(const Arguments& a, const Task& task) {
  Stored state = loadStored(a.host_file, a.map.file, task);
  Project& p = state.project;
  p.picture.reset();
  showChosen(state, a.host_file, a.map.view, a.region);
  const std::string plotted = p.figure.recording;
  p.figure = figureRequest(a.figure, p.figure);
  if (!plotted.empty() && p.figure.recording == plotted && a.figure.recording.empty()) {
    requireOwnRecording(p, a.host_file, task);
  }
  for (const Measurement& m : measurements(a.figure)) p.measurements.push_back(m);
  return state;
}

Json measurementsJson(const Surface& surface, const Project& project) {
  Json list = Json::array();
  const MapCells cells = mapCells(surface);
  for (const Measurement& m : project.measurements) {
    const Reading reading = read(cells, m);
    Json entry{{"name", m.name}, {"kind", name(m.kind)}};
    for (const Quantity& q : reading.quantities) {
      entry["values"].push_back({{"what", q.title},
                                 {"value", q.value},
                                 {"uncertainty", q.uncertainty},
                                 {"unit", q.unit}});
    }
    entry["not_measured"] = reading.not_measured;
    if (hasPlane(m.kind)) entry["plane"] = planeJson(m);
    list.push_back(entry);
  }
  return list;
}

FigureFiles figureFiles(const Arguments& a) {
  return {.figure = a.out,
          .both_eyes = a.figure.both_eyes,
          .heights = a.heights,
          .caption = a.caption == "-" ? "" : a.caption};  // Shown in any case.
}

CommandResult runFigure(const Arguments& a, const Task& task) {
  if (!a.compare.empty()) return compareFigure(a.host_file, a.map.file, task);
  if (!a.host_file.given() && a.map.file.empty()) {
    throw failure<MessageId::figure_of_nothing>();
  }
  const FigureFiles files = figureFiles(a);
  check(files);  // Refused before the work.
  const Stored state = a.host_file.given() ? fromState(a, task) : fromArguments(a, task);
  const Surface& surface = state.surface;
  const Project& project = state.project;
  warnIfAliased(surface, project.region);
  const Json measured = measurementsJson(surface, project);  // Refused before anything is drawn.
  OutputSet set;
  if (!a.region.window_out.empty()) {
    writeWindowIfAsked(a.region, surface, windowOf(surface, project.region, project.gain), set);
  }
  tellRivalry(surface, windowOf(surface, project.region, project.gain), project.figure.look.kind,
              project.figure.stereo);
  const DisplayGuard display;
  const FigureSession session;
  const FigureWritten written = writeFigureFiles(surface, project, files, task, {}, &set);
  task.check();
  set.commit();
  const FigureFacts& facts = written.facts;
  Json json;
  json["pixels"] = {facts.width_px, facts.height_px};
  json["paper_mm"] = {facts.width_mm, facts.height_mm};
  json["mm_per_pixel"] = facts.mm_per_pixel;
  json["scale_1_to"] = 1 / facts.paper_per_mm;
  json["level"] = project.region.level.value;
  json["region_mm"] = jsonOf(project.region);
  json["layout"] = name(project.figure.layout);
  json["relief"] = name(project.figure.look.kind);
  json["stereo"] = name(project.figure.stereo);
  json["eye_angle_deg"] = facts.eye_angle_deg;
  json["parallax_deg"] = facts.parallax_deg;
  json["measurements"] = measured;
  json["caption"] = facts.caption;
  json["input_sha256"] = project.sha256;
  if (written.eyes) {
    for (const auto& file : written.eyes->files) json["eyes"].push_back(file.string());
    json["eye_angle_deg"] = written.eyes->eye_angle_deg;
    json["parallax_deg"] = written.eyes->parallax_deg;
  }
  return {
      .json = reportText(json),
      .lines = {a.out + ": " + std::to_string(facts.width_px) + " x " +
                    std::to_string(facts.height_px) + " pixels, " + shortNumber(facts.width_mm) +
                    " x " + shortNumber(facts.height_mm) + " mm on paper",
                facts.caption},
      .exit_code = exitCodeAfter(surface)};
}

/// --compare takes the place of -o and of where the state comes from.
void checkCompare(const CLI::App& verb, Arguments& a) {
  if (a.compare.empty()) {
    if (a.out.empty()) throw CLI::RequiredError("--output");
    return;
  }
  for (const auto& [option, text] : {std::pair<const char*, const std::string*>{"-o", &a.out},
                                     {"--caption", &a.caption},
                                     {"--from-image", &a.host_file.from_image},
                                     {"--project", &a.host_file.project}}) {
    if (text->empty()) continue;
    throw ArgumentError(std::string(option) +
                        ": --compare draws again what its picture shows, and writes nothing. "
                        "Nothing was drawn. Leave one of them out.");
  }
  a.host_file.from_image = a.compare;
  refuseBeside(verb, a.host_file, {"compare"});
}

VerbFiles filesOf(const Arguments& a) {
  VerbFiles files;
  files.readsStateOf(a.host_file, a.map.file);
  files.reads(a.figure.recording, "the recording that is read");
  for (const auto& out : namesOf(figureFiles(a))) files.writes(out);
  files.writesMap(a.region.window_out);
  files.namesMap("--window-out", a.region.window_out);
  return files;
}

}  // namespace

Verb figureVerb() {
  auto arguments = std::make_shared<Arguments>();
  return {
      .name = "figure",
      .help = helpOfDrawingVerb("figure"),
      .declare =
          [arguments](CLI::App& verb) {
            addMapOptions(verb, arguments->map);
            addHostFileOptions(verb, arguments->host_file);
            addRegionOptions(verb, arguments->region);
            addFigureOptions(verb, arguments->figure);
            verb.add_option("--caption", arguments->caption, "Also write the caption as text");
            verb.add_option("--heights", arguments->heights,
                            "Also write the region's heights as a 16-bit TIFF");
            verb.add_option("-o,--output", arguments->out, "FIG.png, .tif, .pdf or .svg");
            verb.add_option("--compare", arguments->compare,
                            "Draw this picture of relievo again and compare the pixels; nothing is "
                            "written, exit 5 if any differs");
            verb.final_callback([arguments, &verb] {
              checkCompare(verb, *arguments);
              if (!arguments->compare.empty()) return;
              requireHostFile(arguments->host_file);
              requireProject(arguments->host_file);
              if (!arguments->host_file.given()) return;
              refuseBeside(
                  verb, arguments->host_file,
                  {"place",     "view",       "region",    "level",        "gain",    "window-out",
                   "layout",    "width-mm",   "dpi",       "scale",        "text-pt", "relief",
                   "colours",   "light",      "radius",    "range",        "shading", "stereo",
                   "eye-angle", "zero-plane", "swap-eyes", "any-parallax", "without", "transparent",
                   "recording", "measure",    "heights",   "both-eyes"});
            });
          },
      .files = [arguments] { return filesOf(*arguments); },
      .run = [arguments](const Task& task) { return runFigure(*arguments, task); }};
}

}  // namespace relievo::batch
