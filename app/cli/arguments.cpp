// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/arguments.h"

#include <algorithm>
#include <charconv>
#include <CLI/CLI.hpp>
#include <cmath>
#include <limits>
#include <string_view>

#include "app/cli/options/number_option.h"
#include "app/cli/published/published_input.h"
#include "core/base/failure.h"
#include "core/depth/rules/point_rule.h"
#include "core/io/format.h"
#include "core/io/formats/lines.h"

namespace relievo::batch {
namespace {

constexpr double kLargestNumber = 1e12;  // What follows may square it.

double number(const std::string& option, std::string_view text) {
  const auto value = parseNumber(text);
  if (value && std::abs(*value) <= kLargestNumber) return *value;  // Not a number fails as well.
  throw failure<MessageId::option_no_number>(option, text);
}

/// base, none, membrane, interpolate:MAX_MM2 or membrane:MAX_MM2.
HoleChoice holeChoice(const std::string& text) {
  if (text == "base") return {.rule = HoleRule::base};
  if (text == "none") return {.rule = HoleRule::none};
  constexpr double kAll = std::numeric_limits<double>::infinity();
  if (text == "membrane") return {.rule = HoleRule::membrane, .max_area_mm2 = kAll};
  const auto limit_after = [&](std::string_view prefix) -> std::optional<double> {
    if (!text.starts_with(prefix)) return std::nullopt;
    const double area = number("--holes", std::string_view(text).substr(prefix.size()));
    if (area < 0) throw failure<MessageId::option_holes_area>();
    return area;
  };
  if (const auto area = limit_after("interpolate:")) {
    return {.rule = HoleRule::interpolate, .max_area_mm2 = *area};
  }
  if (const auto area = limit_after("membrane:")) {
    return {.rule = HoleRule::membrane, .max_area_mm2 = *area};
  }
  throw failure<MessageId::option_none_of>(
      "--holes", text, "base, interpolate:MAX_MM2, membrane, membrane:MAX_MM2 and none");
}

StrayRule strayRule(const std::string& text) {
  if (text == "drop") return StrayRule::drop;
  if (text == "keep") return StrayRule::keep;
  if (text == "drop-groups") return StrayRule::drop_groups;
  throw failure<MessageId::option_none_of>("--strays", text, "drop, keep and drop-groups");
}

std::optional<NodataChoice> nodataChoice(const std::string& text) {
  if (text.empty()) return std::nullopt;
  if (text == "none") return NodataChoice{};
  return NodataChoice{.value = number("--nodata", text)};
}

ViewChoice viewChoice(const MapArguments& a) {
  ViewChoice view{.name = a.view.empty() ? "auto" : a.view, .rotation = std::nullopt};
  if (std::find(kViewNames.begin(), kViewNames.end(), view.name) == kViewNames.end()) {
    throw failure<MessageId::option_none_of>(
        "--view", a.view, "front, back, left, right, top, bottom, auto, fit and axes");
  }
  if (!a.turn.empty()) {
    const std::vector<double> turn = numberList("--turn", a.turn, 3);
    view.turn_deg = {turn[0], turn[1], turn[2]};
  }
  return view;
}

}  // namespace

std::vector<double> numberList(const std::string& option, const std::string& text,
                               std::size_t count) {
  std::vector<double> values;
  std::size_t start = 0;
  while (start <= text.size()) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    values.push_back(number(option, std::string_view(text).substr(start, comma - start)));
    start = comma + 1;
  }
  if (values.size() != count) {
    throw failure<MessageId::option_needs_numbers>(option, count, text);
  }
  return values;
}

void addScanOptions(CLI::App& verb, ScanArguments& a) {
  verb.add_flag("--load-incomplete", a.accept_incomplete,
                "Load the complete records of a cut file (E101)");
  verb.add_option("--parts", a.parts, "Which scans of an E57 or PTX file: 1,3; all");
  verb.add_option("--reader", a.reader,
                  "Whose code reads the points: auto (PCL where it reads right), pcl, own")
      ->check(CLI::IsMember({"auto", "pcl", "own"}));
  verb.add_flag("--keep-withheld", a.keep_withheld,
                "Of LAS: take points, too, that are marked as not to be used");
  takes(verb.add_option("--every", a.every,
                        "Take one point in so many: of clouds that are larger than the memory "
                        "(E102); 1"),
        {.low = 1, .high = 1e9});
}

ImportOptions importOptions(const ScanArguments& a) {
  ImportOptions options;
  options.accept_incomplete = a.accept_incomplete;
  options.scan.keep_withheld = a.keep_withheld;
  options.scan.every = static_cast<std::uint64_t>(a.every);
  const auto* const reader = std::find(kReaderNames.begin(), kReaderNames.end(), a.reader);
  options.scan.reader = static_cast<ReaderChoice>(reader - kReaderNames.begin());
  std::string_view rest = a.parts;
  while (!rest.empty()) {
    const std::string_view word = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    int part = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), part);
    const bool comma_at_end = rest.empty() && a.parts.back() == ',';
    if (error != std::errc{} || end != word.data() + word.size() || part < 1 || comma_at_end) {
      throw failure<MessageId::option_parts>(a.parts);
    }
    options.scan.parts.push_back(part);
  }
  return options;
}

