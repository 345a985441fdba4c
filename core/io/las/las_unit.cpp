// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/las/las_unit.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string>

#include "core/io/file_check.h"
#include "core/io/formats/lines.h"
#include "core/io/formats/little_endian.h"
#include "core/io/formats/number_text.h"
#include "core/io/formats/unit_text.h"
#include "core/io/worker/planted_fault.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::size_t kRecordHead = 54;
constexpr std::uint16_t kGeoKeys = 34735;
constexpr std::uint16_t kWellKnownText = 2112;

constexpr std::uint16_t kModelType = 1024;  ///< 2: coordinates are degrees.
constexpr std::uint16_t kProjectedSystem = 3072;
constexpr std::uint16_t kGeographicSystem = 2048;
constexpr std::uint16_t kVerticalSystem = 4096;
constexpr std::uint16_t kUserDefined = 32767;
constexpr std::uint16_t kLinearUnits = 3076;
constexpr std::uint16_t kVerticalUnits = 4099;

/// What the file says; a later record wins over an earlier one.
struct StatedUnits {
  std::optional<LengthUnit> horizontal, vertical;
  std::string unknown;  ///< A horizontal unit that is stated but not known here, in words.
  std::optional<std::uint16_t> system;  ///< EPSG code of the projected system.
  bool degrees = false;
  std::string text;  ///< Well-known text, as it is.
  std::string keys;  ///< All GeoTIFF keys whose value is a number, "1024=1 3072=26910".
  std::optional<std::uint16_t> geographic_system, vertical_system;

  /// As ScanInfo has it. A code says all that keys could; text says more.
  std::string referenceSystem() const {
    if (!text.empty()) return text;
    const auto& horizontal_system = system ? system : geographic_system;
    if (!horizontal_system) return keys.empty() ? keys : "GeoTIFF " + keys;
    return "EPSG:" + std::to_string(*horizontal_system) +
           (vertical_system ? "+" + std::to_string(*vertical_system) : "");
  }
};

/// EPSG codes of units.
std::optional<LengthUnit> unitOfCode(std::uint16_t code) {
  switch (code) {
    case 1025:
      return LengthUnit::mm;
    case 1033:
      return LengthUnit::cm;
    case 9001:
      return LengthUnit::m;
    case 9002:
      return LengthUnit::ft;
    case 9003:
      return LengthUnit::us_ft;
    default:
      return std::nullopt;
  }
}

void readGeoKeys(std::string_view record, StatedUnits& units) {
  constexpr std::size_t kKey = 8;  // Key, place of its value (0: here), count, value.
  for (std::size_t at = kKey; at + kKey <= record.size(); at += kKey) {
    if (u16At(record, at + 2) != 0) continue;
    const std::uint16_t value = u16At(record, at + 6);
    const bool is_code = value != 0 && value != kUserDefined;
    units.keys += (units.keys.empty() ? "" : " ") + std::to_string(u16At(record, at)) + "=" +
                  std::to_string(value);
    switch (u16At(record, at)) {
      case kModelType:
        units.degrees = value == 2;
        break;
      case kLinearUnits:
        units.horizontal = unitOfCode(value);
        units.unknown = units.horizontal ? "" : "of code " + std::to_string(value);
        break;
      case kProjectedSystem:
        if (is_code) units.system = value;
        break;
      case kGeographicSystem:
        if (is_code) units.geographic_system = value;
        break;
      case kVerticalSystem:
        if (is_code) units.vertical_system = value;
        break;
      case kVerticalUnits:
        units.vertical = unitOfCode(value);
        break;
      default:
        break;
    }
  }
}

