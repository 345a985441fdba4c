// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/project.h"

#include <algorithm>
#include <array>

#include "core/base/failure.h"
#include "core/base/replaceable.h"
#include "core/io/file_check.h"
#include "core/io/formats/text_file.h"
#include "core/provenance/name_text.h"
#include "core/provenance/parameters_json.h"
#include "core/provenance/program.h"

namespace relievo {
namespace {

constexpr std::size_t kMostProjectBytes = 64U << 20U;

template <class Change>
void forEachFile(Project& project, const Change& change) {
  change(project.file);
  for (InputFile& recording : project.recordings) change(recording.file);
  for (std::string& figure : project.figures) change(figure);
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
}

Json figureJson(const FigureRequest& f) {
  Json json;
  json["layout"] = name(f.layout);
  json["stereo"] = name(f.stereo);
  json["eye"] = name(f.eye);
  json["scale_1_to"] = optionalJson(f.scale_1_to);
  json["zero_plane_mm"] = optionalJson(f.zero_plane_mm);
  forEachField(f, [&](const char* key, const auto& field) { json[key] = field; });
  json["recording"] = textOfName(f.recording);
  json["look"] = jsonOf(f.look);
  return json;
}

FigureRequest figureFrom(const Json& json) {
  FigureRequest f;
  f.layout = word<FigureLayout>(json, "layout", kFigureLayoutNames);
  f.stereo = word<StereoPrint>(json, "stereo", kPaperStereoNames);
  if (json.contains("eye")) f.eye = word<FigureEye>(json, "eye", kFigureEyeNames);
  f.scale_1_to = optionalFrom<double>(json, "scale_1_to");
  f.zero_plane_mm = optionalFrom<double>(json, "zero_plane_mm");
  forEachField(f, [&](const char* key, auto& field) { field = json.value(key, field); });
  f.recording = nameFromText(json.value("recording", std::string()));
  if (json.contains("look")) f.look = lookFrom(json.at("look"));
  return f;
}

Json measurementJson(const Measurement& m) {
  Json places = Json::array();
  for (const PlaceMm& place : m.places) places.push_back({place.x, place.y});
  Json json{
      {"name", m.name}, {"kind", name(m.kind)}, {"places_mm", places}, {"plane_mm", m.plane_mm}};
  if (m.kind == MeasureKind::section) json["normal"] = {m.normal.x, m.normal.y, m.normal.z};
  return json;
}

Measurement measurementFrom(const Json& json) {
  Measurement m;
  m.name = json.at("name").get<std::string>();
  m.kind = word<MeasureKind>(json, "kind", kMeasureKindNames);
  for (const Json& place : json.at("places_mm")) {
    m.places.push_back({.x = place.at(0).get<double>(), .y = place.at(1).get<double>()});
  }
  m.plane_mm = json.value("plane_mm", 0.0);
  if (m.kind == MeasureKind::section) {
    const Json& normal = json.at("normal");
    m.normal = {normal.at(0).get<double>(), normal.at(1).get<double>(), normal.at(2).get<double>()};
  }
  return m;
}

Json placeJson(const NamedRegion& place) {
  Json json = regionJson(place.region, place.gain);
  json["name"] = place.name;
  if (place.view) json["view"] = jsonOf(*place.view);
  if (place.is_point) json["point"] = true;
  return json;
}

NamedRegion placeFrom(const Json& json) {
  NamedRegion place{.name = json.at("name").get<std::string>(),
                    .region = regionFrom(json),
                    .gain = json.value("gain", 1.0),
                    .is_point = json.value("point", false)};
  if (json.contains("view")) place.view = viewFrom(json.at("view"));
  return place;
}

/// Within the limits of what is drawn. @throw FileError
void checkEyeAngle(const std::optional<double>& angle_deg) {
  if (!angle_deg || (*angle_deg >= 0 && *angle_deg <= 90)) return;
  throw failure<MessageId::field_out_of_range>("chosen_eye_angle_deg", Json(*angle_deg).dump());
}

template <class T, class ToJson>
Json listChangeJson(const ListChange<T>& change, const ToJson& to_json) {
  Json back = Json::array();
  for (const T& one : change.back) back.push_back(to_json(one));
  return {{"at", change.at}, {"gone", change.gone}, {"back", back}};
}

template <class T, class FromJson>
std::optional<ListChange<T>> listChangeFrom(const Json& json, const char* key,
                                            const FromJson& from_json) {
  if (!json.contains(key)) return std::nullopt;
  const Json& read = json.at(key);
  ListChange<T> change{.at = read.at("at").get<std::size_t>(),
                       .gone = read.at("gone").get<std::size_t>(),
                       .back = {}};
  for (const Json& one : read.at("back")) change.back.push_back(from_json(one));
  return change;
}

Json stepJson(const UndoStep& step) {
  Json json = placeJson(step.before);
  if (step.chosen_eye_angle_deg) json["chosen_eye_angle_deg"] = *step.chosen_eye_angle_deg;
  if (step.places) json["places"] = listChangeJson(*step.places, placeJson);
  if (step.measurements) json["measurements"] = listChangeJson(*step.measurements, measurementJson);
  return json;
}

UndoStep stepFrom(const Json& json) {
  UndoStep step{.before = placeFrom(json),
                .chosen_eye_angle_deg = optionalFrom<double>(json, "chosen_eye_angle_deg"),
                .places = listChangeFrom<NamedRegion>(json, "places", placeFrom),
                .measurements = listChangeFrom<Measurement>(json, "measurements", measurementFrom)};
  checkEyeAngle(step.chosen_eye_angle_deg);
  return step;
}

/// Keys that a later version wrote.
std::string unknownKeys(const Json& json) {
  constexpr std::array<const char*, 16> kKnown{"relievo_project",
                                               "program",
                                               "input",
                                               "depth_map",
                                               "view",
                                               "picture",
                                               "figure",
                                               "figures",
                                               "measurements",
                                               "places",
                                               "recordings",
                                               "camera_paths",
                                               "history",
                                               "undo",
                                               "saved_as",
                                               "chosen_eye_angle_deg"};
  Json others = Json::object();
  for (const auto& [key, value] : json.items()) {
    if (key == "made") continue;  // Belongs to what was written, not to what will be.
    if (std::find(kKnown.begin(), kKnown.end(), key) == kKnown.end()) others[key] = value;
  }
  return others.empty() ? std::string() : others.dump();
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
      throw FileError(messageOf(error));
    }
  }
  return path;
}

