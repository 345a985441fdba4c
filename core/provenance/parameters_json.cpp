// SPDX-License-Identifier: BSD-3-Clause
#include "core/provenance/parameters_json.h"

#include <cmath>
#include <limits>

#include "core/base/failure.h"
#include "core/base/json_nesting.h"
#include "core/depth/rules/point_rule.h"
#include "core/provenance/name_text.h"

namespace relievo {
namespace {

constexpr std::array<std::string_view, 4> kHoleRuleNames{"base", "interpolate", "membrane", "none"};
constexpr std::array<std::string_view, 5> kUnitSourceNames{"given", "file", "remembered", "assumed",
                                                           "guessed"};
constexpr std::array<std::string_view, 3> kStrayRuleNames{"drop", "keep", "drop-groups"};
constexpr std::array<std::string_view, 8> kRuleNames{"front", "second", "topmean",   "median",
                                                     "mean",  "splat",  "quadratic", "min"};
constexpr double kAny = std::numeric_limits<double>::max();
constexpr int kMostThinned = 1'000'000'000;
constexpr double kLeastMm = 1e-9;  // A size that is none.

/// A number within its limits. @throw FileError naming the key
double number(const Json& json, const char* key, double low, double high) {
  const auto value = json.at(key).get<double>();
  if (!(value >= low) || !(value <= high)) {
    throw failure<MessageId::field_out_of_range>(key, json.at(key).dump());
  }
  return value;
}

int wholeNumber(const Json& json, const char* key, int low, int high) {
  if (!json.at(key).is_number_integer()) {
    throw failure<MessageId::field_not_whole>(key);
  }
  return static_cast<int>(number(json, key, low, high));
}

bool has(const Json& json, const char* key) {
  return json.contains(key) && !json.at(key).is_null();
}

Json jsonOf(const std::optional<ViewChoice>& view) {
  if (!view) return nullptr;
  Json json{{"name", view->name}, {"turn_deg", view->turn_deg}};
  if (view->rotation) json["rotation"] = *view->rotation;
  return json;
}

std::optional<ViewChoice> viewChoiceFrom(const Json& json) {
  if (!has(json, "view")) return std::nullopt;
  const Json& stored = json.at("view");
  ViewChoice view{.name = stored.at("name").get<std::string>(), .rotation = std::nullopt};
  if (has(stored, "rotation")) {
    if (stored.at("rotation").size() != Rotation{}.size()) {
      throw failure<MessageId::field_count>("rotation", Rotation{}.size());
    }
    view.rotation = stored.at("rotation").get<Rotation>();
  }
  if (stored.at("turn_deg").size() != view.turn_deg.size()) {
    throw failure<MessageId::field_count>("turn_deg", view.turn_deg.size());
  }
  view.turn_deg = stored.at("turn_deg").get<std::array<double, 3>>();
  return view;
}

/// null: nothing was said; {"value": null}: every height is one.
Json jsonOf(const std::optional<NodataChoice>& nodata) {
  if (!nodata) return nullptr;
  return {{"value", nodata->value ? Json(*nodata->value) : Json(nullptr)}};
}

std::optional<NodataChoice> nodataFrom(const Json& json) {
  if (!has(json, "nodata")) return std::nullopt;
  NodataChoice nodata;
  if (has(json.at("nodata"), "value")) {
    nodata.value = number(json.at("nodata"), "value", -kAny, kAny);
  }
  return nodata;
}

/// null: nothing was said.
Json jsonOf(const RasterScale& scale) {
  if (scale == RasterScale{}) return nullptr;
  const auto of = [](const std::optional<double>& v) { return v ? Json(*v) : Json(nullptr); };
  return {{"pixel_mm", of(scale.pixel_mm)},
          {"height_mm", of(scale.height_mm)},
          {"zero", of(scale.zero)}};
}

RasterScale rasterScaleFrom(const Json& json) {
  RasterScale scale;
  if (!has(json, "raster_scale")) return scale;  // Older versions have none.
  const Json& stored = json.at("raster_scale");
  if (has(stored, "pixel_mm")) scale.pixel_mm = number(stored, "pixel_mm", kLeastMm, kAny);
  if (has(stored, "height_mm")) scale.height_mm = number(stored, "height_mm", -kAny, kAny);
  if (has(stored, "zero")) scale.zero = number(stored, "zero", -kAny, kAny);
  return scale;
}

Json jsonOf(const StereoOptions& stereo) {
  return {{"mode", name(stereo.mode)},
          {"eye_angle_deg", stereo.eye_angle_deg},
          {"zero_plane_mm", stereo.zero_plane_mm ? Json(*stereo.zero_plane_mm) : Json(nullptr)},
          {"swap_eyes", stereo.swap_eyes},
          {"automatic_depth", stereo.automatic_depth}};
}

StereoOptions stereoFrom(const Json& json) {
  StereoOptions stereo;
  stereo.mode = word<StereoMode>(json, "mode", kStereoModeNames);
  stereo.eye_angle_deg = number(json, "eye_angle_deg", 0, 90);
  if (has(json, "zero_plane_mm")) stereo.zero_plane_mm = number(json, "zero_plane_mm", -kAny, kAny);
  stereo.swap_eyes = json.value("swap_eyes", false);
  stereo.automatic_depth = json.value("automatic_depth", false);
  return stereo;
}

}  // namespace

Json parsedJson(std::string_view text) {
  constexpr int kDeepest = 64;
  if (isNestedDeeper(text, kDeepest)) throw failure<MessageId::field_nested_too_deep>();
  return Json::parse(text);
}

void throwUnknownWord(const std::string& word, const char* key) {
  throw failure<MessageId::field_unknown_word>(word, key);
}

void putScanChoices(const ScanChoices& choices, Json& input) {
  if (choices.keep_withheld) input["keep_withheld"] = true;
  if (choices.reader != ReaderChoice::automatic) {
    input["reader"] = kReaderNames[static_cast<std::size_t>(choices.reader)];
  }
  if (!choices.parts.empty()) input["parts"] = choices.parts;
  if (choices.every != 1) input["every"] = choices.every;
}

ScanChoices scanChoicesFrom(const Json& input) {
  ScanChoices choices;
  choices.keep_withheld = input.value("keep_withheld", false);
  if (input.contains("reader")) choices.reader = word<ReaderChoice>(input, "reader", kReaderNames);
  if (input.contains("parts")) choices.parts = input.at("parts").get<std::vector<int>>();
  if (input.contains("every")) {
    choices.every = static_cast<std::uint64_t>(wholeNumber(input, "every", 1, kMostThinned));
  }
  return choices;
}

Json jsonOf(const InputFile& input) {
  return {{"file", textOfName(input.file)}, {"bytes", input.bytes}, {"sha256", input.sha256}};
}

InputFile inputFrom(const Json& json) {
  InputFile input{.file = nameFromText(json.at("file").get<std::string>()),
                  .sha256 = json.at("sha256").get<std::string>(),
                  .bytes = json.at("bytes").get<std::uint64_t>()};
  const bool is_digits = std::all_of(input.sha256.begin(), input.sha256.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
  });
  if (!input.sha256.empty() && (input.sha256.size() != 64 || !is_digits)) {
    throw failure<MessageId::field_no_checksum>("sha256");
  }
  // A file name with a zero inside would be another file to the operating system.
  if (input.file.empty() || input.file.find('\0') != std::string::npos) {
    throw failure<MessageId::field_no_file_name>("file");
  }
  return input;
}

