// SPDX-License-Identifier: BSD-3-Clause
// Journey U1 with an Inverse3: a researcher touches a relief, goes nearer and back by the grip's
// buttons, loses the device in the middle of a touch and has it back, records all of it, and has
// the recording verified; the work opens again where there is no device. The service of its maker
// is a mock on a port of this computer, with an arm and a hand behind it; pictures are kept in
// screenshots/ of the build folder.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <QAction>
#include <QLabel>
#include <QtTest/QTest>
#include <string>
#include <thread>

#include "core/project/recording.h"
#include "core/region/window.h"
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

constexpr double kAboveZ = 25, kBelowZ = -17;  // Of the grip, over and under the relief.
constexpr double kDomeX = 90, kDomeY = 100;    // The middle of the dome, mm of the object.
constexpr std::chrono::milliseconds kShortPress{150};
constexpr int kPatienceMs = 20'000;  // Then a person tries again.
constexpr int kVerifyMismatch = 5;   // Exit status of `replay --verify`.
const QString kRelief = QStringLiteral(RELIEVO_SOURCE_DIR "/data/samples/relief_f.ply");

class HaplyJourney : public Journey {
 protected:
  HaplyJourney() : Journey("haply") {
    setenv("RELIEVO_HAPLY_SERVICE", std::to_string(mock_.port()).c_str(), 1);
    setenv("RELIEVO_HAPLY_EVENTS", std::to_string(mock_.eventsPort()).c_str(), 1);
    setenv("RELIEVO_HAPLY_PATIENCE_S", "60", 1);
  }
  ~HaplyJourney() override {
    for (const char* name :
         {"RELIEVO_HAPLY_SERVICE", "RELIEVO_HAPLY_EVENTS", "RELIEVO_HAPLY_PATIENCE_S"}) {
      unsetenv(name);
    }
  }
  void SetUp() override {
    window().settings().setChoice(
        QStringLiteral("plugins/haptics_plugin"),
        QByteArray(R"({"device": "haply:049D", "bound_by_rate": false})").toBase64());
    attach();
    window().resize(1280, 800);
  }
  void plant(HaplyFault fault) {
    mock_.with([&](HaplyWorld& world) { world.fault = fault; });
  }
  /// The hand over the middle of the dome as the whole relief lay in its space, as deep as `z`
  /// says.
  void handTo(double z) {
    mock_.with([&](HaplyWorld& world) { world.pullToward({dome_.x, dome_.y, z}); });
  }
  double shownN() {
    return mock_.with([](const HaplyWorld& world) {
      return std::hypot(world.force()[0], world.force()[1], world.force()[2]);
    });
  }
  /// The motors push the hand off the relief, and the window shows it so.
  bool pushed() {
    const double toward = mock_.with([](const HaplyWorld& world) { return world.force()[2]; });
    return toward > 0.2 && probe() && probe()->touching && probe()->hip.z < probe()->proxy.z;
  }
  /// Forces on over the relief, then down on it. A busy computer may stop the forces for safety;
  /// then a person lifts the hand and begins again.
  bool touch() {
    return stalls_.repeatAfterStalls(5, [this] {
      handTo(kAboveZ);
      if (!eventually([this] { return probe() && !probe()->touching; })) return false;
      if (!action("forces")->isChecked()) key(Qt::Key_F5);
      if (!QTest::qWaitFor([this] { return probe() && probe()->forces_on; }, kPatienceMs)) {
        return false;
      }
      handTo(kBelowZ);
      return QTest::qWaitFor([this] { return pushed(); }, kPatienceMs);
    });
  }
  /// One of the grip's buttons, pressed shortly; again if a busy computer took it for a long press,
  /// which goes elsewhere.
  bool press(bool HaplyWorld::*button, int wanted_detail) {
    const int before = document().detail();
    return stalls_.repeatAfterStalls(5, [&] {
      if (document().detail() != before) window().runCommand("undo");
      mock_.with([&](HaplyWorld& world) { world.*button = true; });
      std::this_thread::sleep_for(kShortPress);  // A window that is drawn meanwhile prolongs none.
      mock_.with([&](HaplyWorld& world) { world.*button = false; });
      return QTest::qWaitFor([&] { return document().detail() == wanted_detail; }, kPatienceMs);
    });
  }
  /// What the panel Touch says of the forces, and of what keeps them off.
  QString state() { return child<QLabel>("forceState")->text(); }
  /// The loop feels the window that is shown now.
  bool feelsThisWindow() {
    return eventually([this] { return probe() && probe()->window_id == document().window()->id; });
  }
  /// For a failure's message.
  std::string where() {
    return "detail " + std::to_string(document().detail()) + ", force " + std::to_string(shownN()) +
           " N, proxy " +
           (probe() ? std::to_string(probe()->proxy.x) + ", " + std::to_string(probe()->proxy.y)
                    : "none") +
           "; " + state().toStdString() + "; " + said().toStdString();
  }