Project projectFrom(const Json& json) {
  Project p;
  p.version = json.at("program").at("version").get<std::string>();
  const InputFile input = inputFrom(json.at("input"));
  p.file = input.file;
  p.sha256 = input.sha256;
  p.bytes = input.bytes;
  p.accept_incomplete = json.at("input").value("incomplete", false);
  p.scan = scanChoicesFrom(json.at("input"));
  p.options = optionsFrom(json.at("depth_map"));
  setView(p, viewFrom(json.at("view")));
  p.chosen_eye_angle_deg = optionalFrom<double>(json, "chosen_eye_angle_deg");
  checkEyeAngle(p.chosen_eye_angle_deg);
  if (json.contains("picture")) p.picture = pictureFrom(json.at("picture"));
  if (json.contains("figure")) p.figure = figureFrom(json.at("figure"));
  for (const Json& place : json.value("places", Json::array())) {
    p.places.push_back(placeFrom(place));
  }
  for (const Json& m : json.value("measurements", Json::array())) {
    p.measurements.push_back(measurementFrom(m));
  }
  for (const Json& file : json.value("recordings", Json::array())) {
    p.recordings.push_back(inputFrom(file));
  }
  p.figures = json.value("figures", std::vector<std::string>());
  for (std::string& figure : p.figures) figure = nameFromText(figure);
  for (const Json& path : json.value("camera_paths", Json::array())) {
    p.paths.push_back(pathFrom(path));
  }
  p.history = json.value("history", std::vector<std::string>());
  for (const Json& step : json.value("undo", Json::array())) p.undo.push_back(stepFrom(step));
  p.saved_as = nameFromText(json.value("saved_as", std::string()));
  p.others = unknownKeys(json);
  return p;
}

// The structured bindings name every field of these records: one that is added later does not
// compile until it is compared.
bool same(const std::optional<ViewChoice>& a, const std::optional<ViewChoice>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  const auto& [name, rotation, turn_deg] = *a;
  return name == b->name && rotation == b->rotation && turn_deg == b->turn_deg;
}

