// SPDX-License-Identifier: BSD-3-Clause
// The guide and the introduction to touch, as menu, keys and speech have them: the plugin as a
// file, and a Host that remembers what is said.
#include <cmath>
#include <QApplication>
#include <QComboBox>

#include "core/region/hand.h"
#include "plugins/haptics/buttons/device_buttons.h"
#include "tests/plugins/plugin_fixture.h"

namespace relievo {
namespace {

using test::eventually;

constexpr double kRadiusMm = 16;

class GuidePluginTest : public test::PluginTest {
 protected:
  /// A round hill of 8 mm in the middle of 80 mm.
  static std::shared_ptr<const RegionWindow> hill(std::uint64_t id) {
    return std::make_shared<RegionWindow>(test::windowOf(
        80,
        [](double x, double y) {
          return 4 + 4 * std::tanh(kRadiusMm - std::hypot(x - 40, y - 40));
        },
        id));
  }
  void takeTheVirtualHand() {
    // A busy computer makes the loop slow, which would bound the stiffness (E306).
    plugin_->restoreState(R"({"bound_by_rate": false, "device": "virtual:relaxed",
                              "window_silence_s": 30})");
    Q_EMIT host_.handMoved({handOver(*host_.window, 60, 40, false, 0), true});
  }
  bool switchForcesOn() {
    host_.actions.at("forces")->trigger();
    return probeBecomes([](const Probe& p) { return p.forces_on; });
  }
  QAction* guide() { return host_.actions.at("guide"); }
};

TEST_F(GuidePluginTest, LeadsTheHandAlongTheOutlineAndLetsGo) {
  host_.window = hill(11);
  attach();
  takeTheVirtualHand();
  ASSERT_TRUE(switchForcesOn());
  guide()->trigger();
  ASSERT_TRUE(said("Guiding along the outline of a raised area, you lead."));
  EXPECT_TRUE(guide()->isChecked());
  // From the right side of the hill to its other side, along its edge. Where a busy computer makes
  // the loop pause, the simulated hand flies on with the last force, and the guide lets go of it,
  // as it must: then it is asked again.
  double worst_mm = 0;
  bool on_outline = false;
  ASSERT_TRUE(probeBecomes([&](const Probe& p) {
    if (!guide()->isChecked()) {
      worst_mm = 0;
      on_outline = false;
      guide()->trigger();
    }
    const double x = p.hip.x - 40, y = p.hip.y - 40;
    const double off_mm = std::abs(std::hypot(x, y) - kRadiusMm);
    if (off_mm < 2) on_outline = true;
    if (on_outline && std::abs(y) > 5) worst_mm = std::max(worst_mm, off_mm);
    return on_outline && x < -kRadiusMm / 2;
  })) << host_.announcements.join(" | ").toStdString();
  EXPECT_LT(worst_mm, 4) << "round it and not across";
  guide()->trigger();
  EXPECT_TRUE(host_.announcements.contains("The guide is off."));
  EXPECT_FALSE(guide()->isChecked());
}

TEST_F(GuidePluginTest, AHandThatPushesAgainstItLeads) {
  host_.window = hill(12);
  attach();
  takeTheVirtualHand();
  ASSERT_TRUE(switchForcesOn());
  guide()->trigger();
  ASSERT_TRUE(said("Guiding along the outline of a raised area, you lead."));
  ASSERT_TRUE(eventually([this] {
    Q_EMIT host_.handMoved({handOver(*host_.window, 75, 40, true, 1), true});
    return host_.announcements.contains("You lead.");
  }));
  EXPECT_FALSE(guide()->isChecked());
}

TEST_F(GuidePluginTest, SaysWhatItNeeds) {
  attach();
  guide()->trigger();
  EXPECT_TRUE(host_.announcements.contains("Nothing is open."));
  host_.showWindow(hill(13));
  guide()->trigger();
  EXPECT_TRUE(host_.announcements.contains("The guide needs a device that can move the hand."));
  takeTheVirtualHand();
  guide()->trigger();
  EXPECT_TRUE(host_.announcements.contains("The guide needs the forces. Switch them on first."));
  EXPECT_FALSE(guide()->isChecked());
  host_.showWindow(std::make_shared<RegionWindow>(test::windowOf(
      80, [](double, double) { return 0.0; }, 14)));
  ASSERT_TRUE(switchForcesOn());
  guide()->trigger();
  ASSERT_TRUE(said("There is no outline here to be led along."));
  EXPECT_FALSE(guide()->isChecked());
}

TEST_F(GuidePluginTest, AnotherWindowEndsIt) {
  host_.window = hill(15);
  attach();
  takeTheVirtualHand();
  ASSERT_TRUE(switchForcesOn());
  guide()->trigger();
  ASSERT_TRUE(said("Guiding along the outline of a raised area, you lead."));
  host_.showWindow(hill(16));
  ASSERT_TRUE(said("The guide is off: the window is another one."));
}

TEST_F(GuidePluginTest, AMarkerThatIsGoneToPullsTheHandBack) {
  host_.window = hill(17);
  attach();
  takeTheVirtualHand();
  Q_EMIT host_.wentToMarker(30, 30);
  ASSERT_TRUE(switchForcesOn());
  EXPECT_FALSE(host_.announcements.contains("The hand is at the marker."));
  Q_EMIT host_.wentToMarker(30, 30);
  ASSERT_TRUE(said("The hand is at the marker."));
  ASSERT_TRUE(
      probeBecomes([](const Probe& p) { return std::hypot(p.hip.x - 30, p.hip.y - 30) < 5; }));
}

TEST_F(GuidePluginTest, AMarkersPullLetsGoOfAHandThatGoesAway) {
  host_.window = hill(18);
  attach();
  takeTheVirtualHand();
  ASSERT_TRUE(switchForcesOn());
  Q_EMIT host_.wentToMarker(10, 40);
  double x_mm = 60;
  ASSERT_TRUE(eventually([&] {
    x_mm = x_mm < 78 ? x_mm + 0.5 : 60;
    Q_EMIT host_.handMoved({handOver(*host_.window, x_mm, 40, true, 1), true});
    return host_.announcements.contains("You lead.");
  }));
}

TEST_F(GuidePluginTest, TheIntroductionGoesThroughFiveShapesAndGivesTheReliefBack) {
  host_.window = hill(21);
  attach();
  takeTheVirtualHand();
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.window_id == 21; }));
  QAction* const introduction = host_.actions.at("touchIntroduction");
  QAction* const next = host_.actions.at("nextShape");
  EXPECT_FALSE(next->isEnabled());
  introduction->trigger();
  EXPECT_TRUE(host_.announcements.contains(
      "Introduction: five shapes. The button Forward goes on. I switch the forces on now. They "
      "start softly. There is a flat plate. Push towards it and slide."))
      << host_.announcements.join('|').toStdString();
  EXPECT_TRUE(host_.actions.at("forces")->isChecked());
  EXPECT_TRUE(next->isEnabled());
  host_.actions.at("whereAmI")->trigger();
  EXPECT_EQ(host_.announcements.back(), "There is a flat plate. Push towards it and slide.");
  for (const char* task :
       {"Now there is a bump. Find it.", "Now there is a step. Go over its edge.",
        "Now there are waves. Stroke across them.",
        "Now there is a groove. Find it and follow it."}) {
    next->trigger();
    EXPECT_EQ(host_.announcements.back(), QStringLiteral("Let us go on. ") + task);
  }
  const std::size_t probes = host_.probes.size();
  next->trigger();
  EXPECT_EQ(host_.announcements.back(),
            "Let us go on. The introduction has ended. The relief is under the hand again.");
  EXPECT_FALSE(introduction->isChecked());
  ASSERT_TRUE(eventually([&] { return host_.probes.size() > probes; }));
  EXPECT_EQ(host_.probes.back().window_id, 21U);
}

