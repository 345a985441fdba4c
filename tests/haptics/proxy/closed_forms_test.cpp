// SPDX-License-Identifier: BSD-3-Clause
// Surfaces whose nearest point is known, and what must hold on any surface.
#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <random>

#include "haptics/loop/haptic_core.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

using test::angleDegrees;
using test::belowMm;
using test::spaceOf;

HapticOptions bare(ProxyKind kind = ProxyKind::converged) {
  HapticOptions options;
  options.proxy.kind = kind;
  options.stiffness_by_detail = false;
  options.force.stiffness_n_per_mm = 0.5;
  return options;
}

/// Drives the core at 1 kHz along view positions.
class Hand {
 public:
  Hand(const HapticSpace& space, HapticOptions options) : space_(space), options_(options) {}
  HapticSample to(ViewMm hip) {
    DeviceReading reading;
    reading.position = space_.deviceFromView(hip);
    reading.time_ns = now_ns_;
    const HapticSample sample = core_.tick(space_, options_, reading, now_ns_);
    now_ns_ += 1'000'000;
    return sample;
  }

 private:
  const HapticSpace& space_;
  HapticOptions options_;
  HapticCore core_{ForceChain::bare};
  std::int64_t now_ns_ = 0;
};

TEST(Proxy, RestsAtTheFootOfThePerpendicularOnPlanes) {
  struct Plane {
    double a, b, c;
  };
  for (const Plane& plane : {Plane{0, 0, 5}, Plane{0.5, 0, 1}, Plane{-0.3, 0.8, 40}}) {
    const auto space =
        spaceOf(80, [&](double x, double y) { return plane.a * x + plane.b * y + plane.c; });
    const double length = std::sqrt(1 + plane.a * plane.a + plane.b * plane.b);
    const ViewMm normal{-plane.a / length, -plane.b / length, 1 / length};
    Hand hand(*space, bare());
    for (int i = 0; i <= 2000; ++i) {
      const double angle = 0.004 * i, depth = std::min(0.02 * i - 2, 6.0);
      const double x = 40 + 18 * std::cos(angle), y = 40 + 14 * std::sin(angle);
      const ViewMm foot{x, y, plane.a * x + plane.b * y + plane.c};
      const HapticSample sample = hand.to(foot - depth * normal);
      if (std::abs(depth) < 1e-3) continue;  // On the surface: rounding decides.
      if (depth <= 0) {
        EXPECT_FALSE(sample.contact);
        EXPECT_EQ(sample.force, DeviceN{}) << "free space";
        continue;
      }
      // Heights are floats, 4e-6 mm at 80 mm; over a cell of 0.4 mm that tilts a patch by 1e-5.
      EXPECT_NEAR(norm(sample.proxy_view - foot), 0, 2e-4);
      if (depth < 0.1) continue;
      const DeviceN expected{normal.x, normal.y, normal.z};
      EXPECT_LT(angleDegrees(sample.force, expected), 0.1);
      EXPECT_NEAR(norm(sample.force), 0.5 * depth * space->device_per_view, 1e-4);
    }
  }
}

TEST(Proxy, StandsUnderTheHandOnASphereCap) {
  constexpr double kRadius = 60;
  const auto cap = [](double x, double y) {
    return std::sqrt(kRadius * kRadius - (x - 40) * (x - 40) - (y - 40) * (y - 40));
  };
  const auto space = spaceOf(80, cap);
  const ViewMm centre{40, 40, 0};
  Hand hand(*space, bare());
  for (int i = 0; i < 3000; ++i) {
    const double tilt = 0.35 * std::sin(0.0021 * i), turn = 0.0017 * i;
    const ViewMm out{std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn),
                     std::cos(tilt)};
    const HapticSample sample = hand.to(centre + (i == 0 ? kRadius + 1 : kRadius - 1) * out);
    if (i == 0) continue;
    ASSERT_TRUE(sample.contact);
    // A bilinear patch of 0.4 mm differs from the sphere by about h^2/8R and 1/2 h/R in slope.
    EXPECT_NEAR(norm(sample.proxy_view - (centre + kRadius * out)), 0, 0.02);
    EXPECT_LT(angleDegrees(sample.force, DeviceN{out.x, out.y, out.z}), 0.6);
  }
}