bool same(const HoleChoice& a, const HoleChoice& b) {
  const auto& [rule, max_area_mm2] = a;
  return rule == b.rule && max_area_mm2 == b.max_area_mm2;
}

bool same(const PyramidOptions& a, const PyramidOptions& b) {
  const auto& [factor, coarsest_samples, threads] = a;
  static_cast<void>(threads);  // The bytes are the same for every number.
  return factor == b.factor && coarsest_samples == b.coarsest_samples;
}

bool same(const SurfaceOptions& a, const SurfaceOptions& b) {
  const auto& [unit, unit_source, view, cells, spacing_mm, engine, rule, strays, nodata, raster,
               holes, pyramid] = a;
  return unit == b.unit && unit_source == b.unit_source && same(view, b.view) && cells == b.cells &&
         spacing_mm == b.spacing_mm && engine == b.engine && rule == b.rule && strays == b.strays &&
         nodata == b.nodata && raster == b.raster && same(holes, b.holes) &&
         same(pyramid, b.pyramid);
}

/// Whole, but nothing that this version opens as a project.
struct OtherFile : FileError {
  using FileError::FileError;
};

void refuseOthers(const Json& json, const std::string& source) {
  if (!json.is_object() || !json.contains("relievo_project")) {
    throw OtherFile(said<MessageId::no_project>(shownName(source)));
  }
  const int schema = json.at("relievo_project").get<int>();
  if (schema != kProjectSchema) {
    throw OtherFile(
        said<MessageId::project_of_another_version>(shownName(source), schema, kProjectSchema));
  }
}

}  // namespace

bool operator==(const Project& a, const Project& b) {
  const auto& [file, sha256, bytes, accept_incomplete, scan, options, region, gain, look, stereo,
               chosen_eye_angle_deg, azimuth_deg, elevation_deg, picture, figure, places,
               measurements, recordings, figures, paths, history, undo, version, made, saved_as,
               others] = a;
  return file == b.file && sha256 == b.sha256 && bytes == b.bytes &&
         accept_incomplete == b.accept_incomplete && scan == b.scan && same(options, b.options) &&
         region == b.region && gain == b.gain && look == b.look && stereo == b.stereo &&
         chosen_eye_angle_deg == b.chosen_eye_angle_deg && azimuth_deg == b.azimuth_deg &&
         elevation_deg == b.elevation_deg && picture == b.picture && figure == b.figure &&
         places == b.places && measurements == b.measurements && recordings == b.recordings &&
         figures == b.figures && paths == b.paths && history == b.history && undo == b.undo &&
         version == b.version && made == b.made && saved_as == b.saved_as && others == b.others;
}

StereoOptions chosenStereo(const Project& p) {
  StereoOptions chosen = p.stereo;
  if (chosen.automatic_depth) {
    chosen.eye_angle_deg = StereoOptions{}.eye_angle_deg;  // It follows the heights.
  } else {
    chosen.eye_angle_deg = p.chosen_eye_angle_deg.value_or(chosen.eye_angle_deg);
  }
  return chosen;
}

Project workIn(const Project& state, bool settings) {
  Project work;
  work.places = state.places;
  work.measurements = state.measurements;
  work.paths = state.paths;
  if (settings) {
    work.options = state.options;
    work.figures = state.figures;
    work.look = state.look;
    work.stereo = chosenStereo(state);
  }
  return work;
}

Project storedProject(Project project, const Surface& surface) {
  const std::optional<ViewChoice>& view = project.options.view;
  const bool of_a_scan = !surface.is_raster && !surface.tiles;
  if (of_a_scan && (!view || view->name == "auto") && namedRotation(surface.view_name)) {
    project.options.view = ViewChoice{.name = surface.view_name, .rotation = std::nullopt};
  }
  return project;
}

Provenance provenanceOf(const Project& project, const Surface& surface,
                        const std::filesystem::path& folder) {
  return provenanceOf(project, surface, folder, madeText(surface));
}

Provenance provenanceOf(const Project& project, const Surface& surface,
                        const std::filesystem::path& folder, std::string made_text) {
  Provenance made = provenanceOf(surface, project.options, std::move(made_text));
  made.input = {
      .file = relativePath(project.file, folder), .sha256 = project.sha256, .bytes = project.bytes};
  made.accept_incomplete = project.accept_incomplete;
  made.scan = project.scan;
  made.view = viewOf(project);
  return made;
}

