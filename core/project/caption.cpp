// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/caption.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "core/measure/measure_text.h"
#include "core/project/shown_lengths.h"
#include "core/provenance/name_text.h"
#include "core/provenance/program.h"
#include "core/region/smoothing.h"
#include "core/relief/relief_image.h"
#include "core/session/map_facts.h"

namespace relievo {
namespace {

constexpr double kLeastArea = 0.01;  // Of the object's unit, squared.

std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string objectText(const Project& p, const Surface& surface) {
  const HeightRange z = mapFacts(surface).heights;
  const GridFrame& map = mapFrame(surface);
  const ShownLengths lengths(surface);
  const double width_mm = map.size.cols * map.spacing_mm;
  const double height_mm = map.size.rows * map.spacing_mm;
  const double rise_mm = z.max_mm - z.min_mm;
  const ShownUnit unit = lengths.unitOf(std::max(width_mm, height_mm));
  std::string size = lengths.rectangle(width_mm, height_mm);
  if (lengths.unitOf(rise_mm).name == unit.name) size.resize(size.rfind(' '));  // Said once.
  return escapedName(std::filesystem::path(p.file).filename().string()) + ", " + size + " \u00d7 " +
         lengths.text(rise_mm) + " (unit " + std::string(name(surface.unit)) + ", " +
         std::string(name(surface.unit_source)) + "), view " + surface.view_name + ".";
}

std::string holesText(const Project& p, const Surface& surface) {
  if (surface.holes.empty()) return "no enclosed holes";
  double area_mm2 = 0;
  std::size_t filled = 0;
  for (const Hole& hole : surface.holes) {
    area_mm2 += hole.area_mm2;
    if (hole.filled) ++filled;
  }
  std::string text = counted(surface.holes.size(), "enclosed hole");
  const ShownUnit unit = ShownLengths(surface).unitFor("mm\u00b2");
  if (area_mm2 >= kLeastArea * unit.size) {
    text +=
        " of " + shortNumber(area_mm2 / unit.size, 3) + " " + std::string(unit.name) + " together";
  }
  if (p.options.holes.rule == HoleRule::none) return text + " left open";
  if (filled == surface.holes.size()) return text + ", interpolated";
  if (filled == 0) return text + ", on the base plane";
  return text + ", " + std::to_string(filled) + " interpolated and the others on the base plane";
}

std::string mapText(const Project& p, const Surface& surface) {
  const GridFrame& frame = mapFrame(surface);
  std::string text = "Depth map of " + std::to_string(frame.size.cols) + " \u00d7 " +
                     std::to_string(frame.size.rows) + " cells, " +
                     ShownLengths(surface).text(frame.spacing_mm) + " apart";
  if (surface.engine == "as stored") return text + ", as stored.";
  text += ", method " + methodName(surface.engine);
  text += surface.rule == "as stored" ? ", heights as stored" : ", heights by " + surface.rule;
  return text + "; " + holesText(p, surface) + ".";
}

/// By how much a level is smoother than the map; nothing for the map itself.
std::string smoothingText(const Surface& surface, Level level) {
  if (level.value == 0) return {};
  const double sigma_mm = smoothingMm(surface.ladder, level);
  return ", smoothed by \u03c3 = " + ShownLengths(surface).text(sigma_mm, 3);
}

std::string regionText(const Project& p, const Surface& surface) {
  const Region& r = p.region;
  const ShownLengths lengths(surface);
  return "Resolution " + std::to_string(surface.ladder.detailOf(r.level)) + " of " +
         std::to_string(surface.ladder.levels()) + " (level " + std::to_string(r.level.value) +
         ", pyramid factor " + shortNumber(surface.ladder.factor, 9) +
         smoothingText(surface, r.level) + "): " + lengths.rectangle(r.side_mm, r.side_mm) +
         " from x " + lengths.number(r.x_mm) + ", y " + lengths.number(r.y_mm) + " " +
         std::string(lengths.unit().name) + "; vertical exaggeration \u00d7 " +
         shortNumber(p.gain) + (p.gain == 1 ? " (true to scale)." : ".");
}

/// @param spacing_mm  of the samples, which decides a radius that the look leaves open
std::string lookText(const ReliefLook& look, double spacing_mm, const ShownLengths& lengths) {
  const std::string light = "light from " + shortNumber(look.light.azimuth_deg) + "\u00b0, " +
                            shortNumber(look.light.elevation_deg) + "\u00b0 above the plane";
  const std::string colours = " in " + std::string(name(look.colours));
  const std::string around = ", radius " + lengths.text(radiusMm(look, spacing_mm));
  const std::string shading =
      look.shading > 0 ? "shaded by " + shortNumber(100 * look.shading, 3) + " % of the " + light
                       : "without shading";
  switch (look.kind) {
    case ReliefKind::lit:
      return "Shaded relief, " + light;
    case ReliefKind::height:
      return "Heights" + colours + ", " + light;
    case ReliefKind::hillshade:
      return "Hillshade, " + light;
    case ReliefKind::multi_hillshade:
      return "Hillshade of four lights " + shortNumber(look.light.elevation_deg) +
             "\u00b0 above the plane";
    case ReliefKind::slope:
      return "Slope" + colours;
    case ReliefKind::local_relief:
      return "Local relief" + around + "," + colours;
    case ReliefKind::sky_view:
      return "Sky-view factor" + around + "," + colours;
    case ReliefKind::openness:
      return "Positive openness" + around + "," + colours;
    case ReliefKind::multi_scale:
      return "Largest deviation from the neighbourhood" + around + " and its halves," + colours;
    case ReliefKind::curvature:
      return "Multi-scale curvature (volume within balls)" + around + " and its halves," + colours;
    case ReliefKind::occlusion:
      return "Shaded relief with ambient occlusion" + around + ", " + light;
    case ReliefKind::natural:
      return "Natural colours of the scan, " + shading;
    case ReliefKind::intensity:
      return "Intensity of the scan, " + shading;
  }
  return {};
}

std::string stereoText(const CaptionFacts& facts) {
  if (facts.stereo == StereoPrint::off && facts.eye == FigureEye::both) return {};
  constexpr std::array<const char*, 7> kWords{"",
                                              "grey red-cyan anaglyph",
                                              "half-colour red-cyan anaglyph",
                                              "Dubois red-cyan anaglyph",
                                              "two pictures side by side",
                                              "two pictures, one over the other",
                                              "two pictures in alternate rows"};
  const std::string picture = facts.eye == FigureEye::both
                                  ? kWords.at(static_cast<std::size_t>(facts.stereo))
                                  : std::string(name(facts.eye)) + " eye's picture of two";
  return "; " + picture + ", " + shortNumber(facts.eye_angle_deg, 3) + "\u00b0 between the eyes" +
         (facts.swap_eyes ? ", eyes swapped" : "");
}

std::string seenText(const Project& p, const CaptionFacts& facts, double spacing_mm,
                     const ShownLengths& lengths) {
  std::string text = lookText(facts.look, spacing_mm, lengths);
  if (p.azimuth_deg != 0 || p.elevation_deg != 0) {
    text += "; turned by " + shortNumber(p.azimuth_deg) + "\u00b0 and " +
            shortNumber(p.elevation_deg) + "\u00b0";
  }
  if (facts.look.unmeasured) text += "; interpolated cells in orange";
  text += stereoText(facts);
  if (facts.hand_by_shape) text += "; ball: proxy, ring with a cross: HIP";
  return text + ".";
}

std::string scaleText(const CaptionFacts& facts, const ShownLengths& lengths) {
  std::string text;
  if (facts.paper_mm_per_mm) {
    const double one_to = 1 / *facts.paper_mm_per_mm;
    text = one_to >= 1 ? " Scale 1:" + shortNumber(one_to, 3)
                       : " Scale " + shortNumber(1 / one_to, 3) + ":1";
    text += ".";
  }
  if (facts.mm_per_pixel) text += " 1 pixel is " + lengths.text(*facts.mm_per_pixel) + ".";
  return text;
}

/// Of what is drawn, the planes that a reader cannot see: where a section cuts, and from where a
/// volume counts.
std::string planesText(const CaptionFacts& facts, const ShownLengths& lengths) {
  std::string text;
  for (const Measurement& m : facts.measurements) {
    if (!hasPlane(m.kind)) continue;
    text += text.empty() ? " Planes: " : "; ";
    text += m.kind == MeasureKind::section ? "section " : "volume of ";
    text += m.name + ", " + planeText(m, lengths.unit().size, lengths.unit().name);
  }
  return text.empty() ? text : text + ".";
}

/// Of the picture, not of the whole map: what the reader sees.
std::string windowSharesText(const RegionWindow& window) {
  return "Of the cells of this region " + sharesText(sharesOf(window)) + ".";
}

std::string sourceText(const Project& p) {
  std::string text = "relievo " + std::string(programVersion());
  if (programCommit() != "unknown") text += " (" + std::string(programCommit().substr(0, 12)) + ")";
  if (!p.sha256.empty()) text += ", input SHA-256 " + p.sha256;
  return text + ".";
}

}  // namespace

std::string methodName(const std::string& engine) {
  if (engine == "cpu") return "CPU";
  return engine == "depthbuffer" ? "OpenGL" : engine;
}

std::string shortNumber(double value, int digits) {
  std::array<char, 64> text{};
  // Kilometres in millimetres are still read more easily than an exponent.
  constexpr double kExponentFrom = 1e15;
  const bool is_whole =
      std::abs(value) >= std::pow(10.0, digits) - 0.5 && std::abs(value) < kExponentFrom;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value == 0 ? 0 : value,
                                 is_whole ? std::chars_format::fixed : std::chars_format::general,
                                 is_whole ? 0 : digits);
  return {text.data(), end.ptr};
}

