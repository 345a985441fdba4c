// SPDX-License-Identifier: BSD-3-Clause
#include "core/provenance/provenance.h"

#include <array>
#include <cstddef>

#include "core/base/failure.h"
#include "core/provenance/libraries.h"
#include "core/provenance/parameters_json.h"
#include "core/provenance/program.h"
#include "core/session/large/large_map.h"
#include "core/session/map_facts.h"

namespace relievo {
namespace {

constexpr int kSchema = 1;
constexpr int kViewSchema = 1;

/// What came out, for a reader of the file; made anew, never read back into choices.
/// @param made  a Surface or a LargeMap
template <class Made>
Json madeJson(const Made& made, const GridFrame& frame, const HeightRange& heights,
              const std::array<double, kOriginCount>& shares, std::size_t levels) {
  Json json;
  json["cells"] = {frame.size.cols, frame.size.rows};
  json["spacing_mm"] = frame.spacing_mm;
  json["height_mm"] = {{"min", heights.min_mm}, {"max", heights.max_mm}};
  json["levels"] = levels;
  json["view"] = made.view_name;
  json["view_from_file"] = made.view_from_file.m;
  json["engine"] = made.engine;
  json["rule"] = made.rule;
  json["holes"] = made.holes.size();
  json["strays"] = {{"points", made.strays.points},
                    {"share_of_box", made.strays.share_of_box},
                    {"kept", made.strays.kept},
                    {"grouped", made.strays.grouped},
                    {"share_of_box_grouped", made.strays.share_of_box_grouped},
                    {"groups_kept", made.strays.groups_kept}};
  json["missing"] = made.missing;
  if (!made.info.reader.empty()) json["reader"] = made.info.reader;
  for (const LibraryVersion& one : coreLibraries()) json["libraries"][one.name] = one.version;
  for (std::size_t i = 0; i < kOriginCount; ++i) {
    json["shares"][std::string(kOriginNames[i])] = shares[i];
  }
  return json;
}

/// @param made  a Surface or a LargeMap that is no map of ours, taken as it is
template <class Made>
SurfaceOptions writtenOut(SurfaceOptions out, const Made& made, bool is_raster, double spacing_mm) {
  out.unit = made.unit;
  out.unit_source = made.unit_source;
  if (is_raster) return out;
  const bool automatic =
      !out.view || out.view->name == "auto" || out.view->name == kEarlierAutomatic;
  if (automatic && namedRotation(made.view_name)) {
    out.view = ViewChoice{.name = made.view_name, .rotation = std::nullopt, .turn_deg = {}};
  }
  out.cells.reset();
  out.spacing_mm = spacing_mm;
  return out;
}

std::string objectText(const Json& json, const char* key) {
  if (!json.contains(key)) return {};
  if (!json.at(key).is_object()) throw failure<MessageId::field_no_object>(key);
  return json.at(key).dump();
}

Provenance provenanceFrom(const Json& json) {
  if (!json.is_object() || !json.contains("relievo_provenance")) {
    throw failure<MessageId::field_missing>("relievo_provenance");
  }
  const int schema = json.at("relievo_provenance").get<int>();
  if (schema < 1 || schema > kSchema) {
    throw failure<MessageId::schema_unknown>(schema, kSchema);
  }
  Provenance p;
  p.version = json.at("program").at("version").get<std::string>();
  p.commit = json.at("program").at("commit").get<std::string>();
  p.input = inputFrom(json.at("input"));
  if (json.at("input").contains("files")) {
    for (const Json& file : json.at("input").at("files")) p.files.push_back(inputFrom(file));
  }
  p.accept_incomplete = json.at("input").value("incomplete", false);
  p.scan = scanChoicesFrom(json.at("input"));
  p.options = optionsFrom(json.at("depth_map"));
  if (json.contains("view")) p.view = viewFrom(json.at("view"));
  if (json.contains("picture")) p.picture = pictureFrom(json.at("picture"));
  if (json.contains("values")) p.values = lookFrom(json.at("values"));
  p.touch = objectText(json, "touch");
  p.figure = objectText(json, "figure");
  p.made = objectText(json, "made");
  return p;
}

}  // namespace

std::string madeText(const Surface& surface) {
  const MapFacts facts = mapFacts(surface);
  return madeJson(surface, mapFrame(surface), facts.heights, facts.shares,
                  static_cast<std::size_t>(surface.ladder.levels()))
      .dump();
}

Provenance provenanceOf(const Surface& surface, const SurfaceOptions& options) {
  return provenanceOf(surface, options, madeText(surface));
}

Provenance provenanceOf(const Surface& surface, const SurfaceOptions& options, std::string made) {
  Provenance p;
  p.version = programVersion();
  p.commit = programCommit();
  p.options = resolved(options, surface);
  p.made = std::move(made);
  return p;
}

Provenance provenanceOf(const LargeMap& map, const SurfaceOptions& options) {
  Provenance p;
  p.version = programVersion();
  p.commit = programCommit();
  p.options = options;
  p.options.pyramid.threads = 0;
  const GridFrame& frame = map.frames.front();
  if (map.engine != "as stored") {
    p.options = writtenOut(p.options, map, map.engine == "raster", frame.spacing_mm);
  }
  p.made = madeJson(map, frame, map.heights, map.shares, map.frames.size()).dump();
  return p;
}

SurfaceOptions resolved(const SurfaceOptions& options, const Surface& surface) {
  SurfaceOptions out = options;
  out.pyramid.threads = 0;  // The bytes are the same for every number.
  // A map of ours is taken as it is.
  if (surface.engine == "as stored" || surface.tiles) return out;
  return writtenOut(out, surface, surface.is_raster, mapFrame(surface).spacing_mm);
}

std::string toJson(const Provenance& p, int indent) {
  Json json;
  json["relievo_provenance"] = kSchema;
  json["program"] = {{"name", "relievo"}, {"version", p.version}, {"commit", p.commit}};
  json["input"] = jsonOf(p.input);
  json["input"]["incomplete"] = p.accept_incomplete;
  for (const InputFile& file : p.files) json["input"]["files"].push_back(jsonOf(file));
  putScanChoices(p.scan, json["input"]);
  json["depth_map"] = jsonOf(p.options);
  if (p.view) json["view"] = jsonOf(*p.view);
  if (p.picture) json["picture"] = jsonOf(*p.picture);
  if (p.values) json["values"] = jsonOf(*p.values);
  if (!p.touch.empty()) json["touch"] = Json::parse(p.touch);
  if (!p.figure.empty()) json["figure"] = Json::parse(p.figure);
  if (!p.made.empty()) json["made"] = Json::parse(p.made);
  // A file name need not be UTF-8; JSON must be. ASCII goes through every tag and comment.
  return json.dump(indent, ' ', true, Json::error_handler_t::replace);
}

Provenance provenanceFromJson(std::string_view text, const std::string& source) {
  try {
    return provenanceFrom(parsedJson(text));
  } catch (const nlohmann::json::parse_error&) {
    throw failure<MessageId::state_damaged>(source);
  } catch (const nlohmann::json::exception&) {
    throw failure<MessageId::state_part_damaged>(source);
  } catch (const FileError& error) {
    throw failure<MessageId::state_unreadable>(source, messageOf(error));
  }
}

std::string toText(const ViewState& view) {
  Json json{{"relievo_view", kViewSchema}};
  json.update(jsonOf(view));
  return json.dump(2);
}

ViewState viewFromText(std::string_view text) {
  try {
    const Json json = parsedJson(text);
    if (!json.is_object() || json.value("relievo_view", 0) != kViewSchema) {
      throw failure<MessageId::view_schema_unknown>();
    }
    return viewFrom(json);
  } catch (const nlohmann::json::exception&) {
    throw failure<MessageId::text_is_no_view>();
  } catch (const std::exception& error) {
    throw failure<MessageId::text_is_no_view_for>(messageOf(error));
  }
}

}  // namespace relievo
