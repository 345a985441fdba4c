// SPDX-License-Identifier: BSD-3-Clause
// The plugin and a Falcon that comes and goes on a mocked port, through the real libusb.
#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QSet>

#include <QTranslator>
#include <QXmlStreamReader>

#include "tests/emulator/mock_hid.h"
#include "tests/emulator/mock_usb.h"
#include "tests/plugins/plugin_fixture.h"
#include "tests/realtime/fake_logind.h"
#include "tests/realtime/message_bus.h"

namespace relievo {
namespace {

using emulator::FalconEmulator;
using emulator::SharedFalcon;
using test::eventually;

class FalconPluginTest : public test::PluginTest {
 protected:
  void SetUp() override {
    if (!emulator::MockUsb::works()) GTEST_SKIP() << "umockdev's library is not preloaded";
    logind_ = std::make_unique<test::FakeLogind>(bus_->address());
    test::PluginTest::SetUp();
    host_.window = std::make_shared<RegionWindow>(test::windowOf(
        80, [](double, double) { return 5.0; }, 7));
    attach();
  }
  /// One that another program has started and homed.
  void plugIn() {
    falcon_ = std::make_shared<SharedFalcon>(
        emulator::EmulatorOptions{.firmware_loaded = true, .homed = true});
    usb_.plugIn(falcon_);
  }
  bool listed(const QString& name) {
    return eventually([&] { return inPanel<QComboBox>("deviceList")->findText(name) >= 0; });
  }
  QString all() const { return host_.announcements.join('\n'); }

  static void SetUpTestSuite() {
    dbus_threads_init_default();
    bus_ = std::make_unique<test::MessageBus>();
  }
  static void TearDownTestSuite() { bus_.reset(); }

