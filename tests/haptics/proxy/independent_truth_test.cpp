// SPDX-License-Identifier: BSD-3-Clause
// The proxy and its force against a second evaluator: facets between the window's own samples, in
// long double, written from the equations and sharing nothing with haptics/. The relief is rough:
// creases, steps and a ridge, with another height at every sample.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "haptics/loop/haptic_core.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

using Real = long double;
constexpr double kSideMm = 80;

/// Largest cell whose samples lie around a coordinate; the surface goes on as a constant outside.
struct Between {
  int low = 0;
  Real part = 0;
};
Between between(Real along_mm) {
  const Real at = along_mm * kWindowSamples / kSideMm - 0.5L;
  if (!(at > 0)) return {0, 0};
  if (at >= kWindowSamples - 1) return {kWindowSamples - 2, 1};
  const int low = static_cast<int>(std::floor(at));
  return {low, at - low};
}

/// f(x, y) of the facets, view mm.
Real facetHeight(const RegionWindow& window, Real x, Real y) {
  const Between col = between(x), row = between(y);
  const auto sample = [&](int dx, int dy) {
    const auto index = static_cast<std::size_t>((row.low + dy) * kWindowSamples + col.low + dx);
    return static_cast<Real>(window.heights_mm[index]);
  };
  const Real below = (1 - col.part) * sample(0, 0) + col.part * sample(1, 0);
  const Real above = (1 - col.part) * sample(0, 1) + col.part * sample(1, 1);
  return (1 - row.part) * below + row.part * above;
}

RegionWindow roughRelief() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> grain(-0.08, 0.08);
  return test::windowOf(kSideMm, [&](double x, double y) {
    const double creases = 1.2 * std::abs(std::sin(0.35 * x)) + 0.8 * std::abs(std::cos(0.3 * y));
    const double steps = (x > 47 ? 2.5 : 0) + (y > 30 && y < 34 ? 1.5 : 0);
    return creases + steps + std::max(0.0, 3 - std::abs(x + y - 60)) + grain(random);
  });
}

/// A hand that wanders in and out of the relief, given to the core tick by tick.
template <class Each>
int wander(const HapticSpace& space, const HapticOptions& options, const Each& each) {
  std::mt19937 random(31);
  std::normal_distribution<double> push(0, 1);
  HapticCore core(ForceChain::bare);
  ViewMm hand{40, 40, 12}, speed{0, 0, 0};
  int contacts = 0;
  for (int n = 0; n < 60'000; ++n) {
    const ViewMm home{40 + 25 * std::sin(0.0007 * n), 40 + 25 * std::cos(0.0011 * n), 1.2};
    speed = 0.995 * speed + 0.0006 * (home - hand) +
            0.002 * ViewMm{push(random), push(random), push(random)};
    hand = hand + speed;
    DeviceReading reading;
    reading.position = space.deviceFromView(hand);
    reading.time_ns = n * 1'000'000LL;
    const HapticSample s = core.tick(space, options, reading, reading.time_ns);
    contacts += s.contact ? 1 : 0;
    each(s);
  }
  return contacts;
}

class Truth : public ::testing::Test {
 protected:
  Truth() {
    fill(*space_, window_, {}, SurfaceKind::bilinear);
    options_.stiffness_by_detail = false;
    options_.force.stiffness_n_per_mm = kStiffness;
  }
  static constexpr double kStiffness = 0.5;
  RegionWindow window_ = roughRelief();
  std::unique_ptr<HapticSpace> space_ = std::make_unique<HapticSpace>();
  HapticOptions options_;
};

TEST_F(Truth, TheProxyIsNeverBelowTheFacets) {
  Real deepest = 0;
  const int contacts = wander(*space_, options_, [&](const HapticSample& s) {
    const ViewMm& p = s.proxy_view;
    deepest = std::max(deepest, facetHeight(window_, p.x, p.y) - static_cast<Real>(p.z));
  });
  EXPECT_GT(contacts, 20'000);
  EXPECT_LE(deepest, 1e-6L) << "mm of view";
  RecordProperty("deepest_nm", static_cast<int>(1e6L * deepest));
}

TEST_F(Truth, TheForceIsKTimesTheWayFromTheHandToTheFacets) {
  Real worst = 0;
  const Real scale = space_->device_per_view;
  wander(*space_, options_, [&](const HapticSample& s) {
    if (!s.contact) return;
    const ViewMm &p = s.proxy_view, &h = s.hip_view;
    // From view mm and the second evaluator's height, not from the core's hand mm.
    const std::array<Real, 3> way{static_cast<Real>(p.x) - h.x, static_cast<Real>(p.y) - h.y,
                                  facetHeight(window_, p.x, p.y) - h.z};
    const std::array<Real, 3> force{s.force.x, s.force.y, s.force.z};
    for (std::size_t i = 0; i < 3; ++i) {
      worst = std::max(worst, std::abs(force[i] - kStiffness * scale * way[i]));
    }
  });
  EXPECT_LE(worst, 1e-6L) << "N";
  RecordProperty("worst_nano_n", static_cast<int>(1e9L * worst));
}

/// What a converged proxy means: nowhere around it do the facets come nearer to the hand. Beyond
/// the next crease they may; it has to be found by going there.
TEST_F(Truth, NowhereAroundTheProxyAreTheFacetsNearerToTheHand) {
  int judged = 0, missed = 0;
  wander(*space_, options_, [&](const HapticSample& s) {
    if (!s.contact || s.tick % 7 != 0) return;
    const ViewMm &p = s.proxy_view, &h = s.hip_view;
    const auto distance2 = [&](Real x, Real y) {
      const Real z = facetHeight(window_, x, y) - h.z;
      return (x - h.x) * (x - h.x) + (y - h.y) * (y - h.y) + z * z;
    };
    const Real here = distance2(p.x, p.y);
    ++judged;
    bool nearer = false;
    for (const Real step_mm : {1e-6L, 1e-5L}) {
      for (int i = 0; i < 32; ++i) {
        const Real angle = 2 * std::acos(-1.0L) * i / 32;
        const Real there =
            distance2(p.x + step_mm * std::cos(angle), p.y + step_mm * std::sin(angle));
        nearer = nearer || there < here - 1e-7L * step_mm * std::sqrt(here) - 1e-12L;
      }
    }
    missed += nearer ? 1 : 0;
  });
  EXPECT_GT(judged, 2000);
  EXPECT_EQ(missed, 0);
}

}  // namespace
}  // namespace relievo
