// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <CLI/CLI.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "app/cli/json.h"
#include "app/cli/large.h"
#include "app/cli/options/look_arguments.h"
#include "app/cli/options/number_option.h"
#include "app/cli/report_text.h"
#include "app/cli/state.h"
#include "app/cli/verb.h"
#include "core/base/failure.h"
#include "core/file/output_set.h"
#include "core/io/formats/text_file.h"
#include "core/measure/measure_text.h"
#include "core/project/caption.h"
#include "core/provenance/embedded.h"
#include "core/provenance/name_text.h"
#include "core/provenance/set_mark.h"
#include "core/session/map_facts.h"

namespace relievo::batch {
namespace {

struct MeasureArguments {
  MapArguments map;
  /// What was asked for, by kind, each "NAME=X,Y,..." or "X,Y,..."; sections "NX,NY,NZ,OFFSET".
  std::array<std::vector<std::string>, kMeasureKindNames.size()> places;
  std::optional<double> plane_mm;
  std::string out, profile_csv, profile_svg, section_csv, section_svg;
};

/// @throw ArgumentError  no even count of numbers, or a name without a letter
Measurement measurementFrom(MeasureKind kind, const std::string& text, double plane_mm,
                            std::size_t number) {
  const std::string option = "--" + std::string(name(kind));
  const std::size_t equals = text.find('=');
  const bool named = equals != std::string::npos;
  requireUse(option.c_str(), named, text.find_first_not_of(" \t") != equals, "a NAME before '='");
  Measurement m{.name = named ? text.substr(0, equals)
                              : std::string(name(kind)) + " " + std::to_string(number),
                .kind = kind,
                .places = {},
                .plane_mm = kind == MeasureKind::area ? plane_mm : 0};
  const std::string numbers = named ? text.substr(equals + 1) : text;
  if (kind == MeasureKind::section) {
    const std::vector<double> plane = numberList(option, numbers, 4);
    m.normal = {plane[0], plane[1], plane[2]};
    m.plane_mm = plane[3];
    return m;
  }
  const auto count = static_cast<std::size_t>(std::count(numbers.begin(), numbers.end(), ',')) + 1;
  const auto needed = 2 * static_cast<std::size_t>(placesNeeded(kind));
  const bool fits = takesMore(kind) ? count >= needed && count % 2 == 0 : count == needed;
  if (!fits && takesMore(kind)) {
    throw failure<MessageId::measure_needs_more_places>(option, placesNeeded(kind), numbers);
  }
  if (!fits) throw failure<MessageId::measure_needs_places>(option, placesNeeded(kind), numbers);
  const std::vector<double> values = numberList(option, numbers, count);
  for (std::size_t i = 0; i < values.size(); i += 2) {
    m.places.push_back({.x = values[i], .y = values[i + 1]});
  }
  return m;
}

std::vector<Measurement> measurements(const MeasureArguments& a) {
  std::vector<Measurement> list;
  for (std::size_t k = 0; k < a.places.size(); ++k) {
    std::size_t number = 0;
    for (const std::string& text : a.places[k]) {
      list.push_back(
          measurementFrom(static_cast<MeasureKind>(k), text, a.plane_mm.value_or(0), ++number));
    }
  }
  if (list.empty()) {
    throw failure<MessageId::measure_nothing>();
  }
  return list;
}

Json pointJson(const SurfacePoint& p) {
  return {{"at_mm", {p.at.x, p.at.y, p.at.z}},
          {"height_uncertainty_mm", p.height_uncertainty_mm},
          {"origin", name(p.origin)}};
}

Json curvesJson(const Reading& reading) {
  Json list = Json::array();
  for (const SectionCurve& curve : reading.curves) {
    list.push_back({{"points", curve.points.size()},
                    {"closed", curve.closed},
                    {"length_mm", curve.length_mm},
                    {"uncertainty_mm", curve.length_off_mm},
                    {"not_measured", curve.not_measured}});
  }
  return list;
}

Json readingJson(const Measurement& m, const Reading& reading) {
  Json json{{"name", m.name}, {"kind", name(m.kind)}};
  json["quantities"] = Json::array();
  for (const Quantity& q : reading.quantities) {
    json["quantities"].push_back({{"quantity", q.title},
                                  {"value", q.value},
                                  {"uncertainty", q.uncertainty},
                                  {"unit", q.unit}});
  }
  json["points"] = Json::array();
  for (const SurfacePoint& p : reading.points) json["points"].push_back(pointJson(p));
  if (m.kind == MeasureKind::area) json["plane_mm"] = m.plane_mm;
  if (m.kind == MeasureKind::section) {
    json["plane"] = planeJson(m);
    json["curves"] = curvesJson(reading);
  }
  json["not_measured"] = reading.not_measured;
  return json;
}

/// To the nearest nanometre, for people; files keep every digit.
std::string shown(double value) {
  return shortNumber(std::round(value * 1e6) / 1e6 + 0.0, 7);  // + 0.0: no "-0".
}

std::string lineFor(const Measurement& m, const Reading& reading) {
  std::string line = m.name + ":";
  for (const Quantity& q : reading.quantities) {
    line += (line.back() == ':' ? " " : ", ") + std::string(q.title) + " " + shown(q.value) +
            " \u00b1 " + shortNumber(q.uncertainty, 4) + " " + std::string(q.unit);
  }
  if (!reading.curves.empty()) line += "; curves: " + std::to_string(reading.curves.size());
  if (hasPlane(m.kind)) line += "; plane " + planeText(m);
  if (reading.not_measured > 0) {
    line += "; " + shortNumber(100 * reading.not_measured, 3) + " % of it not measured";
  }
  return line;
}

/// @throw ArgumentError  none of the kind, or more than one
void onlyOne(const std::vector<Measurement>& list, MeasureKind kind, const std::string& option) {
  const auto found =
      std::count_if(list.begin(), list.end(), [&](const Measurement& m) { return m.kind == kind; });
  if (found > 1) {
    throw failure<MessageId::measure_for_one>(option, name(kind));
  }
  if (found == 0) throw failure<MessageId::measure_needs_one>(option, name(kind));
}

/// Asked for with files that nobody could tell apart by their names otherwise.
void checkEnding(const std::string& option, const std::string& file,
                 const std::vector<std::string>& endings) {
  if (file.empty()) return;
  const std::string extension = std::filesystem::path(file).extension().string();
  if (std::find(endings.begin(), endings.end(), extension) != endings.end()) return;
  std::string list;
  for (const std::string& ending : endings) list += (list.empty() ? "" : " or ") + ending;
  throw failure<MessageId::measure_name>(option, list, file);
}

void checkFiles(const MeasureArguments& a, const std::vector<Measurement>& list) {
  checkEnding("--output", a.out, {".csv", ".json"});
  checkEnding("--profile-csv", a.profile_csv, {".csv"});
  checkEnding("--profile-svg", a.profile_svg, {".svg"});
  checkEnding("--section-csv", a.section_csv, {".csv"});
  checkEnding("--section-svg", a.section_svg, {".svg"});
  using enum MeasureKind;
  const bool areas =
      std::any_of(list.begin(), list.end(), [](const Measurement& m) { return m.kind == area; });
  requireUse("--plane", a.plane_mm.has_value(), areas, "--area");
  if (!a.profile_csv.empty()) onlyOne(list, profile, "--profile-csv");
  if (!a.profile_svg.empty()) onlyOne(list, profile, "--profile-svg");
  if (!a.section_csv.empty()) onlyOne(list, section, "--section-csv");
  if (!a.section_svg.empty()) onlyOne(list, section, "--section-svg");
}

/// The state that a file carries.
using StateFor = std::function<std::string(const std::string& out)>;

void writeProfileFiles(const MeasureArguments& a, const MapCells& cells, const Measurement& m,
                       const std::string& title, const StateFor& state, OutputSet& set) {
  if (a.profile_csv.empty() && a.profile_svg.empty()) return;
  const std::vector<ProfileRow> rows = profile(cells, m.places);
  if (!a.profile_csv.empty()) {
    writeTextFile(set.file(a.profile_csv), profileCsv(rows, stateLine(state(a.profile_csv))));
  }
  if (!a.profile_svg.empty()) {
    writeTextFile(set.file(a.profile_svg),
                  withState(profileSvg(rows, title), state(a.profile_svg)));
  }
}

void writeSectionFiles(const MeasureArguments& a, const Reading& reading, const Measurement& m,
                       const std::string& title, const StateFor& state, OutputSet& set) {
  if (!a.section_csv.empty()) {
    writeTextFile(set.file(a.section_csv),
                  sectionCsv(reading.curves, stateLine(state(a.section_csv))));
  }
  if (!a.section_svg.empty()) {
    writeTextFile(set.file(a.section_svg),
                  withState(sectionSvg(reading.curves, planeOf(m), title), state(a.section_svg)));
  }
}

CommandResult runMeasure(const MeasureArguments& a, const Task& task) {
  const std::vector<Measurement> list = measurements(a);
  checkFiles(a, list);
  const Surface surface = openForVerb(a.map, task);
  const MapCells cells = mapCells(surface, task);
  Json json;
  CommandResult outcome;
  json["spacing_mm"] = cells.frame().spacing_mm;
  json["measurements"] = Json::array();
  std::vector<Reading> readings;
  for (const Measurement& m : list) {
    readings.push_back(read(cells, m));
    json["measurements"].push_back(readingJson(m, readings.back()));
    outcome.lines.push_back(lineFor(m, readings.back()));
  }
  const std::string shown = reportText(json);
  std::map<std::filesystem::path, std::string> states;  // Of each folder: names are relative to it.
  const auto state = [&](const std::string& out) {
    std::string& text = states[std::filesystem::path(out).parent_path()];
    if (!text.empty()) return text;
    Provenance made = provenanceOfVerb(a.map, surface, out, task);
    Provenance anywhere = made;  // The folder is no part of what is shown.
    anywhere.input.file.clear();
    made.made = markedMade(made.made, setMark(toJson(anywhere, -1) + shown));
    return text = toJson(made, -1);
  };
  OutputSet set;
  // Only after all could be read.
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string title =
        escapedName(surface.info.file.filename().string()) + ": " + list[i].name;
    if (list[i].kind == MeasureKind::profile)
      writeProfileFiles(a, cells, list[i], title, state, set);
    if (list[i].kind == MeasureKind::section) {
      writeSectionFiles(a, readings[i], list[i], title, state, set);
    }
  }
  outcome.json = reportText(json);
  if (!a.out.empty()) {
    const bool as_json = std::filesystem::path(a.out).extension() == ".json";
    if (as_json) {
      json["provenance"] = Json::parse(state(a.out));
    }
    writeTextFile(set.file(a.out), as_json ? reportText(json) + "\n"
                                           : measurementsCsv(cells, list, stateLine(state(a.out))));
  }
  set.commit();
  return outcome;
}

VerbFiles filesOf(const MeasureArguments& a) {
  VerbFiles files;
  files.reads(a.map.file);
  for (const std::string& out :
       {a.out, a.profile_csv, a.profile_svg, a.section_csv, a.section_svg}) {
    files.writes(out);
  }
  return files;
}

void declareMeasure(CLI::App& verb, MeasureArguments& a) {
  addMapOptions(verb, a.map);
  constexpr std::array<const char*, kMeasureKindNames.size()> kHelp{
      "X,Y: height of a place (view mm); each of these may be NAME=X,Y and come again",
      "X,Y,X,Y: straight through the air",
      "X,Y,X,Y: height of the second place above the first",
      "X,Y,X,Y,X,Y: angle at the second place",
      "X,Y,X,Y,...: heights along a line",
      "X,Y,X,Y,X,Y,...: area and volume above --plane inside these corners",
      "NX,NY,NZ,OFFSET: where this plane cuts; 0,0,1,H is the contour at H mm"};
  for (std::size_t k = 0; k < kHelp.size(); ++k) {
    verb.add_option("--" + std::string(kMeasureKindNames[k]), a.places[k], kHelp[k])
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
  }
  takes(
      verb.add_option("--plane", a.plane_mm, "Height in mm from which the volume of --area counts"),
      {.low = -kFarMm, .high = kFarMm, .unit = "mm"});
  verb.add_option("-o,--output", a.out, "List of all as CSV, or as JSON if it ends so");
  verb.add_option("--profile-csv", a.profile_csv, "The profile's heights as CSV");
  verb.add_option("--profile-svg", a.profile_svg, "The profile as a drawing");
  verb.add_option("--section-csv", a.section_csv, "The section's curves as CSV");
  verb.add_option("--section-svg", a.section_svg, "The section as a drawing");
}

}  // namespace

Verb measureVerb() {
  auto arguments = std::make_shared<MeasureArguments>();
  return {
      .name = "measure",
      .help = "Points, distances, depths, angles, profiles, areas and sections of the depth map",
      .declare = [arguments](CLI::App& verb) { declareMeasure(verb, *arguments); },
      .files = [arguments] { return filesOf(*arguments); },
      .run = [arguments](const Task& task) { return runMeasure(*arguments, task); }};
}

}  // namespace relievo::batch
