// SPDX-License-Identifier: BSD-3-Clause
// Recipes as JSON and back. What comes back is from outside: every key and number is looked at.
#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "core/base/failure.h"
#include "core/base/json_nesting.h"
#include "core/prepare/recipe.h"

namespace relievo {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;
constexpr const char* kKey = "relievo_recipe";

Json jsonOf(const FilePoint& p) {
  return {p.x, p.y, p.z};
}

template <class T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// The name of a standard view, else its nine numbers.
Json jsonOf(const Rotation& rotation) {
  for (const std::string_view view : kViewNames) {
    const auto standard = standardRotation(view);
    if (standard && *standard == rotation) return view;
  }
  return Json(rotation);
}

struct ToJson {
  Json& json;

  void operator()(const CropBox& s) const {
    json["min"] = jsonOf(s.min);
    json["max"] = jsonOf(s.max);
    json["axes"] = jsonOf(s.axes);
    json["keep"] = s.keep_inside ? "inside" : "outside";
  }
  void operator()(const CropOutline& s) const {
    json["view"] = jsonOf(s.view);
    json["outline"] = s.outline;
    json["keep"] = s.keep_inside ? "inside" : "outside";
  }
  void operator()(const Classes& s) const {
    json["keep"] = s.keep;
    json["keep_noise"] = s.keep_noise;
  }
  void operator()(const Returns& s) const {
    json["keep"] = kReturnNames.at(static_cast<std::size_t>(s.keep));
  }
  void operator()(const Intensities& s) const {
    json["low"] = s.low;
    json["high"] = s.high;
  }
  void operator()(const Duplicates&) const {}
  void operator()(const Outliers& s) const {
    json["neighbours"] = s.neighbours;
    json["deviations"] = s.deviations;
  }
  void operator()(const Lonely& s) const {
    json["radius_mm"] = orNull(s.radius_mm);
    json["spacings"] = s.spacings;
    json["share"] = s.share;
    json["neighbours"] = s.neighbours;
  }
  void operator()(const Sparse& s) const {
    json["neighbours"] = s.neighbours;
    json["factor"] = s.factor;
    json["off_surface"] = s.off_surface;
  }
  void operator()(const Thin& s) const { json["spacing_mm"] = s.spacing_mm; }
  void operator()(const Base& s) const {
    json["lay"] = s.lay;
    json["distance_mm"] = orNull(s.distance_mm);
    json["seed"] = s.seed;
  }
  void operator()(const Normals& s) const { json["neighbours"] = s.neighbours; }
  void operator()(const Align& s) const {
    json["method"] = kAlignMethodNames.at(static_cast<std::size_t>(s.method));
    json["reference"] = s.reference;
    json["pairs"] = Json::array();
    for (const PickedPair& pair : s.pairs) {
      json["pairs"].push_back({{"scan", pair.scan},
                               {"point", jsonOf(pair.point)},
                               {"reference", jsonOf(pair.reference)}});
    }
    json["seed"] = s.seed;
    json["poses"] = Json::array();
    for (const Pose& pose : s.poses) json["poses"].push_back(pose.m);
  }
};

Json jsonOf(const Step& step) {
  Json json;
  json["kind"] = kindOf(step);
  std::visit(ToJson{json}, step);
  return json;
}

/// A key that nobody reads is a mistake of whoever wrote it, not a choice of ours.
void requireKeys(const Json& json, std::initializer_list<std::string_view> known) {
  if (!json.is_object()) throw failure<MessageId::recipe_part_no_object>();
  for (const auto& [key, value] : json.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      throw failure<MessageId::recipe_key_unknown>(key);
    }
  }
}

double number(const Json& json) {
  if (!json.is_number()) throw failure<MessageId::recipe_no_number>(json.dump().substr(0, 40));
  return json.get<double>();
}

std::uint32_t wholeNumber(const Json& json) {
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() > UINT32_MAX) {
    throw failure<MessageId::recipe_no_whole_number>(json.dump().substr(0, 40));
  }
  return json.get<std::uint32_t>();
}

