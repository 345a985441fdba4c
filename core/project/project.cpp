// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/project.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/depth/point_rule.h"
#include "core/io/text_file.h"

namespace relievo {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 4> kHoleRuleNames{"base", "interpolate", "membrane", "none"};
constexpr std::array<const char*, 7> kRuleNames{"front", "second", "topmean",  "median",
                                                "mean",  "splat",  "quadratic"};

constexpr std::size_t kMostProjectBytes = 64U << 20U;
constexpr int kDeepest = 64;  // Writing recurses.

template <class Change>
void forEachFile(Project& project, const Change& change) {
  change(project.file);
  for (InputFile& recording : project.recordings) change(recording.file);
}

template <class T>
Json optionalJson(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

template <class T>
std::optional<T> optionalFrom(const Json& json, const char* key) {
  if (!json.contains(key) || json.at(key).is_null()) return std::nullopt;
  return json.at(key).get<T>();
}

/// A word of a list, by its place; what a newer version may write is refused by name.
template <class Enum, class Names>
Enum wordFrom(const Json& json, const char* key, const Names& names, Enum fallback) {
  if (!json.contains(key)) return fallback;
  const auto word = json.at(key).get<std::string>();
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end()) {
    throw FileError("'" + word + "' is not a known value of '" + std::string(key) + "'.");
  }
  return static_cast<Enum>(found - names.begin());
}

Json optionsJson(const SurfaceOptions& o) {
  Json json;
  json["unit"] = o.unit ? Json(name(*o.unit)) : Json(nullptr);
  json["unit_source"] = name(o.unit_source);
  if (o.view) {
    json["view"] = {{"name", o.view->name},
                    {"rotation", optionalJson(o.view->rotation)},
                    {"turn_deg", o.view->turn_deg}};
  } else {
    json["view"] = nullptr;
  }
  json["cells"] = optionalJson(o.cells);
  json["spacing_mm"] = optionalJson(o.spacing_mm);
  json["engine"] = o.engine;
  json["rule"] = nullptr;
  for (const char* rule : kRuleNames) {
    if (o.rule && pointRule(rule) == o.rule) json["rule"] = rule;
  }
  json["holes"] = {{"rule", kHoleRuleNames[static_cast<std::size_t>(o.holes.rule)]}};
  // JSON has no infinity; no limit is written as none.
  if (std::isfinite(o.holes.max_area_mm2)) json["holes"]["max_area_mm2"] = o.holes.max_area_mm2;
  json["factor"] = o.pyramid.factor;
  return json;
}

SurfaceOptions optionsFrom(const Json& json) {
  SurfaceOptions o;
  if (const auto unit = optionalFrom<std::string>(json, "unit")) {
    o.unit = lengthUnit(*unit);
    if (!o.unit) throw FileError("'" + *unit + "' is not a known unit.");
  }
  constexpr std::array<const char*, 4> kSources{"given", "file", "remembered", "assumed"};
  o.unit_source = wordFrom(json, "unit_source", kSources, UnitSource::given);
  if (json.contains("view") && !json.at("view").is_null()) {
    const Json& view = json.at("view");
    o.view =
        ViewChoice{view.at("name").get<std::string>(), optionalFrom<Rotation>(view, "rotation"),
                   view.value("turn_deg", std::array<double, 3>{})};
  }
  o.cells = optionalFrom<int>(json, "cells");
  o.spacing_mm = optionalFrom<double>(json, "spacing_mm");
  o.engine = json.value("engine", o.engine);
  if (o.engine != "cpu" && o.engine != "depthbuffer") {
    throw FileError("'" + o.engine + "' is not a known engine.");
  }
  if (const auto rule = optionalFrom<std::string>(json, "rule")) {
    o.rule = pointRule(*rule);
    if (!o.rule) throw FileError("'" + *rule + "' is not a known rule.");
  }
  if (json.contains("holes")) {
    const Json& holes = json.at("holes");
    o.holes.rule = wordFrom(holes, "rule", kHoleRuleNames, HoleRule::base);
    o.holes.max_area_mm2 = holes.value("max_area_mm2", std::numeric_limits<double>::infinity());
  }
  o.pyramid.factor = json.value("factor", o.pyramid.factor);
  return o;
}

Json regionJson(const Region& r, double gain) {
  return {{"x_mm", r.x_mm},
          {"y_mm", r.y_mm},
          {"side_mm", r.side_mm},
          {"level", r.level.value},
          {"gain", gain}};
}

Region regionFrom(const Json& json) {
  return {json.at("x_mm").get<double>(), json.at("y_mm").get<double>(),
          json.at("side_mm").get<double>(), Level{json.at("level").get<int>()}};
}

Json lookJson(const ReliefLook& look) {
  return {{"kind", name(look.kind)},
          {"colours", name(look.colours)},
          {"light_azimuth_deg", look.light.azimuth_deg},
          {"light_elevation_deg", look.light.elevation_deg},
          {"radius_mm", look.radius_mm},
          {"range", optionalJson(look.range)}};
}

ReliefLook lookFrom(const Json& json) {
  ReliefLook look;
  look.kind = wordFrom(json, "kind", kReliefKindNames, look.kind);
  look.colours = wordFrom(json, "colours", kColourMapNames, look.colours);
  look.light.azimuth_deg = json.value("light_azimuth_deg", look.light.azimuth_deg);
  look.light.elevation_deg = json.value("light_elevation_deg", look.light.elevation_deg);
  look.radius_mm = json.value("radius_mm", look.radius_mm);
  look.range = optionalFrom<std::array<double, 2>>(json, "range");
  return look;
}

/// Calls visit(key, field) for every plain field of a figure: written and read by one list.
template <class Figure, class Visit>
void forEachField(Figure& f, const Visit& visit) {
  visit("width_mm", f.width_mm);
  visit("dpi", f.dpi);
  visit("text_pt", f.text_pt);
  visit("scale_bar", f.scale_bar);
  visit("height_bar", f.height_bar);
  visit("up_mark", f.up_mark);
  visit("window_outline", f.window_outline);
  visit("hatch", f.hatch);
  visit("legend", f.legend);
  visit("letters", f.letters);
  visit("measurements", f.measurements);
  visit("transparent", f.transparent);
  visit("eye_angle_deg", f.eye_angle_deg);
  visit("swap_eyes", f.swap_eyes);
  visit("limit_parallax", f.limit_parallax);
  visit("recording", f.recording);
}

Json figureJson(const FigureRequest& f) {
  Json json;
  json["layout"] = name(f.layout);
  json["stereo"] = name(f.stereo);
  json["scale_1_to"] = optionalJson(f.scale_1_to);
  json["zero_plane_mm"] = optionalJson(f.zero_plane_mm);
  forEachField(f, [&](const char* key, const auto& field) { json[key] = field; });
  json["look"] = lookJson(f.look);
  return json;
}

FigureRequest figureFrom(const Json& json) {
  FigureRequest f;
  f.layout = wordFrom(json, "layout", kFigureLayoutNames, f.layout);
  f.stereo = wordFrom(json, "stereo", kStereoPrintNames, f.stereo);
  f.scale_1_to = optionalFrom<double>(json, "scale_1_to");
  f.zero_plane_mm = optionalFrom<double>(json, "zero_plane_mm");
  forEachField(f, [&](const char* key, auto& field) { field = json.value(key, field); });
  if (json.contains("look")) f.look = lookFrom(json.at("look"));
  return f;
}

Json measurementJson(const Measurement& m) {
  Json places = Json::array();
  for (const PlaceMm& place : m.places) places.push_back({place.x, place.y});
  return {
      {"name", m.name}, {"kind", name(m.kind)}, {"places_mm", places}, {"plane_mm", m.plane_mm}};
}

Measurement measurementFrom(const Json& json) {
  Measurement m;
  m.name = json.at("name").get<std::string>();
  m.kind = wordFrom(json, "kind", kMeasureKindNames, m.kind);
  for (const Json& place : json.at("places_mm")) {
    m.places.push_back({.x = place.at(0).get<double>(), .y = place.at(1).get<double>()});
  }
  m.plane_mm = json.value("plane_mm", 0.0);
  return m;
}

Json pathJson(const CameraPath& path) {
  Json keys = Json::array();
  for (const KeyView& key : path.keys) {
    keys.push_back({{"t_s", key.t_s}, {"view", Json::parse(toText(key.view))}});
  }
  return {{"name", path.name}, {"keys", keys}};
}

CameraPath pathFrom(const Json& json) {
  CameraPath path{json.at("name").get<std::string>(), {}};
  for (const Json& key : json.at("keys")) {
    try {
      path.keys.push_back({key.at("t_s").get<double>(), viewFromText(key.at("view").dump())});
    } catch (const ArgumentError& error) {
      throw FileError(error.what());
    }
  }
  return path;
}

Project projectFrom(const Json& json) {
  if (!json.is_object() || !json.contains("relievo_project")) {
    throw FileError("There is no 'relievo_project' in it.");
  }
  const int schema = json.at("relievo_project").get<int>();
  if (schema < 1 || schema > kProjectSchema) {
    throw FileError("It is of schema " + std::to_string(schema) + "; this version reads up to " +
                    std::to_string(kProjectSchema) + ".");
  }
  Project p;
  p.version = json.value("version", std::string());
  p.file = json.at("input").at("file").get<std::string>();
  p.sha256 = json.at("input").value("sha256", std::string());
  p.options = optionsFrom(json.at("depth_map"));
  p.region = regionFrom(json.at("region"));
  p.gain = json.at("region").value("gain", 1.0);
  if (json.contains("look")) p.look = lookFrom(json.at("look"));
  if (json.contains("stereo")) {
    const Json& stereo = json.at("stereo");
    p.stereo.mode = stereo.value("on", false) ? StereoMode::anaglyph : StereoMode::off;
    p.stereo.eye_angle_deg = stereo.value("eye_angle_deg", p.stereo.eye_angle_deg);
    p.stereo.zero_plane_mm = optionalFrom<double>(stereo, "zero_plane_mm");
  }
  if (json.contains("figure")) p.figure = figureFrom(json.at("figure"));
  for (const Json& place : json.value("places", Json::array())) {
    p.places.push_back(
        {place.at("name").get<std::string>(), regionFrom(place), place.value("gain", 1.0)});
  }
  for (const Json& m : json.value("measurements", Json::array())) {
    p.measurements.push_back(measurementFrom(m));
  }
  for (const Json& file : json.value("recordings", Json::array())) {
    p.recordings.push_back({.file = file.at("file").get<std::string>(),
                            .sha256 = file.at("sha256").get<std::string>(),
                            .bytes = file.at("bytes").get<std::uint64_t>()});
  }
  for (const Json& path : json.value("camera_paths", Json::array())) {
    p.paths.push_back(pathFrom(path));
  }
  p.history = json.value("history", std::vector<std::string>());
  Json others = Json::object();
  constexpr std::array<const char*, 13> kKnown{
      "camera_paths", "relievo_project", "version",      "input",  "depth_map",  "region", "look",
      "stereo",       "figure",          "measurements", "places", "recordings", "history"};
  for (const auto& [key, value] : json.items()) {
    if (std::find(kKnown.begin(), kKnown.end(), key) == kKnown.end()) others[key] = value;
  }
  if (!others.empty()) p.others = others.dump();
  return p;
}

}  // namespace

