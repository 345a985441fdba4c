// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/unit.h"

namespace relievo {

/// The unit of so many metres, to 1e-7.
inline std::optional<LengthUnit> unitOfMetres(double metres) {
  for (const LengthUnitFact& fact : kLengthUnits) {
    if (std::abs(metres * 1000 - fact.mm) <= 1e-7 * fact.mm) return fact.unit;
  }
  return std::nullopt;
}

/// The name by which projections call a unit.
inline constexpr std::string_view projectionName(LengthUnit unit) noexcept {
  constexpr std::array<std::string_view, 6> kNames{"millimetre", "centimetre", "metre",
                                                   "inch",       "foot",       "US survey foot"};
  return kNames[static_cast<std::size_t>(unit)];
}

/// By one of the names that rasters and projections use.
inline std::optional<LengthUnit> unitOfName(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, LengthUnit>, 13> kNames{{
      {"m", LengthUnit::m},
      {"metre", LengthUnit::m},
      {"meter", LengthUnit::m},
      {"metres", LengthUnit::m},
      {"meters", LengthUnit::m},
      {"mm", LengthUnit::mm},
      {"cm", LengthUnit::cm},
      {"in", LengthUnit::in},
      {"ft", LengthUnit::ft},
      {"foot", LengthUnit::ft},
      {"sfoot", LengthUnit::us_ft},
      {"US survey foot", LengthUnit::us_ft},
      {"us-ft", LengthUnit::us_ft},
  }};
  for (const auto& [known, unit] : kNames) {
    if (known == text) return unit;
  }
  return std::nullopt;
}

}  // namespace relievo