int count(const Json& json) {
  return static_cast<int>(std::min<std::uint32_t>(wholeNumber(json), 1U << 30U));
}

template <std::size_t N>
std::array<double, N> numbers(const Json& json) {
  if (!json.is_array() || json.size() != N) {
    throw failure<MessageId::recipe_list_length>(N);
  }
  std::array<double, N> values{};
  for (std::size_t i = 0; i < N; ++i) values[i] = number(json.at(i));
  return values;
}

FilePoint pointFrom(const Json& json) {
  const auto v = numbers<3>(json);
  return {v[0], v[1], v[2]};
}

Rotation rotationFrom(const Json& json) {
  if (!json.is_string()) return numbers<9>(json);
  const auto rotation = standardRotation(json.get<std::string>());
  if (!rotation) throw failure<MessageId::recipe_no_view>(json.dump());
  return *rotation;
}

bool keepsInside(const Json& json) {
  const auto word = json.at("keep").get<std::string>();
  if (word != "inside" && word != "outside") {
    throw failure<MessageId::recipe_keep_side>();
  }
  return word == "inside";
}

const Json& listOf(const Json& json, const char* key, std::size_t most) {
  const Json& list = json.at(key);
  if (!list.is_array() || list.size() > most) {
    throw failure<MessageId::recipe_list_too_long>(key, most);
  }
  return list;
}

std::optional<double> optionalNumber(const Json& json, const char* key) {
  if (!json.contains(key) || json.at(key).is_null()) return std::nullopt;
  return number(json.at(key));
}

Rotation optionalRotation(const Json& json, const char* key) {
  return json.contains(key) ? rotationFrom(json.at(key)) : kFileAxes;
}

Step cropBoxFrom(const Json& json) {
  requireKeys(json, {"kind", "min", "max", "axes", "keep"});
  return CropBox{.min = pointFrom(json.at("min")),
                 .max = pointFrom(json.at("max")),
                 .axes = optionalRotation(json, "axes"),
                 .keep_inside = keepsInside(json)};
}

Step cropOutlineFrom(const Json& json) {
  requireKeys(json, {"kind", "view", "outline", "keep"});
  CropOutline step{
      .view = optionalRotation(json, "view"), .outline = {}, .keep_inside = keepsInside(json)};
  for (const Json& corner : listOf(json, "outline", kMostOutlineCorners)) {
    step.outline.push_back(numbers<2>(corner));
  }
  return step;
}

Step classesFrom(const Json& json) {
  requireKeys(json, {"kind", "keep", "keep_noise"});
  Classes step;
  for (const Json& kept : listOf(json, "keep", 256)) {
    const std::uint32_t number_of_class = wholeNumber(kept);
    if (number_of_class > 255) throw failure<MessageId::recipe_class>();
    step.keep.push_back(static_cast<std::uint8_t>(number_of_class));
  }
  step.keep_noise = json.value("keep_noise", step.keep_noise);
  return step;
}

Step returnsFrom(const Json& json) {
  requireKeys(json, {"kind", "keep"});
  const auto keep = json.at("keep").get<std::string>();
  const auto* const known = std::find(kReturnNames.begin(), kReturnNames.end(), keep);
  if (known == kReturnNames.end()) throw failure<MessageId::recipe_returns>();
  return Returns{static_cast<ReturnChoice>(known - kReturnNames.begin())};
}

Step intensitiesFrom(const Json& json) {
  requireKeys(json, {"kind", "low", "high"});
  return Intensities{.low = number(json.at("low")), .high = number(json.at("high"))};
}

Step outliersFrom(const Json& json) {
  requireKeys(json, {"kind", "neighbours", "deviations"});
  return Outliers{.neighbours = count(json.at("neighbours")),
                  .deviations = number(json.at("deviations"))};
}

