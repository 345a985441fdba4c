// SPDX-License-Identifier: BSD-3-Clause
// How a surface feels, from the command line: the presets and records of the window.
#include <algorithm>
#include <array>
#include <charconv>
#include <CLI/CLI.hpp>
#include <cmath>

#include "app/cli/json.h"
#include "app/cli/options/number_option.h"
#include "app/cli/verbs/touch_setup.h"
#include "core/base/failure.h"
#include "haptics/loop/strength_preset.h"

namespace relievo::batch {
namespace {

constexpr std::array<std::string_view, 3> kProxyNames{"converged", "equation", "successive"};

ProxyKind proxyKind(const std::string& name) {
  const auto* const found = std::find(kProxyNames.begin(), kProxyNames.end(), name);
  if (found == kProxyNames.end()) {
    throw failure<MessageId::option_none_of>("--proxy", name, "converged, equation and successive");
  }
  return static_cast<ProxyKind>(found - kProxyNames.begin());
}

/// The paper's two proxies walk the paper's surface unless another is asked for.
SurfaceKind surfaceKind(const std::string& name, ProxyKind proxy) {
  if (name == "exact") return SurfaceKind::bilinear;
  if (name == "spline") return SurfaceKind::spline;
  if (name != "auto") {
    throw failure<MessageId::option_none_of>("--surface", name, "auto, exact and spline");
  }
  return proxy == ProxyKind::converged ? SurfaceKind::crease_aware : SurfaceKind::bilinear;
}

const char* nameOf(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::bilinear:
      return "exact";
    case SurfaceKind::spline:
      return "spline";
    case SurfaceKind::crease_aware:
      break;
  }
  return "gated";
}

/// Not a number fails as well.
double within(double value, double least, double most, const char* option) {
  if (value >= least && value <= most) return value;
  throw failure<MessageId::option_out_of_range>(option, Json(least).dump(), Json(most).dump());
}

SurfaceFeel presetOf(const TouchArguments& a) {
  if (a.preset.empty()) {
    return {.stiffness_by_detail = false, .stiffness_n_per_mm = 0.5, .fields = {}, .transient = {}};
  }
  if (const SurfacePreset* preset = surfacePreset(a.preset)) return preset->feel;
  std::string ids;
  for (const SurfacePreset& preset : kSurfacePresets) {
    ids.append(ids.empty() ? "" : ", ").append(preset.id);
  }
  throw failure<MessageId::option_none_of>("--preset", a.preset, ids);
}

void setStiffness(const TouchArguments& a, SurfaceFeel& feel) {
  if (a.stiffness_n_per_mm) {
    feel.stiffness_by_detail = false;
    feel.stiffness_n_per_mm = *a.stiffness_n_per_mm;
  }
  if (!a.detail_stiffness_n_per_mm.empty()) {
    const auto& given = a.detail_stiffness_n_per_mm;
    feel.stiffness_by_detail = !a.stiffness_n_per_mm;
    for (std::size_t i = 0; i < feel.detail_stiffness.size(); ++i) {
      feel.detail_stiffness[i] = given[std::min(i, given.size() - 1)];
    }
  }
  const auto above_zero = [](double k) { return k > 0 && std::isfinite(k); };
  if (!above_zero(feel.stiffness_n_per_mm)) {
    throw failure<MessageId::option_stiffness>();
  }
  if (!std::all_of(feel.detail_stiffness.begin(), feel.detail_stiffness.end(), above_zero)) {
    throw failure<MessageId::option_level_stiffness>();
  }
}
}  // namespace

SurfaceFeel feelOf(const TouchArguments& a) {
  SurfaceFeel feel = presetOf(a);
  if (!a.proxy.empty()) feel.proxy = proxyKind(a.proxy);
  if (!a.surface.empty() || a.preset.empty()) {
    feel.surface = surfaceKind(a.surface.empty() ? "auto" : a.surface, feel.proxy);
  }
  setStiffness(a, feel);
  if (a.damping) feel.damping_n_s_per_mm = *a.damping;
  if (!a.friction.empty()) feel.friction = a.friction.front();
  FieldOptions& fields = feel.fields;
  if (a.softest_part) fields.softest_part = within(*a.softest_part, kLeastSoftPart, 1, "--soft");
  if (a.texture_mm) fields.texture_mm = within(*a.texture_mm, 0, kMostTextureMm, "--texture");
  if (a.magnet_n) fields.magnet_n = within(*a.magnet_n, 0, kMostMagnetN, "--magnet");
  if (a.magnet_reach_mm) {
    fields.magnet_reach_mm =
        within(*a.magnet_reach_mm, kLeastReachMm, kMostReachMm, "--magnet-reach");
  }
  TransientOptions& transient = feel.transient;
  if (a.contact_n) transient.contact_n = within(*a.contact_n, 0, kMostContactN, "--knock");
  if (a.crossing_n) transient.crossing_n = within(*a.crossing_n, 0, kMostCrossingN, "--tick");
  return feel;
}