  /// Of the first event with these words at or after a time of the recording, s; -1: there is none.
  double timeOf(const std::string& words, double from_s = 0) const {
    for (const TouchEvent& event : recorded_.events) {
      if (event.t_s >= from_s && event.text.find(words) != std::string::npos) return event.t_s;
    }
    ADD_FAILURE() << words;
    return -1;
  }

  InverseService mock_;
  emulator::StallWatch stalls_;
  DeviceMm dome_;
  fs::path log_;  ///< What is recorded.
  TouchRecording recorded_;

 public:  // Named by the test below.
  void startDevice();
  void openRelief();
  void touchDome();
  void zoomByButtons();
  void unplug();
  void replug();
  void readRecording();
  void verifyRecording();
  void openElsewhere();
};

/// U1.1 The device starts by itself: nobody has to home it, and no force comes from it.
void HaplyJourney::startDevice() {
  ASSERT_TRUE(hears("Haply device ready"));
}

/// U1.2, U1.3 The relief lies under the hand.
void HaplyJourney::openRelief() {
  drop(kRelief);
  ASSERT_TRUE(settled()) << window().message().toStdString();
  EXPECT_EQ(document().detail(), 1);
  ASSERT_TRUE(feelsThisWindow());
  dome_ = handMapping(*document().window()).device_from_view({kDomeX, kDomeY, 0});
  handTo(kAboveZ);
  const auto is_over = [this] {
    return std::hypot(probe()->hip.x - kDomeX, probe()->hip.y - kDomeY) < 2;
  };
  ASSERT_TRUE(eventually(is_over)) << where();
  picture("1_open");
  EXPECT_EQ(mock_.with([](const HaplyWorld& world) { return world.largest_n; }), 0) << "before F5";
}

/// U1.6, U1.7, U1.11 What follows is recorded. Forces on, down on the dome.
void HaplyJourney::touchDome() {
  key(Qt::Key_R, Qt::ControlModifier);
  ASSERT_TRUE(eventually([this] { return !recordings().empty(); }));
  log_ = recordings().back();
  ASSERT_TRUE(touch()) << where();
  EXPECT_NEAR(probe()->proxy.x, kDomeX, 3);
  EXPECT_NEAR(probe()->proxy.y, kDomeY, 3);
  picture("2_dome");
}

/// U1.9, U1.10 Button a goes nearer, twice, and c back; the touched point stays under the hand.
void HaplyJourney::zoomByButtons() {
  const auto staysPushed = [this] {
    return QTest::qWaitFor([this] { return pushed(); }, kPatienceMs) || touch();
  };
  for (const int detail : {2, 3}) {
    ASSERT_TRUE(press(&HaplyWorld::button_a, detail)) << where();
    ASSERT_TRUE(feelsThisWindow());
    ASSERT_TRUE(staysPushed()) << where();
    EXPECT_NEAR(probe()->proxy.x, kDomeX, 3) << where();
    EXPECT_NEAR(probe()->proxy.y, kDomeY, 3) << where();
  }
  picture("3_nearer");
  ASSERT_TRUE(press(&HaplyWorld::button_c, 2)) << where();
  ASSERT_TRUE(feelsThisWindow());
  ASSERT_TRUE(staysPushed()) << where();
  picture("4_back");
}

/// U1.x1 The plug is pulled in the middle of a touch: a sentence, no force, and the recording goes
/// on.
void HaplyJourney::unplug() {
  ASSERT_TRUE(action("forces")->isChecked());
  plant(HaplyFault::device_absent);
  ASSERT_TRUE(eventually([this] { return state().startsWith("E313: The Haply device went away"); }))
      << state().toStdString();
  EXPECT_TRUE(eventually([this] { return !action("forces")->isChecked(); }));
  ASSERT_TRUE(eventually([this] { return shownN() == 0; })) << where();
  QTest::qWait(500);  // A while of it stands in the recording.
  EXPECT_TRUE(action("record")->isChecked()) << "the recording goes on";
  picture("5_unplugged");
}

