// SPDX-License-Identifier: BSD-3-Clause
// A device of Haply under the window's loop, on a mock of its service.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <QComboBox>
#include <QDeadlineTimer>
#include <QFocusEvent>
#include <QKeyEvent>
#include <string>
#include <vector>

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

TEST_F(HaplyInTheList, WhereItsGripIsIsToldWhileNothingIsOpen) {
  mock_.with([](HaplyWorld& world) { world.hold({3, 4, 5}); });
  lookAtTheList();
  ASSERT_TRUE(eventually([this] { return isListed("haply:049D"); }));
  EXPECT_FALSE(host_.status.grip) << "the mouse has none";
  devices()->setCurrentIndex(devices()->findData("haply:049D"));
  ASSERT_TRUE(said("Haply device ready."));
  EXPECT_TRUE(eventually([this] {
    const auto& grip = host_.status.grip;
    return grip && norm(*grip - DeviceMm{3, 4, 5}) < 0.01;
  }));
  EXPECT_TRUE(host_.probes.empty()) << "of which no probe tells";
  mock_.with([](HaplyWorld& world) { world.fault = HaplyFault::device_absent; });
  EXPECT_TRUE(eventually([this] { return !host_.status.grip; }))
      << "where it was is not where it is";
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

/// A port of this computer at which somebody could be, and what is said there.
class QuietPort {
 public:
  QuietPort() : listener_(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    EXPECT_EQ(::bind(listener_, any, size), 0);
    EXPECT_EQ(::listen(listener_, 8), 0);
    EXPECT_EQ(::getsockname(listener_, any, &size), 0);
    port_ = ntohs(address.sin_port);
  }
  ~QuietPort() {
    for (const int visitor : visitors_) ::close(visitor);
    ::close(listener_);
  }
  QuietPort(const QuietPort&) = delete;
  QuietPort& operator=(const QuietPort&) = delete;

  int port() const { return port_; }
  /// Whether anybody has come so far.
  bool isVisited() {
    for (int one = 0; (one = ::accept(listener_, nullptr, nullptr)) >= 0;) visitors_.push_back(one);
    return !visitors_.empty();
  }
  /// Whether any visitor has said a word so far.
  bool hears() {
    isVisited();
    std::array<char, 100> words{};
    for (const int visitor : visitors_) {
      heard_ = heard_ || ::recv(visitor, words.data(), words.size(), MSG_DONTWAIT) > 0;
    }
    return heard_;
  }

 private:
  int listener_, port_ = 0;
  std::vector<int> visitors_;
  bool heard_ = false;
};

/// Of children that have ended; no process does without memory.
long pageFaultsOfChildren() {  // NOLINT(google-runtime-int): as the system has it.
  rusage used{};
  ::getrusage(RUSAGE_CHILDREN, &used);
  return used.ru_minflt;
}

TEST_F(HaplyInTheList, UntilSomebodyTurnsToItNobodyIsSpokenToAndNoPlugInRuns) {
  QuietPort service;
  setenv("RELIEVO_HAPLY_SERVICE", std::to_string(service.port()).c_str(), 1);
  setenv("RELIEVO_HAPLY_PATIENCE_S", "1", 1);
  setenv("RELIEVO_DEVICE_PATH", RELIEVO_BINARY_DIR "/tests/stand_ins", 1);
  const auto faults_before = pageFaultsOfChildren();
  attach();
  const QDeadlineTimer nothing_may_happen(1500);
  while (!nothing_may_happen.hasExpired()) {
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
  }
  EXPECT_FALSE(service.isVisited());
  EXPECT_FALSE(isListed("haply"));
  EXPECT_EQ(pageFaultsOfChildren(), faults_before);

  QFocusEvent focus(QEvent::FocusIn);
  QCoreApplication::sendEvent(devices(), &focus);
  EXPECT_TRUE(isListed("haply")) << "somebody is there, it seems";
  EXPECT_TRUE(eventually([&] { return service.hears(); })) << "and is asked";
  EXPECT_TRUE(eventually([&] { return pageFaultsOfChildren() > faults_before; }))
      << "and so are plug-ins, each in a process of its own";
  unsetenv("RELIEVO_DEVICE_PATH");
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