std::string projectJson(const Project& p) {
  Json json;
  json["relievo_project"] = kProjectSchema;
  json["version"] = RELIEVO_VERSION_STRING;
  json["input"] = {{"file", p.file}, {"sha256", p.sha256}};
  json["depth_map"] = optionsJson(p.options);
  json["region"] = regionJson(p.region, p.gain);
  json["look"] = lookJson(p.look);
  json["stereo"] = {{"on", p.stereo.mode == StereoMode::anaglyph},
                    {"eye_angle_deg", p.stereo.eye_angle_deg},
                    {"zero_plane_mm", optionalJson(p.stereo.zero_plane_mm)}};
  json["figure"] = figureJson(p.figure);
  json["places"] = Json::array();
  for (const NamedRegion& place : p.places) {
    Json entry = regionJson(place.region, place.gain);
    entry["name"] = place.name;
    json["places"].push_back(entry);
  }
  json["measurements"] = Json::array();
  for (const Measurement& m : p.measurements) json["measurements"].push_back(measurementJson(m));
  json["recordings"] = Json::array();
  for (const InputFile& file : p.recordings) {
    json["recordings"].push_back(
        {{"file", file.file}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  }
  if (!p.paths.empty()) json["camera_paths"] = Json::array();
  for (const CameraPath& path : p.paths) json["camera_paths"].push_back(pathJson(path));
  json["history"] = p.history;
  if (!p.others.empty()) json.update(Json::parse(p.others));
  // A file name need not be UTF-8; JSON must be.
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

Project projectFromJson(std::string_view json, const std::string& source) {
  try {
    return projectFrom(Json::parse(json, [](int depth, Json::parse_event_t, Json&) {
      if (depth > kDeepest) throw FileError("It is nested too deep.");
      return true;
    }));
  } catch (const nlohmann::json::exception& error) {
    throw FileError("'" + source + "' is not a project that this version can read (" +
                    error.what() + "). Nothing was changed.");
  } catch (const FileError& error) {
    throw FileError("'" + source + "' is not a project that this version can read. " +
                    error.what() + " Nothing was changed.");
  }
}

void writeProject(const std::filesystem::path& target, Project project) {
  const std::filesystem::path parent = target.parent_path();
  const std::filesystem::path folder = parent.empty() ? std::filesystem::path(".") : parent;
  forEachFile(project, [&](std::string& file) { file = relativePath(file, folder); });
  writeTextFile(target, projectJson(project) + "\n");
}

Project readProject(const std::filesystem::path& source) {
  Project project =
      projectFromJson(readTextFile(source, kMostProjectBytes), source.filename().string());
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::absolute(source, error).parent_path();
  forEachFile(project, [&](std::string& file) {
    file = (folder / file).lexically_normal().generic_string();
  });
  return project;
}

}  // namespace relievo
