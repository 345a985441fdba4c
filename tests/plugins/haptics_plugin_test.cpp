// SPDX-License-Identifier: BSD-3-Clause
// The plugin as the application sees it: a file, loaded; a Host, spoken to.
#include <gtest/gtest.h>
#include <algorithm>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>
#include <vector>

#include "core/region/hand.h"
#include "haptics/record/replay.h"
#include "haptics/rt/realtime_thread.h"
#include "plugins/haptics/touch_settings.h"
#include "tests/plugins/plugin_fixture.h"

namespace relievo {
namespace {

using test::eventually;
using test::TestHost;

std::shared_ptr<const RegionWindow> flatWindow(double height, std::uint64_t id) {
  return std::make_shared<RegionWindow>(test::windowOf(
      80, [height](double x, double) { return height + (x < 10 ? 1.0 : 0.0); }, id));
}

class HapticsPluginTest : public test::PluginTest {
 protected:
  void press(double depth_hand_mm) {
    Q_EMIT host_.handMoved({handOver(*host_.window, 40, 40, true, depth_hand_mm), true});
  }
  void hover() { Q_EMIT host_.handMoved({handOver(*host_.window, 40, 40, false, 0), true}); }
};

TEST_F(HapticsPluginTest, SaysWhatItIsBeforeItIsLoaded) {
  EXPECT_EQ(loader_.metaData()["IID"].toString(), QStringLiteral(RELIEVO_PLUGIN_IID));
  EXPECT_EQ(loader_.metaData()["MetaData"].toObject()["name"].toString(),
            QStringLiteral("haptics"));
}

TEST_F(HapticsPluginTest, FollowsTheHandAndTouches) {
  host_.window = flatWindow(5, 11);
  attach();
  hover();
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.window_id == 11 && !p.touching; }));
  press(2);
  const double depth_mm = 2 / handMapping(*host_.window).device_per_view;
  ASSERT_TRUE(probeBecomes(
      [&](const Probe& p) { return p.touching && std::abs(p.hip.z - (5 - depth_mm)) < 0.01; }));
  const Probe& probe = host_.probes.back();
  EXPECT_NEAR(probe.proxy.z, 5, 1e-6);
  EXPECT_NEAR(probe.proxy.x, probe.hip.x, 1e-6);
  EXPECT_FALSE(probe.forces_on);
  EXPECT_EQ(probe.force, DeviceN{}) << "forces are off";
  EXPECT_EQ(probe.origin, CellStatus::measured);
  EXPECT_TRUE(eventually([this] { return !host_.plotted.empty(); }));
}

TEST_F(HapticsPluginTest, SwitchesForcesOnGentlyAndOffAtOnce) {
  host_.window = flatWindow(5, 12);
  attach();
  press(2);
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.touching; }));
  QAction* forces = host_.actions.at("forces");
  forces->trigger();
  EXPECT_TRUE(host_.answers.contains("Forces on.")) << "the answer to a command";
  EXPECT_TRUE(inPanel<QCheckBox>("forcesBox")->isChecked());
  // The hand is in the surface: forces wait.
  ASSERT_TRUE(eventually([this] { return host_.status.forces_on; }));
  EXPECT_EQ(host_.probes.back().force, DeviceN{});
  ASSERT_TRUE(said("Forces wait: the hand is inside. Let go or press Page Up."));
  hover();
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return !p.touching; }));
  ASSERT_TRUE(said("The hand is clear: forces come on."));
  const std::size_t plotted = host_.plotted.size();  // Some quiet ticks go by.
  ASSERT_TRUE(eventually([&] { return host_.plotted.size() > plotted + 5; }));
  press(2);
  // 2 mm at 0.8 N/mm and 60 %.
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.force.z > 0.9; }));
  EXPECT_LE(norm(host_.probes.back().force), 0.97);
  EXPECT_TRUE(host_.actions.at("forcesOff")->isEnabled());
  host_.actions.at("forcesOff")->trigger();
  EXPECT_FALSE(forces->isChecked());
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.force == DeviceN{} && !p.forces_on; }));
}