/// U1.x1 It is there again without a restart, and pushes only once it is asked to.
void HaplyJourney::replug() {
  handTo(kBelowZ);  // As it was pulled: deep in the relief.
  const auto changes = [this] {
    return mock_.with([](const HaplyWorld& world) { return world.log.size(); });
  };
  const std::size_t before = changes();
  plant(HaplyFault::none);
  ASSERT_TRUE(eventually([this] { return state().startsWith("Off. Press F5"); }))
      << state().toStdString();
  QTest::qWait(500);  // In which nothing may happen.
  EXPECT_EQ(changes(), before) << "no force before F5";
  ASSERT_TRUE(touch()) << where();
  picture("6_again");
  key(Qt::Key_Escape);
  ASSERT_TRUE(eventually([this] { return !action("forces")->isChecked(); }));
  ASSERT_TRUE(eventually([this] { return shownN() == 0; })) << where();
}

/// U1.11 The recording has the touch before, the device's absence, and the touch after; every force
/// within its limits.
void HaplyJourney::readRecording() {
  key(Qt::Key_R, Qt::ControlModifier);
  ASSERT_TRUE(hears("Recording saved"));
  ASSERT_EQ(recordings().size(), 1U) << "one recording of all of it";
  fs::copy_file(log_, kept("touch.csv").toStdString(), fs::copy_options::overwrite_existing);
  recorded_ = relievo::readRecording(log_);
  EXPECT_EQ(recorded_.input_sha256, document().fileSha256().toStdString());
  const double lost_s = timeOf("unplugged"), again_s = timeOf("forces rise", lost_s);
  ASSERT_LT(lost_s, again_s);
  const auto felt = [&](int detail, bool before) {
    return std::any_of(recorded_.rows.begin(), recorded_.rows.end(), [&](const TouchRow& row) {
      return row.detail == detail && row.contact && norm(row.force) > 0.2 &&
             (row.t_s < lost_s) == before;
    });
  };
  for (const int detail : {1, 2, 3}) EXPECT_TRUE(felt(detail, true)) << detail;
  EXPECT_TRUE(felt(2, false)) << "after it was back";
  std::ptrdiff_t without = 0, pushing = 0;
  for (const TouchRow& row : recorded_.rows) {
    if (row.t_s < lost_s || row.t_s >= again_s) continue;
    ++without;
    if (norm(row.force) > 0) ++pushing;
  }
  EXPECT_GT(without, 500) << "the recording went on without it";
  EXPECT_EQ(pushing, 0);
  std::ifstream in(log_, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(text.find("zero violations 0, limit violations 0, step violations 0"),
            std::string::npos);
  EXPECT_NE(text.find("# device Haply Inverse3 049D"), std::string::npos);
}

/// U1.15 Every tick again, to the last bit, without a device; one that was changed is found.
void HaplyJourney::verifyRecording() {
  const auto verify = [](const std::string& log) {
    return test::runRelievo({"replay", log, "--verify"}, {"RELIEVO_HAPLY_SERVICE=1"});
  };
  const test::CommandResult same = verify(log_.string());
  EXPECT_EQ(same.exit_code, 0) << same.out << same.err;
  EXPECT_NE(same.out.find("all the same to the last bit"), std::string::npos) << same.out;

  std::ifstream in(log_, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t row = text.find('\n', text.size() / 2) + 1;
  const std::size_t digit = text.find_first_of("0123456789", text.find(',', row));
  ASSERT_NE(digit, std::string::npos);
  text[digit] = text[digit] == '7' ? '8' : '7';
  const std::string changed = path("changed.csv").toStdString();
  std::ofstream(changed, std::ios::binary) << text;
  EXPECT_EQ(verify(changed).exit_code, kVerifyMismatch) << "a digit of one row was changed";
}

/// U1.15 Saved, and opened again where no service runs: the same window, and the mouse is the hand.
void HaplyJourney::openElsewhere() {
  window().saveProject(path("work.relievo.json"));
  const Region region = document().project().region;
  detach();
  setenv("RELIEVO_HAPLY_SERVICE", "1", 1);
  restart();
  attach();
  window().open(path("work.relievo.json"));
  ASSERT_TRUE(settled()) << window().message().toStdString();
  EXPECT_EQ(document().project().region, region);
  EXPECT_TRUE(eventually([this] { return probe().has_value(); })) << "the mouse stands in";
  picture("7_elsewhere");
}

TEST_F(HaplyJourney, TouchZoomUnplugReplugRecordVerify) {
  using Step = void (HaplyJourney::*)();
  for (const Step step :
       {&HaplyJourney::startDevice, &HaplyJourney::openRelief, &HaplyJourney::touchDome,
        &HaplyJourney::zoomByButtons, &HaplyJourney::unplug, &HaplyJourney::replug,
        &HaplyJourney::readRecording, &HaplyJourney::verifyRecording,
        &HaplyJourney::openElsewhere}) {
    (this->*step)();
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace relievo