  static std::unique_ptr<test::MessageBus> bus_;
  emulator::MockUsb usb_;
  std::shared_ptr<SharedFalcon> falcon_;
  std::unique_ptr<test::FakeLogind> logind_;
};
std::unique_ptr<test::MessageBus> FalconPluginTest::bus_;

TEST_F(FalconPluginTest, TheListFollowsThePlug) {
  auto* list = inPanel<QComboBox>("deviceList");
  EXPECT_EQ(list->findData("falcon:NV000001"), -1);
  plugIn();
  ASSERT_TRUE(listed("Falcon NV000001"));
  EXPECT_EQ(list->currentData().toString(), "mouse") << "chosen is what was chosen";
  EXPECT_TRUE(said("A Falcon was plugged in. Choose it in the panel Touch to use it."));
  usb_.unplug();
  EXPECT_TRUE(eventually([&] { return list->findData("falcon:NV000001") < 0; }));
}

TEST_F(FalconPluginTest, ARememberedFalconIsUsedAsSoonAsItIsThere) {
  plugin_->restoreState(R"({"device": "falcon:0"})");
  EXPECT_TRUE(host_.announcements.last().endsWith("The mouse is the hand now."))
      << all().toStdString();
  EXPECT_EQ(inPanel<QComboBox>("deviceList")->currentData().toString(), "mouse");
  EXPECT_TRUE(plugin_->saveState().contains("falcon:0")) << "the wish is kept";
  plugIn();
  ASSERT_TRUE(said("Device: Falcon NV000001 (USB 1-1).")) << all().toStdString();
  ASSERT_TRUE(said("Falcon ready.")) << all().toStdString();
  EXPECT_TRUE(eventually([this] { return host_.status.device == "Falcon ready."; }));
  EXPECT_TRUE(plugin_->saveState().contains("falcon:NV000001")) << "from now on this one is meant";
}

TEST_F(FalconPluginTest, OfTwoTheChosenOneIsUsedAndRemembered) {
  plugIn();
  usb_.plugInAnother("NV000002");
  ASSERT_TRUE(listed("Falcon NV000001"));
  ASSERT_TRUE(listed("Falcon NV000002"));
  plugin_->restoreState(R"({"device": "falcon:0"})");
  ASSERT_TRUE(said("Several Falcons are plugged in. Choose one. The mouse is the hand now."));
  auto* list = inPanel<QComboBox>("deviceList");
  list->setCurrentIndex(list->findData("falcon:NV000001"));
  ASSERT_TRUE(said("Falcon ready.")) << all().toStdString();
  EXPECT_TRUE(plugin_->saveState().contains("falcon:NV000001"));
  usb_.unplug();
  ASSERT_TRUE(said("Falcon unplugged. Forces are off.")) << all().toStdString();
  EXPECT_TRUE(eventually([&] {
    return inPanel<QLabel>("forceState")->text().contains("NV000002 (USB 1-2), which is not used");
  }));
  EXPECT_TRUE(plugin_->saveState().contains("falcon:NV000001")) << "still the one that is meant";
}

TEST_F(FalconPluginTest, ARememberedOneThatIsNotThereIsNotReplacedByAnother) {
  plugin_->restoreState(R"({"device": "falcon:NV000009"})");
  plugIn();
  ASSERT_TRUE(eventually([&] {
    return inPanel<QLabel>("forceState")
        ->text()
        .startsWith("Falcon NV000009 was chosen and is not plugged in. There is NV000001");
  })) << inPanel<QLabel>("forceState")->text().toStdString();
  EXPECT_EQ(inPanel<QComboBox>("deviceList")->currentData().toString(), "mouse");
  EXPECT_TRUE(plugin_->saveState().contains("falcon:NV000009"));
}

TEST_F(FalconPluginTest, OneThatAnotherProgramUsesIsNamedUntilItIsFree) {
  usb_.set({.claimed_by_other = true});
  plugIn();
  plugin_->restoreState(R"({"device": "falcon:0"})");
  ASSERT_TRUE(said("The Falcon is busy. The mouse is the hand now.")) << all().toStdString();
  auto* state = inPanel<QLabel>("forceState");
  const QString e304 = "E304: Another program is using the Falcon. ";
  ASSERT_TRUE(eventually([&] { return state->text().startsWith(e304); }));
  EXPECT_TRUE(state->text().contains("Off. Press F5")) << "and how the mouse is doing";
  host_.announce("panel.ply is open", SaidBecause::asked);
  EXPECT_FALSE(host_.announcements.contains("Device: Falcon NV000001 (USB 1-1)."))
      << "the other one has it";
  EXPECT_TRUE(state->text().startsWith(e304)) << "whatever else is said";
  EXPECT_EQ(host_.announcements.count("The Falcon is busy. The mouse is the hand now."), 1);
  usb_.set({});
  ASSERT_TRUE(said("Device: Falcon NV000001 (USB 1-1).")) << all().toStdString();
  ASSERT_TRUE(eventually([&] { return state->text().startsWith("Off. Press F5"); }))
      << state->text().toStdString();
}

TEST_F(FalconPluginTest, AnUnpluggedFalconIsNamedAndComesBackByItself) {
  plugIn();
  ASSERT_TRUE(listed("Falcon NV000001"));
  auto* list = inPanel<QComboBox>("deviceList");
  list->setCurrentIndex(list->findData("falcon:NV000001"));
  ASSERT_TRUE(said("Falcon ready.")) << all().toStdString();
  usb_.unplug();
  const QString e305 =
      "E305: Falcon unplugged. Forces off. View and recording go on. Plug it in again, or choose "
      "the mouse as the device.";
  ASSERT_TRUE(said("Falcon unplugged. Forces are off.")) << all().toStdString();
  EXPECT_TRUE(eventually([&] { return inPanel<QLabel>("forceState")->text() == e305; }));
  EXPECT_TRUE(listed("Falcon NV000001 (not here now)"));
  host_.announcements.clear();
  plugIn();
  ASSERT_TRUE(said("Falcon ready.")) << all().toStdString();
  EXPECT_TRUE(listed("Falcon NV000001"));
  EXPECT_EQ(list->findText("Falcon NV000001 (not here now)"), -1);
}

TEST_F(FalconPluginTest, SleepWaitsUntilTheMotorsAreAtZero) {
  plugIn();
  falcon_->with([](FalconEmulator& f) { f.body.pullToward({0, 0, 165}); });
  ASSERT_TRUE(listed("Falcon NV000001"));
  auto* list = inPanel<QComboBox>("deviceList");
  list->setCurrentIndex(list->findData("falcon:NV000001"));
  ASSERT_TRUE(said("Falcon ready.")) << all().toStdString();
  // A mocked port answers so slowly that the stiffness is bound by its rate (E306).
  const auto pushed = [this] {
    return falcon_->with([](FalconEmulator& f) { return f.body.force()[2] > 0.05; });
  };
  // A stall of the mocked port takes the force; then a person begins again.
  QAction* forces = host_.actions.at("forces");
  for (int attempt = 0; attempt < 20 && !pushed(); ++attempt) {
    falcon_->with([](FalconEmulator& f) { f.body.pullToward({0, 0, 165}); });
    ASSERT_TRUE(eventually([this] { return host_.status.device == "Falcon ready."; }));
    if (!forces->isChecked()) forces->trigger();
    ASSERT_TRUE(eventually([&] {
      return !forces->isChecked() || (!host_.probes.empty() && host_.probes.back().forces_on);
    }));
    falcon_->with([](FalconEmulator& f) { f.body.pullToward({0, 0, 100}); });
    ASSERT_TRUE(eventually([&] { return !forces->isChecked() || pushed(); }));
  }
  ASSERT_TRUE(pushed());
  ASSERT_TRUE(logind_->isDelayed());
  logind_->tell(true);
  ASSERT_TRUE(eventually([this] { return !logind_->isDelayed(); }));
  EXPECT_TRUE(falcon_->with([](FalconEmulator& f) { return f.commands().back().neutral(); }))
      << "before the computer sleeps";
  EXPECT_FALSE(host_.actions.at("forces")->isChecked());
  logind_->tell(false);
  EXPECT_TRUE(said("Forces are off after the sleep. Press F5 to switch them on."));
  EXPECT_TRUE(eventually([this] { return logind_->isDelayed(); })) << "the next sleep waits, too";
}

/// Keeps what the plugin asks to be translated.
class Asked : public QTranslator {
 public:
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char* /*disambiguation*/,
                    int /*n*/) const override {
    asked << QString::fromUtf8(context) + '|' + QString::fromUtf8(source);
    return {};
  }
  mutable QSet<QString> asked;
};

QSet<QString> known(const QString& language) {
  QFile file(QStringLiteral(RELIEVO_SOURCE_DIR "/ui/translations/relievo_%1.ts").arg(language));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  QSet<QString> texts;
  QString context;
  for (QXmlStreamReader xml(&file); !xml.atEnd();) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() == QLatin1String("source")) texts << context + '|' + xml.readElementText();
  }
  return texts;
}