TEST_F(GuidePluginTest, AHandThatIsMovedToTheBumpFindsIt) {
  host_.window = hill(22);
  attach();
  takeTheVirtualHand();
  host_.actions.at("touchIntroduction")->trigger();
  host_.actions.at("nextShape")->trigger();
  // The pointer over the shown window, at the same part of its width: 46 and 48 mm of 80.
  ASSERT_TRUE(eventually([this] {
    Q_EMIT host_.handMoved({handOver(*host_.window, 46, 48, true, 4), true});
    return host_.announcements.contains("Yes. Now there is a step. Go over its edge.") ||
           host_.announcements.contains("Let us go on. Now there is a step. Go over its edge.");
  }));
  EXPECT_TRUE(host_.announcements.contains("Yes. Now there is a step. Go over its edge."))
      << host_.announcements.join('|').toStdString();
  host_.actions.at("touchIntroduction")->trigger();
  EXPECT_TRUE(
      host_.announcements.contains("The introduction is off. The relief is under the hand again."));
}

TEST_F(GuidePluginTest, ForcesOffEndsTheIntroductionAndARecordingForbidsIt) {
  host_.window = hill(23);
  attach();
  takeTheVirtualHand();
  QAction* const introduction = host_.actions.at("touchIntroduction");
  introduction->trigger();
  host_.actions.at("record")->trigger();
  EXPECT_TRUE(host_.announcements.contains("The introduction is not recorded. End it first."));
  EXPECT_FALSE(host_.actions.at("record")->isChecked());
  host_.actions.at("forcesOff")->trigger();
  EXPECT_FALSE(introduction->isChecked());
  host_.actions.at("record")->trigger();
  ASSERT_TRUE(host_.actions.at("record")->isChecked());
  introduction->trigger();
  EXPECT_FALSE(introduction->isChecked());
  EXPECT_TRUE(host_.announcements.back().startsWith("A recording is running."));
}