Json jsonOf(const SurfaceOptions& o) {
  Json json;
  json["unit"] = o.unit ? Json(name(*o.unit)) : Json(nullptr);
  json["unit_source"] = name(o.unit_source);
  json["view"] = jsonOf(o.view);
  json["cells"] = o.cells ? Json(*o.cells) : Json(nullptr);
  json["spacing_mm"] = o.spacing_mm ? Json(*o.spacing_mm) : Json(nullptr);
  json["engine"] = o.engine;
  json["rule"] = nullptr;
  for (const std::string_view rule : kRuleNames) {
    if (o.rule && pointRule(rule) == o.rule) json["rule"] = rule;
  }
  json["strays"] = kStrayRuleNames.at(static_cast<std::size_t>(o.strays));
  json["nodata"] = jsonOf(o.nodata);
  json["raster_scale"] = jsonOf(o.raster);
  json["holes"] = {{"rule", kHoleRuleNames.at(static_cast<std::size_t>(o.holes.rule))}};
  // JSON has no infinity; no limit is written as none.
  if (std::isfinite(o.holes.max_area_mm2)) json["holes"]["max_area_mm2"] = o.holes.max_area_mm2;
  json["factor"] = o.pyramid.factor;
  json["coarsest_samples"] = o.pyramid.coarsest_samples;
  return json;
}