TEST_F(FalconPluginTest, EveryTextIsLookedUpWhereTheTranslationsHaveIt) {
  plugin_->detach();
  for (const auto& [title, panel] : host_.panels) delete panel;
  host_.panels.clear();
  Asked translator;
  QCoreApplication::installTranslator(&translator);
  attach();
  plugIn();
  ASSERT_TRUE(listed("Falcon NV000001"));
  plugin_->restoreState(R"({"device": "falcon:0"})");
  ASSERT_TRUE(said("Falcon ready.")) << all().toStdString();
  EXPECT_TRUE(
      eventually([this] { return inPanel<QLabel>("loopHealth")->text().contains("per second"); }));
  QCoreApplication::removeTranslator(&translator);
  const QSet<QString> german = known("de");
  int ours = 0;
  for (const QString& text : translator.asked) {
    if (!text.startsWith("relievo")) continue;  // Qt's own.
    ++ours;
    EXPECT_TRUE(german.contains(text)) << text.toStdString();
  }
  EXPECT_GT(ours, 100);
}

/// While it lives, this thread has no administrator's power over files.
class OrdinaryAccount {
 public:
  OrdinaryAccount() {
    syscall(SYS_capget, &header_, before_.data());
    auto none = before_;
    for (auto& part : none) part.effective = 0;
    EXPECT_EQ(syscall(SYS_capset, &header_, none.data()), 0);
  }
  ~OrdinaryAccount() { EXPECT_EQ(syscall(SYS_capset, &header_, before_.data()), 0); }
  OrdinaryAccount(const OrdinaryAccount&) = delete;
  OrdinaryAccount& operator=(const OrdinaryAccount&) = delete;

 private:
  __user_cap_header_struct header_{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> before_{};
};

/// The plugin and a SpaceMouse, through the real hidapi.
class SpaceMousePluginTest : public test::PluginTest {
 protected:
  void SetUp() override {
    if (!emulator::MockUsb::works()) GTEST_SKIP() << "umockdev's library is not preloaded";
    test::PluginTest::SetUp();
    host_.window = std::make_shared<RegionWindow>(test::windowOf(
        80, [](double, double) { return 5.0; }, 7));
    attach();
    const std::vector<std::uint8_t> multi_axis{0x05, 0x01, 0x09, 0x08, 0xa1, 0x01, 0x85,
                                               0x01, 0x75, 0x10, 0x95, 0x03, 0x09, 0x30,
                                               0x09, 0x31, 0x09, 0x32, 0x81, 0x06, 0xc0};
    hid_.plugIn(0, 0x256f, 0xc635, "SpaceMouse Compact", multi_axis);
    ASSERT_TRUE(said("SpaceMouse Compact connected."));
    ASSERT_TRUE(eventually([this] { return !host_.probes.empty(); }));
  }
  /// Full deflection: to the right, and up (the cap's z points down).
  void pushRight() { hid_.hold(0, {1, 0x5e, 0x01, 0, 0, 0, 0}); }
  void letGo() { hid_.send(0, {1, 0, 0, 0, 0, 0, 0}); }