/// Of the device; what they ask for is run by the host.
class LedButtonsTest : public ::testing::Test {
 protected:
  LedButtonsTest() {
    QObject::connect(&buttons_, &DeviceButtons::letGo, [this] { ++let_go_; });
    QObject::connect(&buttons_, &DeviceButtons::taught, [this](quint8 b) { taught_.push_back(b); });
  }
  void press(std::uint8_t button) {
    buttons_.press(button, true, now_);
    buttons_.press(button, false, now_ + 0.1);
    now_ += 1;
    buttons_.frame({}, now_);
  }

  test::TestHost host_;
  DeviceButtons buttons_{host_, nullptr, std::make_shared<pad::Rumbler>()};
  int let_go_ = 0;
  std::vector<quint8> taught_;
  double now_ = 1;
};

TEST_F(LedButtonsTest, APressThatLetsGoDoesNothingElse) {
  press(ButtonCommands::kPlus);
  EXPECT_EQ(host_.commands, QStringList{"finer"});
  buttons_.setLed(true);
  for (std::uint8_t button = 0; button < 4; ++button) press(button);
  EXPECT_EQ(let_go_, 4);
  EXPECT_EQ(host_.commands, QStringList{"finer"});
  // Let go while the guide ends: the button that comes up is still that press.
  buttons_.press(ButtonCommands::kMinus, true, now_);
  buttons_.setLed(false);
  buttons_.press(ButtonCommands::kMinus, false, now_ + 0.2);
  buttons_.frame({}, now_ + 1);
  EXPECT_EQ(host_.commands, QStringList{"finer"});
  now_ += 2;
  press(ButtonCommands::kMinus);
  EXPECT_EQ(host_.commands, (QStringList{"finer", "coarser"}));
}

TEST_F(LedButtonsTest, InTheIntroductionPressesAreToldAndDoNothingElse) {
  buttons_.setTaught(true);
  press(ButtonCommands::kForward);
  press(ButtonCommands::kCentre);
  EXPECT_EQ(taught_, (std::vector<quint8>{ButtonCommands::kForward, ButtonCommands::kCentre}));
  EXPECT_TRUE(host_.commands.isEmpty());
  EXPECT_FALSE(buttons_.moving());
  buttons_.setTaught(false);
  press(ButtonCommands::kPlus);
  EXPECT_EQ(host_.commands, QStringList{"finer"});
}

}  // namespace
}  // namespace relievo
