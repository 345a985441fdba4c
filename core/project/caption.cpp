// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/caption.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "core/relief/relief_image.h"

namespace relievo {
namespace {

std::string percent(double share) {
  return shortNumber(100 * share, 3) + " %";
}

std::string sharesText(const Surface& surface) {
  const auto shares = originShares(surface.map);
  constexpr std::array<const char*, kOriginCount> kWords{
      "measured", "interpolated", "holes on the base plane", "too steep", "outside"};
  std::string text = percent(shares[0]) + " of the cells measured";
  for (std::size_t i = 1; i < kOriginCount; ++i) {
    if (shares[i] > 0) text += ", " + percent(shares[i]) + " " + kWords[i];
  }
  return text;
}

std::string holesText(const Project& p, const Surface& surface) {
  if (surface.holes.empty()) return "no enclosed holes";
  const std::string count = std::to_string(surface.holes.size()) +
                            (surface.holes.size() == 1 ? " enclosed hole" : " enclosed holes");
  if (p.options.holes.rule == HoleRule::base) return count + " on the base plane";
  if (p.options.holes.rule == HoleRule::none) return count + " left open";
  return count +
         (p.options.holes.rule == HoleRule::membrane ? ", by a membrane up to "
                                                     : ", filled up to ") +
         shortNumber(p.options.holes.max_area_mm2) + " mm\u00b2";
}

std::string lookText(const Project& p) {
  const ReliefLook& look = p.figure.look;
  const std::string light = "light from " + shortNumber(look.light.azimuth_deg) + "\u00b0, " +
                            shortNumber(look.light.elevation_deg) + "\u00b0 high";
  const std::string colours = std::string(name(look.colours));
  const std::string radius =
      look.radius_mm > 0 ? "radius " + shortNumber(look.radius_mm) + " mm" : "radius 10 samples";
  switch (look.kind) {
    case ReliefKind::lit:
      return "Lit relief, " + light;
    case ReliefKind::height:
      return "Height in " + colours + ", " + light;
    case ReliefKind::hillshade:
      return "Hillshade, " + light;
    case ReliefKind::multi_hillshade:
      return "Hillshade from four lights " + shortNumber(look.light.elevation_deg) + "\u00b0 high";
    case ReliefKind::slope:
      return "Slope in " + colours;
    case ReliefKind::local_relief:
      return "Local relief, " + radius + ", in " + colours;
    case ReliefKind::sky_view:
      return "Sky-view factor, 16 directions, " + radius + ", in " + colours;
    case ReliefKind::openness:
      return "Positive openness, 16 directions, " + radius + ", in " + colours;
  }
  return {};
}

std::string stereoText(const Project& p, double eye_angle_deg) {
  if (p.figure.stereo == StereoPrint::off) return {};
  constexpr std::array<const char*, 6> kWords{"",
                                              "grey anaglyph",
                                              "half-colour anaglyph",
                                              "Dubois anaglyph",
                                              "side by side",
                                              "one over the other"};
  return " Stereo: " + std::string(kWords[static_cast<std::size_t>(p.figure.stereo)]) + ", " +
         shortNumber(eye_angle_deg, 3) + "\u00b0 between the eyes" +
         (p.figure.swap_eyes ? ", eyes swapped." : ".");
}

}  // namespace

std::string shortNumber(double value, int digits) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value == 0 ? 0.0 : value);
  return text.data();
}

std::string captionOf(const Project& p, const Surface& surface, double paper_per_mm,
                      double eye_angle_deg) {
  const DepthMap& map = surface.map;
  const HeightRange z = heightRange(map);
  const Region& r = p.region;
  const int levels = surface.ladder.levels();
  const double scale = 1 / paper_per_mm;
  std::string text = std::filesystem::path(p.file).filename().string() + " (unit " +
                     std::string(name(surface.unit)) + ", " +
                     std::string(name(surface.unit_source)) + "), seen from: " + surface.view_name +
                     ". ";
  text += "Depth map of " + std::to_string(map.frame.size.cols) + " \u00d7 " +
          std::to_string(map.frame.size.rows) + " cells of " + shortNumber(map.frame.spacing_mm) +
          " mm (engine " + surface.engine + "; " + surface.rule + "); " + sharesText(surface) +
          "; " + holesText(p, surface) + ". ";
  text += "Object " + shortNumber(map.widthMm()) + " \u00d7 " + shortNumber(map.heightExtentMm()) +
          " mm, relief " + shortNumber(z.max_mm - z.min_mm) + " mm. ";
  text += "Detail " + std::to_string(surface.ladder.detailOf(r.level)) + " of " +
          std::to_string(levels) + " (level " + std::to_string(r.level.value) +
          ", M = " + shortNumber(surface.pyramid.factor) + "): " + shortNumber(r.side_mm) +
          " \u00d7 " + shortNumber(r.side_mm) + " mm from x " + shortNumber(r.x_mm) + ", y " +
          shortNumber(r.y_mm) + " mm";
  text += p.gain == 1 ? ". " : "; heights \u00d7 " + shortNumber(p.gain) + ". ";
  text += lookText(p) + "." + stereoText(p, eye_angle_deg);
  text += scale >= 1 ? " Scale 1:" + shortNumber(scale, 3)
                     : " Scale " + shortNumber(1 / scale, 3) + ":1";
  text += ". relievo " + std::string(RELIEVO_VERSION_STRING);
  if (!p.sha256.empty()) text += ", input SHA-256 " + p.sha256.substr(0, 16) + "\u2026";
  return text + ".";
}

}  // namespace relievo
