// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "haptics/proxy/proxy.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo::test {

// Measurements on scenes whose truth is known, for tests (with bars) and for the figures page.

inline constexpr double kPi = 3.14159265358979323846;

/// A height and its slopes in closed form, view mm.
struct Relief {
  std::string name;
  std::function<double(double x, double y)> height, slope_x, slope_y;
};

/// A sin(kx) cos(ky), its zeros on samples of cells of 0.5 mm; curvature A k^2 on its tops.
inline Relief waves(double amplitude_mm, double length_mm) {
  const double k = 2 * kPi / length_mm, a = amplitude_mm, s = 0.25;
  return {
      "waves of " + std::to_string(length_mm) + " mm",
      [=](double x, double y) { return a * std::sin(k * (x - s)) * std::cos(k * (y - s)); },
      [=](double x, double y) { return a * k * std::cos(k * (x - s)) * std::cos(k * (y - s)); },
      [=](double x, double y) { return -a * k * std::sin(k * (x - s)) * std::sin(k * (y - s)); }};
}

inline Relief sphereCap(double radius_mm, double x0, double y0) {
  const auto z = [=](double x, double y) {
    return std::sqrt(radius_mm * radius_mm - (x - x0) * (x - x0) - (y - y0) * (y - y0));
  };
  return {"sphere cap", z, [=](double x, double y) { return -(x - x0) / z(x, y); },
          [=](double x, double y) { return -(y - y0) / z(x, y); }};
}

/// Through z = 0 in the middle of a window of 100 mm.
inline Relief plane(double slope_x, double slope_y) {
  return {"plane", [=](double x, double y) { return slope_x * (x - 50) + slope_y * (y - 50); },
          [=](double, double) { return slope_x; }, [=](double, double) { return slope_y; }};
}

/// Errors of the force on one scene. Angles in degrees, positions in micrometres on the object;
/// steps are the largest change of force in one tick over the mean force.
struct Accuracy {
  double angle_median = 0, angle_p99 = 0, angle_max = 0;
  double position_max_um = 0;
  double step = 0, true_step = 0;
  double bad_percent = 0;  ///< Ticks with more than 5 degrees or 5 % of force off.
  int ticks = 0;
};

inline double quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  const auto i = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + i, values.end());
  return values[static_cast<std::size_t>(i)];
}

/// How a hand slides: a contact point that runs along a Lissajous figure at about `speed` mm/s.
struct Slide {
  double depth_mm = 1;
  double speed_mm_per_s = 85;
  int ticks = 10000;
  double side_mm = 100;
};

/// The true contact point is chosen on the closed form and the hand put `depth` below it along the
/// normal, so that truth is constructed and not searched; `depth` must be below every radius of
/// curvature.
inline Accuracy slideOver(const HapticSpace& space, const Relief& relief, const Slide& slide,
                          const ProxyOptions& options) {
  Accuracy result;
  std::vector<double> angles;
  const double middle = 0.5 * slide.side_mm, reach = 0.38 * slide.side_mm;
  const double turn = slide.speed_mm_per_s / (reach * 1.55) * 0.001;
  ProxyState state;
  ViewMm last_force, last_true;
  double force_sum = 0;
  int bad = 0;
  for (int n = 0; n < slide.ticks; ++n) {
    const double x = middle + reach * std::sin(1.17 * turn * n + 0.3);
    const double y = middle + reach * std::sin(0.93 * turn * n + 1.1);
    const double fx = relief.slope_x(x, y), fy = relief.slope_y(x, y);
    const double length = std::sqrt(1 + fx * fx + fy * fy);
    const ViewMm normal{-fx / length, -fy / length, 1 / length};
    const ViewMm contact{x, y, relief.height(x, y)};
    const ViewMm hip = contact - slide.depth_mm * normal;
    if (n == 0) {
      state = proxyPlace(space, space.gridFromView(contact + 0.5 * normal));
    }
    state = proxyTick(space, state, space.gridFromView(hip), options);
    const ViewMm proxy = space.viewFromGrid(state.position);
    const ViewMm force = state.contact ? proxy - hip : ViewMm{};
    const ViewMm truth = slide.depth_mm * normal;
    constexpr int kSettling = 20;
    if (n >= kSettling) {
      const double angle = state.contact ? angleDegrees(force, truth) : 180;
      angles.push_back(angle);
      result.position_max_um = std::max(result.position_max_um, 1000 * norm(proxy - contact));
      result.step = std::max(result.step, norm(force - last_force));
      result.true_step = std::max(result.true_step, norm(truth - last_true));
      force_sum += norm(truth);
      if (angle > 5 || std::abs(norm(force) - slide.depth_mm) > 0.05 * slide.depth_mm) ++bad;
    }
    last_force = force;
    last_true = truth;
  }
  result.ticks = static_cast<int>(angles.size());
  const double mean = force_sum / result.ticks;
  result.step /= mean;
  result.true_step /= mean;
  result.bad_percent = 100.0 * bad / result.ticks;
  result.angle_median = quantile(angles, 0.5);
  result.angle_p99 = quantile(angles, 0.99);
  result.angle_max = quantile(angles, 1);
  return result;
}