TEST_F(HapticsPluginTest, TouchesWithTheVirtualHandThatItsForcePushesBack) {
  host_.window = flatWindow(5, 13);
  attach();
  auto* device = inPanel<QComboBox>("deviceList");
  // A busy computer makes the loop slow, which would bound the stiffness (E306).
  plugin_->restoreState(R"({"bound_by_rate": false})");
  device->setCurrentIndex(device->findData("virtual:relaxed"));
  EXPECT_TRUE(host_.announcements.contains("Device: virtual hand, relaxed grip."));
  hover();
  host_.actions.at("forces")->trigger();
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.forces_on && !p.touching; }));
  press(10);
  // 10 mm aimed, a grip of 0.2 N/mm against 0.8 N/mm at 60 %: about 3 mm are left.
  const double per_view = handMapping(*host_.window).device_per_view;
  // After a pause of the whole computer the force rises anew, and the hand is deeper meanwhile.
  ASSERT_TRUE(probeBecomes([per_view](const Probe& p) {
    return p.force.z > 1 && 5 - p.hip.z < 6 / per_view;
  })) << "the force holds the hand up: "
      << host_.probes.back().force.z << " N at " << host_.probes.back().hip.z;
  EXPECT_EQ(host_.status.device, "virtual hand, relaxed grip");
  EXPECT_TRUE(plugin_->saveState().contains("virtual:relaxed"));
}

TEST_F(HapticsPluginTest, SaysThatARememberedDeviceIsMissingAndTakesTheMouse) {
  host_.window = flatWindow(5, 14);
  attach();
  plugin_->restoreState(R"({"device": "virtual:iron"})");
  ASSERT_FALSE(host_.announcements.isEmpty());
  EXPECT_TRUE(host_.announcements.contains(
      "There is no virtual hand \"iron\". Known: light, relaxed, firm. The mouse is the hand now."))
      << host_.announcements.join('|').toStdString();
  EXPECT_EQ(inPanel<QComboBox>("deviceList")->currentData().toString(), "mouse");
  hover();
  EXPECT_TRUE(probeBecomes([](const Probe& p) { return p.window_id == 14; }));
}

TEST_F(HapticsPluginTest, GoesRoundInStrengthsByOneCommandWhichSaysEach) {
  host_.window = flatWindow(5, 16);
  attach();
  QAction* const next = host_.actions.at("strengthPreset");
  next->trigger();
  EXPECT_TRUE(host_.answers.contains("Strength: Full, 100 %."));
  next->trigger();
  EXPECT_TRUE(host_.answers.contains("Strength: Gentle, 30 %."));
  plugin_->restoreState(R"({"strength_percent": 40})");
  next->trigger();
  EXPECT_TRUE(host_.answers.contains("Strength: Medium, 60 %."));
  EXPECT_EQ(inPanel<QComboBox>("strengthPreset")->currentText(), "Medium, 60 %");
}

TEST_F(HapticsPluginTest, AnotherGripPositionSwitchesForcesOffIsSaidAndRemembered) {
  host_.window = flatWindow(5, 17);
  attach();
  hover();
  host_.actions.at("forces")->trigger();
  host_.actions.at("gripPosition")->trigger();
  EXPECT_FALSE(host_.actions.at("forces")->isChecked());
  EXPECT_EQ(host_.answers.last(), "Grip position: Before you, relief flat.");
  EXPECT_EQ(inPanel<QComboBox>("gripPosition", "Touch: advanced")->currentIndex(), 1);
  EXPECT_TRUE(plugin_->saveState().contains(R"("grip_position":"flat")"));
  host_.actions.at("forces")->trigger();
  inPanel<QComboBox>("gripPosition", "Touch: advanced")->setCurrentIndex(3);
  EXPECT_FALSE(host_.actions.at("forces")->isChecked());
  EXPECT_EQ(host_.answers.last(), "Grip position: At your right, turned to you.");
  host_.actions.at("gripPosition")->trigger();
  EXPECT_EQ(host_.answers.last(), "Grip position: Before you, relief upright.") << "and round";
}

TEST_F(HapticsPluginTest, RefusesForcesWithoutASurface) {
  attach();
  host_.actions.at("forces")->trigger();
  EXPECT_FALSE(host_.actions.at("forces")->isChecked());
  EXPECT_TRUE(host_.announcements.contains("Nothing to touch yet. Open a scan first."));
}

TEST_F(HapticsPluginTest, SaysThatAWindowCannotBeFeltAndKeepsTheLastOne) {
  host_.window = flatWindow(5, 15);
  attach();
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.window_id == 15; }));
  auto broken = std::make_shared<RegionWindow>(*flatWindow(5, 16));
  broken->heights_mm[3] = std::numeric_limits<float>::quiet_NaN();
  host_.showWindow(broken);
  EXPECT_TRUE(eventually([this] {
    return !host_.announcements.isEmpty() &&
           host_.announcements.last().contains("not a finite number");
  }));
  EXPECT_EQ(host_.noticed.size(), 1) << "nobody asked, and it cuts in on no answer";
  hover();
  EXPECT_TRUE(probeBecomes([](const Probe& p) { return p.window_id == 15; }));
}

