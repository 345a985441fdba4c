// SPDX-License-Identifier: BSD-3-Clause
// What the panel Touch says of samples that no real loop has to bring about.
#include "plugins/haptics/panel/haptics_panel.h"

#include <gtest/gtest.h>
#include <QComboBox>
#include <QLabel>
#include <QSlider>

#include "plugins/haptics/panel/loop_health.h"

namespace relievo {
namespace {

class HapticsPanelTest : public ::testing::Test {
 protected:
  HapticsPanelTest() { panel_.show(); }
  QString text(const char* name) { return label(name)->text(); }
  QLabel* label(const char* name) { return panel_.findChild<QLabel*>(QString::fromLatin1(name)); }
  HapticsPanel panel_;
  LoopReport report_;
};

TEST_F(HapticsPanelTest, TheComingOfANewSurfaceIsSaidAndGoneWhenItIsThere) {
  report_.sample.engaged = EngagePhase::on;
  panel_.show(report_);
  EXPECT_FALSE(label("surfaceChange")->isVisible());
  report_.sample.change = 0.4;
  panel_.show(report_);
  EXPECT_TRUE(label("surfaceChange")->isVisible());
  EXPECT_EQ(text("surfaceChange"), "The new surface comes under the hand: 40 %.");
  EXPECT_EQ(label("surfaceChange")->accessibleName(), "A new surface under the hand");
  report_.sample.change = 1;
  panel_.show(report_);
  EXPECT_FALSE(label("surfaceChange")->isVisible());
}

TEST_F(HapticsPanelTest, ASlowLoopIsSaidWithWhatItCosts) {
  report_.actuated = true;
  report_.sample.engaged = EngagePhase::on;
  report_.sample.slow = {412, 0.8, 0.45};
  panel_.show(report_);
  EXPECT_EQ(text("forceState"),
            "On. E306: Update rate fell to 412 per second (need 800). Stiffness reduced from 800 "
            "to 450 N/m.");
  report_.sample.slow = {};
  panel_.show(report_);
  EXPECT_EQ(text("forceState"), "On.");
}

// English has its plural forms in a translation, which these tests do not load.
TEST_F(HapticsPanelTest, InterruptionsOfTheForceAreSaidFirst) {
  report_.stats.rate_hz = 1000;
  EXPECT_TRUE(healthText(report_).startsWith("Runs well. 1000 per second, "));
  report_.stats.watchdog_cuts = 5;
  report_.stats.pauses = 7;
  EXPECT_TRUE(healthText(report_).startsWith("Force interrupted 5 time(s). Pauses after which"))
      << healthText(report_).toStdString();
}

TEST_F(HapticsPanelTest, WhetherADeviceWasTriedOnHardwareStandsBesideIt) {
  EXPECT_TRUE(label("triedOnHardware")->isHidden()) << "nobody feels a mouse";
  TouchSettings settings;
  settings.device = "falcon";
  panel_.setSettings(settings);
  EXPECT_FALSE(label("triedOnHardware")->isHidden());
  EXPECT_EQ(text("triedOnHardware"), "Tried on hardware: never.");
  settings.device = "plugin:nothing/here";
  panel_.setSettings(settings);
  EXPECT_EQ(text("triedOnHardware"), "Tried on hardware: ask who made the plug-in.");
  settings.device = "virtual:light";
  panel_.setSettings(settings);
  EXPECT_TRUE(label("triedOnHardware")->isHidden());
}

TEST_F(HapticsPanelTest, DevicesWithTheSameNameAreToldApartAndEachSaysWhetherItWasTried) {
  panel_.setPluginDevices({{"plugin:force_dimension/device.0", "Arm"},
                           {"plugin:force_dimension/device.1", "Arm"},
                           {"haply:049D", "Haply Inverse3 049D"}});
  auto* devices = panel_.findChild<QComboBox*>("deviceList");
  const auto at = [&](const char* id) { return devices->findData(id); };
  const auto tried = [&](const char* id) {
    return devices->itemData(at(id), Qt::AccessibleDescriptionRole).toString();
  };
  EXPECT_EQ(devices->itemText(at("plugin:force_dimension/device.0")),
            "Arm (plugin:force_dimension/device.0)");
  EXPECT_EQ(devices->itemText(at("plugin:force_dimension/device.1")),
            "Arm (plugin:force_dimension/device.1)");
  EXPECT_EQ(devices->itemText(at("haply:049D")), "Haply Inverse3 049D");
  EXPECT_EQ(tried("plugin:force_dimension/device.1"), "Tried on hardware: never.");
  EXPECT_EQ(tried("haply:049D"), "Tried on hardware: never.");
  EXPECT_EQ(tried("mouse"), "");
}

TEST_F(HapticsPanelTest, ThreeStrengthsAreOneChoiceAndAnyOtherIsOnesOwn) {
  auto* preset = panel_.findChild<QComboBox*>("strengthPreset");
  auto* slider = panel_.findChild<QSlider*>("strengthSlider");
  ASSERT_TRUE(preset != nullptr && slider != nullptr);
  EXPECT_EQ(preset->currentText(), "Medium, 60 %") << "as everybody begins";
  int changes = 0;
  QObject::connect(&panel_, &HapticsPanel::settingsChanged, &panel_, [&changes] { ++changes; });
  preset->setCurrentIndex(0);
  EXPECT_EQ(slider->value(), 30);
  EXPECT_EQ(panel_.settings().strength_percent, 30);
  EXPECT_EQ(text("strengthValue"), "30 %");
  EXPECT_EQ(changes, 1);
  slider->setValue(45);
  EXPECT_EQ(preset->currentText(), "Own strength");
  slider->setValue(100);
  EXPECT_EQ(preset->currentText(), "Full, 100 %");
  EXPECT_FALSE(preset->accessibleName().isEmpty());
}

TEST_F(HapticsPanelTest, HowTheDeviceStandsIsChosenAndKept) {
  auto* grip = panel_.findChild<QComboBox*>("gripPosition");
  ASSERT_NE(grip, nullptr);
  EXPECT_EQ(panel_.settings().grip, GripPosition::upright);
  grip->setCurrentIndex(1);
  EXPECT_EQ(panel_.settings().grip, GripPosition::flat);
  TouchSettings settings;
  settings.grip = GripPosition::right;
  EXPECT_EQ(touchSettingsFromJson(toJson(settings)), settings);
  EXPECT_EQ(touchSettingsFromJson(R"({"grip_position": "sideways"})").grip, GripPosition::upright);
  panel_.setSettings(settings);
  EXPECT_EQ(grip->currentIndex(), 3);
}

TEST_F(HapticsPanelTest, WarmMotorsAreSaid) {
  panel_.show(report_);
  EXPECT_TRUE(label("motorHeat")->isHidden());
  report_.heat = "Motors: 80 % of what they can take for good; forces stay below 2.4 N.";
  panel_.show(report_);
  EXPECT_FALSE(label("motorHeat")->isHidden());
  EXPECT_EQ(text("motorHeat"), report_.heat);
}

}  // namespace
}  // namespace relievo
