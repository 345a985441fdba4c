// SPDX-License-Identifier: BSD-3-Clause
// The device of a plug-in in the window: listed when somebody looks, chosen, opened beside the
// window, lost, and opened anew.
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <QComboBox>
#include <QFocusEvent>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <string>

#include "tests/plugins/plugin_fixture.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using test::eventually;

constexpr const char* kId = "plugin:spring_hand/spring.1";
constexpr const char* kTakesForce = "plugin:takes_force/stand-in.7";

/// Of a host that this process has started; 0: there is none.
int hostPid() {
  for (const auto& task : fs::directory_iterator("/proc/self/task")) {
    std::ifstream children(task.path() / "children");
    for (int pid = 0; children >> pid;) {
      std::ifstream stream("/proc/" + std::to_string(pid) + "/comm");
      std::string comm;
      std::getline(stream, comm);
      if (comm.starts_with("relievo-device")) return pid;
    }
  }
  return 0;
}

class PluginDeviceTest : public test::PluginTest {
 protected:
  void SetUp() override {
    const fs::path folder = home_.file("plug-ins").toStdString();
    fs::create_directories(folder);
    fs::permissions(folder, fs::perms(0755));
    install(RELIEVO_BINARY_DIR "/device_example/spring_hand.so", folder);
    install(RELIEVO_BINARY_DIR "/tests/stand_ins/takes_force.so", folder);
    qputenv("RELIEVO_STAND_IN_LOG", home_.file("log").toUtf8());
    qputenv("RELIEVO_DEVICE_PATH", folder.c_str());
    PluginTest::SetUp();
    host_.window = std::make_shared<RegionWindow>(test::windowOf(
        80, [](double, double) { return 5.0; }, 11));
    attach();
  }
  static void install(const fs::path& from, const fs::path& folder) {
    const fs::path file = folder / from.filename();
    fs::copy_file(from, file);
    fs::permissions(file, fs::perms(0755));
  }
  auto timesSaid(const QString& part) const {
    return std::count_if(host_.announcements.begin(), host_.announcements.end(),
                         [&](const QString& text) { return text.contains(part); });
  }
  QComboBox* devices() { return inPanel<QComboBox>("deviceList"); }
  bool isListed() { return devices()->findData(kId) >= 0; }
  void lookAtTheList() {
    QFocusEvent focus(QEvent::FocusIn);
    QCoreApplication::sendEvent(devices(), &focus);
  }
  void choose(const char* id) {
    lookAtTheList();
    ASSERT_TRUE(eventually([&] { return devices()->findData(id) >= 0; }));
    devices()->setCurrentIndex(devices()->findData(id));
  }
  /// A device that has just been opened is not ready for a moment, which ends the forces.
  bool forcesComeOn() {
    QAction* const forces = host_.actions.at("forces");
    return probeBecomes([&](const Probe& p) {
      if (!forces->isChecked()) forces->trigger();
      return p.forces_on && p.window_id == 11;
    });
  }
  /// Open, ready, and told to take its force away.
  void loseForce() {
    choose(kTakesForce);
    ASSERT_TRUE(eventually([this] { return timesSaid("Device: stand-in.7") == 1; }));
    ASSERT_TRUE(forcesComeOn());
    std::ofstream(sign()) << "now";
    ASSERT_TRUE(eventually([this] { return timesSaid("Lift the hand and press F5") == 1; }));
    ASSERT_TRUE(eventually([this] { return host_.actions.at("takeForcesBack")->isEnabled(); }));
    EXPECT_FALSE(host_.actions.at("forces")->isChecked());
    fs::remove(sign());
  }
  fs::path sign() const { return home_.file("log.takes").toStdString(); }
  QPushButton* takeBack() { return inPanel<QPushButton>("takeBackButton"); }
  void chooseIt() {
    lookAtTheList();
    ASSERT_TRUE(eventually([this] { return isListed(); }));
    devices()->setCurrentIndex(devices()->findData(kId));
  }
};

TEST_F(PluginDeviceTest, IsListedWhenSomebodyLooksAndNotBefore) {
  EXPECT_FALSE(isListed());
  EXPECT_EQ(hostPid(), 0) << "nothing is started that nobody asked for";
  lookAtTheList();
  ASSERT_TRUE(eventually([this] { return isListed(); }));
  EXPECT_EQ(devices()->itemText(devices()->findData(kId)), "Hand on a spring");
  EXPECT_EQ(devices()->currentData().toString(), "mouse") << "what was chosen stays chosen";
}

TEST_F(PluginDeviceTest, IsOpenedBesideTheWindowAndIsTheHandThen) {
  chooseIt();
  EXPECT_EQ(timesSaid("is being opened"), 1);
  EXPECT_EQ(inPanel<QLabel>("triedOnHardware")->text(),
            "Tried on hardware: ask who made the plug-in.");
  ASSERT_TRUE(eventually([this] { return timesSaid("Device: spring.1") == 1; }));
  EXPECT_EQ(devices()->currentData().toString(), kId);
  EXPECT_TRUE(plugin_->saveState().contains(kId));
  EXPECT_TRUE(probeBecomes([](const Probe& p) { return p.window_id == 11; }));
}

