// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "haptics/proxy/proxy.h"
#include "tests/haptics/haptic_fixture.h"
#include "tests/haptics/proxy/polyline_truth.h"

namespace relievo::test {

inline constexpr double kProfileCell = 0.5;  ///< mm; the window is 100 mm wide.

/// A scene that is the same for every y: heights of the 200 columns, and how the hand goes up and
/// down over it.
struct Profile {
  std::string name;
  std::vector<double> heights;
  double mean_z = 0, swing_z = 0;
  double bad_share = 0;  ///< Ticks that may differ: where truth itself jumps, one may be late.
  double phase = 0;      ///< Of the hand's way along x.
};

inline Profile profileOf(std::string name, double (*height)(int), double mean_z, double swing_z,
                         double bad_share) {
  Profile profile{std::move(name), {}, mean_z, swing_z, bad_share};
  for (int i = 0; i < kWindowSamples; ++i) profile.heights.push_back(height(i));
  return profile;
}

/// Walls are one cell wide.
inline std::vector<Profile> sharpProfiles() {
  return {
      profileOf(
          "step", [](int i) { return i < 100 ? 0.0 : 5.0; }, 1.5, 3, 0),
      profileOf(
          "roof", [](int i) { return 20 - kProfileCell * std::abs(i - 100); }, 15.5, 3, 0),
      profileOf(
          "groove", [](int i) { return kProfileCell * std::abs(i - 100); }, 1.5, 3, 0.002),
      profileOf(
          "pit", [](int i) { return i >= 97 && i <= 103 ? -8.0 : 0.0; }, -3, 5, 0.002),
      profileOf(
          "fin", [](int i) { return i == 100 || i == 101 ? 8.0 : 0.0; }, 1, 3, 0),
  };
}

/// Plateaus (seed % 3 == 0), ramps (1), or ramps, plateaus and spikes together (2).
inline Profile randomProfile(int seed) {
  std::mt19937 random(static_cast<unsigned>(seed) + 5);
  std::uniform_real_distribution<double> part(0, 1);
  Profile profile{"random " + std::to_string(seed), {}, -1, 4, 0, static_cast<double>(seed)};
  double z = 0, slope = 0;
  for (int i = 0; i < kWindowSamples; ++i) {
    const int kind = seed % 3;
    if (kind > 0 && part(random) < 0.1) slope = -1.5 + 3 * part(random);
    if (std::abs(z) > 5 && z * slope > 0) slope = -slope;
    z += slope * kProfileCell;
    if (kind != 1 && part(random) < (kind == 0 ? 0.12 : 0.05)) z = -4 + 8 * part(random);
    const double spike = kind == 2 && part(random) < 0.03 ? 3 : 0;
    // As the window keeps it, so that truth and surface start from the same numbers.
    profile.heights.push_back(static_cast<double>(static_cast<float>(z + spike)));
  }
  return profile;
}

struct Agreement {
  int ticks = 0;           ///< In which one of the two touched.
  int bad = 0;             ///< Contact differs, or force by more than 5 degrees or 5 %.
  int events = 0;          ///< Times the proxy went more than 1 mm from the truth.
  double farthest_mm = 0;  ///< From the truth, in ticks that are not bad.
};

/// Slides and bounces a hand over a profile, beside the independent solver.
inline Agreement compareWithTruth(const Profile& scene, SurfaceKind kind, int ticks) {
  const auto space = spaceOf(
      kWindowSamples * kProfileCell,
      [&](double x, double) {
        return scene.heights[static_cast<std::size_t>(std::lround(x / kProfileCell - 0.5))];
      },
      1, {}, kind);
  std::vector<Point2> vertices;
  vertices.reserve(kWindowSamples);
  for (int i = 0; i < kWindowSamples; ++i) {
    vertices.push_back({(i + 0.5) * kProfileCell, scene.heights[static_cast<std::size_t>(i)]});
  }
  PolylineProxy truth(vertices);
  ProxyState state;
  Agreement found;
  bool was_far = false;
  for (int n = 0; n < ticks; ++n) {
    const double t = 0.001 * n;
    const ViewMm hip{50 + 9 * std::sin(2.03 * t + scene.phase), 30 + 2.7 * t,
                     n == 0 ? 60 : scene.mean_z + scene.swing_z * std::cos(3.7 * t)};
    const GridPoint grid = space->gridFromView(hip);
    if (n == 0) {
      truth.place({hip.x, hip.z});
      state = proxyPlace(*space, grid);
      continue;
    }
    truth.follow({hip.x, hip.z});
    state = proxyTick(*space, state, grid, {});
    const ViewMm proxy = space->viewFromGrid(state.position);
    if (!truth.contact() && !state.contact) continue;
    ++found.ticks;
    const double off =
        std::hypot(proxy.x - truth.proxy().x, proxy.z - truth.proxy().z, proxy.y - hip.y);
    const Point2 expected = truth.force(), force{proxy.x - hip.x, proxy.z - hip.z};
    const double depth = std::hypot(expected.x, expected.z);
    const double turned = std::atan2(std::abs(force.x * expected.z - force.z * expected.x),
                                     force.x * expected.x + force.z * expected.z);
    constexpr double kFiveDegrees = 0.0873, kShallow = 0.05;
    const bool differs =
        depth > kShallow &&
        (turned > kFiveDegrees || std::abs(std::hypot(force.x, force.z) - depth) > 0.05 * depth);
    const bool bad = truth.contact() != state.contact || differs;
    found.bad += bad ? 1 : 0;
    found.events += off > 1 && !was_far ? 1 : 0;
    was_far = off > 1;
    if (!bad) found.farthest_mm = std::max(found.farthest_mm, off);
  }
  return found;
}

/// A fin 8 mm high, one cell thick on each side, with the hand pushed through it sideways.
/// @return whether the proxy ended on the far side
inline bool passesFin(double base_mm, double speed_mm_per_s, ProxyKind kind,
                      SurfaceKind surface = SurfaceKind::bilinear) {
  const double side = 100 * base_mm;
  const auto space = spaceOf(
      side,
      [&](double x, double) {
        return std::lround(x / (side / kWindowSamples) - 0.5) == 100 ? 8.0 : 0.0;
      },
      1, {}, surface);
  const double ridge = 100.5 * side / kWindowSamples;
  ProxyState state;
  const double step = speed_mm_per_s * 0.001, start = ridge - 5;
  const int ticks = static_cast<int>(10 / step) + 20;
  const double jitter = 0.37;  // So that no tick falls exactly onto the ridge.
  bool first = true;
  for (int n = 0; n < ticks; ++n) {
    const ViewMm hip{start + std::min(10.0, (n + jitter) * step), 0.5 * side + 0.01, 4};
    const GridPoint grid = space->gridFromView(hip);
    ProxyOptions options;
    options.kind = kind;
    options.step_mm = 0.1 * space->device_per_view;  // 0.1 mm on the object, whatever the scale.
    state = first ? ProxyState{grid, grid, false} : proxyTick(*space, state, grid, options);
    first = false;
    if (space->viewFromGrid(state.position).x > ridge) return true;
  }
  return false;
}

}  // namespace relievo::test
