// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/shown_lengths.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/project/caption.h"

namespace relievo {
namespace {

constexpr double kMetresFromMm = 4e3;  // A quarter of it, its scale bar, is a metre.
constexpr double kMillimetresFromMm = 0.04;
constexpr double kKilometreMm = 1e6;

ShownUnit unitOfObject(double longer_side_mm) {
  if (longer_side_mm >= kMetresFromMm) return {.name = "m", .size = 1e3};
  if (longer_side_mm >= kMillimetresFromMm) return {.name = "mm", .size = 1};
  return {.name = "\u00b5m", .size = 1e-3};
}

double longerSideMm(const Surface& surface) {
  return std::max(surface.ladder.width_mm, surface.ladder.height_mm);
}

}  // namespace

ShownLengths::ShownLengths(double longer_side_mm) : unit_(unitOfObject(longer_side_mm)) {}

ShownLengths::ShownLengths(const Surface& surface) : ShownLengths(longerSideMm(surface)) {}

ShownUnit ShownLengths::unitOf(double mm) const {
  if (unit_.name == "m" && std::abs(mm) >= kKilometreMm) return {.name = "km", .size = 1e6};
  return unit_;
}

ShownUnit ShownLengths::unitFor(std::string_view ours) const {
  if (ours == "mm") return unit_;
  constexpr std::array<std::array<std::string_view, 2>, 3> kPowers{
      {{"mm\u00b2", "mm\u00b3"}, {"m\u00b2", "m\u00b3"}, {"\u00b5m\u00b2", "\u00b5m\u00b3"}}};
  const auto& shown = kPowers.at(unit_.name == "mm" ? 0 : unit_.name == "m" ? 1 : 2);
  if (ours == kPowers[0][0]) return {.name = shown[0], .size = std::pow(unit_.size, 2)};
  if (ours == kPowers[0][1]) return {.name = shown[1], .size = std::pow(unit_.size, 3)};
  return {.name = ours};
}

std::string ShownLengths::number(double mm) const {
  return shortNumber(mm / unit_.size);
}

std::string ShownLengths::text(double mm, int digits) const {
  const ShownUnit unit = unitOf(mm);
  return shortNumber(mm / unit.size, digits) + " " + std::string(unit.name);
}

std::string ShownLengths::rectangle(double width_mm, double height_mm) const {
  const ShownUnit unit = unitOf(std::max(width_mm, height_mm));
  return shortNumber(width_mm / unit.size) + " \u00d7 " + shortNumber(height_mm / unit.size) + " " +
         std::string(unit.name);
}

}  // namespace relievo
