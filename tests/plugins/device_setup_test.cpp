// SPDX-License-Identifier: BSD-3-Clause
// The assistant with the emulated Falcon on the computer's clock, by keyboard and text alone.
#include "plugins/haptics/device/device_setup_dialog.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QTest>

#include "haptics/device/falcon/firmware.h"
#include "haptics/device/falcon/settings_file.h"
#include "plugins/haptics/buttons/buttons_panel.h"
#include "plugins/haptics/buttons/device_buttons.h"
#include "plugins/haptics/device/homing_picture.h"
#include "tests/emulator/in_process.h"
#include "tests/emulator/made_image.h"
#include "tests/plugins/plugin_fixture.h"
#include "tests/plugins/shouting.h"

namespace relievo {
namespace {

using emulator::SharedFalcon;
using falcon::LinkState;
using test::eventually;

constexpr const char* kCalibrated = "The force is calibrated.";

class DeviceSetupTest : public ::testing::Test {
 protected:
  void open(emulator::EmulatorOptions options,
            falcon::Presence presence = falcon::Presence::present) {
    emulated_ = std::make_shared<SharedFalcon>(options);
    auto bus = std::make_unique<emulator::InProcessBus>(
        emulated_, std::make_shared<emulator::TestClock>(emulator::TestClock::Kind::real));
    bus->pretend = presence;
    dialog_ = std::make_unique<DeviceSetupDialog>(
        std::make_unique<falcon::FalconDevice>(std::move(bus), falcon::storedFirmwareSource()),
        falcon::FalconSettings{});
    QObject::connect(dialog_.get(), &DeviceSetupDialog::said,
                     [this](const QString& text) { said_ << text; });
    dialog_->show();
    QApplication::setActiveWindow(dialog_.get());
  }
  template <class Widget>
  Widget* child(const char* name) {
    auto* widget = dialog_->findChild<Widget*>(QString::fromLatin1(name));
    EXPECT_NE(widget, nullptr) << name;
    return widget;
  }
  bool becomes(LinkState state) {
    return eventually([&] { return dialog_->status().state == state; });
  }
  void hold(double z) {
    emulated_->with([z](auto& f) { f.body.carry({0, 0, z}); });
  }
  /// Once, by keys, with 100 g on a grip that pulls with 0.3 N by itself. The window's thread holds
  /// the grip meanwhile.
  void calibrate() {
    const emulator::Urgent urgent;
    emulated_->with([](auto& f) {
      f.body.carry({0, 0, 125});
      f.body.letGo(0.3);
    });
    auto* button = child<QPushButton>("setupCalibrate");
    said_.clear();
    const auto ended = [this] {
      return said_.contains(kCalibrated) || !said_.filter("The calibration ended").isEmpty();
    };
    ASSERT_TRUE(eventually([&] { return button->isEnabled(); }));
    QTest::keyClick(button, Qt::Key_Space);
    ASSERT_TRUE(eventually([&] { return waits() || ended(); }));
    if (!waits()) return;
    emulated_->with([](auto& f) { f.body.letGo(0.3 + 0.980665); });
    QTest::keyClick(button, Qt::Key_Space);
    ASSERT_TRUE(eventually(ended));
  }
  bool waits() {
    return child<QPushButton>("setupCalibrate")->text().remove('&').startsWith("Continue");
  }
  void picture(const QString& name) {
    QDir().mkpath(QStringLiteral(RELIEVO_BINARY_DIR "/screenshots"));
    dialog_->grab().save(QStringLiteral(RELIEVO_BINARY_DIR "/screenshots/%1.png").arg(name));
  }
  QString written(const std::vector<std::uint8_t>& bytes) {
    QFile file(home_.file("image.bin"));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
    return file.fileName();
  }

