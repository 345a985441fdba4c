// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

namespace relievo {

/// How strong all forces are, as one choice; the strengths between them can be had, too.
struct StrengthPreset {
  std::string_view id;  ///< Stable; of the command line.
  int percent;          ///< Of every force.
};
/// Medium is where everybody begins; the least that still feels like stone, and all there is.
inline constexpr std::array<StrengthPreset, 3> kStrengthPresets{
    {{"gentle", 30}, {"medium", 60}, {"full", 100}}};

/// Nothing: no preset of that id.
constexpr const StrengthPreset* strengthPreset(std::string_view id) {
  for (const StrengthPreset& preset : kStrengthPresets) {
    if (preset.id == id) return &preset;
  }
  return nullptr;
}

}  // namespace relievo