Step lonelyFrom(const Json& json) {
  requireKeys(json, {"kind", "radius_mm", "spacings", "share", "neighbours"});
  return Lonely{.radius_mm = optionalNumber(json, "radius_mm"),
                .spacings = optionalNumber(json, "spacings").value_or(Lonely{}.spacings),
                .share = optionalNumber(json, "share").value_or(Lonely{}.share),
                .neighbours = count(json.at("neighbours"))};
}

Step sparseFrom(const Json& json) {
  requireKeys(json, {"kind", "neighbours", "factor", "off_surface"});
  return Sparse{.neighbours = count(json.at("neighbours")),
                .factor = number(json.at("factor")),
                .off_surface = optionalNumber(json, "off_surface").value_or(0)};
}

Step baseFrom(const Json& json) {
  requireKeys(json, {"kind", "lay", "distance_mm", "seed"});
  return Base{.lay = json.at("lay").get<bool>(),
              .distance_mm = optionalNumber(json, "distance_mm"),
              .seed = json.contains("seed") ? wholeNumber(json.at("seed")) : Base{}.seed};
}

Step alignFrom(const Json& json) {
  requireKeys(json, {"kind", "method", "reference", "pairs", "seed", "poses"});
  Align step;
  const auto method = json.at("method").get<std::string>();
  const auto* const known = std::find(kAlignMethodNames.begin(), kAlignMethodNames.end(), method);
  if (known == kAlignMethodNames.end()) {
    throw failure<MessageId::recipe_method>();
  }
  step.method = static_cast<AlignMethod>(known - kAlignMethodNames.begin());
  if (json.contains("reference")) step.reference = wholeNumber(json.at("reference"));
  if (json.contains("seed")) step.seed = wholeNumber(json.at("seed"));
  if (json.contains("pairs")) {
    for (const Json& pair : listOf(json, "pairs", kMostPairs)) {
      requireKeys(pair, {"scan", "point", "reference"});
      step.pairs.push_back({.scan = wholeNumber(pair.at("scan")),
                            .point = pointFrom(pair.at("point")),
                            .reference = pointFrom(pair.at("reference"))});
    }
  }
  if (json.contains("poses")) {
    for (const Json& pose : listOf(json, "poses", kMostScans)) {
      step.poses.push_back(Pose{numbers<16>(pose)});
    }
  }
  return step;
}

Step stepFrom(const Json& json) {
  if (!json.is_object()) throw failure<MessageId::recipe_step_no_object>();
  const auto kind = json.at("kind").get<std::string>();
  if (kind == "crop_box") return cropBoxFrom(json);
  if (kind == "crop_outline") return cropOutlineFrom(json);
  if (kind == "classes") return classesFrom(json);
  if (kind == "intensities") return intensitiesFrom(json);
  if (kind == "returns") return returnsFrom(json);
  if (kind == "outliers") return outliersFrom(json);
  if (kind == "lonely") return lonelyFrom(json);
  if (kind == "sparse") return sparseFrom(json);
  if (kind == "base") return baseFrom(json);
  if (kind == "align") return alignFrom(json);
  if (kind == "duplicates") {
    requireKeys(json, {"kind"});
    return Duplicates{};
  }
  if (kind == "thin") {
    requireKeys(json, {"kind", "spacing_mm"});
    return Thin{.spacing_mm = number(json.at("spacing_mm"))};
  }
  if (kind == "normals") {
    requireKeys(json, {"kind", "neighbours"});
    return Normals{.neighbours = count(json.at("neighbours"))};
  }
  throw failure<MessageId::recipe_step_unknown>(kind.substr(0, 40));
}

