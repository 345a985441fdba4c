// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "haptics/proxy/proxy.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

/// How a surface feels, as one choice.
struct SurfaceFeel {
  ProxyKind proxy = ProxyKind::converged;
  SurfaceKind surface = SurfaceKind::gated;
  bool stiffness_by_detail = true;
  double stiffness_n_per_mm = 0.8;  ///< If not by detail; N per mm of hand.
  double friction = 0;  ///< Coulomb's at rest, of the converged proxy alone; 0 .. kMostFriction.
  double damping_n_s_per_mm = 0;  ///< Against the speed of pressing in.
  friend bool operator==(const SurfaceFeel&, const SurfaceFeel&) = default;
};

inline constexpr double kDynamicShare = 0.75;  ///< Of the friction at rest, while sliding.

/// Is it the same to the hand? A stiffness that the level decides does not count.
constexpr bool feelsTheSame(SurfaceFeel a, const SurfaceFeel& b) {
  if (a.stiffness_by_detail && b.stiffness_by_detail) a.stiffness_n_per_mm = b.stiffness_n_per_mm;
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

struct SurfacePreset {
  std::string_view id;  ///< Stable; in settings.
  SurfaceFeel feel;
};

/// The first is the default. Stable for every grip and scene of docs/dev/stability.md at full
/// strength (`haptics/loop/stability_test`), but that the paper's proxy at rest moves by its step
/// of 0.1 mm: up to 0.09 N in that test.
inline constexpr std::array<SurfacePreset, 5> kSurfacePresets{{
    {"smooth", {}},
    {"exact", {.surface = SurfaceKind::bilinear}},
    // Eq. (2), flat facets, its k, a spring alone.
    {"paper",
     {.proxy = ProxyKind::equation,
      .surface = SurfaceKind::bilinear,
      .stiffness_by_detail = false,
      .stiffness_n_per_mm = 0.5}},
    {"soft_stone",
     {.stiffness_by_detail = false,
      .stiffness_n_per_mm = 0.35,
      .friction = 0.6,
      .damping_n_s_per_mm = 0.0005}},
    {"bronze", {.stiffness_by_detail = false, .stiffness_n_per_mm = 0.8, .friction = 0.2}},
}};

/// For logs and settings: "gated", "spline", "bilinear".
constexpr std::string_view name(SurfaceKind kind) {
  constexpr std::array<std::string_view, 3> kNames{"gated", "spline", "bilinear"};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace relievo
