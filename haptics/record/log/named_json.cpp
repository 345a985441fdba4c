// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/log/named_json.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

#include "haptics/record/log/named_fields.h"

namespace relievo {

namespace {

using Json = nlohmann::ordered_json;

template <class T>
constexpr bool kIsVec3 = false;
template <class Tag>
constexpr bool kIsVec3<Vec3<Tag>> = true;
template <class T>
constexpr bool kIsArray = false;
template <class T, std::size_t N>
constexpr bool kIsArray<std::array<T, N>> = true;

// The last value of each enum among the members.
constexpr ProxyKind lastOf(ProxyKind) {
  return ProxyKind::successive;
}
constexpr DeviceFault lastOf(DeviceFault) {
  return DeviceFault::not_ready;
}
constexpr SurfaceKind lastOf(SurfaceKind) {
  return SurfaceKind::bilinear;
}
constexpr ForceChain lastOf(ForceChain) {
  return ForceChain::bare;
}
constexpr EngagePhase lastOf(EngagePhase) {
  return EngagePhase::on;
}
constexpr StopReason lastOf(StopReason) {
  return StopReason::window_silent;
}
constexpr GuidePhase lastOf(GuidePhase) {
  return GuidePhase::pausing;
}
constexpr FeltPattern lastOf(FeltPattern) {
  return FeltPattern::edge;
}
constexpr GuideEnd lastOf(GuideEnd) {
  return GuideEnd::surface;
}
constexpr GripPosition lastOf(GripPosition) {
  return GripPosition::right;
}

// JSON has no numbers for these.
constexpr const char* kInfinity = "inf";
constexpr const char* kMinusInfinity = "-inf";
constexpr const char* kNotANumber = "nan";

template <class T>
Json jsonOf(const T& value) {
  if constexpr (std::is_same_v<T, double>) {
    if (std::isfinite(value)) return value;
    if (std::isnan(value)) return kNotANumber;
    return value > 0 ? kInfinity : kMinusInfinity;
  } else if constexpr (std::is_enum_v<T>) {
    return static_cast<int>(value);
  } else if constexpr (std::is_arithmetic_v<T>) {
    return value;
  } else if constexpr (kIsVec3<T>) {
    return Json::array({jsonOf(value.x), jsonOf(value.y), jsonOf(value.z)});
  } else if constexpr (kIsArray<T>) {
    Json all = Json::array();
    for (const auto& one : value) all.push_back(jsonOf(one));
    return all;
  } else {
    Json all = Json::object();
    const auto put = [&all](const char* name, const auto& member) { all[name] = jsonOf(member); };
    NamedFields::visit(put, value);
    return all;
  }
}

template <class T>
bool read(const Json& json, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    if (json.is_boolean()) value = json.get<bool>();
    return json.is_boolean();
  } else if constexpr (std::is_same_v<T, double>) {
    constexpr double kInf = std::numeric_limits<double>::infinity();
    if (json == kInfinity) return (value = kInf, true);
    if (json == kMinusInfinity) return (value = -kInf, true);
    if (json == kNotANumber) return (value = std::numeric_limits<double>::quiet_NaN(), true);
    if (json.is_number()) value = json.get<double>();
    return json.is_number();
  } else if constexpr (std::is_enum_v<T>) {
    std::uint8_t code = 0;
    const bool fits = read(json, code) && code <= static_cast<int>(lastOf(value));
    if (fits) value = static_cast<T>(code);
    return fits;
  } else if constexpr (std::is_integral_v<T>) {
    if (!json.is_number_integer()) return false;
    const bool fits = json.is_number_unsigned() ? std::in_range<T>(json.get<std::uint64_t>())
                                                : std::in_range<T>(json.get<std::int64_t>());
    if (fits) value = json.get<T>();
    return fits;
  } else if constexpr (kIsVec3<T>) {
    return json.is_array() && json.size() == 3 && read(json[0], value.x) &&
           read(json[1], value.y) && read(json[2], value.z);
  } else if constexpr (kIsArray<T>) {
    if (!json.is_array() || json.size() != value.size()) return false;
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (!read(json[i], value[i])) return false;
    }
    return true;
  } else {
    bool fits = json.is_object();
    const auto take = [&](const char* name, auto& member) {
      const auto found = fits ? json.find(name) : json.end();
      if (found != json.end()) fits = read(*found, member);
    };
    NamedFields::visit(take, value);
    return fits;
  }
}

template <class T>
bool parsed(std::string_view text, T& value) {
  const Json json = Json::parse(text, nullptr, false);
  T told;
  if (json.is_discarded() || !read(json, told)) return false;
  value = told;
  return true;
}

}  // namespace

std::string toJson(const HapticOptions& options) {
  return jsonOf(options).dump();
}
std::string toJson(const CoreSnapshot& snapshot) {
  return jsonOf(snapshot).dump();
}
std::string toJson(const GuidePath& path) {
  Json points = Json::array();
  for (std::uint32_t i = 0; i < path.count; ++i) {
    const GuidePoint& p = path.points[i];
    points.push_back({p.place.x, p.place.y, p.place.z, p.speed_mm_per_s, p.pause_s});
  }
  return Json{{"id", path.id},
              {"scene_id", path.scene_id},
              {"closed", path.closed},
              {"rounds", path.rounds},
              {"points", std::move(points)}}
      .dump();
}

bool fromJson(std::string_view text, GuidePath& path) {
  const Json json = Json::parse(text, nullptr, false);
  GuidePath told;
  const auto has = [&json](const char* name, auto& member) {
    return json.contains(name) && read(json[name], member);
  };
  const bool begins = json.is_object() && has("id", told.id) && has("scene_id", told.scene_id) &&
                      has("closed", told.closed) && has("rounds", told.rounds) &&
                      json.contains("points") && json["points"].is_array() &&
                      json["points"].size() <= GuidePath::kMostPoints;
  if (!begins) return false;
  for (const Json& point : json["points"]) {
    std::array<double, 5> numbers{};
    if (!read(point, numbers)) return false;
    told.points[told.count++] = {{numbers[0], numbers[1], numbers[2]}, numbers[3], numbers[4]};
  }
  if (!completePath(told)) return false;
  path = told;
  return true;
}

bool fromJson(std::string_view text, HapticOptions& options) {
  return parsed(text, options);
}
bool fromJson(std::string_view text, CoreSnapshot& snapshot) {
  return parsed(text, snapshot);
}

}  // namespace relievo