TEST(Proxy, PushesAlongTheSurfaceNormalWhereThereIsOne) {
  const auto space = spaceOf(80, [](double x, double y) {
    return 2 * std::sin(0.31 * x) + 1.5 * std::cos(0.27 * y) + 0.3 * std::sin(1.1 * (x + y));
  });
  Hand hand(*space, bare());
  int checked = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = 40 + 35 * std::sin(0.0011 * i), y = 40 + 35 * std::sin(0.0017 * i);
    const GridPoint under = space->gridFromView({x, y, 0});
    const double surface =
        space->viewFromGrid({under.x, under.y, surfaceHeight(*space, under.x, under.y)}).z;
    const HapticSample sample = hand.to({x, y, i == 0 ? surface + 1 : surface - 1});
    if (i == 0) continue;
    ASSERT_TRUE(sample.contact);
    EXPECT_LE(belowMm(*space, sample.proxy_view), 1e-6);
    const GridPoint p = space->gridFromView(sample.proxy_view);
    const bool on_edge =
        std::abs(p.x - std::round(p.x)) < 1e-6 || std::abs(p.y - std::round(p.y)) < 1e-6;
    if (on_edge || norm(sample.force) < 0.02) continue;
    ++checked;
    EXPECT_LT(
        angleDegrees(sample.force, DeviceN{sample.normal.x, sample.normal.y, sample.normal.z}),
        0.001);
  }
  EXPECT_GT(checked, 1000);
}

TEST(Proxy, ForceIsStiffnessTimesDistanceExactly) {
  const auto space = spaceOf(33, [](double x, double y) { return std::sin(x) * std::cos(y); });
  for (const ProxyKind kind : {ProxyKind::converged, ProxyKind::equation, ProxyKind::successive}) {
    Hand hand(*space, bare(kind));
    int in_contact = 0;
    for (int i = 0; i < 3000; ++i) {
      const HapticSample s = hand.to({5 + 0.007 * i, 12 + 0.002 * i, 1 - 0.0015 * i});
      const DeviceMm d = s.proxy - s.hip;
      const DeviceN expected = s.contact ? DeviceN{0.5 * d.x, 0.5 * d.y, 0.5 * d.z} : DeviceN{};
      EXPECT_LE(norm(s.force - expected), 1e-9 * norm(expected));
      EXPECT_EQ(s.f_cmd_n, norm(s.force));
      in_contact += s.contact ? 1 : 0;
    }
    EXPECT_GT(in_contact, 500);
  }
}

TEST(Proxy, FollowsTheHandInFreeSpaceAndLetsGoOnlyAboveTheSurface) {
  const auto space = spaceOf(80, [](double, double) { return 0.0; });
  Hand hand(*space, bare());
  for (int i = 0; i < 200; ++i) {
    const ViewMm hip{20 + 0.1 * i, 30, 3 * std::cos(0.2 * i)};
    const HapticSample sample = hand.to(hip);
    EXPECT_EQ(sample.contact, hip.z < 0) << i;
    if (!sample.contact) {
      EXPECT_EQ(sample.proxy, sample.hip);
    }
  }
}

TEST(Proxy, StartsStraightAboveAHandThatStartsBelow) {
  const auto space = spaceOf(80, [](double x, double) { return 0.5 * x; });
  Hand below(*space, bare());
  const HapticSample first = below.to({30, 40, 10});
  EXPECT_TRUE(first.contact);
  EXPECT_NEAR(first.proxy_view.x, 30, 1e-9);
  EXPECT_NEAR(first.proxy_view.z, 15, 1e-5);
  Hand above(*space, bare());
  EXPECT_FALSE(above.to({30, 40, 16}).contact);
}

TEST(Proxy, StaysOutsideAndFiniteWhateverTheHandDoes) {
  std::mt19937 random(20260711);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto space = spaceOf(80, [&](double, double) { return 2 * unit(random); });
  for (const ProxyKind kind : {ProxyKind::converged, ProxyKind::equation, ProxyKind::successive}) {
    Hand hand(*space, bare(kind));
    ViewMm hip{40, 40, 5};
    const int ticks = kind == ProxyKind::converged ? 100000 : 10000;
    for (int i = 0; i < ticks; ++i) {
      if (i % 50 == 0) {
        hip = {40 + 90 * unit(random), 40 + 90 * unit(random), 20 * unit(random)};
      }
      hip = hip + ViewMm{0.3 * unit(random), 0.3 * unit(random), 0.3 * unit(random)};
      const HapticSample s = hand.to(hip);
      ASSERT_TRUE(isFinite(s.proxy) && isFinite(s.force) && isFinite(s.normal)) << i;
      EXPECT_NEAR(norm(s.normal), 1, 1e-12);
      if (kind != ProxyKind::equation) {
        EXPECT_LE(belowMm(*space, s.proxy_view), 1e-6) << i;
      }
    }
  }
}

