// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "haptics/loop/haptic_core.h"
#include "tests/haptics/haptic_fixture.h"
#include "tests/haptics/proxy/second_evaluator.h"

namespace relievo::test {

/// Creases, steps and a ridge, with another height at every sample.
inline RegionWindow roughWindow(double side_mm, std::uint64_t id) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> grain(-0.08, 0.08);
  return windowOf(
      side_mm,
      [&](double x, double y) {
        const double creases =
            1.2 * std::abs(std::sin(0.35 * x)) + 0.8 * std::abs(std::cos(0.3 * y));
        const double steps = (x > 47 ? 2.5 : 0) + (y > 30 && y < 34 ? 1.5 : 0);
        return creases + steps + std::max(0.0, 3 - std::abs(x + y - 60)) + grain(random);
      },
      id);
}

/// Waves of 14 samples and more: the crease-aware spline has no reason to break.
inline RegionWindow wavyWindow(double side_mm, std::uint64_t id) {
  return windowOf(
      side_mm,
      [](double x, double y) {
        return 1.5 * std::sin(0.5 * x) * std::cos(0.4 * y) + 0.4 * std::sin(1.1 * x + 0.3 * y);
      },
      id);
}

/// Roofs and steps along the samples, straight between: the crease-aware spline is the facets. For
/// a side of 80 mm, whose samples lie at (i + 1/2) times 0.4 mm.
inline RegionWindow straightWindow(std::uint64_t id) {
  return windowOf(
      80,
      [](double x, double y) {
        const auto roof = [](double at, double top, double slope) {
          return std::max(0.0, slope * (10 - std::abs(at - top)));
        };
        return roof(x, 30.2, 0.3) + roof(y, 50.2, 0.4) + (x > 52.3 ? 4 : 0) + (y < 22.1 ? 2 : 0);
      },
      id);
}

/// A window, the surface that the core has of it, and what is true of that.
struct TruthScene {
  std::string name;
  RegionWindow window;
  std::unique_ptr<HapticSpace> space = std::make_unique<HapticSpace>();
  std::unique_ptr<SplineTruth> spline;  ///< Else the facets are the truth.

  /// View mm.
  Real height(Real x, Real y) const {
    return spline ? spline->height(x, y) : facetHeight(window, x, y);
  }
};

enum class Truth { facets, spline };
inline TruthScene truthScene(std::string name, RegionWindow window, SurfaceKind kind, Truth truth,
                             DetailStep step = {}) {
  TruthScene scene{std::move(name), std::move(window), std::make_unique<HapticSpace>(), nullptr};
  fill(*scene.space, scene.window, step, kind);
  if (truth == Truth::spline) scene.spline = std::make_unique<SplineTruth>(scene.window);
  return scene;
}

/// Every kind of surface that can be judged from outside.
inline std::vector<TruthScene> truthScenes() {
  std::vector<TruthScene> all;
  all.push_back(truthScene("bilinear, rough relief", roughWindow(80, 1), SurfaceKind::bilinear,
                           Truth::facets));
  all.push_back(
      truthScene("spline, rough relief", roughWindow(80, 2), SurfaceKind::spline, Truth::spline));
  all.push_back(truthScene("gated, roofs and steps", straightWindow(3), SurfaceKind::crease_aware,
                           Truth::facets));
  all.push_back(
      truthScene("gated, waves", wavyWindow(80, 4), SurfaceKind::crease_aware, Truth::spline));
  return all;
}

struct TruthFindings {
  int ticks = 0, contacts = 0;
  Real below_mm = 0;     ///< Largest depth of the proxy below the true surface, view mm.
  Real force_off_n = 0;  ///< Largest component of the force that is not k times the true way.
  int judged = 0;        ///< Ticks in which was looked around the proxy ...
  int nearer = 0;        ///< ... and in which the true surface came nearer to the hand there.
};

/// A hand that wanders in and out of the relief, given to the bare core tick by tick; what comes
/// out is judged by the second evaluator alone.
inline TruthFindings wanderOver(const TruthScene& scene, int ticks) {
  constexpr double kStiffness = 0.5;
  HapticOptions options;
  options.stiffness_by_detail = false;
  options.force.stiffness_n_per_mm = kStiffness;
  const Real scale = scene.space->device_per_view;
  std::mt19937 random(31);
  std::normal_distribution<double> push(0, 1);
  HapticCore core(ForceChain::bare);
  ViewMm hand{40, 40, 12}, speed{0, 0, 0};
  TruthFindings found;
  for (int n = 0; n < ticks; ++n) {
    const ViewMm home{40 + 25 * std::sin(0.0007 * n), 40 + 25 * std::cos(0.0011 * n), 1.2};
    speed = 0.995 * speed + 0.0006 * (home - hand) +
            0.002 * ViewMm{push(random), push(random), push(random)};
    hand = hand + speed;
    DeviceReading reading;
    reading.position = scene.space->deviceFromView(hand);
    reading.time_ns = n * 1'000'000LL;
    const HapticSample s = core.tick(*scene.space, options, reading, reading.time_ns);
    ++found.ticks;
    const ViewMm &p = s.proxy_view, &h = s.hip_view;
    const Real ground = scene.height(p.x, p.y);
    found.below_mm = std::max(found.below_mm, ground - static_cast<Real>(p.z));
    if (!s.contact) continue;
    ++found.contacts;
    // From view mm and the second evaluator's height, not from the core's hand mm.
    const std::array<Real, 3> way{static_cast<Real>(p.x) - h.x, static_cast<Real>(p.y) - h.y,
                                  ground - h.z};
    const std::array<Real, 3> force{s.force.x, s.force.y, s.force.z};
    for (std::size_t i = 0; i < 3; ++i) {
      found.force_off_n =
          std::max(found.force_off_n, std::abs(force[i] - kStiffness * scale * way[i]));
    }
    if (n % 7 != 0) continue;
    // What a converged proxy means: nowhere around it does the surface come nearer to the hand.
    // Beyond the next crease it may; that has to be found by going there.
    const auto distance2 = [&](Real x, Real y) {
      const Real z = scene.height(x, y) - h.z;
      return (x - h.x) * (x - h.x) + (y - h.y) * (y - h.y) + z * z;
    };
    const Real here = distance2(p.x, p.y);
    // Slopes are kept as floats where cells are cubic.
    const Real rounding = scene.space->surface == SurfaceKind::bilinear ? 1e-7L : 1e-5L;
    bool nearer = false;
    for (const Real step_mm : {1e-6L, 1e-5L}) {
      for (int i = 0; i < 32; ++i) {
        const Real angle = 2 * std::acos(-1.0L) * i / 32;
        const Real there =
            distance2(p.x + step_mm * std::cos(angle), p.y + step_mm * std::sin(angle));
        nearer = nearer || there < here - rounding * step_mm * std::sqrt(here) - 1e-12L;
      }
    }
    ++found.judged;
    found.nearer += nearer ? 1 : 0;
  }
  return found;
}

}  // namespace relievo::test
