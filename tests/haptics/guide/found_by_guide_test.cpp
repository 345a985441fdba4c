// SPDX-License-Identifier: BSD-3-Clause
// A simulated hand that knows nothing of the relief is led along what was found in it, and knows
// afterwards, from its own way alone, where the bump, the hollow or the plateau is and how large.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/outline/outline.h"
#include "core/region/hand.h"
#include "tests/haptics/guide/led_hand.h"

namespace relievo {
namespace {

enum class Form { bump, hollow, plateau };

/// One thing in a plate of 80 mm, 1 mm of which is 1 mm of hand.
struct Relief {
  Form form = Form::bump;
  double x_mm = 40, y_mm = 40;
  double reach_mm = 12;  ///< Radius; of the plateau half of its side.
  double high_mm = 5;

  double height(double x, double y) const {
    const double dx = std::abs(x - x_mm), dy = std::abs(y - y_mm);
    if (form == Form::plateau) {  // Its edge rises over 0.8 mm.
      const double inside = reach_mm - std::max(dx, dy);
      return high_mm * std::clamp(inside / 0.8 + 0.5, 0.0, 1.0);
    }
    const double part = std::hypot(dx, dy) / reach_mm;
    const double cap = part < 1 ? high_mm * (1 - part * part) : 0;
    return form == Form::bump ? cap : -cap;
  }
};

/// What a hand has learned from where it was.
struct Felt {
  double low_x = 1e9, high_x = -1e9, low_y = 1e9, high_y = -1e9;
  void add(double x, double y) {
    low_x = std::min(low_x, x);
    high_x = std::max(high_x, x);
    low_y = std::min(low_y, y);
    high_y = std::max(high_y, y);
  }
  double x() const { return (low_x + high_x) / 2; }
  double y() const { return (low_y + high_y) / 2; }
  double reach() const { return (high_x - low_x + high_y - low_y) / 4; }
};

TEST(FoundByGuide, BumpHollowAndPlateauInFiftyRandomReliefs) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> reach(8, 16), high(2, 8), part(0, 1);
    std::normal_distribution<double> noise(0, 0.02);
    Relief relief{
        .form = static_cast<Form>(seed % 3), .reach_mm = reach(random), .high_mm = high(random)};
    const double room = 76 - 2 * relief.reach_mm;
    relief.x_mm = 2 + relief.reach_mm + room * part(random);
    relief.y_mm = 2 + relief.reach_mm + room * part(random);
    const RegionWindow window =
        test::windowOf(80, [&](double x, double y) { return relief.height(x, y) + noise(random); });
    const std::vector<Outline> outlines = outlinesOf(window, 0, kOutlineToleranceMm);
    ASSERT_EQ(outlines.size(), 1U);
    // What is said of it before it begins.
    EXPECT_EQ(outlines[0].of, relief.form == Form::hollow ? OutlineOf::sunk : OutlineOf::raised);
    const HandMapping mapping = handMapping(window);
    std::vector<DeviceMm> corners;
    for (const ViewMm& p : outlines[0].corners) corners.push_back(mapping.device_from_view(p));
    test::LedHand hand({.hand = kHandPresets.at(seed % kHandPresets.size())},
                       guidePath(corners, true), 0.2);
    Felt felt;
    hand.each = [&](const HapticSample& sample, double) {
      const bool along = sample.guide == GuidePhase::leading || sample.guide == GuidePhase::pausing;
      if (along) felt.add(sample.hip.x, sample.hip.y);
    };
    const test::Led led = hand.run({}, 200);  // From the middle.
    EXPECT_EQ(led.end, GuideEnd::arrived);
    EXPECT_LE(led.rms_mm, 2);
    EXPECT_EQ(led.audit.violations(), 0U);
    const DeviceMm centre = mapping.device_from_view({relief.x_mm, relief.y_mm, 0});
    EXPECT_LT(std::hypot(felt.x() - centre.x, felt.y() - centre.y), 2);
    // The foot of a cap is not its steepest place once 3 x 3 samples and noise are seen.
    EXPECT_GT(felt.reach(), 0.75 * relief.reach_mm);
    EXPECT_LT(felt.reach(), relief.reach_mm + 1.5);
  }
}

}  // namespace
}  // namespace relievo