ViewState viewOf(const Project& p) {
  return {.region = p.region,
          .gain = p.gain,
          .look = p.look,
          .stereo = p.stereo,
          .azimuth_deg = p.azimuth_deg,
          .elevation_deg = p.elevation_deg};
}

void setView(Project& p, const ViewState& view) {
  p.region = view.region;
  p.gain = view.gain;
  p.look = view.look;
  p.stereo = view.stereo;
  p.azimuth_deg = view.azimuth_deg;
  p.elevation_deg = view.elevation_deg;
}

std::string projectJson(const Project& p) {
  Json json;
  json["relievo_project"] = kProjectSchema;
  json["program"] = {
      {"name", "relievo"}, {"version", programVersion()}, {"commit", programCommit()}};
  json["input"] = jsonOf(InputFile{.file = p.file, .sha256 = p.sha256, .bytes = p.bytes});
  json["input"]["incomplete"] = p.accept_incomplete;
  putScanChoices(p.scan, json["input"]);
  json["depth_map"] = jsonOf(p.options);
  json["view"] = jsonOf(viewOf(p));
  if (p.chosen_eye_angle_deg) json["chosen_eye_angle_deg"] = *p.chosen_eye_angle_deg;
  if (p.picture) json["picture"] = jsonOf(*p.picture);
  json["figure"] = figureJson(p.figure);
  json["places"] = Json::array();
  for (const NamedRegion& place : p.places) json["places"].push_back(placeJson(place));
  json["measurements"] = Json::array();
  for (const Measurement& m : p.measurements) json["measurements"].push_back(measurementJson(m));
  json["recordings"] = Json::array();
  for (const InputFile& file : p.recordings) json["recordings"].push_back(jsonOf(file));
  for (const std::string& figure : p.figures) json["figures"].push_back(textOfName(figure));
  if (!p.paths.empty()) json["camera_paths"] = Json::array();
  for (const CameraPath& path : p.paths) json["camera_paths"].push_back(pathJson(path));
  json["history"] = p.history;
  json["undo"] = Json::array();
  for (const UndoStep& step : p.undo) json["undo"].push_back(stepJson(step));
  if (!p.saved_as.empty()) json["saved_as"] = textOfName(p.saved_as);
  if (!p.made.empty()) json["made"] = Json::parse(p.made);
  if (!p.others.empty()) json.update(Json::parse(p.others));
  // A file name need not be UTF-8; JSON must be.
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

Project projectFromJson(std::string_view json, const std::string& source) {
  try {
    const Json read = parsedJson(json);
    refuseOthers(read, source);
    return projectFrom(read);
  } catch (const nlohmann::json::parse_error& error) {
    const std::string_view before = json.substr(0, std::max<std::size_t>(error.byte, 1) - 1);
    throw failure<MessageId::project_damaged_in_line>(
        shownName(source), 1 + std::count(before.begin(), before.end(), '\n'));
  } catch (const nlohmann::json::exception&) {
    throw failure<MessageId::project_part_damaged>(shownName(source));
  } catch (const OtherFile&) {
    throw;
  } catch (const FileError& error) {
    throw failure<MessageId::project_damaged>(shownName(source),
                                              WordsArgument::clause(messageOf(error)));
  }
}

Project relativeTo(Project project, const std::filesystem::path& written) {
  const std::filesystem::path parent = written.parent_path();
  const std::filesystem::path folder = parent.empty() ? std::filesystem::path(".") : parent;
  forEachFile(project, [&](std::string& file) { file = relativePath(file, folder); });
  return project;
}

void writeProject(const std::filesystem::path& target, Project project) {
  // A relative name is beside the project.
  requireNotAnInput(target, {{.file = target.parent_path() / project.file}});
  writeTextFile(target, projectJson(relativeTo(std::move(project), target)) + "\n");
}

Project readProject(const std::filesystem::path& source) {
  Project project =
      projectFromJson(readTextFile(source, kMostProjectBytes), source.filename().string());
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::absolute(source, error).parent_path();
  forEachFile(project, [&](std::string& file) { file = namedFrom(folder, file); });
  return project;
}

}  // namespace relievo
