// SPDX-License-Identifier: BSD-3-Clause
// The assistant for a device of Haply with a mock of its service: every state that keeps one from
// being felt is told, with what to do, in text and for ears.
#include "plugins/haptics/device/haply_setup_dialog.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDeadlineTimer>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "haptics/device/haply/service_address.h"
#include "tests/emulator/haply/inverse_service.h"
#include "tests/plugins/plugin_fixture.h"

namespace relievo {
namespace {

using emulator::HaplyFault;
using emulator::HaplyWorld;
using emulator::InverseService;
using haply::LinkState;
using test::eventually;

class HaplySetup : public testing::Test {
 protected:
  void open(const std::string& chosen = {}) {
    haply::ServiceAddress told = *haply::addressOf(std::to_string(port_));
    if (mock_) told.events_port = mock_->eventsPort();
    dialog_ = std::make_unique<HaplySetupDialog>(
        [this](const std::string& one) {
          haply::ServiceAddress address = *haply::addressOf(std::to_string(port_));
          constexpr std::int64_t kMinuteNs = 60'000'000'000;
          address.patience_ns = kMinuteNs;
          return std::make_unique<haply::HaplyDevice>(haply::inverseService(address), one);
        },
        chosen, told);
    QObject::connect(dialog_.get(), &SetUpDialog::said,
                     [this](const QString& text) { said_ << text; });
    dialog_->show();
  }
  void plant(HaplyFault fault) {
    mock_->with([&](HaplyWorld& world) { world.fault = fault; });
  }
  template <class Widget>
  Widget* child(const char* name) {
    auto* widget = dialog_->findChild<Widget*>(QString::fromLatin1(name));
    EXPECT_NE(widget, nullptr) << name;
    return widget;
  }
  QString text(const char* name) { return child<QLabel>(name)->text(); }
  bool becomes(LinkState state) {
    return eventually([&] { return dialog_->status().state == state; });
  }
  /// Both on the screen and for ears.
  bool tells(const QString& code, const QString& what_to_do) {
    return eventually([&] {
      const QString shown = text("setupState");
      return shown.startsWith(code) && shown.contains(what_to_do);
    });
  }
  bool isDone(const char* step) { return text(step).contains("done"); }

