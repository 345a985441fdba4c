// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace relievo {

struct LightOptions {
  double azimuth_deg =
      315;  ///< From where the key light shines: 0 = up, clockwise (315 = upper left).
  double elevation_deg = 45;  ///< Above the base plane.
  friend bool operator==(const LightOptions&, const LightOptions&) = default;
};

/// What a relief is painted with.
enum class ReliefKind {
  lit,              ///< Matt stone under lamps: the ordinary picture.
  height,           ///< Height as colour, lit.
  hillshade,        ///< Brightness under the key light alone (Horn 1981).
  multi_hillshade,  ///< Four lights weighted by aspect (Mark 1992).
  slope,            ///< Steepness, degrees.
  local_relief,     ///< Height above the smoothed surface, mm.
  sky_view,         ///< Sky-view factor, 0 .. 1 (Zaksek, Ostir, Kokalj 2011).
  openness,         ///< Positive openness, degrees (Yokoyama, Shirasawa, Pike 2002).
  multi_scale,      ///< Standard deviations above the neighbourhood, at the scale where most.
  curvature,        ///< Share of a ball that lies above the surface, of several scales.
  occlusion,        ///< Stone under lamps, darker where less of the sky is seen.
  natural,          ///< The scan's own colours.
  intensity,        ///< The scan's intensities, grey.
};
inline constexpr std::array<std::string_view, 13> kReliefKindNames{
    "lit",      "height",     "hillshade", "multi",     "slope",   "local",    "skyview",
    "openness", "multiscale", "curvature", "occlusion", "natural", "intensity"};
inline constexpr std::string_view name(ReliefKind kind) noexcept {
  return kReliefKindNames[static_cast<std::size_t>(kind)];
}
std::optional<ReliefKind> reliefKind(std::string_view name);

enum class ColourMap { grey, viridis, cividis, batlow };
inline constexpr std::array<std::string_view, 4> kColourMapNames{"grey", "viridis", "cividis",
                                                                 "batlow"};
inline constexpr std::string_view name(ColourMap map) noexcept {
  return kColourMapNames[static_cast<std::size_t>(map)];
}
std::optional<ColourMap> colourMap(std::string_view name);

/// How a relief is painted; the same record for screen, figure and file.
struct ReliefLook {
  ReliefKind kind = ReliefKind::lit;
  ColourMap colours = ColourMap::viridis;  ///< Not of `lit` and the hillshades, which are grey.
  LightOptions light = {};
  double radius_mm = 0;  ///< Of the kinds that look around a cell (hasRadius); 0: 10 samples.
  /// Values at the colours' ends; nothing: from the data.
  std::optional<std::array<double, 2>> range = std::nullopt;
  /// Of natural and intensity, 0 ... 1: how much the key light's shading of the relief darkens and
  /// lightens them. 0: as they were recorded.
  double shading = 0.5;
  /// Cells that were interpolated in a colour of their own. Figures have their hatch instead.
  bool unmeasured = false;
  friend bool operator==(const ReliefLook&, const ReliefLook&) = default;
};

/// How two eyes' pictures become one on screen: for red (left) and cyan glasses, in grey, half
/// colour, or by Dubois's least squares; or for screens that show each eye its own half or its own
/// rows (see StereoPrint).
enum class StereoMode { off, anaglyph, half_colour, dubois, side_by_side, over_under, interlaced };
inline constexpr std::array<std::string_view, 7> kStereoModeNames{
    "off", "anaglyph", "half", "dubois", "sidebyside", "overunder", "interlaced"};
inline constexpr std::string_view name(StereoMode mode) noexcept {
  return kStereoModeNames[static_cast<std::size_t>(mode)];
}
std::optional<StereoMode> stereoMode(std::string_view name);

struct StereoOptions {
  StereoMode mode = StereoMode::off;
  double eye_angle_deg = 4;  ///< Between the eyes' directions, full, as drawn; see eye_angle.h.
  std::optional<double> zero_plane_mm =
      std::nullopt;  ///< View z of zero parallax; nothing: mid height.
  bool swap_eyes = false;
  /// A window lets the eye angle follow the heights that it shows (automaticEyeAngle).
  bool automatic_depth = false;
  friend bool operator==(const StereoOptions&, const StereoOptions&) = default;
};

}  // namespace relievo