TEST_F(HapticsPluginTest, AHandAtRestCostsNoFrames) {
  host_.window = flatWindow(5, 17);
  attach();
  hover();
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.window_id == 17; }));
  const Probe target = host_.probes.back();
  std::size_t settled = 0;
  // The follower comes to rest; from then on ticks go by without a probe.
  EXPECT_TRUE(eventually([&] {
    const std::size_t plotted = host_.plotted.size();
    const std::size_t shown = host_.probes.size();
    eventually([&] { return host_.plotted.size() > plotted + 40; });
    settled = host_.probes.size() - shown;
    return settled == 0;
  }));
  EXPECT_EQ(host_.probes.back().window_id, target.window_id);
  const auto loop_rests = [this] {
    return inPanel<QLabel>("loopHealth")->text().contains("250 times a second while it rests");
  };
  EXPECT_TRUE(eventually(loop_rests));
  host_.actions.at("forces")->trigger();
  EXPECT_TRUE(eventually([&] { return !loop_rests(); }));
}

TEST_F(HapticsPluginTest, TellsTheLoopsHealthOnceInThirtyTwoFrames) {
  host_.window = flatWindow(5, 18);
  attach();
  hover();
  host_.actions.at("forces")->trigger();  // With forces on each frame looks at the loop.
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.forces_on; }));
  const int plots = host_.plots;
  const int statuses = host_.statuses;
  ASSERT_TRUE(eventually([&] { return host_.plots >= plots + 320; }));
  const int told = host_.statuses - statuses;
  EXPECT_GE(told, 5);
  // Frames in which nothing was plotted count, too, and those in which forces change tell at once.
  EXPECT_LE(told, 30);
}

TEST_F(HapticsPluginTest, KeepsTouchingThroughAChangeOfWindow) {
  host_.window = flatWindow(5, 21);
  attach();
  press(2);
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.touching && p.hip.z < 4; }));
  host_.showWindow(flatWindow(9, 22));
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.window_id == 22 && p.touching; }));
  EXPECT_NEAR(host_.probes.back().proxy.z, 9, 1e-3);
  EXPECT_NEAR(host_.probes.back().proxy.x, 40, 0.5) << "sideways the hand stays";
}

TEST_F(HapticsPluginTest, ShowsHowTheLoopRunsAndWhetherRealTimeWasGranted) {
  host_.window = flatWindow(5, 31);
  attach();
  ASSERT_TRUE(eventually([this] { return host_.status.rate_hz > 0; }));
  EXPECT_EQ(host_.status.device, "mouse");
  EXPECT_TRUE(host_.status.realtime || !host_.status.realtime_note.isEmpty());
  ASSERT_TRUE(
      eventually([this] { return inPanel<QLabel>("loopHealth")->text().contains("per second"); }));
  const auto* health = inPanel<QLabel>("loopHealth");
  EXPECT_TRUE(health->text().contains("ticks late, longest gap")) << health->text().toStdString();
  EXPECT_TRUE(health->text().contains("eal-time priority"));
  EXPECT_EQ(health->accessibleDescription(), health->text());
}

TEST_F(HapticsPluginTest, TellsTheDetailsOfTheLoopAsTables) {
  host_.window = flatWindow(5, 32);
  attach();
  ASSERT_TRUE(eventually([this] { return host_.status.rate_hz > 0; }));
  inPanel<QPushButton>("loopDetailsButton")->click();
  const auto* text = inPanel<QPlainTextEdit>("loopDetailsText");
  ASSERT_NE(text, nullptr);
  EXPECT_TRUE(text->isVisible());
  const QString first = text->toPlainText();
  EXPECT_TRUE(first.contains("Woken late by, in ticks:")) << first.toStdString();
  EXPECT_TRUE(first.contains("  up to 20 µs"));
  EXPECT_TRUE(first.contains("Time spent computing, in ticks:\n  up to 0.5 µs"));
  EXPECT_TRUE(eventually([&] { return text->toPlainText() != first; })) << "it follows the loop";
}

TEST_F(HapticsPluginTest, APresetSetsAllThatIsFeltAndOwnValuesAreNamedSo) {
  host_.window = flatWindow(5, 33);
  attach();
  auto* preset = inPanel<QComboBox>("surfacePreset");
  auto* friction = inPanel<QDoubleSpinBox>("friction");
  EXPECT_EQ(preset->currentText(), "Smooth") << "the default";
  preset->setCurrentIndex(preset->findText("As in the paper"));
  EXPECT_EQ(inPanel<QComboBox>("proxyKind")->currentIndex(), 1);
  EXPECT_EQ(inPanel<QComboBox>("surfaceKind")->currentText(), "Flat facets (exact)");
  EXPECT_EQ(inPanel<QDoubleSpinBox>("stiffness")->value(), 0.5);
  EXPECT_FALSE(inPanel<QCheckBox>("stiffnessByDetail")->isChecked());
  EXPECT_EQ(friction->value(), 0);
  EXPECT_FALSE(friction->isEnabled()) << "the paper's proxies know none";
  preset->setCurrentIndex(preset->findText("Soft stone"));
  EXPECT_EQ(friction->value(), 0.6);
  EXPECT_TRUE(friction->isEnabled());
  EXPECT_EQ(inPanel<QDoubleSpinBox>("damping")->value(), 0.5);
  friction->setValue(0.3);
  EXPECT_EQ(preset->currentText(), "Own values");
  const QByteArray state = plugin_->saveState();
  preset->setCurrentIndex(preset->findText("Bronze"));
  EXPECT_EQ(preset->currentText(), "Bronze");
  plugin_->restoreState(state);
  EXPECT_EQ(friction->value(), 0.3);
  EXPECT_EQ(preset->currentText(), "Own values");
}