  const test::PrivateHome home_;
  std::unique_ptr<InverseService> mock_ = std::make_unique<InverseService>();
  std::uint16_t port_ = mock_->port();
  std::unique_ptr<HaplySetupDialog> dialog_;
  QStringList said_;
};

TEST_F(HaplySetup, LeadsFromTheServiceToTouch) {
  mock_.reset();
  open();
  ASSERT_TRUE(tells("E311", "systemctl start haply-inverse-service"));
  EXPECT_EQ(said_.last(), "Haply's Inverse Service does not answer.");
  EXPECT_FALSE(isDone("stepService"));
  EXPECT_FALSE(child<QPushButton>("setupSave")->isEnabled());
  mock_ = std::make_unique<InverseService>(port_);
  ASSERT_TRUE(becomes(LinkState::ready)) << "it is found as soon as it is there";
  ASSERT_TRUE(eventually([this] { return child<QPushButton>("setupSave")->isEnabled(); }));
  for (const char* const step :
       {"stepService", "stepDevice", "stepPower", "stepStarted", "stepCalibrated", "stepSetUp"}) {
    EXPECT_TRUE(isDone(step)) << step;
  }
  EXPECT_EQ(child<QComboBox>("setupDevices")->currentText(), "049D");
  EXPECT_EQ(said_.last(), "Haply device ready.");
  QTest::keyClick(child<QPushButton>("setupSave"), Qt::Key_Space);
  EXPECT_EQ(dialog_->result(), QDialog::Accepted);
  EXPECT_EQ(dialog_->deviceId(), "haply:049D");
  EXPECT_EQ(mock_->with([](const HaplyWorld& world) { return world.largest_n; }), 0)
      << "nothing was pushed";
}

struct Told {
  HaplyFault fault;
  const char *code, *what_to_do, *step;
};
class HaplySetupTells : public HaplySetup, public testing::WithParamInterface<Told> {};

TEST_P(HaplySetupTells, WhatIsMissingAndWhatToDo) {
  plant(GetParam().fault);
  open();
  ASSERT_TRUE(tells(GetParam().code, GetParam().what_to_do)) << text("setupState").toStdString();
  EXPECT_FALSE(isDone(GetParam().step));
  EXPECT_FALSE(child<QPushButton>("setupSave")->isEnabled());
  EXPECT_FALSE(said_.isEmpty()) << "for ears, too";
  plant(HaplyFault::none);
  EXPECT_TRUE(becomes(LinkState::ready)) << "it goes on by itself";
}
INSTANTIATE_TEST_SUITE_P(
    OfStates, HaplySetupTells,
    testing::Values(
        Told{HaplyFault::device_absent, "E313", "Plug it in and switch it on", "stepDevice"},
        Told{HaplyFault::no_power, "E315", "Plug in its power supply", "stepPower"},
        Told{HaplyFault::not_started, "E315", "Look at it in the Haply Hub", "stepStarted"},
        Told{HaplyFault::uncalibrated, "E314", "Put its grip into the inkwell", "stepCalibrated"}),
    [](const auto& one) { return std::string(nameOf(one.param.fault)); });

TEST_F(HaplySetup, AnotherProgramThatSetsItUpIsNamedAndItIsTriedAgainByTheButton) {
  plant(HaplyFault::foreign_basis_always);
  open();
  ASSERT_TRUE(tells("E316", "Close the other program"));
  EXPECT_FALSE(isDone("stepSetUp"));
  ASSERT_TRUE(eventually([this] { return child<QPushButton>("setupRetry")->isEnabled(); }));
  plant(HaplyFault::none);
  QTest::keyClick(child<QPushButton>("setupRetry"), Qt::Key_Space);
  EXPECT_TRUE(becomes(LinkState::ready));
}

TEST_F(HaplySetup, AServiceOfAnotherVersionIsNamed) {
  mock_->with([](HaplyWorld& world) { world.version = "3.0.5"; });
  open();
  EXPECT_TRUE(tells("E312", "Bring it up to date by the Haply Hub"));
  EXPECT_FALSE(isDone("stepService"));
}

TEST_F(HaplySetup, OfSeveralOneIsChosen) {
  plant(HaplyFault::second_device);
  open();
  auto* const devices = child<QComboBox>("setupDevices");
  ASSERT_TRUE(eventually([&] { return devices->count() == 2; }));
  EXPECT_EQ(devices->currentIndex(), -1) << "nobody is taken unasked";
  EXPECT_FALSE(isDone("stepDevice"));
  devices->setCurrentIndex(devices->findText("049D"));
  Q_EMIT devices->activated(devices->currentIndex());
  ASSERT_TRUE(becomes(LinkState::ready));
  EXPECT_EQ(dialog_->deviceId(), "haply:049D");
}

TEST_F(HaplySetup, ShowsWhereTheHandIsAndWhatIsPressed) {
  mock_->with([](HaplyWorld& world) { world.hold({3, 4, 5}); });
  open();
  ASSERT_TRUE(eventually([this] { return text("setupHand").startsWith("3.0 right, 4.0 up"); }));
  EXPECT_EQ(text("setupButtons"), "none");
  mock_->with([](HaplyWorld& world) { world.button_a = world.button_b = true; });
  EXPECT_TRUE(eventually([this] { return text("setupButtons") == "Plus, Centre"; }));
}

TEST_F(HaplySetup, WhatTheServiceTellsByItselfIsShownAndSpoken) {
  open();
  ASSERT_TRUE(becomes(LinkState::ready));
  // Until somebody listens nothing is told. No flood: what is told next would wait behind it.
  constexpr int kTellEveryMs = 100;
  QDeadlineTimer next_event(0);
  ASSERT_TRUE(eventually([&] {
    if (next_event.hasExpired()) {
      mock_->with([](HaplyWorld& world) { world.tellEvent("device-battery-low"); });
      next_event.setRemainingTime(kTellEveryMs);
    }
    return text("setupEvent").contains("battery");
  }));
  EXPECT_EQ(text("setupEvent"), "The battery of the Haply grip is low. Charge it.");
  EXPECT_EQ(said_.filter("battery").size(), 1) << "it is told once, however often it comes";
  plant(HaplyFault::no_power);
  EXPECT_TRUE(eventually([this] {
    return text("setupEvent").startsWith("The emergency stop of the Haply device was pressed.");
  }));
}

TEST_F(HaplySetup, EveryPartHasANameForEarsAndTheOtherAssistantIsOneKeyAway) {
  open();
  int parts = 0;
  for (const QWidget* const part : dialog_->findChildren<QWidget*>()) {
    const QString name = part->objectName();
    if (!name.startsWith("setup") && !name.startsWith("step")) continue;
    EXPECT_FALSE(part->accessibleName().isEmpty()) << name.toStdString();
    ++parts;
  }
  EXPECT_EQ(parts, 15);
  bool asked = false;
  QObject::connect(dialog_.get(), &SetUpDialog::otherAsked, [&asked] { asked = true; });
  QTest::keyClick(child<QPushButton>("setupOther"), Qt::Key_Space);
  EXPECT_TRUE(asked);
}

}  // namespace
}  // namespace relievo
