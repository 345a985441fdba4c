// SPDX-License-Identifier: BSD-3-Clause
#include "core/provenance/caption.h"

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>

namespace relievo {
namespace {

constexpr double kShortestMm2 = 0.01;

/// At most `digits` significant digits, without trailing zeros; never a decimal comma.
std::string shortText(double value, int digits = 4) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value == 0 ? 0 : value,
                                 std::chars_format::general, digits);
  return {text.data(), end.ptr};
}

std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string objectText(const Provenance& p, const Surface& surface) {
  const DepthMap& map = surface.map;
  const HeightRange z = heightRange(map);
  return std::filesystem::path(p.input.file).filename().string() + ", " + shortText(map.widthMm()) +
         " \u00d7 " + shortText(map.heightExtentMm()) + " \u00d7 " +
         shortText(z.max_mm - z.min_mm) + " mm (unit " + std::string(name(surface.unit)) + ", " +
         std::string(name(surface.unit_source)) + "), view " + surface.view_name + ".";
}

std::string holesText(const Provenance& p, const Surface& surface) {
  if (surface.holes.empty()) return "no enclosed holes";
  double area_mm2 = 0;
  std::size_t filled = 0;
  for (const Hole& hole : surface.holes) {
    area_mm2 += hole.area_mm2;
    if (hole.filled) ++filled;
  }
  std::string text = counted(surface.holes.size(), "enclosed hole");
  if (area_mm2 >= kShortestMm2) text += " of " + shortText(area_mm2, 3) + " mm\u00b2 together";
  if (p.options.holes.rule == HoleRule::none) return text + ", left open";
  if (filled == surface.holes.size()) return text + ", interpolated";
  if (filled == 0) return text + ", on the base plane";
  return text + ", " + std::to_string(filled) + " interpolated and the others on the base plane";
}

std::string mapText(const Provenance& p, const Surface& surface) {
  const GridFrame& frame = surface.map.frame;
  std::string text = "Depth map of " + std::to_string(frame.size.cols) + " \u00d7 " +
                     std::to_string(frame.size.rows) + " cells, " + shortText(frame.spacing_mm) +
                     " mm apart";
  if (surface.engine == "as stored") return text + ", as stored.";
  return text + ", engine " + surface.engine + ", heights by " + surface.rule + "; " +
         holesText(p, surface) + ".";
}

std::string regionText(const Surface& surface, const ViewState& view) {
  const Region& r = view.region;
  return "Detail " + std::to_string(surface.ladder.detailOf(r.level)) + " of " +
         std::to_string(surface.ladder.levels()) + " (level " + std::to_string(r.level.value) +
         ", M = " + shortText(surface.ladder.factor, 9) + "): " + shortText(r.side_mm) +
         " \u00d7 " + shortText(r.side_mm) + " mm from x " + shortText(r.x_mm) + ", y " +
         shortText(r.y_mm) + " mm; heights \u00d7 " + shortText(view.gain) +
         (view.gain == 1 ? " (true to scale)." : ".");
}

std::string lookText(const ReliefLook& look) {
  const std::string light = "light from " + shortText(look.light.azimuth_deg) + "\u00b0, " +
                            shortText(look.light.elevation_deg) + "\u00b0 above the plane";
  const std::string colours = " in " + std::string(name(look.colours));
  const std::string around =
      look.radius_mm > 0 ? ", radius " + shortText(look.radius_mm) + " mm" : ", radius 10 samples";
  switch (look.kind) {
    case ReliefKind::lit:
      return "Lit relief, " + light;
    case ReliefKind::height:
      return "Heights" + colours + ", " + light;
    case ReliefKind::hillshade:
      return "Hillshade, " + light;
    case ReliefKind::multi_hillshade:
      return "Hillshade of four lights " + shortText(look.light.elevation_deg) +
             "\u00b0 above the plane";
    case ReliefKind::slope:
      return "Slope" + colours;
    case ReliefKind::local_relief:
      return "Local relief" + around + "," + colours;
    case ReliefKind::sky_view:
      return "Sky-view factor" + around + "," + colours;
    case ReliefKind::openness:
      return "Positive openness" + around + "," + colours;
  }
  return {};
}

std::string seenText(const ViewState& view) {
  std::string text = lookText(view.look);
  if (view.azimuth_deg != 0 || view.elevation_deg != 0) {
    text += "; turned by " + shortText(view.azimuth_deg) + "\u00b0 and " +
            shortText(view.elevation_deg) + "\u00b0";
  }
  if (view.stereo.mode == StereoMode::anaglyph) {
    text +=
        "; red-cyan anaglyph, " + shortText(view.stereo.eye_angle_deg) + "\u00b0 between the eyes";
  }
  return text + ".";
}

std::string scaleText(const CaptionScale& scale) {
  std::string text = "1 pixel is " + shortText(scale.mm_per_pixel) + " mm";
  if (scale.paper_mm_per_mm) {
    const double one_to = 1 / *scale.paper_mm_per_mm;
    text += one_to >= 1 ? "; scale 1:" + shortText(one_to, 3)
                        : "; scale " + shortText(1 / one_to, 3) + ":1";
  }
  return text + ".";
}

/// Of the picture, not of the whole map: what the reader sees.
std::string sharesText(const RegionWindow& window) {
  constexpr std::array<const char*, kOriginCount> kWords{
      "measured", "interpolated", "holes on the base plane", "too steep to trust",
      "outside the object"};
  std::array<std::size_t, kOriginCount> counts{};
  for (const Origin origin : window.origins) ++counts.at(static_cast<std::size_t>(origin));
  std::string text;
  for (std::size_t i = 0; i < kOriginCount; ++i) {
    if (counts[i] == 0 && i > 0) continue;
    const double percent = 100.0 * static_cast<double>(counts[i]) /
                           static_cast<double>(std::max<std::size_t>(window.origins.size(), 1));
    text += (text.empty() ? "" : ", ") + shortText(percent, 3) + " % " + kWords.at(i);
  }
  return "Of the cells shown " + text + ".";
}

std::string sourceText(const Provenance& p) {
  std::string text = "relievo " + p.version;
  if (p.commit != "unknown") text += " (" + p.commit.substr(0, 12) + ")";
  if (!p.input.sha256.empty()) text += ", input SHA-256 " + p.input.sha256;
  return text + ".";
}

}  // namespace

std::string caption(const Provenance& p, const Surface& surface, const ViewState& view,
                    const RegionWindow& window, const CaptionScale& scale) {
  std::string text;
  for (const std::string& sentence :
       {objectText(p, surface), mapText(p, surface), regionText(surface, view), seenText(view),
        scaleText(scale), sharesText(window), sourceText(p)}) {
    text += (text.empty() ? "" : " ") + sentence;
  }
  return text;
}

}  // namespace relievo