TEST_F(HapticsPluginTest, ALevelTakesAStiffnessOfItsOwn) {
  host_.window = flatWindow(5, 33);
  attach();
  auto* stiffness = inPanel<QDoubleSpinBox>("stiffness");
  auto* by_detail = inPanel<QCheckBox>("stiffnessByDetail");
  ASSERT_TRUE(by_detail->isChecked());
  stiffness->setValue(0.7);
  EXPECT_EQ(inPanel<QComboBox>("surfacePreset")->currentText(), "Own values");
  by_detail->setChecked(false);
  stiffness->setValue(0.4);
  by_detail->setChecked(true);
  EXPECT_EQ(stiffness->value(), 0.7) << "the level's";
  const TouchSettings settings = touchSettingsFromJson(plugin_->saveState());
  EXPECT_EQ(settings.feel.detail_stiffness[0], 0.7);
  EXPECT_EQ(settings.feel.detail_stiffness[2], 0.6) << "others keep theirs";
  EXPECT_EQ(settings.feel.stiffness_n_per_mm, 0.4);
}

TEST_F(HapticsPluginTest, SoftnessTextureKnockAndMagnetAreChosenAndRemembered) {
  host_.window = flatWindow(5, 33);
  attach();
  EXPECT_EQ(inPanel<QDoubleSpinBox>("softPart")->value(), 60) << "the default";
  inPanel<QDoubleSpinBox>("softPart")->setValue(50);
  inPanel<QDoubleSpinBox>("crossingTick")->setValue(0.1);
  inPanel<QDoubleSpinBox>("texture")->setValue(20);
  inPanel<QDoubleSpinBox>("contactKnock")->setValue(0.25);
  inPanel<QDoubleSpinBox>("magnet")->setValue(0.4);
  const HapticOptions options = hapticOptions(touchSettingsFromJson(plugin_->saveState()), true);
  EXPECT_EQ(options.fields.softest_part, 0.5);
  EXPECT_EQ(options.fields.texture_mm, 0.02);
  EXPECT_EQ(options.fields.magnet_n, 0.4);
  EXPECT_EQ(options.force.transient.contact_n, 0.25);
  EXPECT_EQ(options.force.transient.crossing_n, 0.1);
  auto* preset = inPanel<QComboBox>("surfacePreset");
  preset->setCurrentIndex(preset->findText("As in the paper"));
  EXPECT_EQ(inPanel<QDoubleSpinBox>("softPart")->value(), 100);
  EXPECT_EQ(inPanel<QDoubleSpinBox>("texture")->value(), 0);
  EXPECT_EQ(inPanel<QDoubleSpinBox>("magnet")->value(), 0);
}