/// Largest change of force in one tick, of truth's.
struct CreaseSteps {
  double ours = 0, truth = 0;
  double ratio() const { return ours / truth; }
};

/// Slides over waves up to half a cell from the foot of a block that stands on them, along its side
/// and past its ends: from cells that are spline to cells that break and back, on 60 000 ticks.
inline CreaseSteps stepsAcrossCreases(double amplitude_mm, double length_mm, SurfaceKind kind) {
  const Relief relief = waves(amplitude_mm, length_mm);
  const auto space = spaceOf(
      100,
      [&](double x, double y) {
        return relief.height(x, y) + (x > 50 && std::abs(y - 50) < 20 ? 5 : 0);
      },
      1, {}, kind);
  constexpr double kNearestX = 49.5, kDepthMm = 0.4;  // Its foot is the sample at 49.75.
  CreaseSteps steps;
  ProxyState state;
  ViewMm last_force, last_normal;
  for (int n = 0; n < 60000; ++n) {
    const double x = kNearestX - 3 + 3 * std::sin(0.011 * n);
    const double y = 50 + 40 * std::sin(0.00117 * n + 0.2);
    const double fx = relief.slope_x(x, y), fy = relief.slope_y(x, y);
    const double length = std::sqrt(1 + fx * fx + fy * fy);
    const ViewMm normal{-fx / length, -fy / length, 1 / length};
    const ViewMm contact{x, y, relief.height(x, y)}, hip = contact - kDepthMm * normal;
    if (n == 0) state = proxyPlace(*space, space->gridFromView(contact + normal));
    state = proxyTick(*space, state, space->gridFromView(hip), {});
    const ViewMm force = (1 / kDepthMm) * (space->viewFromGrid(state.position) - hip);
    constexpr int kSettling = 20;
    if (n >= kSettling) {
      steps.ours = std::max(steps.ours, norm(force - last_force));
      steps.truth = std::max(steps.truth, norm(normal - last_normal));
    }
    last_force = force;
    last_normal = normal;
  }
  return steps;
}

/// Work on the hand over closed cycles of press, slide, lift and return, by the trapezoid rule.
struct Work {
  double net_mj = 0;    ///< Positive: the surface gave energy.
  double gross_mj = 0;  ///< All work in either direction.
};

inline Work workPerCycle(const HapticSpace& space, const Relief& relief,
                         const ProxyOptions& options, double stiffness_n_per_mm = 0.5) {
  Work work;
  constexpr int kTicks = 2000, kCycles = 5;
  ViewMm last_hip, last_force;
  ProxyState state;
  for (int n = 0; n <= kCycles * kTicks; ++n) {
    const double turn = 2 * kPi * n / kTicks;
    const double x = 50 + 12 * std::sin(turn), y = 50 + 7 * std::sin(2 * turn);
    // Presses on the way out, hovers on the way back; the path closes after every cycle.
    const double depth = 2.5 * std::cos(turn + 0.6) - 0.5;
    const ViewMm hip{x, y, relief.height(x, y) - depth};
    const GridPoint grid = space.gridFromView(hip);
    state = n == 0 ? proxyPlace(space, space.gridFromView(hip + ViewMm{0, 0, 10})) : state;
    state = proxyTick(space, state, grid, options);
    const ViewMm out = space.viewFromGrid(state.position) - hip;
    const ViewMm force = state.contact ? stiffness_n_per_mm * out : ViewMm{};
    if (n > kTicks) {  // The first cycle only comes to the surface.
      const double done = 0.5 * dot(force + last_force, hip - last_hip);
      work.net_mj += done;
      work.gross_mj += std::abs(done);
    }
    last_hip = hip;
    last_force = force;
  }
  work.net_mj /= kCycles - 1;
  work.gross_mj /= kCycles - 1;
  return work;
}

inline std::unique_ptr<HapticSpace> spaceOf(const Relief& relief, double side_mm,
                                            SurfaceKind kind) {
  return spaceOf(side_mm, relief.height, 1, {}, kind);
}

}  // namespace relievo::test