std::array<double, kOriginCount> sharesOf(const RegionWindow& window) {
  std::array<double, kOriginCount> shares{};
  for (const CellStatus origin : window.origins) shares.at(static_cast<std::size_t>(origin)) += 1;
  for (double& share : shares) {
    share /= static_cast<double>(std::max<std::size_t>(window.origins.size(), 1));
  }
  return shares;
}

std::string sharesText(const std::array<double, kOriginCount>& shares) {
  constexpr std::array<const char*, kOriginCount> kWords{
      "measured", "interpolated", "holes on the base plane", "too steep to trust",
      "outside the object"};
  std::string text;
  for (std::size_t i = 0; i < kOriginCount; ++i) {
    if (shares.at(i) == 0 && i > 0) continue;
    text += (text.empty() ? "" : ", ") + shortNumber(100 * shares.at(i), 3) + " % " + kWords.at(i);
  }
  return text;
}

CaptionFacts pictureFacts(const Project& p, double mm_per_pixel) {
  const bool measured = p.picture && !p.picture->lines.empty();
  return {.look = p.look,
          .stereo = printed(p.stereo.mode),
          .eye = p.picture ? p.picture->eye : FigureEye::both,
          .swap_eyes = p.stereo.swap_eyes,
          .hand_by_shape = p.picture && p.picture->hand && p.stereo.mode == StereoMode::anaglyph,
          .eye_angle_deg = p.stereo.eye_angle_deg,
          .mm_per_pixel = mm_per_pixel,
          .measurements = measured ? p.measurements : std::vector<Measurement>{}};
}

std::string captionOf(const Project& p, const Surface& surface, const RegionWindow& window,
                      const CaptionFacts& facts) {
  const ShownLengths lengths(surface);
  return objectText(p, surface) + " " + mapText(p, surface) + " " + regionText(p, surface) + " " +
         seenText(p, facts, window.spacingMm(), lengths) + scaleText(facts, lengths) +
         planesText(facts, lengths) + " " + windowSharesText(window) + " " + sourceText(p);
}

}  // namespace relievo
