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
#include <string>

#include "tests/plugins/plugin_fixture.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using test::eventually;

constexpr const char* kId = "plugin:spring_hand/spring.1";

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
    const fs::path file = folder / "spring_hand.so";
    fs::copy_file(RELIEVO_BINARY_DIR "/device_example/spring_hand.so", file);
    fs::permissions(file, fs::perms(0755));
    qputenv("RELIEVO_DEVICE_PATH", folder.c_str());
    PluginTest::SetUp();
    host_.window = std::make_shared<RegionWindow>(test::windowOf(
        80, [](double, double) { return 5.0; }, 11));
    attach();
  }
  QComboBox* devices() { return inPanel<QComboBox>("deviceList"); }
  bool isListed() { return devices()->findData(kId) >= 0; }
  void lookAtTheList() {
    QFocusEvent focus(QEvent::FocusIn);
    QCoreApplication::sendEvent(devices(), &focus);
  }
  void chooseIt() {
    lookAtTheList();
    ASSERT_TRUE(eventually([this] { return isListed(); }));
    devices()->setCurrentIndex(devices()->findData(kId));
  }
  auto timesSaid(const QString& part) const {
    return std::count_if(host_.announcements.begin(), host_.announcements.end(),
                         [&](const QString& text) { return text.contains(part); });
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
  EXPECT_TRUE(eventually([this] { return timesSaid("Device: spring.1") >= 2; }));
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