  test::PrivateHome home_;
  std::shared_ptr<SharedFalcon> emulated_;
  std::unique_ptr<DeviceSetupDialog> dialog_;
  QStringList said_;
};

TEST_F(DeviceSetupTest, LeadsFromPlugToTouch) {
  open({});
  ASSERT_TRUE(becomes(LinkState::no_firmware));
  ASSERT_TRUE(eventually([this] {
    return child<QLabel>("setupState")->text().contains("nvent_firmware.bin (8492 bytes)");
  }));
  EXPECT_EQ(child<QLabel>("setupFirmwareFile")->text(), "Firmware: no file found yet");
  EXPECT_FALSE(dialog_->installFirmware(written({1, 2, 3}), true));
  EXPECT_TRUE(said_.last().contains("3 bytes"));
  picture("setup_firmware");
  EXPECT_TRUE(dialog_->installFirmware(written(relievo::test::madeImage()), true));
  ASSERT_TRUE(becomes(LinkState::homing));
  ASSERT_TRUE(
      eventually([this] { return child<QLabel>("setupState")->text().startsWith("E308"); }));
  EXPECT_TRUE(child<QProgressBar>("setupUpload")->text().startsWith("attempt 1 of 10"));
  EXPECT_FALSE(child<QPushButton>("setupSave")->isEnabled()) << "nothing to use yet";
  EXPECT_EQ(child<QPushButton>("setupClose")->text(), "Cancel") << "homing can be left";
  const std::string stored = falcon::readSettings(falcon::settingsFile()).firmware;
  EXPECT_EQ(stored, home_.file("data/relievo/falcon/nvent_firmware.bin").toStdString());
  EXPECT_EQ(child<QLabel>("setupFirmwareFile")->text(),
            QString("Firmware: %1, accepted by you").arg(QString::fromStdString(stored)));
  picture("setup_homing");
  auto* shown = dialog_->findChild<HomingPicture*>("homingPicture");
  ASSERT_NE(shown, nullptr);
  EXPECT_TRUE(shown->accessibleDescription().startsWith("Push the grip all the way in."));
  const QImage push = shown->grab().toImage();
  hold(172);
  hold(90);
  ASSERT_TRUE(becomes(LinkState::pull_out));
  for (const char* arm : {"armTop", "armRight", "armLeft"}) {
    EXPECT_TRUE(eventually([&] { return child<QLabel>(arm)->text().contains("found"); })) << arm;
  }
  EXPECT_TRUE(eventually([&] { return shown->state() == LinkState::pull_out; }));
  EXPECT_TRUE(shown->accessibleDescription().startsWith("Pull the grip all the way out."));
  EXPECT_NE(shown->grab().toImage(), push) << "the other way, and another light";
  hold(172);
  ASSERT_TRUE(becomes(LinkState::ready));
  ASSERT_TRUE(eventually([this] { return child<QPushButton>("setupSave")->isEnabled(); }));
  EXPECT_TRUE(said_.contains("Falcon ready.")) << said_.join("|").toStdString();
  child<QCheckBox>("leftHanded")->setChecked(true);
  QTest::keyClick(child<QPushButton>("setupSave"), Qt::Key_Space);
  EXPECT_FALSE(dialog_->isVisible());
  EXPECT_TRUE(falcon::readSettings(falcon::settingsFile()).left_handed);
  EXPECT_EQ(falcon::readSettings(falcon::settingsFile()).firmware, stored) << "kept by Save";
  emulated_->with([](auto& f) { EXPECT_TRUE(f.commands().back().neutral()); });
}

TEST_F(DeviceSetupTest, CancellingHomingLeavesTheFalconAtRest) {
  open({.firmware_loaded = true});
  ASSERT_TRUE(becomes(LinkState::homing));
  auto* leave = child<QPushButton>("setupClose");
  ASSERT_TRUE(eventually([&] { return leave->text() == "Cancel"; }));
  QTest::keyClick(leave, Qt::Key_Space);
  EXPECT_FALSE(dialog_->isVisible());
  EXPECT_EQ(dialog_->result(), QDialog::Rejected);
  dialog_.reset();
  emulated_->with([](auto& f) {
    EXPECT_TRUE(f.commands().back().neutral());
    EXPECT_EQ(f.commands().back().lights, 0);
  });
}

TEST_F(DeviceSetupTest, AFirmwareFileThatIsSetAndMissingIsSaid) {
  falcon::FalconSettings settings;
  settings.firmware = "/nowhere/image.bin";
  falcon::writeSettings(settings, falcon::settingsFile());
  open({});
  ASSERT_TRUE(becomes(LinkState::no_firmware));
  EXPECT_TRUE(eventually([this] {
    return child<QLabel>("setupState")->text().contains("/nowhere/image.bin");
  })) << child<QLabel>("setupState")->text().toStdString();
}

TEST_F(DeviceSetupTest, ShowsTheRuleWhenAccessIsForbidden) {
  open({}, falcon::Presence::forbidden);
  ASSERT_TRUE(becomes(LinkState::forbidden));
  ASSERT_TRUE(eventually([this] { return child<QPlainTextEdit>("setupRule")->isVisible(); }));
  EXPECT_TRUE(
      child<QPlainTextEdit>("setupRule")->toPlainText().contains("ATTR{idProduct}==\"cb48\""));
  EXPECT_TRUE(child<QLabel>("setupState")->text().startsWith("E301"));
  EXPECT_TRUE(said_.contains("Falcon found, but not allowed. Ask staff."));
  picture("setup_forbidden");
}

TEST_F(DeviceSetupTest, TestsAndCalibratesByKeyboard) {
  open({.firmware_loaded = true, .homed = true});
  emulated_->with([](auto& f) { f.body.pullToward({0, 0, 125}); });
  ASSERT_TRUE(becomes(LinkState::ready));
  ASSERT_TRUE(eventually([this] { return child<QPushButton>("setupSelfTest")->isEnabled(); }));
  QTest::keyClick(child<QPushButton>("setupSelfTest"), Qt::Key_Space);
  ASSERT_TRUE(eventually([this] {
    return child<QPlainTextEdit>("setupResults")
        ->toPlainText()
        .contains("Move the grip to its end");
  })) << child<QPlainTextEdit>("setupResults")->toPlainText().toStdString();
  constexpr std::array<const char*, 4> kButtons{"plus", "forward", "centre", "minus"};
  for (int i = 0; i < 4; ++i) {
    emulated_->with([i](auto& f) {
      f.buttons = 1 << i;
      f.body.carry({0, 0, 100.0 + 20 * i});
    });
    const char* const button = kButtons[static_cast<std::size_t>(i)];
    ASSERT_TRUE(eventually([&] {  // As long as it takes until it is no longer asked for.
      return !child<QPlainTextEdit>("setupResults")->toPlainText().contains(button);
    })) << button;
  }
  for (const DeviceMm& end : {DeviceMm{38, 0, 0}, DeviceMm{-38, 0, 0}, DeviceMm{0, 38, 0},
                              DeviceMm{0, -38, 0}, DeviceMm{0, 0, 33}, DeviceMm{0, 0, -33}}) {
    emulated_->with([end](auto& f) { f.body.carry({end.x, end.y, 125.0 + end.z}); });
    // Until the driver has seen it; the test reads the same places.
    ASSERT_TRUE(eventually([&] {
      const DeviceMm& at = dialog_->status().position;
      return norm(at - end) < 3;
    })) << end.x
        << ' ' << end.y << ' ' << end.z;
  }
  ASSERT_TRUE(eventually([this] { return child<QPushButton>("setupSelfTest")->isEnabled(); }));
  EXPECT_TRUE(child<QPlainTextEdit>("setupResults")->toPlainText().contains("passed: Edges:"))
      << child<QPlainTextEdit>("setupResults")->toPlainText().toStdString();
  const QString results = child<QPlainTextEdit>("setupResults")->toPlainText();
  EXPECT_TRUE(results.contains("all four work")) << results.toStdString();
  EXPECT_TRUE(results.contains("passed: Encoder of the top arm")) << results.toStdString();
  picture("setup_tested");

  emulated_->with([](auto& f) { f.body.counts_per_n_mm = 6; });
  // On a busy computer it may end with a reason; a person would begin again.
  for (int attempt = 0; attempt < 20 && !said_.contains(kCalibrated); ++attempt) calibrate();
  ASSERT_TRUE(said_.contains(kCalibrated))
      << child<QPlainTextEdit>("setupResults")->toPlainText().toStdString();
  const double gain = child<QLabel>("setupGain")->text().section(' ', 0, 0).toDouble();
  EXPECT_NEAR(gain, 6, 0.3);
}

TEST_F(DeviceSetupTest, ACalibrationEndsBeforeTheComputerSleeps) {
  open({.firmware_loaded = true, .homed = true});
  ASSERT_TRUE(becomes(LinkState::ready));
  hold(125);
  emulated_->with([](auto& f) { f.body.letGo(0.3); });
  auto* button = child<QPushButton>("setupCalibrate");
  ASSERT_TRUE(eventually([&] { return button->isEnabled(); }));
  QTest::keyClick(button, Qt::Key_Space);
  ASSERT_TRUE(eventually(
      [this] { return emulated_->with([](auto& f) { return !f.commands().back().neutral(); }); }));
  dialog_->endBeforeSleep();
  EXPECT_TRUE(said_.last().contains("goes to sleep")) << said_.last().toStdString();
  ASSERT_TRUE(eventually(
      [this] { return emulated_->with([](auto& f) { return f.commands().back().neutral(); }); }));
  EXPECT_TRUE(child<QPlainTextEdit>("setupResults")->toPlainText().contains("goes to sleep"));
  const auto sent = emulated_->with([](auto& f) { return f.commands().size(); });
  ASSERT_TRUE(eventually(
      [&] { return emulated_->with([&](auto& f) { return f.commands().size() > sent + 50; }); }));
  EXPECT_TRUE(emulated_->with([&](auto& f) {
    return std::all_of(f.commands().begin() + static_cast<std::ptrdiff_t>(sent), f.commands().end(),
                       [](const auto& c) { return c.neutral(); });
  }));
}

TEST_F(DeviceSetupTest, ItIsWholeWhereThereIsRoom) {
  const QFont usual = QApplication::font();
  QFont small = usual;
  small.setPointSizeF(0.4 * usual.pointSizeF());  // The screen of the tests is small.
  QApplication::setFont(small);
  open({});
  QCoreApplication::processEvents();
  const int room = 9 * QGuiApplication::primaryScreen()->availableSize().height() / 10;
  const int hidden = child<QScrollArea>("setupParts")->verticalScrollBar()->maximum();
  EXPECT_TRUE(hidden == 0 || dialog_->height() >= room) << hidden << ", " << dialog_->height();
  QApplication::setFont(usual);
}

TEST_F(DeviceSetupTest, OnASmallScreenWhatIsAskedForIsInSight) {
  open({.firmware_loaded = true, .homed = true});
  dialog_->resize(640, 420);
  hold(125);
  ASSERT_TRUE(becomes(LinkState::ready));
  ASSERT_TRUE(eventually([this] { return child<QPushButton>("setupSelfTest")->isEnabled(); }));
  QTest::keyClick(child<QPushButton>("setupSelfTest"), Qt::Key_Space);
  auto* results = child<QPlainTextEdit>("setupResults");
  // Its end, but for the frame.
  constexpr int kFramePx = 3;
  const auto is_in_sight = [&] {
    return results->visibleRegion().boundingRect().bottom() >= results->rect().bottom() - kFramePx;
  };
  for (const char* prompt : {"Measuring how evenly", "Watch the lights", "Hold the grip"}) {
    ASSERT_TRUE(eventually([&] { return results->toPlainText().contains(prompt); })) << prompt;
    EXPECT_TRUE(eventually(is_in_sight)) << prompt;
  }
  child<QLabel>("setupGain")->setText("A line above that becomes longer,\nby a line\nand another.");
  EXPECT_TRUE(eventually(is_in_sight));
}

TEST_F(DeviceSetupTest, WhatSelfTestAndFirmwareSayIsInTheWindowsLanguage) {
  const test::Shouting shouting;
  open({.firmware_loaded = true, .homed = true});
  hold(125);
  auto* results = child<QPlainTextEdit>("setupResults");
  const auto shows = [&](const char* text) {
    return eventually([=] { return results->toPlainText().contains(text); });
  };
  ASSERT_TRUE(
      eventually([this] { return child<QLabel>("setupState")->text() == "FALCON READY."; }));
  ASSERT_TRUE(eventually([this] { return child<QPushButton>("setupSelfTest")->isEnabled(); }));
  EXPECT_FALSE(dialog_->installFirmware(written({1, 2, 3}), true));
  EXPECT_TRUE(shows("IS NO FALCON FIRMWARE: IT HAS 3 BYTES;")) << said_.last().toStdString();
  EXPECT_TRUE(said_.last().contains("IT HAS 3 BYTES;")) << said_.last().toStdString();
  QTest::keyClick(child<QPushButton>("setupSelfTest"), Qt::Key_Space);
  EXPECT_TRUE(
      shows("MOVE THE GRIP TO ITS END ON EVERY SIDE AND PRESS EACH OF THE FOUR BUTTONS. STILL "
            "MISSING: PLUS, FORWARD, CENTRE, MINUS, "))
      << results->toPlainText().toStdString();
  EXPECT_TRUE(said_.contains("MEASURING HOW EVENLY THE FALCON ANSWERS."));
  emulated_->with([](auto& f) { f.unplug(); });
  EXPECT_TRUE(shows("failed: THE TEST ENDED EARLY: THE DEVICE WAS UNPLUGGED. FALCON UNPLUGGED."))
      << results->toPlainText().toStdString();
  EXPECT_FALSE(results->toPlainText().contains(" answer")) << "every line of it";
  EXPECT_TRUE(child<QLabel>("setupState")->text().startsWith("E305: FALCON UNPLUGGED."));
}

TEST_F(DeviceSetupTest, WhatCalibrationAndSettingsSayIsInTheWindowsLanguage) {
  const test::Shouting shouting;
  open({.firmware_loaded = true, .homed = true});
  hold(125);
  ASSERT_TRUE(becomes(LinkState::ready));
  auto* calibrate = child<QPushButton>("setupCalibrate");
  ASSERT_TRUE(eventually([&] { return calibrate->isEnabled(); }));
  QTest::keyClick(calibrate, Qt::Key_Space);
  auto* results = child<QPlainTextEdit>("setupResults");
  const QString first = "TAKE YOUR HAND OFF THE GRIP. THE FALCON HOLDS IT IN PLACE.";
  EXPECT_TRUE(eventually([&] { return results->toPlainText() == first; }))
      << results->toPlainText().toStdString();
  EXPECT_TRUE(said_.contains(first));

  open({.firmware_loaded = true, .homed = true});
  ASSERT_TRUE(becomes(LinkState::ready));
  auto* save = child<QPushButton>("setupSave");
  ASSERT_TRUE(eventually([&] { return save->isEnabled(); }));
  const QString settings = QString::fromStdString(falcon::settingsFile().string());
  ASSERT_TRUE(QDir().mkpath(settings));  // A folder where the file should go.
  QTest::keyClick(save, Qt::Key_Space);
  EXPECT_TRUE(said_.last().startsWith("THE FALCON'S SETTINGS COULD NOT BE WRITTEN TO \"" +
                                      settings + "\"."))
      << said_.last().toStdString();
}

TEST_F(DeviceSetupTest, WithTextTwiceAsLargeEverythingIsReachedByKeyOnASmallScreen) {
  const QFont usual = QApplication::font();
  QFont large = usual;
  large.setPointSizeF(2 * usual.pointSizeF());
  QApplication::setFont(large);
  open({.firmware_loaded = true, .homed = true});
  ASSERT_TRUE(becomes(LinkState::ready));
  ASSERT_TRUE(eventually([this] { return child<QPushButton>("setupSave")->isEnabled(); }));
  constexpr QSize kSmall(800, 600);
  dialog_->resize(kSmall);
  EXPECT_EQ(dialog_->size(), kSmall) << "it needs more";
  QCoreApplication::processEvents();
  EXPECT_EQ(child<QScrollArea>("setupParts")->horizontalScrollBar()->maximum(), 0);
  picture("setup_large_text");
  QSet<QString> reached;
  QWidget* const first = dialog_->focusWidget();
  do {
    QTest::keyClick(dialog_->focusWidget(), Qt::Key_Tab);
    QWidget* const at = dialog_->focusWidget();
    reached << at->objectName();
    EXPECT_FALSE(at->visibleRegion().isEmpty()) << at->objectName().toStdString();
  } while (dialog_->focusWidget() != first && reached.size() < 50);
  for (const char* name : {"setupFirmware", "setupSelfTest", "setupWeight", "setupCalibrate",
                           "setupResults", "leftHanded", "setupOther", "setupSave", "setupClose"}) {
    EXPECT_TRUE(reached.contains(name)) << name;
  }
  picture("setup_large_text_end");
  QApplication::setFont(usual);
}

TEST_F(DeviceSetupTest, EveryControlHasANameAndALetterOfItsOwn) {
  open({});
  QStringList letters;
  for (QWidget* widget : dialog_->findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus || widget->objectName().startsWith("qt_")) continue;
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->objectName().toStdString();
  }
  for (QAbstractButton* button : dialog_->findChildren<QAbstractButton*>()) {
    const int at = button->text().indexOf('&');
    if (at >= 0) letters << button->text().mid(at + 1, 1).toLower();
  }
  letters << "w";  // The weight's label.
  EXPECT_EQ(letters.removeDuplicates(), 0) << letters.join(' ').toStdString();
  EXPECT_GE(letters.size(), 7);
}

HapticSample sampleAt(double x, double y) {
  HapticSample sample;
  sample.hip = {x, y, 0};
  sample.hip_view = sample.proxy_view = {12, 34, 5.5};
  sample.contact = true;
  sample.origin = CellStatus::measured;
  return sample;
}

class DeviceButtonsTest : public ::testing::Test {
 protected:
  DeviceButtonsTest() {
    host_.window = std::make_shared<RegionWindow>(test::windowOf(
        80, [](double, double) { return 5.0; }, 3));
  }
  void press(std::uint8_t button, double held_s) {
    buttons_.press(button, true, now_s_);
    pass(held_s);
    buttons_.press(button, false, now_s_);
    pass(0.1);
  }
  void pass(double seconds) {
    for (const double end = now_s_ + seconds; now_s_ < end; now_s_ += 0.02) {
      buttons_.frame(sampleAt(x_, y_), now_s_);
    }
  }
  QString last() const {
    return host_.announcements.isEmpty() ? QString() : host_.announcements.last();
  }