ScanSource sourceFrom(const Json& json) {
  requireKeys(json, {"file", "sha256", "unit", "parts", "keep_withheld"});
  ScanSource source{.file = json.at("file").get<std::string>(),
                    .sha256 = json.value("sha256", std::string()),
                    .unit = std::nullopt};
  // A file name with a zero inside would be another file to the operating system.
  if (source.file.empty() || source.file.find('\0') != std::string::npos) {
    throw failure<MessageId::field_no_file_name>("file");
  }
  const bool digits = source.sha256.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!source.sha256.empty() && (source.sha256.size() != 64 || !digits)) {
    throw failure<MessageId::field_no_checksum>("sha256");
  }
  if (json.contains("unit") && !json.at("unit").is_null()) {
    source.unit = lengthUnit(json.at("unit").get<std::string>());
    if (!source.unit) throw failure<MessageId::recipe_unit>();
  }
  if (json.contains("parts")) {
    for (const Json& part : listOf(json, "parts", kMostScans)) {
      if (!part.is_number_integer() || part.get<std::int64_t>() < 1 ||
          part.get<std::int64_t>() > std::numeric_limits<int>::max()) {
        throw failure<MessageId::recipe_parts>();
      }
      source.parts.push_back(part.get<int>());
    }
  }
  source.keep_withheld = json.value("keep_withheld", false);
  return source;
}

Recipe recipeFrom(std::string_view text) {
  constexpr int kDeepest = 16;
  if (isNestedDeeper(text, kDeepest)) throw failure<MessageId::field_nested_too_deep>();
  const Json json = Json::parse(text);
  if (!json.is_object() || !json.contains(kKey) || !json.at(kKey).is_number_integer()) {
    throw failure<MessageId::field_missing>(kKey);
  }
  const auto schema = json.at(kKey).get<std::int64_t>();
  if (schema != kSchema) {
    throw failure<MessageId::recipe_schema>(schema);
  }
  requireKeys(json, {kKey, "scans", "steps"});
  Recipe recipe;
  if (json.contains("scans")) {
    for (const Json& source : listOf(json, "scans", kMostScans)) {
      recipe.scans.push_back(sourceFrom(source));
    }
  }
  for (const Json& step : listOf(json, "steps", kMostSteps)) recipe.steps.push_back(stepFrom(step));
  check(recipe);
  return recipe;
}

}  // namespace

std::string toJson(const Step& step) {
  return jsonOf(step).dump();
}

std::string toJson(const Recipe& recipe, int indent) {
  Json json;
  json[kKey] = kSchema;
  json["scans"] = Json::array();
  for (const ScanSource& source : recipe.scans) {
    Json& scan = json["scans"].emplace_back(Json{{"file", source.file}});
    if (!source.sha256.empty()) scan["sha256"] = source.sha256;
    if (source.unit) scan["unit"] = name(*source.unit);
    if (!source.parts.empty()) scan["parts"] = source.parts;
    if (source.keep_withheld) scan["keep_withheld"] = true;
  }
  json["steps"] = Json::array();
  for (const Step& step : recipe.steps) json["steps"].push_back(jsonOf(step));
  return json.dump(indent, ' ', true, Json::error_handler_t::replace);
}

namespace {

/// The library names the key that is missing in quotes.
Message messageOf(const nlohmann::json::out_of_range& error) {
  constexpr int kNoSuchKey = 403;
  const std::string_view what = error.what();
  const std::size_t begin = what.find('\''), end = what.rfind('\'');
  if (error.id != kNoSuchKey || begin == end) return said<MessageId::recipe_number_too_large>();
  return said<MessageId::recipe_key_missing>(what.substr(begin + 1, end - begin - 1));
}

}  // namespace

Recipe recipeFromJson(std::string_view text, const std::string& source) {
  const auto refused = [&source](Message why) {
    return failure<MessageId::recipe_unreadable>(source, std::move(why));
  };
  try {
    return recipeFrom(text);
  } catch (const nlohmann::json::parse_error& error) {
    const std::string_view before = text.substr(0, std::max<std::size_t>(error.byte, 1) - 1);
    throw refused(said<MessageId::recipe_line_is_no_json>(
        1 + std::count(before.begin(), before.end(), '\n')));
  } catch (const nlohmann::json::out_of_range& error) {
    throw refused(messageOf(error));
  } catch (const nlohmann::json::exception&) {
    throw refused(said<MessageId::recipe_part_missing>());
  } catch (const Error& error) {
    throw refused(relievo::messageOf(error));
  }
}

}  // namespace relievo