TEST_F(HapticsPluginTest, ARasterOfFirmGroundIsChosenByKeysFeltAndRemembered) {
  host_.window = flatWindow(5, 36);
  host_.rasters = {{"/scans/soft.tif", 0.0F}};
  attach();
  inPanel<QDoubleSpinBox>("softPart")->setValue(50);
  auto* name = inPanel<QLabel>("firmnessName");
  auto* none = inPanel<QPushButton>("firmnessNone");
  EXPECT_EQ(name->text(), "where it was measured");
  EXPECT_FALSE(none->isEnabled());
  hover();
  host_.actions.at("forces")->trigger();
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.forces_on && !p.touching; }));
  press(1);
  const auto settled = [](const Probe& p, double newton) {
    return p.touching && std::abs(norm(p.force) - newton) < 0.005;
  };
  constexpr double kAtStrength = 0.6 * 0.8;  // N for 1 mm at Detail 1, where the ground is firm.
  ASSERT_TRUE(probeBecomes([&](const Probe& p) { return settled(p, kAtStrength); }))
      << norm(host_.probes.back().force);
  QTest::keyClick(inPanel<QPushButton>("firmnessChoose"), Qt::Key_Space);
  auto* dialog = inPanel<QFileDialog>("firmness_dialog");
  Q_EMIT dialog->fileSelected("/scans/soft.tif");
  EXPECT_EQ(host_.announcements.last(), "Stiffness map: soft.tif.");
  EXPECT_EQ(name->text(), "soft.tif");
  EXPECT_EQ(inPanel<QPushButton>("firmnessChoose")->accessibleDescription(), "soft.tif");
  EXPECT_TRUE(probeBecomes([&](const Probe& p) { return settled(p, 0.5 * kAtStrength); }))
      << norm(host_.probes.back().force);
  const QByteArray state = plugin_->saveState();
  EXPECT_EQ(touchSettingsFromJson(state).firmness, "/scans/soft.tif");
  // A preset does not change what is measured where.
  inPanel<QComboBox>("surfacePreset")->setCurrentIndex(1);
  EXPECT_EQ(touchSettingsFromJson(plugin_->saveState()).firmness, "/scans/soft.tif");
  QTest::keyClick(none, Qt::Key_Space);
  EXPECT_EQ(name->text(), "where it was measured");
  EXPECT_EQ(touchSettingsFromJson(plugin_->saveState()).firmness, "");
  plugin_->restoreState(state);
  EXPECT_EQ(name->text(), "soft.tif");
  EXPECT_EQ(plugin_->saveState(), state);
  hover();
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return !p.touching; }));
  press(1);
  EXPECT_TRUE(probeBecomes([&](const Probe& p) { return settled(p, 0.5 * kAtStrength); }))
      << norm(host_.probes.back().force);
}

TEST_F(HapticsPluginTest, ARasterThatCannotBeUsedIsSaidAndTheOneBeforeStays) {
  host_.window = flatWindow(5, 37);
  host_.rasters = {{"/scans/a.tif", 0.0F}, {"/scans/b.tif", 1.0F}};
  attach();
  const auto choose = [this](const QString& file) {
    inPanel<QPushButton>("firmnessChoose")->click();
    auto* dialog = inPanel<QFileDialog>("firmness_dialog");
    Q_EMIT dialog->fileSelected(file);
    delete dialog;
  };
  const auto kept = [this] { return touchSettingsFromJson(plugin_->saveState()).firmness; };
  choose("/scans/a.tif");
  choose("/scans/missing.tif");
  EXPECT_EQ(host_.announcements.last(), "There is no raster.");
  EXPECT_EQ(kept(), "/scans/a.tif");
  host_.rasters_fit = false;
  choose("/scans/b.tif");
  EXPECT_EQ(host_.announcements.last(), "It does not fit.");
  EXPECT_EQ(kept(), "/scans/a.tif");
  // Another map, which the chosen one does not fit: said once, and kept for its own map.
  host_.announcements.clear();
  host_.showWindow(flatWindow(5, 38));
  host_.showWindow(flatWindow(5, 39));
  EXPECT_EQ(host_.announcements.filter("It does not fit.").size(), 1);
  EXPECT_EQ(inPanel<QLabel>("firmnessName")->text(), "a.tif (not of this map)");
  host_.rasters_fit = true;
  host_.showWindow(flatWindow(5, 40));
  EXPECT_EQ(inPanel<QLabel>("firmnessName")->text(), "a.tif");
  // One that was remembered and has gone is forgotten, in words.
  plugin_->restoreState(R"({"firmness": "/scans/gone.tif"})");
  EXPECT_EQ(host_.announcements.last(), "There is no raster.");
  EXPECT_EQ(kept(), "");
  EXPECT_EQ(inPanel<QLabel>("firmnessName")->text(), "where it was measured");
}

