// SPDX-License-Identifier: BSD-3-Clause
// A device of Haply under the window's loop, on a mock of its service.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <QComboBox>
#include <QFocusEvent>
#include <QKeyEvent>
#include <string>

#include "core/base/error.h"
#include "plugins/haptics/loop_session.h"
#include "tests/emulator/haply/inverse_service.h"
#include "tests/plugins/plugin_fixture.h"

namespace relievo {
namespace {

using emulator::HaplyFault;
using emulator::HaplyWorld;
using emulator::InverseService;
using test::eventually;

class HaplySession : public testing::Test {
 protected:
  HaplySession() {
    setenv("RELIEVO_HAPLY_SERVICE", std::to_string(mock_.port()).c_str(), 1);
    setenv("RELIEVO_HAPLY_PATIENCE_S", "60", 1);
  }
  ~HaplySession() override {
    unsetenv("RELIEVO_HAPLY_SERVICE");
    unsetenv("RELIEVO_HAPLY_PATIENCE_S");
  }
  void plant(HaplyFault fault) {
    mock_.with([&](HaplyWorld& world) { world.fault = fault; });
  }
  static bool comesTo(LoopSession& session, haply::LinkState state) {
    return eventually([&] { return session.haplyStatus()->state == state; });
  }

  const test::PrivateHome home_;
  InverseService mock_;
};

TEST_F(HaplySession, TheHandIsWhereTheGripIsThroughUnpluggingAndBack) {
  mock_.with([](HaplyWorld& world) { world.hold({3, 4, 5}); });
  LoopSession session("haply:049D");
  EXPECT_EQ(session.falconStatus(), nullptr);
  EXPECT_FALSE(session.isSteered());
  ASSERT_NE(session.haplyStatus(), nullptr);
  ASSERT_TRUE(comesTo(session, haply::LinkState::ready));
  EXPECT_EQ(session.loop().device().name, "Haply Inverse3 049D");
  EXPECT_TRUE(eventually([&] { return std::abs(session.update().hip.z - 5) < 0.01; }));
  plant(HaplyFault::device_absent);
  EXPECT_TRUE(comesTo(session, haply::LinkState::no_device));
  plant(HaplyFault::none);
  EXPECT_TRUE(comesTo(session, haply::LinkState::ready));
}

TEST_F(HaplySession, OneThatIsNotThereIsSaid) {
  plant(HaplyFault::device_absent);
  EXPECT_THROW(LoopSession("haply"), DeviceError);
}

/// The whole plugin, whose list of devices asks the service.
class HaplyInTheList : public test::PluginTest {
 protected:
  HaplyInTheList() {
    setenv("RELIEVO_HAPLY_SERVICE", std::to_string(mock_.port()).c_str(), 1);
    setenv("RELIEVO_HAPLY_PATIENCE_S", "60", 1);
  }
  ~HaplyInTheList() override {
    unsetenv("RELIEVO_HAPLY_SERVICE");
    unsetenv("RELIEVO_HAPLY_PATIENCE_S");
  }
  QComboBox* devices() { return inPanel<QComboBox>("deviceList"); }
  bool isListed(const char* id) { return devices()->findData(id) >= 0; }
  void lookAtTheList() {
    attach();
    QFocusEvent focus(QEvent::FocusIn);
    QCoreApplication::sendEvent(devices(), &focus);
  }

  InverseService mock_;
};

TEST_F(HaplyInTheList, EveryDeviceThatTheServiceSeesStandsThereByItsId) {
  mock_.with([](HaplyWorld& world) { world.fault = HaplyFault::second_device; });
  lookAtTheList();
  EXPECT_TRUE(eventually([this] { return isListed("haply:049D") && isListed("haply:04BA"); }));
  EXPECT_EQ(devices()->itemText(devices()->findData("haply:049D")), "Haply Inverse3 049D");
  EXPECT_FALSE(isListed("haply")) << "which one would it be?";
  EXPECT_EQ(mock_.with([](const HaplyWorld& world) { return world.configurations; }), 0U)
      << "to look changes nothing";
}

TEST_F(HaplyInTheList, WhatTheServiceTellsOfItsGripIsSaidOnceAndOfPlugsByTheStateAlone) {
  setenv("RELIEVO_HAPLY_EVENTS", std::to_string(mock_.eventsPort()).c_str(), 1);
  lookAtTheList();
  ASSERT_TRUE(eventually([this] { return isListed("haply:049D"); }));
  devices()->setCurrentIndex(devices()->findData("haply:049D"));
  ASSERT_TRUE(said("Haply device ready."));
  ASSERT_TRUE(eventually([this] {
    mock_.with([](HaplyWorld& world) { world.tellEvent("device-battery-low"); });
    return host_.announcements.contains("The battery of the grip is low.");
  }));
  mock_.with([](HaplyWorld& world) { world.fault = HaplyFault::device_absent; });
  ASSERT_TRUE(said("The Haply device went away. Forces are off."));
  mock_.with([](HaplyWorld& world) { world.fault = HaplyFault::none; });
  ASSERT_TRUE(eventually([this] { return host_.announcements.count("Haply device ready.") == 2; }));
  unsetenv("RELIEVO_HAPLY_EVENTS");
  EXPECT_EQ(host_.announcements.count("The battery of the grip is low."), 1);
  EXPECT_TRUE(host_.announcements.filter("A Haply device was unplugged").isEmpty());
  EXPECT_TRUE(host_.announcements.filter("A Haply device was plugged in").isEmpty());
}

TEST_F(HaplyInTheList, OneIsChosenByAKey) {
  lookAtTheList();
  ASSERT_TRUE(eventually([this] { return isListed("haply:049D"); }));
  QKeyEvent end(QEvent::KeyPress, Qt::Key_End, Qt::NoModifier);
  QCoreApplication::sendEvent(devices(), &end);
  EXPECT_EQ(devices()->currentData().toString(), "haply:049D");
  EXPECT_TRUE(eventually([this] {
    return mock_.with([](const HaplyWorld& world) { return world.configurations > 0; });
  }));
}

}  // namespace
}  // namespace relievo