void addMapOptions(CLI::App& verb, MapArguments& a) {
  mayBeWebAddress(
      verb.add_option("FILE", a.file,
                      "Scan (" + scanFormatList(" ") +
                          "), TIFF, PNG, ASCII grid, MAP.tif, or the address of a published map"))
      ->required();
  verb.add_option("--unit", a.unit, "Unit of the file's coordinates: mm cm m in ft us-ft");
  verb.add_option("--view", a.view,
                  "front back left right top bottom; auto: upright, what shows most; fit: "
                  "on the best-fit plane; axes: by the principal axes");
  takesList(verb.add_option("--turn", a.turn,
                            "X,Y,Z: then turned about the view's axes by so many degrees"),
            3, {.low = -360, .high = 360, .unit = "degrees"});
  takes(verb.add_option("--cells", a.cells, "Samples across the longer side"),
        {.low = 2, .high = 1e6});
  takes(verb.add_option("--spacing", a.spacing_mm, "Distance of samples in mm"),
        {.low = 1e-4, .high = 1e6, .unit = "mm"});
  verb.add_option("--engine", a.engine, "Method: cpu, or depthbuffer (the paper's, by OpenGL)");
  verb.add_option(
      "--rule", a.rule,
      "Height per cell from its points: auto front second topmean median mean min splat "
      "quadratic");
  verb.add_option("--holes", a.holes,
                  "base (the paper's), interpolate:MAX_MM2, membrane, membrane:MAX_MM2 or none");
  verb.add_option("--strays", a.strays,
                  "Few points far from all others, which stretch the box: drop, keep, or "
                  "drop-groups, which also leaves out groups of up to 1 %; drop");
  verb.add_option("--nodata", a.nodata,
                  "A height of the file that stands for none, as -9999; none: every height is one");
  takes(verb.add_option("--pixel-size", a.pixel_mm,
                        "Of a raster: distance of its samples in mm, whatever the file says"),
        {.low = 1e-6, .high = 1e6, .unit = "mm"});
  takes(verb.add_option("--height-scale", a.height_mm,
                        "Of a raster: mm that a step of 1 of its values is high; below 0: larger "
                        "values lie deeper"),
        {.low = -1e6, .high = 1e6, .unit = "mm"});
  takes(verb.add_option("--height-zero", a.height_zero,
                        "Of a raster: the value that lies on the base plane; else the lowest"),
        {.low = -kLargestNumber, .high = kLargestNumber});
  takes(verb.add_option("--factor", a.factor, "Pyramid factor, the paper's M: 1.1 to 8; 2"),
        {.low = kLeastFactor, .high = kMostFactor});
  addScanOptions(verb, a.scan);
}

SurfaceOptions surfaceOptions(const MapArguments& a) {
  SurfaceOptions options;
  if (!a.unit.empty()) {
    options.unit = lengthUnit(a.unit);
    if (!options.unit) {
      throw failure<MessageId::option_none_of>("--unit", a.unit, "mm, cm, m, in, ft and us-ft");
    }
  }
  if (!a.view.empty() || !a.turn.empty()) options.view = viewChoice(a);
  if (a.engine != "cpu" && a.engine != "depthbuffer") {
    throw failure<MessageId::option_neither>("--engine", a.engine, "cpu", "depthbuffer");
  }
  if (!a.rule.empty() && a.rule != "auto") {
    options.rule = pointRule(a.rule);
    if (!options.rule) {
      throw failure<MessageId::option_none_of>(
          "--rule", a.rule, "auto, front, second, topmean, median, mean, min, splat and quadratic");
    }
  }
  if (a.cells && *a.cells < 2) throw failure<MessageId::option_cells>();
  if (a.spacing_mm && !(*a.spacing_mm > 0)) throw failure<MessageId::option_spacing>();
  if (a.cells && a.spacing_mm) throw failure<MessageId::option_cells_or_spacing>();
  if (!(a.factor >= kLeastFactor) || !(a.factor <= kMostFactor)) {
    throw failure<MessageId::option_factor>();
  }
  options.cells = a.cells;
  options.spacing_mm = a.spacing_mm;
  options.engine = a.engine;
  options.holes = holeChoice(a.holes);
  options.strays = strayRule(a.strays);
  options.nodata = nodataChoice(a.nodata);
  if (a.height_mm && *a.height_mm == 0) throw failure<MessageId::raster_scale_is_none>();
  options.raster = {.pixel_mm = a.pixel_mm, .height_mm = a.height_mm, .zero = a.height_zero};
  options.pyramid.factor = a.factor;
  return options;
}

void addRegionOptions(CLI::App& verb, RegionArguments& a) {
  takes(verb.add_option("--level", a.level, "Pyramid level, 0 = finest"), {.low = 0, .high = 63});
  takesList(
      verb.add_option("--region", a.region, "X,Y,W,H in view mm; X,Y is the lower left corner"), 4,
      {.low = -kFarMm, .high = kFarMm, .unit = "mm"});
  takes(verb.add_option("--gain", a.gain, "Vertical exaggeration; 1 is true to scale"),
        {.low = 1e-3, .high = 1e3})
      .each([&a](const std::string&) { a.gain_given = true; });
  verb.add_option("--window-out", a.window_out, "Also write the 200 x 200 samples as a GeoTIFF");
}

Region chosenRegion(const Surface& surface, const RegionArguments& a) {
  std::optional<Level> level;
  if (a.level) level = Level{*a.level};
  if (!a.region.empty()) {
    const std::vector<double> r = numberList("--region", a.region, 4);
    const Region region = regionFromRect(
        surface.ladder, {.x_mm = r[0], .y_mm = r[1], .width_mm = r[2], .height_mm = r[3]}, level);
    // A window beside the map would be a picture of nothing, and a touch of the plane around it.
    if (!a.as_recorded && !onMap(surface.ladder, region)) {
      throw failure<MessageId::nothing_in_region>();
    }
    return region;
  }
  const Region whole = wholeRegion(surface.ladder);
  if (!level) return whole;
  return regionFromRect(surface.ladder,
                        {.x_mm = whole.x_mm,
                         .y_mm = whole.y_mm,
                         .width_mm = whole.side_mm,
                         .height_mm = whole.side_mm},
                        level);
}

}  // namespace relievo::batch