void addFeelOptions(CLI::App& verb, TouchArguments& arguments) {
  verb.add_option(
      "--preset", arguments.preset,
      "smooth, exact, paper, soft_stone or bronze, as in the window; what else is given "
      "overrides it. Without one: a spring of 0.5 N/mm and nothing else");
  verb.add_option("--surface", arguments.surface,
                  "auto: smooth, broken at walls and creases; exact: bilinear; spline");
  verb.add_option("--proxy", arguments.proxy,
                  "converged, equation (the paper's eq. 2) or successive");
  takes(verb.add_option("--stiffness", arguments.stiffness_n_per_mm, "N per mm of hand"),
        {.low = 1e-3, .high = 100, .unit = "N/mm"});
  takes(verb.add_option("--level-stiffness", arguments.detail_stiffness_n_per_mm,
                        "N per mm of hand for resolution 1, 2, 3 and all finer ones"),
        {.low = 1e-3, .high = 100, .unit = "N/mm"})
      .delimiter(',')
      ->expected(1, 4);
  takes(verb.add_option("--friction", arguments.friction,
                        "Coulomb friction of the surface: MU, or STATIC,DYNAMIC; 0 is off"),
        {.low = 0, .high = kMostFriction})
      .delimiter(',')
      ->expected(1, 2);
  takes(verb.add_option("--damping", arguments.damping,
                        "N s per mm of hand, against pressing in; 0 is off"),
        {.low = 0, .high = 1, .unit = "N s/mm"});
  takes(
      verb.add_option("--soft", arguments.softest_part,
                      "Part of the stiffness that ground keeps which was not measured, 0.25 to 1"),
      {.low = kLeastSoftPart, .high = 1});
  verb.add_option(
      "--firmness", arguments.firmness,
      "Stiffness map: raster of numbers from 0 (as soft as --soft says) to 1, laid over the "
      "whole map; "
      "instead of where it was measured");
  takes(verb.add_option(
            "--tick", arguments.crossing_n,
            "Edge cue: N, on the way from measured ground to other ground and back; 0 is off"),
        {.low = 0, .high = kMostCrossingN, .unit = "N"});
  takes(verb.add_option("--texture", arguments.texture_mm,
                        "Largest rise of the next finer level that is felt, mm of hand; 0 is off"),
        {.low = 0, .high = kMostTextureMm, .unit = "mm"});
  takes(verb.add_option("--knock", arguments.contact_n,
                        "Contact impulse: largest N of a new contact; 0 is off"),
        {.low = 0, .high = kMostContactN, .unit = "N"});
  takes(verb.add_option("--magnet", arguments.magnet_n,
                        "Largest N of a pull toward the surface; 0 is off"),
        {.low = 0, .high = kMostMagnetN, .unit = "N"});
  takes(verb.add_option("--magnet-reach", arguments.magnet_reach_mm,
                        "It begins so many mm of hand above"),
        {.low = kLeastReachMm, .high = kMostReachMm, .unit = "mm"});
}

double strengthOf(const TouchArguments& a) {
  constexpr double kWhole = 100;
  if (a.strength.empty()) return 1;
  if (const StrengthPreset* preset = strengthPreset(a.strength)) return preset->percent / kWhole;
  int percent = 0;
  const char* const last = a.strength.data() + a.strength.size();
  const auto [end, error] = std::from_chars(a.strength.data(), last, percent);
  if (error == std::errc() && end == last && percent >= 1 && percent <= kWhole) {
    return percent / kWhole;
  }
  std::string ids;
  for (const StrengthPreset& preset : kStrengthPresets) ids.append(preset.id).append(", ");
  throw failure<MessageId::option_none_of>("--strength", a.strength, ids + "1 to 100");
}

std::string feelJson(const TouchArguments& a) {
  const SurfaceFeel feel = feelOf(a);
  Json json{{"preset", a.preset},
            {"surface", nameOf(feel.surface)},
            {"proxy", kProxyNames.at(static_cast<std::size_t>(feel.proxy))},
            {"stiffness_by_detail", feel.stiffness_by_detail}};
  if (feel.stiffness_by_detail) {
    json["detail_stiffness_n_per_mm"] = feel.detail_stiffness;
  } else {
    json["stiffness_n_per_mm"] = feel.stiffness_n_per_mm;
  }
  json["friction"] = a.friction.empty() ? Json{feel.friction, kDynamicShare * feel.friction}
                                        : Json{a.friction.front(), a.friction.back()};
  json["damping_n_s_per_mm"] = feel.damping_n_s_per_mm;
  json["softest_part"] = feel.fields.softest_part;
  json["firmness"] = a.firmness;
  json["texture_mm"] = feel.fields.texture_mm;
  json["magnet_n"] = feel.fields.magnet_n;
  json["magnet_reach_mm"] = feel.fields.magnet_reach_mm;
  json["contact_n"] = feel.transient.contact_n;
  json["crossing_n"] = feel.transient.crossing_n;
  if (!a.strength.empty()) json["strength"] = strengthOf(a);
  return json.dump();
}

}  // namespace relievo::batch