TEST_F(HapticsPluginTest, TextureThatIsReadLateComesToItsWindow) {
  host_.window = flatWindow(5, 44);
  attach();
  EXPECT_EQ(host_.finer_asked, std::vector<std::uint64_t>{44});
  const std::vector<float> finer_mm(TextureMap::kCount, 5.01F);
  Q_EMIT host_.finerHeightsRead(43, finer_mm, {});  // Of a window that has gone.
  Q_EMIT host_.finerHeightsRead(44, finer_mm, {});
  inPanel<QComboBox>("surfaceKind")->setCurrentIndex(2);  // The same window again.
  EXPECT_EQ(host_.finer_asked.size(), 1U) << "known by now";
  // A worker prepares it; a newer one would take its place before.
  const std::size_t plotted = host_.plotted.size();
  ASSERT_TRUE(eventually([&] { return host_.plotted.size() > plotted + 40; }));
  host_.showWindow(flatWindow(5, 45));
  EXPECT_EQ(host_.finer_asked.back(), 45U);
  Q_EMIT host_.finerHeightsRead(45, {}, "Cannot read a tile.");
  EXPECT_EQ(host_.announcements.last(), "Cannot read a tile.");
  QAction* record = host_.actions.at("record");
  record->trigger();
  ASSERT_TRUE(eventually([this] { return host_.status.recorded_samples > 100; }));
  record->trigger();
  ASSERT_TRUE(
      eventually([this] { return host_.announcements.last().startsWith("Recording saved"); }));
  ASSERT_EQ(host_.recordings.size(), 1);
  EXPECT_TRUE(QFileInfo::exists(host_.recordings[0]));
  const QDir folder(home_.file("Documents/relievo"));
  const LogTable log =
      readLog(folder.filePath(folder.entryList({"relief_*.csv"}).value(0)).toStdString());
  QStringList textured;
  for (const QString& line : QString::fromStdString(log.footer).split('\n')) {
    const QStringList words = line.split(' ');
    if (words.value(1) == "scene") textured << words.value(3) + ':' + words.value(10);
  }
  ASSERT_GE(textured.size(), 2) << textured.join(' ').toStdString();
  EXPECT_EQ(textured.at(textured.size() - 2), "44:1");
  EXPECT_EQ(textured.last(), "45:0") << "its own was never read";
}

TEST_F(HapticsPluginTest, AnotherShapeIsFeltUnderTheTouchingHand) {
  // Beside a step the facets are flat; a spline rings there.
  host_.window = std::make_shared<RegionWindow>(test::windowOf(
      80, [](double x, double) { return x < 40 ? 5.0 : 7.0; }, 34));
  attach();
  auto* shape = inPanel<QComboBox>("surfaceKind");
  shape->setCurrentIndex(2);
  const auto over = [this](bool pressing) {
    Q_EMIT host_.handMoved({handOver(*host_.window, 40.5, 40, pressing, 1), true});
  };
  over(false);
  ASSERT_TRUE(probeBecomes([](const Probe& p) {
    return p.window_id == 34 && !p.touching && std::abs(p.hip.x - 40.5) < 1e-3;
  }));
  over(true);
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.touching; }));
  const auto is_flat = [](const Probe& p) { return p.touching && std::abs(p.proxy.z - 7) < 1e-4; };
  EXPECT_TRUE(probeBecomes(is_flat));
  shape->setCurrentIndex(1);
  EXPECT_TRUE(
      probeBecomes([](const Probe& p) { return p.touching && std::abs(p.proxy.z - 7) > 0.02; }));
  const std::size_t before = host_.probes.size();
  shape->setCurrentIndex(2);
  EXPECT_TRUE(probeBecomes(is_flat)) << "and back";
  for (std::size_t i = before; i < host_.probes.size(); ++i) {
    EXPECT_TRUE(host_.probes[i].touching) << "never let go";
  }
}

