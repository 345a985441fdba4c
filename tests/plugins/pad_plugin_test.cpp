// SPDX-License-Identifier: BSD-3-Clause
// A gamepad in the window: its buttons command, it rumbles only if somebody wants it, and as long
// as forces are on.
#include <algorithm>
#include <QAction>
#include <QCheckBox>
#include <string>

#include "core/region/hand.h"
#include "tests/emulator/mock_pad.h"
#include "tests/emulator/mock_usb.h"
#include "tests/plugins/plugin_fixture.h"

namespace relievo {
namespace {

using emulator::MockPad;
using emulator::RumbleCall;
using test::eventually;

class PadPluginTest : public test::PluginTest {
 protected:
  void SetUp() override {
    if (!emulator::MockUsb::works()) GTEST_SKIP() << "umockdev's library is not preloaded";
    test::PluginTest::SetUp();
    host_.window = std::make_shared<RegionWindow>(test::windowOf(
        80, [](double, double) { return 5.0; }, 7));
    attach();
    pad_ = pads_.plugIn({.name = "Xbox pad", .keys = {0x130, 0x131, 0x133, 0x134}});
    ASSERT_TRUE(said("Xbox pad connected."));
  }
  void touch(bool pressing) {
    Q_EMIT host_.handMoved({handOver(*host_.window, 40, 40, pressing, 2), true});
  }
  void switchForcesOnInTheAir() {
    touch(false);
    ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.window_id == 7 && !p.touching; }));
    host_.actions.at("forces")->trigger();
    ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.forces_on && !p.touching; }));
  }
  auto calls(RumbleCall::What what) const {
    const auto all = pads_.rumble(pad_);
    return std::count_if(all.begin(), all.end(),
                         [what](const RumbleCall& call) { return call.what == what; });
  }

  MockPad pads_;
  int pad_ = 0;
};

TEST_F(PadPluginTest, ItsButtonsCommandAsThoseOfAnyDevice) {
  pads_.press(pad_, 0x130, true);
  pads_.press(pad_, 0x130, false);
  EXPECT_TRUE(eventually([this] { return host_.commands.contains("finer"); }));
  EXPECT_GE(host_.hushed, 1) << "a press cuts what is being said";
}

TEST_F(PadPluginTest, RumblesAtAContactIfItIsSwitchedOnAndForcesAre) {
  switchForcesOnInTheAir();
  touch(true);
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.touching; }));
  touch(false);
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return !p.touching; }));
  EXPECT_EQ(calls(RumbleCall::What::play), 0) << "it is off at first";
  host_.actions.at("rumble")->trigger();
  EXPECT_TRUE(
      host_.announcements.contains("Gamepads rumble at contact and edge. It is a cue, no force."));
  // A busy computer may end the forces meanwhile: a person lifts the hand and begins again.
  EXPECT_TRUE(eventually([this] {
    if (!host_.actions.at("forces")->isChecked()) host_.actions.at("forces")->trigger();
    touch(host_.probes.back().touching ? false : host_.probes.back().forces_on);
    return calls(RumbleCall::What::play) > 0;
  }));
  const auto all = pads_.rumble(pad_);
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0].what, RumbleCall::What::upload);
  EXPECT_LE(all[0].length_ms, 200);
  EXPECT_TRUE(eventually([this] { return calls(RumbleCall::What::stop) > 0; }));
}

TEST_F(PadPluginTest, TheMenuAndThePanelHaveOneSwitchThatIsRemembered) {
  auto* box = inPanel<QCheckBox>("rumble", "Buttons");
  QAction* const action = host_.actions.at("rumble");
  EXPECT_FALSE(action->isChecked());
  EXPECT_EQ(box->accessibleName(), "Gamepads rumble at contact and edge");
  box->click();
  EXPECT_TRUE(action->isChecked());
  EXPECT_TRUE(plugin_->saveState().contains(R"("rumble":true)"));
  action->trigger();
  EXPECT_FALSE(box->isChecked());
  EXPECT_TRUE(host_.announcements.contains("Gamepads do not rumble."));
  plugin_->restoreState(R"({"rumble": true})");
  EXPECT_TRUE(box->isChecked());
  EXPECT_TRUE(action->isChecked());
}

TEST_F(PadPluginTest, UnpluggingIsSaidAndHarmless) {
  pads_.press(pad_, 0x131, true);
  pads_.unplug(pad_);
  EXPECT_TRUE(said("Xbox pad disconnected."));
}

}  // namespace
}  // namespace relievo