  static constexpr std::uint8_t kPlus = 0, kForward = 1, kCentre = 2, kMinus = 3;
  test::TestHost host_;
  DeviceButtons buttons_{host_, nullptr, std::make_shared<pad::Rumbler>()};
  double now_s_ = 1, x_ = 0, y_ = 0;
};

TEST_F(DeviceButtonsTest, RunTheWindowsCommandsAndSayWhatTheyFind) {
  host_.object.name = "Ear";
  press(kPlus, 0.2);
  press(kMinus, 0.2);
  press(kMinus, 1.0);
  press(kCentre, 1.6);
  press(kForward, 1.0);
  EXPECT_EQ(host_.commands, (QStringList{"finer", "coarser", "whole", "forces", "beacon"}));
  press(kCentre, 0.2);
  EXPECT_EQ(last(), "Touching: middle left, 5.5 millimetres high. Bookmark: Ear.");
  press(kCentre, 0.2);
  EXPECT_EQ(
      last(),
      "Touching: middle left, 5.5 millimetres high. Bookmark: Ear. 1.2 centimetres from the "
      "left edge. nearly 3.5 centimetres from the bottom edge. Measured here. Resolution 1 of "
      "1, 8 centimetres wide. One centimetre of hand: 1 centimetre of relief. Samples are "
      "0.5 millimetres apart.");
  EXPECT_EQ(host_.hushed, 7) << "each press cuts what is being said";
  press(kPlus, 1.0);
  EXPECT_TRUE(last().startsWith("Resolution 1 of 1, 8 centimetres wide."));
}

TEST_F(DeviceButtonsTest, PlusAndMinusTogetherAreTheWindowsSwitchOfLookAndTouch) {
  buttons_.press(kPlus, true, now_s_);
  buttons_.press(kMinus, true, now_s_);
  pass(0.2);
  buttons_.press(kPlus, false, now_s_);
  buttons_.press(kMinus, false, now_s_);
  pass(0.2);
  EXPECT_EQ(host_.commands, QStringList{"pointer_switch"});
}

TEST_F(DeviceButtonsTest, MoveModePutsAGateUnderTheHandAndStepsTheWindow) {
  x_ = 4;
  press(kForward, 0.2);
  EXPECT_TRUE(last().startsWith("Move mode."));
  EXPECT_TRUE(buttons_.detent().on);
  EXPECT_EQ(buttons_.detent().centre.x, 4) << "where the hand was";
  EXPECT_EQ(buttons_.detent().blocked, 0);
  x_ = 25;
  host_.at_edges = 2;
  pass(0.1);
  EXPECT_EQ(host_.commands, QStringList{"move_right"});
  EXPECT_EQ(buttons_.detent().blocked, 2) << "the next push to the right meets a wall";
  x_ = 4;
  pass(0.1);
  y_ = -25;
  pass(0.1);
  press(kPlus, 0.2);
  press(kMinus, 0.2);
  EXPECT_EQ(host_.commands,
            (QStringList{"move_right", "move_down", "next_place", "previous_place"}));
  press(kForward, 0.2);
  EXPECT_TRUE(last().startsWith("Moved. Resolution 1 of 1"));
  EXPECT_FALSE(buttons_.detent().on);
  EXPECT_TRUE(host_.regions.empty());
}

TEST_F(DeviceButtonsTest, CentreLeavesMoveModeToTheOldWindow) {
  const Region before = host_.window->region;
  buttons_.toggleMoving();  // By key or menu: the same.
  EXPECT_TRUE(buttons_.moving());
  auto moved = std::make_shared<RegionWindow>(*host_.window);
  moved->region.x_mm += 20;
  host_.window = moved;
  press(kCentre, 0.2);
  ASSERT_EQ(host_.regions.size(), 1U);
  EXPECT_EQ(host_.regions[0], before);
  EXPECT_TRUE(last().startsWith("Back at the old window."));
  EXPECT_FALSE(buttons_.moving());
  buttons_.cancelMoving();
  EXPECT_EQ(host_.regions.size(), 1U) << "there is nothing to cancel";
}

TEST_F(DeviceButtonsTest, WithoutAWindowThereIsNothingToMove) {
  host_.window = nullptr;
  press(kForward, 0.2);
  EXPECT_EQ(last(), "Nothing is open.");
  EXPECT_FALSE(buttons_.moving());
  pass(0.1);
  EXPECT_TRUE(host_.regions.empty());
}

TEST_F(DeviceButtonsTest, OneButtonScansThroughTheCommands) {
  buttons_.setSettings({.one_button = true, .scan_s = 1});
  press(kMinus, 0.1);
  EXPECT_EQ(last(), "Where am I?");
  pass(1);
  EXPECT_EQ(last(), "Finer resolution?");
  press(kMinus, 0.1);
  EXPECT_EQ(host_.commands, QStringList{"finer"});
  press(kMinus, 0.1);
  pass(3);
  EXPECT_EQ(last(), "Whole object?");
  pass(1);
  EXPECT_EQ(last(), "Move mode?");
  press(kMinus, 0.1);
  EXPECT_TRUE(buttons_.moving());
  press(kMinus, 0.1);
  EXPECT_EQ(last(), "Moved?") << "in Move mode other things are offered";
  press(kMinus, 0.1);
  EXPECT_FALSE(buttons_.moving());
  buttons_.setSettings({});
  press(kMinus, 0.1);
  EXPECT_EQ(host_.commands.last(), "coarser") << "a button is a button again";
}

TEST_F(DeviceButtonsTest, OneButtonHeldStopsForcesAndSaysSoIfThereAreNone) {
  int ticks = 0;
  QObject::connect(&buttons_, &DeviceButtons::ticked, [&ticks] { ++ticks; });
  buttons_.setSettings({.one_button = true, .scan_s = 1});
  press(kPlus, 1.6);
  EXPECT_EQ(host_.commands, QStringList{"forcesOff"});
  EXPECT_EQ(ticks, 1) << "before it is done";
  EXPECT_EQ(last(), "") << "the window says what it did";
  host_.possible = false;
  press(kPlus, 1.6);
  EXPECT_EQ(last(), "Forces are off.");
}

TEST_F(DeviceButtonsTest, ThePanelsSettingsAreKept) {
  ButtonsPanel panel;
  int changes = 0;
  QObject::connect(&panel, &ButtonsPanel::settingsChanged, [&changes] { ++changes; });
  auto* scan = panel.findChild<QDoubleSpinBox*>("scanTime");
  EXPECT_FALSE(scan->isEnabled());
  panel.findChild<QCheckBox*>("oneButton")->setChecked(true);
  EXPECT_TRUE(scan->isEnabled());
  scan->setValue(3);
  panel.findChild<QComboBox*>("spaceMouse")->setCurrentIndex(1);
  EXPECT_EQ(changes, 3);
  const ButtonSettings chosen = panel.settings();
  EXPECT_EQ(chosen, (ButtonSettings{
                        .one_button = true, .scan_s = 3, .space_mouse = SpaceMouseMoves::view}));
  const QByteArray json = withButtons(R"({"device": "mouse"})", chosen);
  EXPECT_TRUE(json.contains("\"device\":\"mouse\"")) << "beside the others";
  EXPECT_EQ(buttonSettingsFromJson(json), chosen);
  EXPECT_EQ(buttonSettingsFromJson(R"({"scan_s": 99})").scan_s, 5);
  EXPECT_EQ(buttonSettingsFromJson("no json"), ButtonSettings{});
}

}  // namespace
}  // namespace relievo