TEST(Proxy, ConvergedRestsAtALocalMinimumOfTheDistance) {
  std::mt19937 random(99);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto space = spaceOf(80, [&](double x, double y) {
    return std::sin(0.5 * x) + std::cos(0.4 * y) + 0.4 * unit(random);
  });
  Hand hand(*space, bare());
  for (int i = 0; i < 3000; ++i) {
    const ViewMm hip{40 + 38 * std::sin(0.003 * i), 40 + 38 * std::cos(0.0041 * i),
                     i == 0 ? 5 : -2 + unit(random)};
    const HapticSample s = hand.to(hip);
    if (!s.contact) continue;
    const GridPoint p = space->gridFromView(s.proxy_view), q = space->gridFromView(hip);
    const double here = norm(p - q);
    for (int k = 0; k < 16; ++k) {
      const double angle = k * std::acos(-1.0) / 8, step = 1e-4;
      const double x = p.x + step * std::cos(angle), y = p.y + step * std::sin(angle);
      const GridPoint beside{x, y, surfaceHeight(*space, x, y)};
      EXPECT_GE(norm(beside - q), here - 1e-9) << "tick " << i << ", direction " << k;
    }
  }
}

TEST(Proxy, RepeatsItselfBitByBit) {
  const auto run = [] {
    const auto space =
        spaceOf(60, [](double x, double y) { return std::sin(x) + std::cos(0.7 * y + 0.2 * x); });
    Hand hand(*space, bare());
    std::vector<std::uint64_t> bits;
    for (int i = 0; i < 5000; ++i) {
      const HapticSample s =
          hand.to({30 + 28 * std::sin(0.002 * i), 30 + 28 * std::cos(0.003 * i), -1});
      for (const double v : {s.proxy.x, s.proxy.y, s.proxy.z, s.force.x, s.force.y, s.force.z}) {
        bits.push_back(std::bit_cast<std::uint64_t>(v));
      }
    }
    return bits;
  };
  EXPECT_EQ(run(), run());
}

TEST(Proxy, AsInThePaperChattersByOneStepAndConvergedDoesNot) {
  const auto space = spaceOf(80, [](double, double) { return 0.0; });
  const auto largest_change = [&](ProxyKind kind) {
    Hand hand(*space, bare(kind));
    hand.to({20, 20, 1});
    double largest = 0, last = 0;
    for (int i = 0; i < 1500; ++i) {
      const HapticSample s = hand.to({20 + 0.0173 * i, 40, -2});
      const double depth = norm(s.proxy - s.hip);
      if (i > 200) largest = std::max(largest, std::abs(depth - last));
      last = depth;
    }
    return largest;
  };
  // Eq. (2) ends a tick up to one step of 0.1 mm above or below the surface.
  EXPECT_GT(largest_change(ProxyKind::equation), 0.05);
  EXPECT_LT(largest_change(ProxyKind::equation), 0.25);
  EXPECT_LT(largest_change(ProxyKind::successive), 1e-6);
  EXPECT_LT(largest_change(ProxyKind::converged), 1e-9);
}

TEST(Proxy, FollowsTheBorderBeyondTheWindow) {
  const auto space = spaceOf(80, [](double x, double y) { return 0.1 * x + 0.05 * y; });
  Hand hand(*space, bare());
  hand.to({40, 40, 20});
  HapticSample last;
  for (int i = 0; i < 400; ++i) last = hand.to({40 + 0.2 * i, 40, 2});
  // Beyond x = 79.8 mm the surface is the last column, constant in x.
  EXPECT_TRUE(last.contact);
  EXPECT_NEAR(last.proxy_view.x, 119.8, 1e-6);
  EXPECT_NEAR(last.proxy_view.z, 0.1 * 79.8 + 0.05 * last.proxy_view.y, 1e-4);
}

}  // namespace
}  // namespace relievo