SurfaceOptions optionsFrom(const Json& json) {
  SurfaceOptions o;
  if (has(json, "unit")) {
    const auto unit = json.at("unit").get<std::string>();
    o.unit = lengthUnit(unit);
    if (!o.unit) throw failure<MessageId::field_unknown_word>(unit, "unit");
  }
  o.unit_source = word<UnitSource>(json, "unit_source", kUnitSourceNames);
  o.view = viewChoiceFrom(json);
  if (has(json, "cells")) o.cells = wholeNumber(json, "cells", 2, 1 << 30);
  if (has(json, "spacing_mm")) o.spacing_mm = number(json, "spacing_mm", 0, kAny);
  o.engine = json.at("engine").get<std::string>();
  if (o.engine != "cpu" && o.engine != "depthbuffer") {
    throw failure<MessageId::field_unknown_word>(o.engine, "engine");
  }
  if (has(json, "rule")) {
    const auto rule = json.at("rule").get<std::string>();
    o.rule = pointRule(rule);
    if (!o.rule) throw failure<MessageId::field_unknown_word>(rule, "rule");
  }
  if (json.contains("strays")) {
    o.strays = word<StrayRule>(json, "strays", kStrayRuleNames);
  } else {
    // Older versions left nothing out, and chose among six views.
    o.strays = StrayRule::keep;
    if (!o.view || o.view->name == "auto") {
      o.view = ViewChoice{.name = std::string(kEarlierAutomatic),
                          .rotation = std::nullopt,
                          .turn_deg = o.view ? o.view->turn_deg : std::array<double, 3>{}};
    }
  }
  o.nodata = nodataFrom(json);
  o.raster = rasterScaleFrom(json);
  const Json& holes = json.at("holes");
  o.holes.rule = word<HoleRule>(holes, "rule", kHoleRuleNames);
  o.holes.max_area_mm2 = has(holes, "max_area_mm2") ? number(holes, "max_area_mm2", 0, kAny)
                                                    : std::numeric_limits<double>::infinity();
  o.pyramid.factor = number(json, "factor", kLeastFactor, kMostFactor);
  if (has(json, "coarsest_samples")) {
    o.pyramid.coarsest_samples = wholeNumber(json, "coarsest_samples", 1, 1 << 30);
  }
  return o;
}

Json jsonOf(const ReliefLook& look) {
  return {{"kind", name(look.kind)},
          {"colours", name(look.colours)},
          {"light_azimuth_deg", look.light.azimuth_deg},
          {"light_elevation_deg", look.light.elevation_deg},
          {"radius_mm", look.radius_mm},
          {"range", look.range ? Json(*look.range) : Json(nullptr)},
          {"shading", look.shading},
          {"unmeasured", look.unmeasured}};
}

ReliefLook lookFrom(const Json& json) {
  ReliefLook look;
  look.kind = word<ReliefKind>(json, "kind", kReliefKindNames);
  look.colours = word<ColourMap>(json, "colours", kColourMapNames);
  look.light.azimuth_deg = number(json, "light_azimuth_deg", -kAny, kAny);
  look.light.elevation_deg = number(json, "light_elevation_deg", -90, 90);
  look.radius_mm = number(json, "radius_mm", 0, kAny);
  if (has(json, "range")) {
    if (json.at("range").size() != 2) throw failure<MessageId::field_count>("range", 2);
    look.range = json.at("range").get<std::array<double, 2>>();
  }
  // Files of versions without natural colours lack it.
  if (has(json, "shading")) look.shading = number(json, "shading", 0, 1);
  look.unmeasured = json.value("unmeasured", false);
  return look;
}

Json jsonOf(const ViewState& view) {
  return {
      {"region_mm", {view.region.x_mm, view.region.y_mm, view.region.side_mm, view.region.side_mm}},
      {"level", view.region.level.value},
      {"gain", view.gain},
      {"turn_deg", {view.azimuth_deg, view.elevation_deg}},
      {"look", jsonOf(view.look)},
      {"stereo", jsonOf(view.stereo)}};
}

