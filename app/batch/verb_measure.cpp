// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <CLI/CLI.hpp>
#include <cmath>
#include <utility>

#include "app/batch/json.h"
#include "app/batch/large.h"
#include "app/batch/state.h"
#include "app/batch/verb.h"
#include "core/io/text_file.h"
#include "core/measure/measure_text.h"
#include "core/project/caption.h"
#include "core/provenance/embedded.h"
#include "core/session/map_facts.h"

namespace relievo::batch {
namespace {

struct MeasureArguments {
  MapArguments map;
  /// What was asked for, by kind, each "NAME=X,Y,..." or "X,Y,...".
  std::array<std::vector<std::string>, kMeasureKindNames.size()> places;
  double plane_mm = 0;
  std::string section;  ///< "NX,NY,NZ,OFFSET"
  std::string out, profile_csv, profile_svg, section_csv;
};

/// @throw ArgumentError  no even count of numbers
Measurement measurementFrom(MeasureKind kind, const std::string& text, double plane_mm,
                            std::size_t number) {
  const std::string option = "--" + std::string(name(kind));
  const std::size_t equals = text.find('=');
  const bool named = equals != std::string::npos;
  Measurement m{.name = named ? text.substr(0, equals)
                              : std::string(name(kind)) + " " + std::to_string(number),
                .kind = kind,
                .places = {},
                .plane_mm = kind == MeasureKind::area ? plane_mm : 0};
  const std::string numbers = named ? text.substr(equals + 1) : text;
  const auto count = static_cast<std::size_t>(std::count(numbers.begin(), numbers.end(), ',')) + 1;
  const auto needed = 2 * static_cast<std::size_t>(placesNeeded(kind));
  const bool fits = takesMore(kind) ? count >= needed && count % 2 == 0 : count == needed;
  if (!fits) {
    throw ArgumentError(option + " needs x and y of " + (takesMore(kind) ? "at least " : "") +
                        std::to_string(placesNeeded(kind)) + " places, not '" + numbers + "'.");
  }
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
      list.push_back(measurementFrom(static_cast<MeasureKind>(k), text, a.plane_mm, ++number));
    }
  }
  if (list.empty() && a.section.empty()) {
    throw ArgumentError(
        "There is nothing to measure. Give --point, --distance, --depth, --angle, --profile, "
        "--area or --section.");
  }
  return list;
}

Json pointJson(const SurfacePoint& p) {
  return {{"at_mm", {p.at.x, p.at.y, p.at.z}},
          {"height_uncertainty_mm", p.height_uncertainty_mm},
          {"origin", name(p.origin)}};
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
            " \u00b1 " + shown(q.uncertainty) + " " + std::string(q.unit);
  }
  if (reading.not_measured > 0) {
    line += "; " + shortNumber(100 * reading.not_measured, 3) + " % of it not measured";
  }
  return line;
}

const Measurement& onlyProfile(const std::vector<Measurement>& list, const std::string& option) {
  const Measurement* found = nullptr;
  for (const Measurement& m : list) {
    if (m.kind != MeasureKind::profile) continue;
    if (found != nullptr) throw ArgumentError(option + " is for one --profile; there are more.");
    found = &m;
  }
  if (found == nullptr) throw ArgumentError(option + " needs a --profile.");
  return *found;
}

Json sectionJson(const MeasureArguments& a, const MapCells& map, const std::string& header) {
  const std::vector<double> n = numberList("--section", a.section, 4);
  const std::vector<SectionCurve> curves =
      section(map, {.normal = {n[0], n[1], n[2]}, .offset_mm = n[3]});
  Json list = Json::array();
  for (const SectionCurve& curve : curves) {
    // Each of its points may lie half a cell off, along the curve at its two ends only.
    list.push_back({{"points", curve.points.size()},
                    {"closed", curve.closed},
                    {"length_mm", curve.length_mm},
                    {"uncertainty_mm", map.frame().spacing_mm},
                    {"not_measured", curve.not_measured}});
  }
  if (!a.section_csv.empty()) writeTextFile(a.section_csv, sectionCsv(curves, header));
  return list;
}

