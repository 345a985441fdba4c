// SPDX-License-Identifier: BSD-3-Clause
// Journey U1 with Haply's Inverse3 in the place of the Falcon, on a mock of its service: the window
// is opened with it, the dome is touched, buttons zoom, the device is unplugged under the hand and
// plugged in again, forces come back by one key, and the recording of all of it is verified.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <QAction>
#include <QLabel>
#include <QtTest/QTest>

#include "core/project/recording.h"
#include "data/generate/relief_f.h"
#include "tests/app/command.h"
#include "tests/app/journeys/journey.h"
#include "tests/emulator/haply/inverse_service.h"
#include "tests/emulator/stall_watch.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using emulator::HaplyFault;
using emulator::HaplyWorld;
using emulator::InverseService;

constexpr double kAboveZ = 28, kBelowZ = -14;  // Of the grip, over and under the relief, mm.
constexpr int kPatienceMs = 20'000;            // Then a person tries again.
const QString kRelief = QStringLiteral(RELIEVO_SOURCE_DIR "/data/samples/relief_f.ply");

class JourneyHaply : public Journey {
 protected:
  JourneyHaply() : Journey("haply") {
    setenv("RELIEVO_HAPLY_SERVICE", std::to_string(mock_.port()).c_str(), 1);
    setenv("RELIEVO_HAPLY_EVENTS", std::to_string(mock_.eventsPort()).c_str(), 1);
    setenv("RELIEVO_HAPLY_PATIENCE_S", "60", 1);
  }
  void SetUp() override {
    window().settings().setChoice(
        QStringLiteral("plugins/haptics_plugin"),
        QByteArray(R"({"device": "haply:049D", "bound_by_rate": false})").toBase64());
    attach();
    window().resize(1280, 800);
    OpenRequest request;
    request.file = kRelief;
    request.unit = LengthUnit::mm;
    window().open(request);
  }
  void plant(HaplyFault fault) {
    mock_.with([&](HaplyWorld& world) { world.fault = fault; });
  }
  void handTo(double x_mm, double y_mm, double z) {
    const HandMapping map = handMapping(*document().window());
    const DeviceMm at = map.device_from_view({x_mm, y_mm, 0});
    mock_.with([&](HaplyWorld& world) { world.pullToward({at.x, at.y, z}); });
  }
  double pushN() {
    return mock_.with([](HaplyWorld& world) { return world.force()[2]; });
  }
  /// Forces on over a place, then down on it.
  bool touch(double x_mm, double y_mm) {
    return stalls_.repeatAfterStalls(5, [&] {
      handTo(x_mm, y_mm, kAboveZ);
      if (!action("forces")->isChecked()) key(Qt::Key_F5);
      if (!QTest::qWaitFor([this] { return probe() && probe()->forces_on; }, kPatienceMs)) {
        return false;
      }
      handTo(x_mm, y_mm, kBelowZ);
      return QTest::qWaitFor(
          [this] {
            return pushN() > 0.2 && probe()->touching && probe()->hip.z < probe()->proxy.z;
          },
          kPatienceMs);
    });
  }
  /// A short press; again if a busy computer took it for a long one.
  bool press(bool HaplyWorld::*button, int wanted_detail) {
    return stalls_.repeatAfterStalls(5, [&] {
      mock_.with([&](HaplyWorld& world) { world.*button = true; });
      QTest::qWait(150);
      mock_.with([&](HaplyWorld& world) { world.*button = false; });
      return QTest::qWaitFor([&] { return document().detail() == wanted_detail; }, kPatienceMs);
    });
  }
  bool tells(const QString& part) {
    return eventually([&] { return said().contains(part); });
  }

  InverseService mock_;
  emulator::StallWatch stalls_;
};

TEST_F(JourneyHaply, TouchZoomUnplugReplugRecordVerify) {
  ASSERT_TRUE(settled()) << window().message().toStdString();
  ASSERT_TRUE(eventually([this] {
    return mock_.with([](HaplyWorld& world) { return world.configurations > 0; });
  })) << "it is the hand from the start";
  EXPECT_EQ(mock_.with([](HaplyWorld& world) { return world.largest_n; }), 0) << "before F5";
  key(Qt::Key_R, Qt::ControlModifier);  // What follows is recorded.
  ASSERT_TRUE(touch(90, 100)) << "the dome; " << said().toStdString();
  picture("1_dome");
  ASSERT_TRUE(press(&HaplyWorld::button_a, 2)) << "the grip's a is Plus";
  ASSERT_TRUE(press(&HaplyWorld::button_c, 1)) << "and its c Minus";
  ASSERT_TRUE(touch(90, 100)) << said().toStdString();
  plant(HaplyFault::device_absent);
  ASSERT_TRUE(eventually([this] { return !action("forces")->isChecked(); }));
  ASSERT_TRUE(eventually([this] { return pushN() == 0; })) << "unplugged under the hand";
  picture("2_unplugged");
  plant(HaplyFault::none);
  ASSERT_TRUE(tells("Haply device ready.")) << "without a restart; " << said().toStdString();
  EXPECT_FALSE(action("forces")->isChecked()) << "nobody is pushed unasked";
  ASSERT_TRUE(touch(90, 100)) << "one key brings the forces back; " << said().toStdString();
  picture("3_replugged");
  key(Qt::Key_Escape);
  ASSERT_TRUE(eventually([this] { return pushN() == 0; }));
  key(Qt::Key_R, Qt::ControlModifier);
  ASSERT_TRUE(tells("Recording saved")) << said().toStdString();
  ASSERT_FALSE(recordings().empty());
  const fs::path log = recordings().back();
  const TouchRecording recording = relievo::readRecording(log);
  EXPECT_EQ(recording.input_sha256, document().fileSha256().toStdString());
  EXPECT_GE(recording.windows.size(), 3U) << "two zooms";
  detach();
  const test::CommandResult verified =
      test::runRelievo({"replay", log.string(), "--input", kRelief.toStdString(), "--verify"});
  EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
}

}  // namespace
}  // namespace relievo
