// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "haptics/loop/haptic_core.h"
#include "haptics/proxy/proxy.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

/// How a surface feels, as one choice.
struct SurfaceFeel {
  ProxyKind proxy = ProxyKind::converged;
  SurfaceKind surface = SurfaceKind::crease_aware;
  bool stiffness_by_detail = true;
  double stiffness_n_per_mm = 0.8;  ///< If not by detail; N per mm of hand.
  double friction = 0;  ///< Coulomb's at rest, of the converged proxy alone; 0 .. kMostFriction.
  double damping_n_s_per_mm = 0;                        ///< Against the speed of pressing in.
  DetailStiffness detail_stiffness = kDetailStiffness;  ///< If by detail.
  FieldOptions fields = {.softest_part = 0.6, .texture_mm = 0.01};
  TransientOptions transient = {.crossing_n = 0.08};
  friend bool operator==(const SurfaceFeel&, const SurfaceFeel&) = default;
};

inline constexpr double kDynamicShare = 0.75;  ///< Of the friction at rest, while sliding.

/// Is it the same to the hand? A stiffness that something else decides does not count.
constexpr bool feelsTheSame(SurfaceFeel a, const SurfaceFeel& b) {
  if (a.stiffness_by_detail && b.stiffness_by_detail) {
    a.stiffness_n_per_mm = b.stiffness_n_per_mm;
  } else {
    a.detail_stiffness = b.detail_stiffness;
  }
  return a == b;
}

/// Of the proxy; the paper's two know no friction.
constexpr ProxyOptions proxyOptions(const SurfaceFeel& feel) {
  ProxyOptions options;
  options.kind = feel.proxy;
  if (feel.proxy != ProxyKind::converged) return options;
  options.static_friction = feel.friction;
  options.dynamic_friction = kDynamicShare * feel.friction;
  return options;
}

/// The same for the core: all of it but the shape, which the space was filled with.
constexpr void setFeel(HapticOptions& options, const SurfaceFeel& feel) {
  options.proxy = proxyOptions(feel);
  options.fields = feel.fields;
  options.stiffness_by_detail = feel.stiffness_by_detail;
  options.detail_stiffness = feel.detail_stiffness;
  options.force.stiffness_n_per_mm = feel.stiffness_n_per_mm;
  options.force.damping_n_s_per_mm = feel.damping_n_s_per_mm;
  options.force.transient = feel.transient;
}

struct SurfacePreset {
  std::string_view id;  ///< Stable; in settings.
  SurfaceFeel feel;
};

/// The first is the default. Stable for every grip and scene of docs/dev/stability.md at full
/// strength (`haptics/loop/stability_test`), but that the paper's proxy at rest moves by its step
/// of 0.1 mm: up to 0.09 N in that test.
inline constexpr std::array<SurfacePreset, 5> kSurfacePresets{{
    {"smooth", {}},
    // Its shape and nothing else.
    {"exact", {.surface = SurfaceKind::bilinear, .fields = {}, .transient = {}}},
    // Eq. (2), flat facets, its k, a spring alone.
    {"paper",
     {.proxy = ProxyKind::equation,
      .surface = SurfaceKind::bilinear,
      .stiffness_by_detail = false,
      .stiffness_n_per_mm = 0.5,
      .fields = {},
      .transient = {}}},
    {"soft_stone",
     {.stiffness_by_detail = false,
      .stiffness_n_per_mm = 0.35,
      .friction = 0.6,
      .damping_n_s_per_mm = 0.0005,
      .fields = {.softest_part = 0.6, .texture_mm = 0.02}}},
    {"bronze",
     {.stiffness_by_detail = false,
      .stiffness_n_per_mm = 0.8,
      .friction = 0.2,
      .transient = {.contact_n = 0.3, .crossing_n = 0.08}}},
}};

/// Nothing: no preset of that id.
constexpr const SurfacePreset* surfacePreset(std::string_view id) {
  for (const SurfacePreset& preset : kSurfacePresets) {
    if (preset.id == id) return &preset;
  }
  return nullptr;
}

/// For logs and settings, where crease_aware is "gated", "spline", "bilinear".
constexpr std::string_view name(SurfaceKind kind) {
  constexpr std::array<std::string_view, 3> kNames{"gated", "spline", "bilinear"};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace relievo
