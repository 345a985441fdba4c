// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/options/look_arguments.h"

#include <CLI/CLI.hpp>
#include <cmath>

#include "app/cli/arguments.h"
#include "app/cli/options/number_option.h"
#include "app/cli/state.h"
#include "core/base/failure.h"
#include "core/relief/relief_image.h"

namespace relievo::batch {
namespace {

/// As FigureReliefRows::limit.
void refuseUseless(const LookArguments& a, ReliefKind kind) {
  const bool lamps = isLit(kind) || kind == ReliefKind::hillshade ||
                     kind == ReliefKind::multi_hillshade || showsOwnColours(kind);
  const std::string coloured =
      "a --relief with colours: height, slope, local, skyview, openness, multiscale or curvature";
  requireUse("--colours", !a.colours.empty(), hasLegend(kind), coloured);
  requireUse("--range", !a.range.empty(), hasLegend(kind), coloured);
  requireUse("--light", !a.light.empty(), lamps,
             "--relief lit, height, hillshade, multi, occlusion, natural or intensity");
  requireUse("--shading", a.shading.has_value(), showsOwnColours(kind),
             "--relief natural or intensity");
  requireUse("--radius", a.radius_mm.has_value(), hasRadius(kind),
             "--relief local, skyview, openness, multiscale, curvature or occlusion");
}

}  // namespace

void requireUse(const char* option, bool given, bool applies, const std::string& needs) {
  if (!given || applies) return;
  throw failure<MessageId::option_needs_other>(option, needs);
}

void requireHostFile(const HostFileArguments& a) {
  requireUse("--changed-input", a.changed_input, a.given(), "--from-image or --project");
}

void requireProject(const HostFileArguments& a) {
  requireUse("--place", !a.place.empty(), a.given(), "--project or --from-image");
}

void refuseWord(const char* option, const std::string& text, const std::string& words) {
  throw failure<MessageId::option_none_of>(option, text, words);
}

void addValueOptions(CLI::App& verb, LookArguments& a) {
  verb.add_option("--relief", a.relief, listOf(kReliefKindNames));
  takesList(verb.add_option("--light", a.light, "AZIMUTH,ELEVATION in degrees; 315,45"), 2,
            {.low = -360, .high = 360, .unit = "degrees"});
  takes(verb.add_option("--radius", a.radius_mm, "Of a --relief that looks around, mm; 10 samples"),
        {.low = 0, .high = 1e6, .unit = "mm"});
}

void addLookOptions(CLI::App& verb, LookArguments& a) {
  addValueOptions(verb, a);
  verb.add_option("--colours", a.colours, listOf(kColourMapNames));
  takesList(verb.add_option("--range", a.range, "LOW,HIGH: values at the colours' ends"), 2,
            {.low = -kFarMm, .high = kFarMm});
  takes(verb.add_option(
            "--shading", a.shading,
            "Of natural and intensity: 0 as photographed ... 1 under the full light; 0.5"),
        {.low = 0, .high = 1});
}

ReliefLook reliefLook(const LookArguments& a, ReliefLook look) {
  if (!a.relief.empty()) {
    look.kind = word("--relief", a.relief, reliefKind(a.relief), kReliefKindNames);
  }
  if (!a.colours.empty()) {
    look.colours = word("--colours", a.colours, colourMap(a.colours), kColourMapNames);
  }
  if (!a.light.empty()) {
    const std::vector<double> light = numberList("--light", a.light, 2);
    if (!std::isfinite(light[0]) || !(light[1] >= 0 && light[1] <= 90)) {
      throw failure<MessageId::option_light>();
    }
    look.light = {.azimuth_deg = light[0], .elevation_deg = light[1]};
  }
  if (!a.range.empty()) {
    const std::vector<double> range = numberList("--range", a.range, 2);
    look.range = {{range[0], range[1]}};
    checkRange(look);
  }
  if (a.radius_mm && !(*a.radius_mm >= 0 && std::isfinite(*a.radius_mm))) {
    throw failure<MessageId::option_radius>();
  }
  look.radius_mm = a.radius_mm.value_or(look.radius_mm);
  if (a.shading && !(*a.shading >= 0 && *a.shading <= 1)) {
    throw failure<MessageId::option_shading>();
  }
  look.shading = a.shading.value_or(look.shading);
  refuseUseless(a, look.kind);
  return look;
}

}  // namespace relievo::batch
