// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/source/unit_guess.h"

#include <algorithm>
#include <cmath>

#include "core/message/catalogue.h"

namespace relievo {
namespace {

// Of map projections the smallest coordinates in use are some ten thousands of metres; 100 m from
// the origin, in millimetres, no scanner measures an object a fraction as large.
constexpr double kProjected = 1e5;
constexpr double kPerhapsProjected = 1e4;
constexpr double kFarOff = 2;          // Times the scan's own width: it lies beside the origin.
constexpr double kHighestPlace = 3e4;  // Elevation of any place on land, in feet.
constexpr double kSmallestOfModels = 3;
constexpr double kSmallestInMm = 50;   // Below, thick objects are likelier in centimetres ...
constexpr double kFlat = 0.15;         // ... but for coins and seals.
constexpr double kLargestInMm = 3000;  // Beyond, a site in metres is likelier.

/// How far off the origin the scan lies in the plane, if that is far beside its width; else 0.
double distanceOff(const FileBounds& box) {
  const FilePoint size = box.max - box.min;
  const double off = std::max(std::abs(box.min.x + box.max.x), std::abs(box.min.y + box.max.y)) / 2;
  const double highest = std::max(std::abs(box.min.z), std::abs(box.max.z));
  const bool is_place = off >= kFarOff * std::max(size.x, size.y) && highest <= kHighestPlace;
  return is_place ? off : 0;
}

bool isFormat(const ScanInfo& info, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return info.format.rfind(name, 0) == 0; });
}

UnitGuess fromSize(const ScanInfo& info) {
  const FilePoint size = info.bounds->max - info.bounds->min;
  const double longest = std::max({size.x, size.y, size.z});
  const double shortest = std::min({size.x, size.y, size.z});
  if (isFormat(info, {"LAS", "LAZ", "COPC", "E57", "PTX"})) {
    return {.unit = LengthUnit::m, .reason = said<MessageId::unit_of_format>()};
  }
  if (longest < kSmallestOfModels) {
    return {.unit = LengthUnit::m, .reason = said<MessageId::unit_of_tiny>()};
  }
  if (longest < kSmallestInMm && shortest > kFlat * longest && !isFormat(info, {"STL", "3DS"})) {
    return {.unit = LengthUnit::cm, .reason = said<MessageId::unit_of_small>()};
  }
  if (longest > kLargestInMm) {
    return {.unit = LengthUnit::m, .reason = said<MessageId::unit_of_large>()};
  }
  return {.unit = LengthUnit::mm, .reason = said<MessageId::unit_of_usual>()};
}

NumberArgument fourDigits(double number) {
  return {.value = number, .digits = 4, .form = NumberArgument::Form::significant};
}

}  // namespace

UnitGuess guessUnit(const ScanInfo& info) {
  const double off = distanceOff(*info.bounds);
  if (off >= kProjected) {
    return {
        .unit = LengthUnit::m, .is_strong = true, .reason = said<MessageId::unit_of_projection>()};
  }
  if (off >= kPerhapsProjected) {
    return {.unit = LengthUnit::m, .reason = said<MessageId::unit_of_far_off>()};
  }
  return fromSize(info);
}

UnitInUse unitInUse(const ScanInfo& info, const std::optional<LengthUnit>& chosen,
                    UnitSource chosen_source) {
  if (chosen) return {.unit = *chosen, .source = chosen_source};
  if (info.unit) return {.unit = *info.unit, .source = UnitSource::file};
  if (info.bounds) {
    const UnitGuess guess = guessUnit(info);
    if (guess.is_strong) return {.unit = guess.unit, .source = UnitSource::guessed};
  }
  return {};
}

std::optional<Message> unitWords(const ScanInfo& info, const UnitInUse& unit) {
  if (unit.source == UnitSource::guessed) {
    return said<MessageId::unit_guessed>(name(unit.unit), guessUnit(info).reason);
  }
  if (unit.source != UnitSource::assumed) return std::nullopt;
  if (!info.bounds) return said<MessageId::unit_assumed>();
  const UnitGuess guess = guessUnit(info);
  if (guess.unit == LengthUnit::mm) return said<MessageId::unit_assumed>();
  const FilePoint size = mmPer(guess.unit) * (info.bounds->max - info.bounds->min);
  return said<MessageId::unit_assumed_but_likelier>(
      name(guess.unit), fourDigits(size.x), fourDigits(size.y), fourDigits(size.z), guess.reason);
}

}  // namespace relievo
