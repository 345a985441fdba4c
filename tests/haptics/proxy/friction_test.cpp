// SPDX-License-Identifier: BSD-3-Clause
// Coulomb friction as a cone on the proxy: holds, slides, loses work, never creeps.
#include <gtest/gtest.h>

#include <random>

#include "haptics/loop/haptic_core.h"
#include "haptics/loop/surface_preset.h"
#include "haptics/proxy/friction.h"
#include "tests/haptics/proxy/measure.h"

namespace relievo {
namespace {

constexpr std::array<SurfaceKind, 3> kKinds{SurfaceKind::crease_aware, SurfaceKind::spline,
                                            SurfaceKind::bilinear};

ProxyOptions rubbing(double fixed, double sliding) {
  ProxyOptions options;
  options.static_friction = fixed;
  options.dynamic_friction = sliding;
  return options;
}

std::unique_ptr<HapticSpace> flat(SurfaceKind kind) {
  return test::spaceOf(
      80, [](double, double) { return 0.0; }, 1, {}, kind);
}

TEST(Friction, HoldsWithinTheStaticConeAndSlidesOnTheDynamicOne) {
  for (const SurfaceKind kind : kKinds) {
    const auto space = flat(kind);
    const ProxyOptions options = rubbing(0.5, 0.3);
    ProxyState state = proxyPlace(*space, {100.3, 100.4, 1});
    state = proxyTick(*space, state, {100.3, 100.4, -2}, options);
    ASSERT_TRUE(state.contact);
    const GridPoint start = state.position;
    double held_until = 0;
    for (int n = 1; n <= 400; ++n) {
      const GridPoint hip{100.3 + 0.01 * n, 100.4, -2};
      state = proxyTick(*space, state, hip, options);
      if (state.position == start) {
        held_until = hip.x - start.x;
        continue;
      }
      EXPECT_NEAR(hip.x - state.position.x, 0.3 * 2, 1e-6) << "slides on the dynamic cone";
    }
    EXPECT_NEAR(held_until, 0.5 * 2, 0.011) << "static cone at depth 2";
  }
}

TEST(Friction, DoesNotCreepUnderAHandAtRest) {
  for (const SurfaceKind kind : kKinds) {
    const test::Relief relief = test::waves(1, 10);
    const auto space = test::spaceOf(relief, 100, kind);
    const ProxyOptions options = rubbing(0.2, 0.15);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(20, 180);
    for (int trial = 0; trial < 200; ++trial) {
      const double x = place(random), y = place(random);
      const double surface = surfaceHeight(*space, x, y);
      ProxyState state = proxyPlace(*space, {x, y, surface + 1});
      for (int n = 0; n <= 20; ++n) {  // Comes to rest while it slides.
        state = proxyTick(*space, state, {x + 0.1 * n, y + 0.05 * n, surface - 1.5}, options);
      }
      const GridPoint hip = state.hip, rest = state.position;
      for (int n = 0; n < 300; ++n) state = proxyTick(*space, state, hip, options);
      EXPECT_EQ(state.position, rest) << "trial " << trial;
    }
  }
}

TEST(Friction, OnlyLosesWork) {
  const test::Relief relief = test::waves(1, 10);
  for (const SurfaceKind kind : kKinds) {
    const auto space = test::spaceOf(relief, 100, kind);
    double last = 0;
    for (const double mu : {0.1, 0.3, 0.6}) {
      const test::Work work = test::workPerCycle(*space, relief, rubbing(1.4 * mu, mu));
      EXPECT_LT(work.net_mj, last) << mu;
      EXPECT_LT(work.net_mj, -0.01 * work.gross_mj) << mu;
      last = work.net_mj;
    }
  }
}

/// The place that is held back on the cone can be farther from the hand than where the proxy came
/// from: over relief that falls off between the two. Going there would give the hand energy.
TEST(Friction, NoMoveOfLessThanACellStretchesTheSpring) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> unit(-1, 1);
  int moves = 0;
  for (int scene = 0; scene < 12; ++scene) {
    const auto space = test::spaceOf(
        80,
        [&](double x, double y) {
          return 1.5 * std::sin(0.9 * x) * std::cos(0.8 * y) + 0.5 * unit(random);
        },
        1, {}, kKinds[static_cast<std::size_t>(scene) % kKinds.size()]);
    for (int trial = 0; trial < 400; ++trial) {
      const double mu = 0.05 + 0.9 * std::abs(unit(random));
      const ProxyOptions options = rubbing(1.4 * mu, mu);
      const double x = 100 + 80 * unit(random), y = 100 + 80 * unit(random);
      const double surface = surfaceHeight(*space, x, y);
      ProxyState state = proxyPlace(*space, {x, y, surface + 1});
      GridPoint hip{x, y, surface - 2 - 3 * std::abs(unit(random))};
      for (int n = 0; n < 40; ++n) {
        const ProxyState before = state;
        hip = hip + 0.55 * GridPoint{unit(random), unit(random), 0.5 * unit(random)};
        state = proxyTick(*space, state, hip, options);
        if (!before.contact || !state.contact || state.position == before.position) continue;
        ++moves;
        ASSERT_LE(norm(state.position - hip), norm(before.position - hip) * (1 + 1e-9) + 1e-9)
            << "scene " << scene << ", trial " << trial << ", tick " << n;
      }
    }
  }
  EXPECT_GT(moves, 10'000);
}

TEST(Friction, KeepsTheForceWithinTheConeAndTheProxyOutside) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto space = test::spaceOf(
      80,
      [&](double x, double y) {
        return std::sin(0.6 * x) + std::cos(0.5 * y) + 0.1 * unit(random) + (x > 40 ? 4 : 0);
      },
      1, {}, SurfaceKind::crease_aware);
  const ProxyOptions options = rubbing(0.4, 0.25);
  GridPoint hip{100, 100, 30};
  ProxyState state = proxyPlace(*space, hip);
  int contacts = 0;
  for (int n = 0; n < 30000; ++n) {
    if (n % 200 == 0) hip = {100 + 90 * unit(random), 100 + 90 * unit(random), 12 * unit(random)};
    hip = hip + GridPoint{0.3 * unit(random), 0.3 * unit(random), 0.3 * unit(random)};
    state = proxyTick(*space, state, hip, options);
    const GridPoint p = state.position;
    ASSERT_TRUE(isFinite(p)) << n;
    ASSERT_LE(space->cell_mm * (surfaceHeight(*space, p.x, p.y) - p.z), 1e-6) << n;
    contacts += state.contact ? 1 : 0;
  }
  EXPECT_GT(contacts, 10000);
}

/// How a hand slides: steadily, pressed in with 2 N along the normal.
struct Stroke {
  double step_mm = 0;  ///< Its places are counts of so much.
  double mm_per_s = 20;
  double turn = 0;   ///< Of the way over the window, radians from x.
  double slope = 0;  ///< Of the ground, along the way.
};

/// How much the force swings meanwhile.
double ripple(const SurfaceFeel& feel, const Stroke& stroke) {
  const double c = std::cos(stroke.turn), s = std::sin(stroke.turn);
  const auto space = test::spaceOf(
      80, [&](double x, double y) { return stroke.slope * (c * (x - 40) + s * (y - 40)); }, 1, {},
      SurfaceKind::crease_aware);
  HapticOptions options;
  setFeel(options, feel);
  const double k = feel.stiffness_by_detail ? 0.8 : feel.stiffness_n_per_mm;
  HapticCore core(ForceChain::bare);
  const double middle_mm = space->deviceFromView({40, 40, 0}).z;
  const auto counted = [&](double mm) {
    return stroke.step_mm > 0 ? stroke.step_mm * std::round(mm / stroke.step_mm) : mm;
  };
  const double length = std::hypot(1, stroke.slope);
  DeviceN low{9, 9, 9}, high{-9, -9, -9};
  // Within the window, beyond which the ground is level.
  constexpr double kStartMm = -32, kWayMm = 60;
  const int end_ms = std::min(2500, 400 + static_cast<int>(1e3 * kWayMm / stroke.mm_per_s));
  for (int ms = 0; ms < end_ms; ++ms) {
    // Down with 2 N, and along for a second before it is judged.
    const double in_mm = std::min(2 / k, 0.02 * ms - 1);
    const double along = kStartMm + 1e-3 * stroke.mm_per_s * std::max(0, ms - 400) / length;
    const double aside = along + in_mm * stroke.slope / length;
    DeviceReading reading;
    reading.time_ns = ms * 1'000'000LL;
    reading.position = {counted(c * aside), counted(s * aside),
                        counted(middle_mm + stroke.slope * along - in_mm / length)};
    const DeviceN f = core.tick(*space, options, reading, reading.time_ns).force;
    if (ms < 1400) continue;
    low = {std::min(low.x, f.x), std::min(low.y, f.y), std::min(low.z, f.z)};
    high = {std::max(high.x, f.x), std::max(high.y, f.y), std::max(high.z, f.z)};
  }
  return norm(high - low);
}

constexpr double kMostRippleN = 0.03;
constexpr std::array kSteadySpeeds{5.0, 20.0, 40.0};
// Exact, the Falcon's in and out and sideways, the virtual hand's.
constexpr std::array kCounts{0.0, 0.028, 0.048, 0.0635};

/// The presets that know friction, which the paper's does not, and rougher ground on the spring
/// that `relievo touch` has without a preset.
std::vector<SurfacePreset> rubbingFeels() {
  std::vector<SurfacePreset> all(kSurfacePresets.begin(), kSurfacePresets.end());
  std::erase_if(all, [](const auto& one) { return one.feel.proxy != ProxyKind::converged; });
  for (const auto& [id, friction] :
       {std::pair{"friction 0.4", 0.4}, std::pair{"friction 0.6", 0.6},
        std::pair{"friction 0.8", 0.8}, std::pair{"friction 1", 1.0}}) {
    all.push_back({id,
                   {.stiffness_by_detail = false,
                    .stiffness_n_per_mm = 0.5,
                    .friction = friction,
                    .fields = {},
                    .transient = {}}});
  }
  return all;
}

TEST(Friction, ASteadyHandFeelsNoRippleFromTheCountsOfItsEncoders) {
  const double kDiagonal = std::atan(1.0);
  for (const SurfacePreset& preset : rubbingFeels()) {
    for (const double step_mm : kCounts) {
      for (const double mm_per_s : kSteadySpeeds) {
        for (const double turn :
             {0.0, 0.2, 0.4, kDiagonal, 1.2, 2 * kDiagonal, 3 * kDiagonal, -0.3}) {
          EXPECT_LE(ripple(preset.feel, {.step_mm = step_mm, .mm_per_s = mm_per_s, .turn = turn}),
                    kMostRippleN)
              << preset.id << ", count " << step_mm << " mm, " << mm_per_s << " mm/s, turned "
              << turn;
        }
      }
    }
  }
}

/// A proxy towed on a line of length l follows a corner as a tractrix: its pull is turned by
/// 2 atan(exp(-s / l)) from the new way after s. It turns no sooner than on its own length r, and
/// no later than on the line that it trails on.
void followsACorner(double deep_mm, double mu) {
  const auto space = flat(SurfaceKind::crease_aware);
  const double mm_per_cell = space->deviceMmPerCell(), deep = deep_mm / mm_per_cell;
  const ProxyOptions options = rubbing(4 * mu / 3, mu);
  ProxyState state = proxyPlace(*space, {60, 60, 1});
  GridPoint hip{60, 60, -deep};
  const auto move = [&](double x, double y) {
    hip = hip + GridPoint{x / mm_per_cell, y / mm_per_cell, 0};
    state = proxyTick(*space, state, hip, options);
    return mm_per_cell * (hip - state.position);
  };
  constexpr double kStepMm = 0.02;
  const double r = deep_mm * mu;
  for (int n = 0; n < 500; ++n) move(kStepMm, 0);
  const double line = std::max(kTrailMm, (1 + kTrailShare) * r);
  const int way = static_cast<int>(7 * line / kStepMm);
  double pull = 0;
  for (int n = 1; n <= way; ++n) {
    const auto turned = [&](double length) {
      return r * std::sin(2 * std::atan(std::exp(-n * kStepMm / length)));
    };
    pull = move(0, kStepMm).x;
    EXPECT_GE(pull, std::min(turned(r), turned(line)) - 0.02) << n;
    EXPECT_LE(pull, std::max(turned(r), turned(line)) + 0.02) << n;
  }
  EXPECT_LE(pull, 0.01);
  double aside = 0;
  for (int n = 0; n < 250; ++n) aside = std::max(aside, std::abs(move(0, -kStepMm).x));
  EXPECT_LE(aside, 0.01) << "back";
}

TEST(Friction, AHandThatTurnsACornerIsFollowedAndOneThatTurnsBackIsPulledStraight) {
  followsACorner(2.5, 0.15);
  followsACorner(4, 0.45);
}

/// On a slope the counts change the depth as well, whatever rubs: a spring of 0.8 N/mm swings by
/// 0.05 N. Friction may add no more than on the flat.
TEST(Friction, NorDoesOneThatGoesUpOrDownASlope) {
  double worst = 0;
  for (const SurfacePreset& preset : rubbingFeels()) {
    SurfaceFeel smooth = preset.feel;
    smooth.friction = 0;
    for (const double step_mm : kCounts) {
      for (const double mm_per_s : kSteadySpeeds) {
        for (const double slope : {-0.5, 0.3, 0.7}) {
          for (const double turn : {0.0, std::atan(1.0)}) {
            const Stroke stroke{
                .step_mm = step_mm, .mm_per_s = mm_per_s, .turn = turn, .slope = slope};
            const double more = ripple(preset.feel, stroke) - ripple(smooth, stroke);
            worst = std::max(worst, more);
            EXPECT_LE(more, kMostRippleN)
                << preset.id << ", count " << step_mm << " mm, " << mm_per_s << " mm/s, slope "
                << slope << ", turned " << turn;
          }
        }
      }
    }
  }
  RecordProperty("worst_mn", static_cast<int>(1e3 * worst));
}

/// What a real material shows is left: it holds harder at rest, and lets go at once.
TEST(Friction, AHandThatHasRestedIsHeldHarderBeforeItSlides) {
  const auto space = flat(SurfaceKind::crease_aware);
  const ProxyOptions options = rubbing(0.5, 0.3);
  ProxyState state = proxyPlace(*space, {100.3, 100.4, 1});
  const auto slide = [&](double from, double to) {
    double most = 0;
    for (double x = from; x <= to; x += 0.05) {
      state = proxyTick(*space, state, {x, 100.4, -2}, options);
      most = std::max(most, x - state.position.x);
    }
    return most;
  };
  state = proxyTick(*space, state, {100.3, 100.4, -2}, options);
  for (int n = 0; n < kRestTicks; ++n)
    state = proxyTick(*space, state, {100.3, 100.4, -2}, options);
  EXPECT_NEAR(slide(100.3, 104), 0.5 * 2, 0.06) << "from rest";
  for (int n = 0; n + 5 < kRestTicks; ++n) {
    state = proxyTick(*space, state, state.hip, options);
  }
  EXPECT_NEAR(slide(104, 106), 0.3 * 2, 0.06) << "a moment is no rest";
  for (int n = 0; n < kRestTicks; ++n) state = proxyTick(*space, state, state.hip, options);
  EXPECT_NEAR(slide(106, 108), 0.5 * 2, 0.06) << "rested";
}

}  // namespace
}  // namespace relievo