  emulator::MockHid hid_;
};

TEST_F(SpaceMousePluginTest, MovesTheHandAsLongAsItIsPushed) {
  const double from = host_.probes.back().hip.x;
  pushRight();
  EXPECT_TRUE(eventually([&] { return host_.probes.back().hip.x > from + 10; }));
  letGo();
  EXPECT_EQ(host_.turned_az_deg, 0);
  hid_.send(0, {3, 2, 0});
  hid_.send(0, {3, 0, 0});
  EXPECT_TRUE(eventually([this] { return host_.commands.contains("finer"); })) << "its button";
}

TEST_F(SpaceMousePluginTest, OrTheViewIfThatIsChosen) {
  auto* choice = inPanel<QComboBox>("spaceMouse", "Buttons");
  ASSERT_NE(choice, nullptr);
  choice->setCurrentIndex(1);
  const double from = host_.probes.back().hip.x;
  hid_.hold(0, {2, 0x5e, 0x01, 0, 0, 0xa2, 0xfe});  // Top toward the user, near side to the right.
  EXPECT_TRUE(eventually([this] { return host_.turned_az_deg < -20; }))
      << "the near side follows the cap, as with the command turn_right";
  EXPECT_DOUBLE_EQ(host_.turned_el_deg, -host_.turned_az_deg);
  EXPECT_EQ(host_.tilted_deg, 0);
  hid_.hold(0,
            {2, 0, 0, 0xa2, 0xfe, 0, 0});  // To one side, as HID counts: about the line of sight.
  EXPECT_TRUE(eventually([this] { return host_.tilted_deg < -20; }));
  hid_.send(0, {2, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(host_.pushed.right, 0) << "turns alone move nothing";
  hid_.hold(0, {1, 0x5e, 0x01, 0xaf, 0, 0xa2, 0xfe});  // Right, half toward the user, up.
  EXPECT_TRUE(eventually([this] { return host_.pushed.right > 0.2; }));
  EXPECT_DOUBLE_EQ(host_.pushed.up, host_.pushed.right);
  EXPECT_GT(host_.pushed.nearer, 1);
  letGo();
  EXPECT_NEAR(host_.probes.back().hip.x, from, 1e-6) << "the hand stays";
  EXPECT_TRUE(plugin_->saveState().contains(R"("space_mouse":"view")"));
}

TEST_F(SpaceMousePluginTest, ItsTurnsDoNothingWhileItMovesTheHandAndNothingAtAllAtRest) {
  const double from = host_.probes.back().hip.x;
  hid_.send(0, {2, 0x5e, 0x01, 0, 0, 0xa2, 0xfe});
  pushRight();
  EXPECT_TRUE(eventually([&] { return host_.probes.back().hip.x > from + 5; }));
  EXPECT_EQ(host_.turned_az_deg, 0);
  EXPECT_EQ(host_.turned_el_deg, 0);
  // Let go of, and not quite centred: 14 counts of 350.
  hid_.send(0, {2, 0x0e, 0, 0, 0, 0xf2, 0xff});
  hid_.send(0, {1, 0x0e, 0, 0, 0, 0xf2, 0xff});
  inPanel<QComboBox>("spaceMouse", "Buttons")->setCurrentIndex(1);
  hid_.send(0, {3, 2, 0});
  hid_.send(0, {3, 0, 0});
  ASSERT_TRUE(eventually([this] { return host_.commands.contains("finer"); })) << "it was asked";
  EXPECT_EQ(host_.turned_az_deg, 0);
  EXPECT_EQ(host_.pushed.right, 0);
  EXPECT_EQ(host_.pushed.nearer, 1);
}

TEST_F(SpaceMousePluginTest, OneThatMayNotBeOpenedIsSaidOnceWithWhatHelps) {
  const QString said_of_it =
      "Foot switch is plugged in but this account may not use it. Install the rule that 'relievo "
      "devices rule' prints, once, then replug.";
  const std::vector<std::uint8_t> foot_switch{0x05, 0x01, 0x09, 0x04, 0xa1, 0x01, 0x05, 0x09,
                                              0x19, 0x01, 0x29, 0x01, 0x15, 0x00, 0x25, 0x01,
                                              0x75, 0x01, 0x95, 0x01, 0x81, 0x02, 0xc0};
  const OrdinaryAccount account;
  hid_.plugIn(1, 0x1234, 0x0001, "Foot switch", foot_switch);
  hid_.forbid(1, true);
  ASSERT_TRUE(said(said_of_it)) << host_.announcements.join('\n').toStdString();
  hid_.forbid(1, false);
  ASSERT_TRUE(said("Foot switch connected."));
  EXPECT_EQ(host_.announcements.count(said_of_it), 1);
}

}  // namespace
}  // namespace relievo