TEST_F(HapticsPluginTest, TheLoopOutlivesAGuiThatHangsForTenSecondsAndLetsTheForcesFade) {
  host_.window = flatWindow(5, 33);
  attach();
  hover();
  host_.actions.at("forces")->trigger();
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.forces_on && !p.touching; }));
  press(1);
  constexpr double kPressedN = 0.6 * 0.8;  // 1 mm at 60 % of 0.8 N/mm.
  const auto is_pressed = [](double newton) { return std::abs(newton - kPressedN) < 0.01; };
  ASSERT_TRUE(probeBecomes([&](const Probe& p) { return is_pressed(norm(p.force)); }));
  QAction* record = host_.actions.at("record");
  record->trigger();
  ASSERT_TRUE(eventually([this] { return host_.status.recorded_samples > 100; }));
  const auto begun = static_cast<std::size_t>(host_.status.recorded_samples);
  // Not one event of Qt's is handled meanwhile.
  constexpr std::int64_t kHangNs = 10'000'000'000;
  sleepUntil(monotonicNs() + kHangNs);
  record->trigger();
  ASSERT_TRUE(
      eventually([this] { return host_.announcements.last().startsWith("Recording saved"); }));
  const QDir folder(home_.file("Documents/relievo"));
  const LogTable log =
      readLog(folder.filePath(folder.entryList({"relief_*.csv"}).value(0)).toStdString());
  ASSERT_GT(log.rows.size(), 1000U);
  for (std::size_t i = 0; i < log.rows.size(); ++i) {
    // A dropped tick would be a consumer that the hang has stopped.
    ASSERT_EQ(log.rows[i].tick, log.rows[0].tick + i);
  }
  // A hand that nobody moves is still there; nobody is, to switch its forces off.
  ASSERT_LT(begun, log.rows.size());
  const double hang_s = log.rows[begun].t_s, end_s = log.rows.back().t_s;
  std::vector<double> resumed_s;
  for (const LogEvent& event : log.events) {
    if (event.text.find("resumed after") != std::string::npos) resumed_s.push_back(event.t_s);
  }
  // After a pause of the whole computer the force rises anew.
  const auto rises = [&resumed_s](double t_s) {
    return std::any_of(resumed_s.begin(), resumed_s.end(),
                       [t_s](double since_s) { return t_s >= since_s && t_s < since_s + 1; });
  };
  std::size_t pressed = 0;
  for (const TouchRow& row : log.rows) {
    ASSERT_TRUE(row.contact);
    if (row.t_s > hang_s + 0.3 && row.t_s < hang_s + 1.7) {
      const bool is_as_before = is_pressed(row.force.z) || rises(row.t_s);
      ASSERT_TRUE(is_as_before) << "it has not been silent for two seconds: " << row.t_s - hang_s;
      ++pressed;
    }
    if (row.t_s > end_s - 6) {
      ASSERT_EQ(row.force.z, 0) << row.t_s - hang_s;
    }
  }
  EXPECT_GT(pressed, 10U);
  EXPECT_TRUE(
      std::any_of(host_.announcements.begin(), host_.announcements.end(), [](const QString& text) {
        return text.startsWith("Forces went off, because the window did not");
      }));
  EXPECT_FALSE(host_.actions.at("forces")->isChecked());
  // Positions had no age, and no force was cut for the GUI: the audit in the header tells.
  // A cut is one of the pauses of the whole computer, of which the loop itself tells.
  const auto counted = [&log](const std::string& what) {
    const std::size_t at = log.header.find(what);
    EXPECT_NE(at, std::string::npos) << log.header;
    return std::stoi(log.header.substr(at + what.size()));
  };
  EXPECT_LE(counted("watchdog cuts "), counted("pauses ")) << log.header;
  EXPECT_NE(log.header.find("zero violations 0, limit violations 0, step violations 0"),
            std::string::npos);
  // Ticks went on during the whole hang; what the whole computer missed is not made up for.
  const double seconds = 1e-9 * static_cast<double>(nanosecondsOf(log.rows.back()));
  EXPECT_GT(seconds, 9);
  EXPECT_GT(static_cast<double>(log.rows.size()), 10 * seconds);
}

TEST_F(HapticsPluginTest, ForcesThatAreSwitchedOnAfterAHangStayOn) {
  host_.window = flatWindow(5, 34);
  attach();
  TouchSettings settings;
  settings.window_silence_s = kLeastSilenceS;
  plugin_->restoreState(toJson(settings));
  hover();
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.window_id == 34 && !p.touching; }));
  // As while something long is opened: the key comes before any other event.
  sleepUntil(monotonicNs() + static_cast<std::int64_t>(2e9 * kLeastSilenceS));
  host_.actions.at("forces")->trigger();
  sleepUntil(monotonicNs() + 50'000'000);  // The window draws what the key has changed.
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.forces_on; }));
  press(2);
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.force.z > 0.9; }))
      << host_.announcements.join('\n').toStdString();
  EXPECT_TRUE(host_.actions.at("forces")->isChecked());
}

TEST_F(HapticsPluginTest, AHandThatIsOverTheNextWindowAlreadyDoesNotPressOnTheLast) {
  host_.window = flatWindow(40, 35);
  attach();
  hover();
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.window_id == 35 && !p.touching; }));
  // The view of the window hears of a lower one before the plugin does.
  const auto low = flatWindow(0, 36);
  host_.window = low;
  hover();
  host_.showWindow(low);
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.window_id == 36; }));
  for (const Probe& p : host_.probes) EXPECT_FALSE(p.touching) << p.window_id;
  EXPECT_TRUE(probeBecomes([](const Probe& p) { return p.hip.z > 0 && p.hip.z < 2; }));
}

