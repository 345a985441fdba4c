// SPDX-License-Identifier: BSD-3-Clause
// What a surface is beyond its shape: softness, texture, a pull from above, and knocks.
#include "haptics/loop/surface_fields.h"

#include <gtest/gtest.h>

#include <random>

#include "haptics/loop/haptic_core.h"
#include "haptics/proxy/texture.h"
#include "tests/haptics/closed_loop.h"
#include "tests/haptics/haptic_fixture.h"
#include "tests/haptics/hollows.h"
#include "tests/haptics/stability.h"

namespace relievo {
namespace {

constexpr double kSideMm = 80;  // One to one under the hand.
constexpr double kStiffness = 0.5;

double hills(double x, double y) {
  return 1.5 * std::sin(0.35 * x) * std::cos(0.3 * y);
}
/// Too fine for samples of 0.4 mm.
double grain(double x, double y) {
  return 0.03 * std::sin(5.5 * x) * std::cos(4.5 * y);
}

/// Hills of which the right half was not measured, with a texture.
std::unique_ptr<HapticSpace> scene(SurfaceKind kind = SurfaceKind::crease_aware) {
  RegionWindow window = test::windowOf(kSideMm, hills);
  for (int row = 0; row < kWindowSamples; ++row) {
    for (int col = kWindowSamples / 2; col < kWindowSamples; ++col) {
      window.origins[HapticSpace::index(col, row)] = CellStatus::interpolated;
    }
  }
  auto space = std::make_unique<HapticSpace>();
  fill(*space, window, {}, kind);
  std::vector<float> finer(TextureMap::kCount);
  for (std::size_t i = 0; i < finer.size(); ++i) {
    const double x = 0.2 * (static_cast<double>(i % TextureMap::kSamples) + 0.5);
    const double y = 0.2 * (static_cast<double>(i / TextureMap::kSamples) + 0.5);
    finer[i] = static_cast<float>(hills(x, y) + grain(x, y));
  }
  fillTexture(*space, finer);
  return space;
}

FieldOptions everything() {
  return {.softest_part = 0.5, .texture_mm = 0.02, .magnet_n = 0.5, .magnet_reach_mm = 3};
}

HapticOptions bare() {
  HapticOptions options;
  options.stiffness_by_detail = false;
  options.force.stiffness_n_per_mm = kStiffness;
  return options;
}

/// Energy of spring and fields at a hand, by the proxy that a short way from `near` leads to.
double energyMj(const HapticSpace& space, const ProxyState& near, GridPoint hip,
                const FieldOptions& options) {
  const ProxyState proxy = proxyTick(space, near, hip, {});
  const Fields fields = fieldsAt(space, proxy, proxy.hip, kStiffness, {}, options);
  const double depth = space.deviceMmPerCell() * norm(proxy.position - proxy.hip);
  return 0.5 * kStiffness * fields.part * depth * depth + fields.energy_mj;
}

/// Spring and fields together.
DeviceN forceOf(const HapticSpace& space, const ProxyState& proxy, const FieldOptions& options) {
  const Fields fields = fieldsAt(space, proxy, proxy.hip, kStiffness, {}, options);
  const GridPoint out = proxy.position - proxy.hip;
  const double k = proxy.contact ? kStiffness * fields.part * space.deviceMmPerCell() : 0;
  return DeviceN{k * out.x, k * out.y, k * out.z} + fields.force;
}

TEST(SurfaceFields, TheForceIsTheSlopeOfTheirEnergyOverTheHand) {
  const auto space = scene(SurfaceKind::spline);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(20, 180), depth(-6, 4);
  constexpr double kStep = 1e-4;  // Cells.
  int touching = 0, above = 0;
  for (int i = 0; i < 400; ++i) {
    GridPoint hip{place(random), place(random), 0};
    hip.z = surfaceHeight(*space, hip.x, hip.y) - depth(random);
    const ProxyState proxy = proxyTick(*space, proxyPlace(*space, hip), hip, {});
    const DeviceN force = forceOf(*space, proxy, everything());
    const auto slope = [&](GridPoint way) {
      return (energyMj(*space, proxy, hip + kStep * way, everything()) -
              energyMj(*space, proxy, hip - kStep * way, everything())) /
             (2 * kStep * space->deviceMmPerCell());
    };
    const DeviceN expected{-slope({1, 0, 0}), -slope({0, 1, 0}), -slope({0, 0, 1})};
    // Beside a hill the magnet is held to its largest pull: there the slope is larger.
    if (!proxy.contact && norm(expected) > everything().magnet_n) continue;
    EXPECT_NEAR(norm(force - expected), 0, 2e-4) << i;
    ++(proxy.contact ? touching : above);
  }
  EXPECT_GT(touching, 100);
  EXPECT_GT(above, 100);
}

TEST(SurfaceFields, AClosedWayOfAHandWithoutFrictionGivesNoWork) {
  for (const SurfaceKind kind : {SurfaceKind::crease_aware, SurfaceKind::bilinear}) {
    const auto space = scene(kind);
    HapticOptions options = bare();
    options.fields = everything();
    HapticCore core(ForceChain::bare);
    DeviceN before;
    DeviceMm was;
    double work_mj = 0, gross_mj = 0;
    constexpr int kTicks = 40'000;
    const double turn = 2 * std::acos(-1.0) / kTicks;
    for (int i = 0; i <= kTicks + 1; ++i) {
      const double angle = turn * std::max(0, i - 1);
      DeviceReading reading;
      reading.time_ns = i * 1'000'000LL;
      // Over the border of the measured half and back, pressed in by up to 2.5 mm and let go.
      const double x = 15 * std::sin(3 * angle), y = 12 * std::sin(2 * angle);
      reading.position = {x, y,
                          hills(x + 40, y + 40) + (i == 0 ? 6 : 3 * std::cos(5 * angle) + 0.5)};
      const HapticSample sample = core.tick(*space, options, reading, reading.time_ns);
      if (i > 1) {
        const DeviceN mean = 0.5 * (sample.force + before);
        const DeviceMm way = sample.hip - was;
        const double mj = mean.x * way.x + mean.y * way.y + mean.z * way.z;
        work_mj += mj;
        gross_mj += std::abs(mj);
      }
      before = sample.force;
      was = sample.hip;
    }
    EXPECT_GT(gross_mj, 10);
    EXPECT_LE(work_mj, 2e-4 * gross_mj) << static_cast<int>(kind);
  }
}

TEST(SurfaceFields, ADeepClosedWayOverHollowsOfDifferingFirmnessGivesNoWork) {
  for (const SurfaceKind kind : {SurfaceKind::crease_aware, SurfaceKind::bilinear}) {
    for (const double depth_mm : {5.0, 7.0}) {
      const test::Work work = test::workOverHollows(kind, depth_mm);
      EXPECT_GT(work.gross_mj, 200);
      EXPECT_LE(work.net_mj, 2e-4 * work.gross_mj) << depth_mm << " mm";
      EXPECT_GT(work.net_mj, -0.01 * work.gross_mj) << "and takes little";
    }
  }
}

TEST(SurfaceFields, FirmGroundIsFullyFeltAgainOnceTheHandLetsGo) {
  SoftSpring spring;
  const auto at = [](double energy, double pull, double z) {
    return SoftPull{energy, {0, 0, pull}, {0, 0, z}, 0.5};
  };
  spring = yielded(spring, at(1, 2, 0));
  EXPECT_EQ(spring.share, 1);
  spring = yielded(spring, at(1.25, 3, 0));
  EXPECT_NEAR(spring.share, 0.8, 1e-12) << "a slip without a way: the energy stays what it was";
  spring = yielded(spring, at(1.25 + 0.3 + 0.005, 3.1, -0.1));
  EXPECT_NEAR(spring.share, 0.8, 1e-3) << "pressing on pays for all of it";
  spring = yielded(spring, at(4, 3, -0.1));
  EXPECT_EQ(spring.share, 0.5) << "never softer than the softest ground";
  spring = yielded(spring, at(1, 2, -0.1));
  EXPECT_EQ(spring.share, 1) << "what a slip back loses is firmness again";
  spring = yielded(spring, at(4, 3, 5));
  EXPECT_EQ(spring.share, 1) << "after a jump of the hand nothing is known";
}

TEST(SurfaceFields, UnmeasuredGroundIsSofterAndTheWayThereIsSmooth) {
  const auto space = scene();
  HapticOptions options = bare();
  options.fields.softest_part = 0.5;
  double last = 0;
  for (int col = 40; col <= 160; ++col) {
    const GridPoint p{col + 0.3, 90, surfaceHeight(*space, col + 0.3, 90)};
    const ProxyState proxy{p, p - GridPoint{0, 0, 1}, true, false};
    const Fields fields = fieldsAt(*space, proxy, proxy.hip, kStiffness, {}, options.fields);
    if (col < 90) {
      EXPECT_EQ(fields.part, 1) << col;
    }
    if (col > 110) {
      EXPECT_EQ(fields.part, 0.5) << col;
    }
    if (col > 40) {
      EXPECT_LT(std::abs(fields.part - last), 0.08) << col;
    }
    last = fields.part;
  }
}

TEST(SurfaceFields, SwitchedOffTheyChangeNotOneBit) {
  const auto plain = test::spaceOf(kSideMm, hills, 1, {}, SurfaceKind::crease_aware);
  const auto rich = scene();
  HapticCore a(ForceChain::bare), b(ForceChain::bare);
  for (int i = 0; i < 3000; ++i) {
    DeviceReading reading;
    reading.time_ns = i * 1'000'000LL;
    reading.position = {20 * std::sin(0.004 * i), 15 * std::cos(0.003 * i), 3 - 0.003 * i};
    const HapticSample one = a.tick(*plain, bare(), reading, reading.time_ns);
    const HapticSample other = b.tick(*rich, bare(), reading, reading.time_ns);
    ASSERT_EQ(one.force, other.force);
    ASSERT_EQ(one.proxy, other.proxy);
  }
}

TEST(SurfaceFields, TextureIsFeltAndHeldToItsAmplitude) {
  const auto space = scene();
  for (const double most_mm : {0.005, 0.02, kMostTextureMm}) {
    const FieldOptions options{.texture_mm = most_mm};
    double largest = 0;
    for (int i = 0; i < 4000; ++i) {
      const double x = 30 + 0.01 * i, y = 60;
      const double z = surfaceHeight(*space, x, y);
      const ProxyState proxy =
          proxyTick(*space, {{x, y, z}, {x, y, z}, true, true}, {x, y, z - 5}, {});
      const Fields fields = fieldsAt(*space, proxy, proxy.hip, kStiffness, {}, options);
      largest = std::max(largest, norm(fields.force));
      ASSERT_LE(std::abs(textureAt(*space, x, y, most_mm).value), most_mm);
    }
    // At most the bend's stiffness over half a place along both axes, and a part of it is felt.
    EXPECT_GT(largest, 0.01) << most_mm;
    EXPECT_LT(largest, 0.5 * kMostTextureStiffness * 0.2 * std::sqrt(2.0) + 0.01) << most_mm;
  }
  space->texture.present = false;
  const ProxyState proxy{{50, 50, 0}, {50, 50, -3}, true, false};
  EXPECT_EQ(fieldsAt(*space, proxy, proxy.hip, kStiffness, {}, {.texture_mm = 0.02}).force,
            DeviceN{});
}

TEST(SurfaceFields, AMagnetPullsGentlyWithinItsReachOnly) {
  const auto space = test::spaceOf(kSideMm, [](double, double) { return 0.0; });
  const auto pull = [&](double gap_mm, const FieldOptions& options) {
    GridPoint hip{80, 80, gap_mm / space->deviceMmPerCell()};
    return fieldsAt(*space, {hip, hip, false, false}, hip, kStiffness, {}, options).force;
  };
  const FieldOptions options{.magnet_n = 0.8, .magnet_reach_mm = 4};
  EXPECT_NEAR(pull(2, options).z, -0.8, 1e-12) << "strongest half way";
  EXPECT_NEAR(pull(1e-6, options).z, 0, 1e-5);
  EXPECT_EQ(pull(4.001, options), DeviceN{});
  EXPECT_LT(pull(3.9, options).z, 0);
  EXPECT_EQ(pull(2, {}), DeviceN{}) << "off unless asked for";
}

/// Closed loop over the scene with everything at once, stronger than any preset.
HapticOptions strongest() {
  HapticOptions options;
  options.fields = {.softest_part = kLeastSoftPart,
                    .texture_mm = kMostTextureMm,
                    .magnet_n = kMostMagnetN,
                    .magnet_reach_mm = 3};
  options.force.transient = {
      .contact_n = kMostContactN, .contact_n_s_per_mm = 0.01, .crossing_n = kMostCrossingN};
  options.force.strength = 1;
  return options;
}

TEST(SurfaceFields, AHandRestsOnAllOfThemAndThePassivityStageIsEnough) {
  const auto space = scene();
  for (const HandImpedance& grip : kHandPresets) {
    for (const double x_mm : {-20.0, 0.3, 15.0}) {
      VirtualHandOptions hand;
      hand.hand = grip;
      test::ClosedLoop loop(*space, hand, strongest());
      const auto aim = [&](double along, double height) {
        const GridPoint p = space->gridFromDevice({along, 3, 0});
        const double top = space->deviceFromGrid({p.x, p.y, surfaceHeight(*space, p.x, p.y)}).z;
        return DeviceMm{along, 3, top + height};
      };
      loop.switchOn(aim(x_mm, 6));
      const double reach = 2 / grip.stiffness_n_per_mm;
      for (int i = 0; i < 1000; ++i) loop.tick(aim(x_mm + 0.01 * std::min(i, 500), -reach));
      test::Swing swing;
      HapticSample last;
      for (int i = 0; i < 1500; ++i) {
        last = loop.tick(aim(x_mm + 5, -reach));
        if (i == 1000) swing.restart();
        swing.add(norm(last.force));
      }
      EXPECT_TRUE(last.contact);
      EXPECT_LT(swing.peakToPeak(), test::kStillN) << x_mm;
      EXPECT_EQ(last.softened, 0) << "not taken for an oscillation";
    }
  }
}

TEST(SurfaceFields, CrossingToUnmeasuredGroundTicksFaintlyOnce) {
  const auto space = scene();
  HapticOptions options = bare();
  options.force.forces_on = true;
  options.force.strength = 1;
  const auto run = [&](double crossing_n) {
    options.force.transient.crossing_n = crossing_n;
    HapticCore core;
    std::vector<DeviceN> forces;
    for (int i = 0; i < 4000; ++i) {
      const double x_mm = i < 2000 ? -10 : -10 + 0.01 * (i - 2000);
      const GridPoint p = space->gridFromDevice({x_mm, 0.2, 0});
      GridPoint at{p.x, p.y, surfaceHeight(*space, p.x, p.y)};
      DeviceReading reading;
      reading.time_ns = i * 1'000'000LL;
      reading.position = space->deviceFromGrid(at);
      reading.position.z += i < 1500 ? 2 : std::max(-1.0, 2 - 0.01 * (i - 1500));
      forces.push_back(core.tick(*space, options, reading, reading.time_ns).force);
    }
    return forces;
  };
  const std::vector<DeviceN> with = run(0.1), without = run(0);
  int different = 0, first = -1, last = -1;
  double largest = 0;
  for (int i = 0; i < 4000; ++i) {
    const double change =
        norm(with[static_cast<std::size_t>(i)] - without[static_cast<std::size_t>(i)]);
    if (change == 0) continue;
    ++different;
    if (first < 0) first = i;
    last = i;
    largest = std::max(largest, change);
  }
  EXPECT_GT(different, 4);
  EXPECT_LE(last - first, kKnockTicks);
  EXPECT_LE(largest, 0.1);
  EXPECT_GT(largest, 0.05);
}

}  // namespace
}  // namespace relievo
