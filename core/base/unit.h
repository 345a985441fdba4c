// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace relievo {

/// Length unit of a file's coordinates.
enum class LengthUnit { mm, cm, m, in, ft, us_ft };

struct LengthUnitFact {
  LengthUnit unit;
  std::string_view name;  ///< As on the command line.
  double mm;              ///< Millimetres in one unit, exact by definition.
};

inline constexpr std::array<LengthUnitFact, 6> kLengthUnits{{
    {LengthUnit::mm, "mm", 1.0},
    {LengthUnit::cm, "cm", 10.0},
    {LengthUnit::m, "m", 1000.0},
    {LengthUnit::in, "in", 25.4},
    {LengthUnit::ft, "ft", 304.8},
    {LengthUnit::us_ft, "us-ft", 1200000.0 / 3937.0},
}};

inline constexpr double mmPer(LengthUnit u) noexcept {
  return kLengthUnits[static_cast<std::size_t>(u)].mm;
}
inline constexpr std::string_view name(LengthUnit u) noexcept {
  return kLengthUnits[static_cast<std::size_t>(u)].name;
}
inline constexpr std::optional<LengthUnit> lengthUnit(std::string_view name) noexcept {
  for (const LengthUnitFact& fact : kLengthUnits) {
    if (fact.name == name) return fact.unit;
  }
  return std::nullopt;
}

/// Who said which unit a file has. guessed: nobody, but it is no millimetre; assumed: nobody, so
/// one file unit is 1 mm.
enum class UnitSource { given, file, remembered, assumed, guessed };
inline constexpr std::string_view name(UnitSource s) noexcept {
  constexpr std::array<std::string_view, 5> kNames{"given", "file", "remembered", "assumed",
                                                   "guessed"};
  return kNames[static_cast<std::size_t>(s)];
}

}  // namespace relievo