TEST_F(HapticsPluginTest, InMoveModeTheGateIsFeltInPlaceOfTheSurface) {
  host_.window = flatWindow(5, 35);
  attach();
  auto* device = inPanel<QComboBox>("deviceList");
  // A busy computer makes the loop slow, which would bound the stiffness (E306).
  plugin_->restoreState(R"({"bound_by_rate": false})");
  device->setCurrentIndex(device->findData("virtual:relaxed"));
  hover();
  host_.actions.at("forces")->trigger();
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.forces_on && !p.touching; }));
  press(10);
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.force.z > 1; }));
  QAction* move = host_.actions.at("moveMode");
  move->trigger();
  EXPECT_TRUE(move->isChecked());
  EXPECT_TRUE(host_.announcements.last().startsWith("Move mode."));
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.force.z < 0.5; })) << "no surface";
  // Far to the right: over the click, one step, and the detent pulls back.
  Q_EMIT host_.handMoved({handOver(*host_.window, 75, 40, false, 0), true});
  ASSERT_TRUE(eventually([this] { return host_.commands.contains("move_right"); }));
  EXPECT_TRUE(probeBecomes([](const Probe& p) { return p.force.x < -0.1; }));
  EXPECT_TRUE(host_.actions.at("moveBack")->isEnabled());
  host_.actions.at("moveBack")->trigger();
  EXPECT_FALSE(move->isChecked());
  ASSERT_EQ(host_.regions.size(), 1U);
  EXPECT_EQ(host_.regions[0], host_.window->region);
  host_.actions.at("whereAmI")->trigger();
  const QString place = host_.announcements.last();
  EXPECT_TRUE(place.startsWith("In the air: ") || place.startsWith("Touching: "))
      << place.toStdString();
  host_.actions.at("whereAmILong")->trigger();
  EXPECT_TRUE(host_.announcements.last().contains(" from the left edge."))
      << host_.announcements.last().toStdString();
  host_.actions.at("sayDetail")->trigger();
  EXPECT_TRUE(host_.announcements.last().startsWith("Resolution 1 of"));
  host_.actions.at("buttonHelp")->trigger();
  EXPECT_TRUE(host_.announcements.last().startsWith("Plus: finer;"));
  host_.actions.at("useMouse")->trigger();
  EXPECT_EQ(device->currentData().toString(), "mouse");
}

TEST_F(HapticsPluginTest, GivesEveryControlANameForSpeech) {
  attach();
  QWidget* panel = host_.panels.at("Touch");
  for (QWidget* widget : panel->findChildren<QWidget*>()) {
    // Not the list that a combo box pops up, nor the line edit inside a spin box.
    if (widget->window() != panel || widget->objectName().startsWith("qt_")) continue;
    if (widget->focusPolicy() == Qt::NoFocus) continue;
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->objectName().toStdString();
  }
  EXPECT_EQ(host_.menus.at("forces"), "Touch");
  EXPECT_EQ(host_.menus.at("record"), "Record");
  for (const auto& [name, action] : host_.actions) {
    EXPECT_TRUE(action->text().contains('&')) << name.toStdString();
    EXPECT_FALSE(action->toolTip().isEmpty()) << name.toStdString();
    EXPECT_FALSE(action->whatsThis().isEmpty()) << name.toStdString();
  }
}

TEST_F(HapticsPluginTest, KeepsWhatLedToAFault) {
  host_.window = flatWindow(5, 42);
  attach();
  hover();
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.window_id == 42; }));
  Q_EMIT host_.handMoved({{std::numeric_limits<double>::quiet_NaN(), 0, 0}, true});
  QStringList kept;
  ASSERT_TRUE(eventually([&] {
    kept = host_.announcements.filter("The last 0 s before the fault are kept: ");
    return !kept.isEmpty();
  }));
  EXPECT_TRUE(kept.front().startsWith("Forces off: ")) << "what happened is still to be read";
  const QDir folder(home_.file("state/relievo/flight"));
  EXPECT_EQ(folder.entryList({"flight-*.csv"}).size(), 1);
}

TEST_F(HapticsPluginTest, RemembersSettingsButNeverThatForcesWereOn) {
  host_.window = flatWindow(5, 51);
  attach();
  inPanel<QComboBox>("proxyKind")->setCurrentIndex(1);
  host_.actions.at("weaker")->trigger();
  host_.actions.at("forces")->trigger();
  const QByteArray state = plugin_->saveState();
  EXPECT_FALSE(state.contains("forces"));
  host_.actions.at("stronger")->trigger();
  host_.actions.at("stronger")->trigger();
  plugin_->restoreState(state);
  EXPECT_EQ(plugin_->saveState(), state);
  plugin_->restoreState(R"({"strength_percent": 5000, "proxy": 77, "surface": -1, "friction": 9})");
  EXPECT_EQ(inPanel<QComboBox>("surfaceKind")->currentIndex(), 0);
  EXPECT_EQ(inPanel<QDoubleSpinBox>("friction")->value(), 1);
  EXPECT_EQ(inPanel<QComboBox>("proxyKind")->currentIndex(), 0);
  EXPECT_TRUE(plugin_->saveState().contains(R"("strength_percent":100)"));
}

TEST_F(HapticsPluginTest, DetachesAndAttachesAgain) {
  host_.window = flatWindow(5, 61);
  attach();
  plugin_->detach();
  plugin_->detach();
  TestHost second;
  second.window = flatWindow(5, 62);
  plugin_->attach(second);
  EXPECT_TRUE(eventually([&] { return !second.probes.empty(); }));
  plugin_->detach();
}

}  // namespace
}  // namespace relievo