TEST_F(PluginDeviceTest, WhenItsHostIsKilledForcesAreOffAndItIsOpenedAnew) {
  chooseIt();
  ASSERT_TRUE(eventually([this] { return timesSaid("Device: spring.1") == 1; }));
  QAction* const forces = host_.actions.at("forces");
  forces->trigger();
  // On a busy computer it may be gone by itself.
  if (const int host = hostPid(); host != 0) ::kill(host, SIGKILL);
  ASSERT_TRUE(eventually([this] { return timesSaid("Forces off: ") >= 1; }));
  EXPECT_FALSE(forces->isChecked());
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return !p.forces_on && p.force == DeviceN{}; }));
  ASSERT_TRUE(eventually([&] {
    if (!forces->isChecked()) forces->trigger();
    return timesSaid("is being opened") >= 2;
  }));
  EXPECT_FALSE(forces->isChecked()) << "forces wait until it is there";
  EXPECT_TRUE(host_.actions.at("forcesOff")->isEnabled()) << "Escape ends the wish, too";
  EXPECT_TRUE(eventually([this] { return timesSaid("Device: spring.1") >= 2; }));
  EXPECT_TRUE(eventually([&] { return forces->isChecked(); })) << "one press took them back";
  EXPECT_TRUE(probeBecomes([](const Probe& p) { return p.forces_on; }));
}

TEST_F(PluginDeviceTest, AForceThatTheDeviceTookAwayComesBackByOneAction) {
  EXPECT_TRUE(takeBack()->isHidden());
  ASSERT_NO_FATAL_FAILURE(loseForce());
  ASSERT_TRUE(eventually([this] { return !takeBack()->isHidden(); }));
  EXPECT_TRUE(inPanel<QLabel>("forceState")->text().contains("forces rise from zero"));
  takeBack()->click();
  QAction* const forces = host_.actions.at("forces");
  EXPECT_FALSE(forces->isChecked()) << "not before it is open";
  EXPECT_TRUE(eventually([&] { return forces->isChecked(); }));
  EXPECT_EQ(timesSaid("Device: stand-in.7"), 2);
  EXPECT_TRUE(probeBecomes([](const Probe& p) { return p.forces_on; }));
  EXPECT_TRUE(eventually([this] { return takeBack()->isHidden(); }));
}

TEST_F(PluginDeviceTest, ItsOwnButtonCentreHeldTakesTheForceBack) {
  ASSERT_NO_FATAL_FAILURE(loseForce());
  // It stays away while the button is held: only opening it anew helps.
  const fs::path holds = home_.file("log.holds").toStdString();
  std::ofstream(holds) << "now";
  ASSERT_TRUE(eventually([this] { return host_.commands.contains("forces"); }))
      << "the window's command, as by key";
  QAction* const forces = host_.actions.at("forces");
  forces->trigger();  // As the window does.
  EXPECT_TRUE(eventually([&] { return forces->isChecked(); }));
  EXPECT_TRUE(probeBecomes([](const Probe& p) { return p.forces_on; }));
  EXPECT_EQ(timesSaid("Device: stand-in.7"), 2);
  EXPECT_EQ(host_.commands.count("forces"), 1) << "one press";
  // The new device saw the button down from its first reading: that press is over.
  fs::remove(holds);
  QTest::qWait(500);  // The device is asked a thousand times a second.
  host_.commands.clear();
  std::ofstream(holds) << "again";
  EXPECT_TRUE(eventually([this] { return host_.commands.contains("forcesOff"); }))
      << "the next press is one";
}

TEST_F(PluginDeviceTest, EscapeWhileItIsOpenedAnewLeavesTheForcesOff) {
  ASSERT_NO_FATAL_FAILURE(loseForce());
  const auto times_on = timesSaid("Forces on.");
  host_.actions.at("takeForcesBack")->trigger();
  ASSERT_TRUE(host_.actions.at("forcesOff")->isEnabled());
  host_.actions.at("forcesOff")->trigger();
  ASSERT_TRUE(eventually([this] { return timesSaid("Device: stand-in.7") == 2; }));
  ASSERT_TRUE(eventually([this] { return !host_.actions.at("takeForcesBack")->isEnabled(); }));
  host_.probes.clear();
  ASSERT_TRUE(probeBecomes([](const Probe& p) { return p.window_id == 11; }));
  EXPECT_FALSE(host_.actions.at("forces")->isChecked());
  EXPECT_EQ(timesSaid("Forces on."), times_on);
}

TEST_F(PluginDeviceTest, OneThatCannotBeOpenedNowIsTakenBackByOneActionLater) {
  const fs::path plug_in = home_.file("plug-ins/takes_force.so").toStdString();
  const fs::path away = home_.file("takes_force.away").toStdString();
  QAction* const take_back = host_.actions.at("takeForcesBack");
  ASSERT_NO_FATAL_FAILURE(loseForce());
  fs::rename(plug_in, away);
  take_back->trigger();
  ASSERT_TRUE(eventually([this] { return timesSaid("Shift+F5 opens the chosen device") == 1; }));
  EXPECT_EQ(devices()->currentData().toString(), "mouse");
  EXPECT_FALSE(host_.actions.at("forces")->isChecked()) << "the mouse gets no forces of its own";
  fs::rename(away, plug_in);
  ASSERT_TRUE(take_back->isEnabled());
  take_back->trigger();
  EXPECT_TRUE(probeBecomes([&](const Probe& p) {
    return p.forces_on && devices()->currentData().toString() == kTakesForce;
  }));
}

TEST_F(PluginDeviceTest, AnotherChoiceEndsTheOpening) {
  chooseIt();
  devices()->setCurrentIndex(devices()->findData("mouse"));
  EXPECT_TRUE(said("Device: mouse."));
  EXPECT_EQ(hostPid(), 0);
  EXPECT_EQ(timesSaid("Device: spring.1"), 0);
}

}  // namespace
}  // namespace relievo