ViewState viewFrom(const Json& json) {
  ViewState view;
  const Json& region = json.at("region_mm");
  const Json& turn = json.at("turn_deg");
  if (region.size() != 4) throw failure<MessageId::field_count>("region_mm", 4);
  if (turn.size() != 2) throw failure<MessageId::field_count>("turn_deg", 2);
  view.region = {.x_mm = region.at(0).get<double>(),
                 .y_mm = region.at(1).get<double>(),
                 .side_mm = region.at(2).get<double>(),
                 .level = Level{wholeNumber(json, "level", 0, 1000)}};
  if (!(view.region.side_mm > 0)) throw failure<MessageId::field_without_size>("region_mm");
  view.gain = number(json, "gain", std::numeric_limits<double>::min(), kAny);
  view.azimuth_deg = turn.at(0).get<double>();
  view.elevation_deg = turn.at(1).get<double>();
  view.look = lookFrom(json.at("look"));
  view.stereo = stereoFrom(json.at("stereo"));
  return view;
}

namespace {

template <class Vector>
Json triple(const Vector& v) {
  return {v.x, v.y, v.z};
}

template <class Vector>
Vector tripleFrom(const Json& json) {
  if (json.size() != 3) throw failure<MessageId::field_picture_place>();
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

DrawnHand handFrom(const Json& json) {
  return {.proxy = tripleFrom<ViewMm>(json.at("proxy_mm")),
          .hip = tripleFrom<ViewMm>(json.at("hip_mm")),
          .force = tripleFrom<DeviceN>(json.at("force_n")),
          .force_limit_n = number(json, "force_limit_n", 0, kAny),
          .touching = json.at("touching").get<bool>(),
          .forces_on = json.at("forces_on").get<bool>(),
          .ball_radius_mm = number(json, "ball_radius_mm", 0, kAny)};
}

bool isColour(const std::string& text) {
  return text.size() == 7 && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdef", 1) == std::string::npos;
}

}  // namespace

Json jsonOf(const PictureChoice& picture) {
  Json json{{"pixels", {picture.width_px, picture.height_px}}, {"scale_bar", picture.scale_bar}};
  if (picture.source != PictureChoice{}.source) json["source"] = picture.source;
  if (picture.eye != FigureEye::both) json["eye"] = name(picture.eye);
  if (!picture.background.empty()) json["background"] = picture.background;
  for (const auto& line : picture.lines) {
    Json& points = json["lines_mm"].emplace_back(Json::array());
    for (const ViewMm& point : line) points.push_back(triple(point));
  }
  if (picture.hand) {
    json["hand"] = {{"proxy_mm", triple(picture.hand->proxy)},
                    {"hip_mm", triple(picture.hand->hip)},
                    {"force_n", triple(picture.hand->force)},
                    {"force_limit_n", picture.hand->force_limit_n},
                    {"touching", picture.hand->touching},
                    {"forces_on", picture.hand->forces_on},
                    {"ball_radius_mm", picture.hand->ball_radius_mm}};
  }
  return json;
}

PictureChoice pictureFrom(const Json& json) {
  const Json& pixels = json.at("pixels");
  PictureChoice picture{.width_px = pixels.at(0).get<int>(),
                        .height_px = pixels.at(1).get<int>(),
                        .scale_bar = json.at("scale_bar").get<bool>()};
  constexpr int kMost = 1 << 20;
  if (picture.width_px < 1 || picture.height_px < 1 || picture.width_px > kMost ||
      picture.height_px > kMost) {
    throw failure<MessageId::field_beyond>("pixels");
  }
  picture.source = json.value("source", picture.source);
  picture.background = json.value("background", picture.background);
  if (!picture.background.empty() && !isColour(picture.background)) {
    throw failure<MessageId::field_no_colour>("background");
  }
  if (json.contains("lines_mm")) {
    for (const Json& points : json.at("lines_mm")) {
      std::vector<ViewMm>& line = picture.lines.emplace_back();
      for (const Json& point : points) line.push_back(tripleFrom<ViewMm>(point));
    }
  }
  if (json.contains("eye")) {
    const auto eye = json.at("eye").get<std::string>();
    const auto* const found = std::find(kFigureEyeNames.begin(), kFigureEyeNames.end(), eye);
    if (found == kFigureEyeNames.end()) throw failure<MessageId::field_beyond>("eye");
    picture.eye = static_cast<FigureEye>(found - kFigureEyeNames.begin());
  }
  if (json.contains("hand")) picture.hand = handFrom(json.at("hand"));
  return picture;
}

}  // namespace relievo
