// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "tests/haptics/closed_loop.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo::test {

/// A surface on which stability is judged.
struct StabilityScene {
  std::string name;
  int detail = 0;  ///< Which level's texture; 0: the same at every level.
  std::unique_ptr<HapticSpace> space;
};

/// What a level carries: the finer, the shorter its waves under the hand. Amplitude 1/20 of the
/// wavelength, so that all have the same slopes.
inline constexpr std::array<double, 4> kTextureWaveMm{40, 16, 6, 2};

inline std::vector<StabilityScene> stabilityScenes() {
  const double turn = 2 * std::acos(-1.0);
  std::vector<StabilityScene> scenes;
  scenes.push_back({"flat", 0, spaceOf(80, [](double, double) { return 0.0; })});
  scenes.push_back({"edge", 0, spaceOf(80, [](double x, double) { return -std::abs(x - 40); })});
  for (std::size_t i = 0; i < kTextureWaveMm.size(); ++i) {
    const double wave = kTextureWaveMm[i];
    scenes.push_back({"texture", static_cast<int>(i) + 1, spaceOf(80, [=](double x, double y) {
                        return wave / 20 * std::sin(turn * x / wave) * std::cos(turn * y / wave);
                      })});
  }
  return scenes;
}

/// One try: a hand lands, slides for a second at 30 mm/s, and rests for two and a half.
struct StabilityTry {
  double k_n_per_mm = 0.5;
  double push_n = 2;  ///< What the hand means to press with.
  double start_x_mm = 0;
  bool passivity = true;
  ProxyOptions proxy = {};
  double damping_n_s_per_mm = 0;
  VirtualHandOptions device = {};  ///< Its own delay, counts and friction; the grip is apart.
  double rate_hz = 1000;
};

/// What the Falcon's driver declares of it, in the same arms and hand.
inline VirtualHandOptions likeTheFalcon() {
  VirtualHandOptions device;
  device.delay_ticks = 2;
  device.position_step_mm = 0.048;
  return device;
}

/// How much the force still swings above 20 Hz in the last half second, on the worst axis, N.
inline double swingAtRest(const HapticSpace& space, const HandImpedance& grip,
                          const StabilityTry& what) {
  VirtualHandOptions hand = what.device;
  hand.hand = grip;
  HapticOptions options;
  options.stiffness_by_detail = false;
  options.force.stiffness_n_per_mm = what.k_n_per_mm;
  options.force.damping_n_s_per_mm = what.damping_n_s_per_mm;
  options.proxy = what.proxy;
  options.force.strength = 1;
  options.force.passivity.on = what.passivity;
  options.force.oscillation.on = false;  // It would soften what is to be judged.
  // What is judged is this stiffness at this rate, not what the loop would make of it.
  ClosedLoop loop(space, hand, options, std::llround(1e9 / what.rate_hz));
  loop.options().bound_by_rate = false;
  const auto ticks = [&what](int ms) {
    return static_cast<int>(std::lround(1e-3 * ms * what.rate_hz));
  };
  const auto topAt = [&space](double x, double y) {
    const GridPoint p = space.gridFromDevice({x, y, 0});
    return space.deviceFromGrid({p.x, p.y, surfaceHeight(space, p.x, p.y)}).z;
  };
  const double reach_mm = what.push_n / grip.stiffness_n_per_mm;
  double x = what.start_x_mm;
  constexpr double kRowMm = 0.13;  // Off the scenes' symmetry lines.
  const auto aim = [&](double height_mm) {
    return DeviceMm{x, kRowMm, topAt(x, kRowMm) + height_mm};
  };
  loop.switchOn(aim(3));
  constexpr int kLandMs = 500, kSlideMs = 1000, kJudgedMs = 500;
  // In dry friction a hand slips once more long after it seems to rest; that is no swing.
  constexpr int kRestMs = 2500;
  for (int i = 0; i < ticks(kLandMs); ++i) loop.tick(aim(-reach_mm));
  for (int i = 0; i < ticks(kSlideMs); ++i) {
    x += 30 / what.rate_hz;
    loop.tick(aim(-reach_mm));
  }
  const Swing still(1 / what.rate_hz);
  std::array<Swing, 3> swings{still, still, still};
  for (int i = 0; i < ticks(kRestMs); ++i) {
    const DeviceN force = loop.tick(aim(-reach_mm)).force;
    if (i == ticks(kRestMs) - ticks(kJudgedMs)) {
      for (Swing& swing : swings) swing.restart();
    }
    swings[0].add(force.x);
    swings[1].add(force.y);
    swings[2].add(force.z);
  }
  return std::max({swings[0].peakToPeak(), swings[1].peakToPeak(), swings[2].peakToPeak()});
}

/// A hand that rests must feel a force that rests; less than this is not felt.
inline constexpr double kStillN = 0.05;

/// Largest stiffness up to which every try is still, in steps of 0.1 N/mm; of 0.02 at slow rates.
inline double largestStable(const HapticSpace& space, const HandImpedance& grip, bool passivity,
                            const VirtualHandOptions& device = {}, double rate_hz = 1000) {
  const double step = rate_hz < 400 ? 0.02 : 0.1;  // Slow loops allow little.
  constexpr double kMost = 3;
  double stable = 0;
  for (int i = 1; i * step <= kMost + 1e-9; ++i) {
    for (const double push : {0.5, 2.0, 4.0}) {
      for (const double start : {-20.3, -8.1}) {
        const StabilityTry what{i * step, push, start, passivity, {}, 0, device, rate_hz};
        if (swingAtRest(space, grip, what) > kStillN) return stable;
      }
    }
    stable = i * step;
  }
  return stable;
}

}  // namespace relievo::test