/// Metres in the last length unit that the text names: UNIT["foot",0.3048] or
/// LENGTHUNIT["metre",1].
std::optional<double> lastUnitMetres(std::string_view text) {
  const std::size_t at = text.rfind("UNIT[\"");
  if (at == std::string_view::npos) return std::nullopt;
  text.remove_prefix(at + 6);
  const std::size_t quote = text.find('"');
  if (quote == std::string_view::npos || quote + 1 >= text.size()) return std::nullopt;
  std::string unit_name(text.substr(0, quote));
  std::transform(unit_name.begin(), unit_name.end(), unit_name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  const bool is_length =
      unit_name.find("met") != std::string::npos || unit_name.find('f') != std::string::npos;
  std::string_view number = text.substr(quote + 1);
  number.remove_prefix(std::min(number.find_first_not_of(", "), number.size()));
  if (!is_length) return std::nullopt;
  return parseNumber(number.substr(0, number.find_first_of(",] ")));
}

std::optional<LengthUnit> lastUnit(std::string_view text) {
  const auto metres = lastUnitMetres(text);
  return metres ? unitOfMetres(*metres) : std::nullopt;
}

/// Where the first of these words is; npos if none is there.
std::size_t findAny(std::string_view text, std::initializer_list<std::string_view> words) {
  std::size_t first = std::string_view::npos;
  for (const std::string_view word : words) first = std::min(first, text.find(word));
  return first;
}

/// Projected systems in the older form of well-known text (the one LAS 1.4 asks for) and in that
/// of 2015 and later (ISO 19162).
void readText(std::string_view text, StatedUnits& units) {
  text = text.substr(0, text.find('\0'));
  units.text = text;
  const std::size_t vertical = findAny(text, {"VERT_CS[", "VERTCRS[", "VERTICALCRS["});
  const std::string_view horizontal = text.substr(0, vertical);
  if (findAny(horizontal, {"PROJCS[", "PROJCRS[", "PROJECTEDCRS["}) == std::string_view::npos) {
    const bool degrees =
        findAny(horizontal, {"GEOGCS[", "GEOGCRS[", "GEOGRAPHICCRS[", "GEODCRS["}) == 0;
    units.degrees = units.degrees || degrees;
    return;
  }
  units.horizontal = lastUnit(horizontal);
  const auto metres = lastUnitMetres(horizontal);
  units.unknown = metres && !units.horizontal ? "of " + roundTripText(std::array{*metres}) + " m"
                                              : std::string();
  if (vertical != std::string_view::npos) units.vertical = lastUnit(text.substr(vertical));
}

StatedUnits readRecords(std::string_view bytes, const LasHeader& header) {
  StatedUnits units;
  const auto end =
      static_cast<std::size_t>(std::min<std::uint64_t>(header.points_at, bytes.size()));
  std::size_t at = header.header_bytes;
  for (std::uint32_t i = 0; i < header.variable_records && at + kRecordHead <= end; ++i) {
    const std::string_view user = bytes.substr(at + 2, 16);
    const std::uint16_t kind = u16At(bytes, at + 18);
    const std::size_t length = u16At(bytes, at + 20);
    if (length > end - at - kRecordHead) break;
    const std::string_view record = bytes.substr(at + kRecordHead, length);
    if (user.starts_with("LASF_Projection")) {
      if (kind == kGeoKeys) readGeoKeys(record, units);
      if (kind == kWellKnownText) readText(record, units);
    }
    at += kRecordHead + length;
  }
  return units;
}

double heightFactor(std::optional<LengthUnit> vertical, ScanInfo& info) {
  if (!info.unit || !vertical || *info.unit == *vertical) return 1;
  info.warnings.push_back(
      said<MessageId::heights_converted_to_unit_of_plane>(name(*vertical), name(*info.unit)));
  return mmPer(*vertical) / mmPer(*info.unit);
}

}  // namespace

double readLasUnit(std::string_view bytes, const LasHeader& header, ScanInfo& info) {
  const StatedUnits units = readRecords(bytes, header);
  info.reference_system = printable(units.referenceSystem());
  plantedFault(units.degrees && units.vertical);
  if (units.degrees) {
    info.warnings.push_back(said<MessageId::las_in_degrees>());
    return 1;
  }
  info.unit = units.horizontal;
  if (!units.unknown.empty()) {
    info.warnings.push_back(said<MessageId::las_unit_unknown>(units.unknown));
  }
  return heightFactor(units.vertical, info);
}

double heightFactor(const LasSystem& system, ScanInfo& info) {
  return heightFactor(system.height_unit, info);
}

std::optional<LasSystem> lasSystem(std::string_view bytes, const LasHeader& header) {
  const StatedUnits units = readRecords(bytes, header);
  if (units.degrees || units.horizontal || !units.unknown.empty() || !units.system) {
    return std::nullopt;
  }
  return LasSystem{.code = *units.system, .height_unit = units.vertical};
}

}  // namespace relievo