Outcome runMeasure(const MeasureArguments& a, const Task& task) {
  const std::vector<Measurement> list = measurements(a);
  if (!a.section_csv.empty() && a.section.empty()) {
    throw ArgumentError("--section-csv needs a --section.");
  }
  if (!a.profile_csv.empty()) onlyProfile(list, "--profile-csv");
  if (!a.profile_svg.empty()) onlyProfile(list, "--profile-svg");
  const Surface surface = openForVerb(a.map, task);
  const MapCells cells = mapCells(surface, task);
  const auto header = [&](const std::string& out) {
    return stateLine(toJson(provenanceOfVerb(a.map, surface, out, task), -1));
  };
  Json json;
  Outcome outcome;
  json["spacing_mm"] = cells.frame().spacing_mm;
  json["measurements"] = Json::array();
  for (const Measurement& m : list) {
    const Reading reading = read(cells, m);
    json["measurements"].push_back(readingJson(m, reading));
    outcome.lines.push_back(lineFor(m, reading));
  }
  if (!a.section.empty()) {
    json["section"] = sectionJson(a, cells, a.section_csv.empty() ? "" : header(a.section_csv));
    outcome.lines.push_back("section: " + std::to_string(json["section"].size()) + " curves");
  }
  if (!a.profile_csv.empty() || !a.profile_svg.empty()) {
    const Measurement& m = onlyProfile(list, "--profile-csv");
    const std::vector<ProfileRow> rows = profile(cells, m.places);
    if (!a.profile_csv.empty()) {
      writeTextFile(a.profile_csv, profileCsv(rows, header(a.profile_csv)));
    }
    if (!a.profile_svg.empty()) {
      writeTextFile(a.profile_svg,
                    profileSvg(rows, surface.info.file.filename().string() + ": " + m.name));
    }
  }
  outcome.json = json.dump(2);
  if (!a.out.empty()) {
    const bool as_json = std::filesystem::path(a.out).extension() == ".json";
    if (as_json) {
      json["provenance"] = Json::parse(toJson(provenanceOfVerb(a.map, surface, a.out, task)));
    }
    writeTextFile(a.out,
                  as_json ? json.dump(2) + "\n" : measurementsCsv(cells, list, header(a.out)));
  }
  return outcome;
}

void declareMeasure(CLI::App& verb, MeasureArguments& a) {
  addMapOptions(verb, a.map);
  constexpr std::array<const char*, kMeasureKindNames.size()> kHelp{
      "X,Y: height of a place (view mm); each of these may be NAME=X,Y and come again",
      "X,Y,X,Y: straight through the air",
      "X,Y,X,Y: height of the second place above the first",
      "X,Y,X,Y,X,Y: angle at the second place",
      "X,Y,X,Y,...: heights along a line",
      "X,Y,X,Y,X,Y,...: area and volume above --plane inside these corners"};
  for (std::size_t k = 0; k < kHelp.size(); ++k) {
    verb.add_option("--" + std::string(kMeasureKindNames[k]), a.places[k], kHelp[k])
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
  }
  verb.add_option("--plane", a.plane_mm, "Height in mm from which the volume of --area counts");
  verb.add_option("--section", a.section,
                  "NX,NY,NZ,OFFSET: where this plane cuts; 0,0,1,H is the contour at H mm");
  verb.add_option("-o,--output", a.out, "List of all as CSV, or as JSON if it ends so");
  verb.add_option("--profile-csv", a.profile_csv, "The profile's heights as CSV");
  verb.add_option("--profile-svg", a.profile_svg, "The profile as a drawing");
  verb.add_option("--section-csv", a.section_csv, "The section's curves as CSV");
}

}  // namespace

Verb measureVerb() {
  auto arguments = std::make_shared<MeasureArguments>();
  return {
      .name = "measure",
      .help = "Points, distances, depths, angles, profiles, areas and sections of the depth map",
      .declare = [arguments](CLI::App& verb) { declareMeasure(verb, *arguments); },
      .run = [arguments](const Task& task) { return runMeasure(*arguments, task); }};
}

}  // namespace relievo::batch
