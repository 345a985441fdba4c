// SPDX-License-Identifier: BSD-3-Clause
// The whole program with a Falcon on a mocked port, through the real libusb: open a sample, home,
// touch, Plus, unplug in contact, replug, touch again. Recorded; the screen is kept as pictures.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <QByteArray>
#include <QSettings>
#include <QString>
#include <QTemporaryDir>
#include <sstream>
#include <thread>

#include "haptics/device/falcon/firmware.h"
#include "haptics/device/falcon/protocol.h"
#include "haptics/device/falcon/settings_file.h"
#include "haptics/rt/realtime_thread.h"
#include "tests/app/program_window.h"
#include "tests/emulator/made_image.h"
#include "tests/emulator/mock_usb.h"
#include "tests/emulator/stall_watch.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using emulator::FalconEmulator;
using emulator::SharedFalcon;
using emulator::Triple;

constexpr std::int64_t kSecondNs = 1'000'000'000;
constexpr Triple kFarOut{0, 0, 172}, kFarIn{0, 0, 90};
constexpr Triple kAbove{5, -4, 150}, kBelow{5, -4, 108};  // Of the sample's surface.

/// Generous: what happens is tested here, not how fast. The mocked port answers in a thread of this
/// process: looking again at once would take the processor from it.
bool eventually(const std::function<bool()>& holds) {
  const std::int64_t give_up = monotonicNs() + 240 * kSecondNs;
  while (!holds()) {
    if (monotonicNs() > give_up) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return true;
}

/// One row of a recording, by column.
struct Row {
  double f_x = 0, f_y = 0, f_z = 0, contact = 0, detail = 0, tick = 0;
  std::string event;
  double force() const { return std::hypot(f_x, f_y, f_z); }
};

struct Recording {
  std::vector<Row> rows;
  std::string comments;
};

Recording readRecording(const fs::path& file) {
  Recording recording;
  std::ifstream stream(file);
  std::map<std::string, std::size_t> columns;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with('#')) {
      recording.comments += line + '\n';
      continue;
    }
    std::istringstream parts(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
    if (columns.empty()) {
      for (std::size_t i = 0; i < cells.size(); ++i) columns[cells[i]] = i;
      continue;
    }
    if (cells.size() < columns.size()) continue;  // The last row, still being written.
    const auto number = [&](const char* name) { return std::stod(cells[columns.at(name)]); };
    recording.rows.push_back({number("f_x_N"), number("f_y_N"), number("f_z_N"), number("contact"),
                              number("detail"), number("tick"), cells[columns.at("event")]});
  }
  return recording;
}

class FalconWindowTest : public ::testing::Test {
 protected:
  FalconWindowTest() {
    const auto folder = [this](const char* variable, const char* name) {
      qputenv(variable, home_.filePath(QString::fromLatin1(name)).toUtf8());
    };
    qputenv("HOME", home_.path().toUtf8());
    folder("XDG_CONFIG_HOME", "config");
    folder("XDG_STATE_HOME", "state");
    folder("XDG_DATA_HOME", "data");
    qunsetenv("RELIEVO_FALCON_FIRMWARE");
    installFirmware();
    // The device was chosen in an earlier session.
    QSettings settings(home_.filePath("config/relievo/relievo.ini"), QSettings::IniFormat);
    settings.setValue("falcon_firmware", QString::fromStdString(firmware_.string()));
    settings.setValue("plugins/haptics_plugin",
                      QByteArray(R"({"device": "falcon:0", "bound_by_rate": false})").toBase64());
  }

  void installFirmware() {
    const fs::path file = fs::path(home_.path().toStdString()) / "image.bin";
    const std::vector<std::uint8_t> bytes = test::madeImage();
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    firmware_ = falcon::installFirmware(falcon::readFirmware(file), falcon::firmwarePlaces());
  }

  /// One that was just switched on.
  void plugIn() {
    falcon_ = std::make_shared<SharedFalcon>(emulator::EmulatorOptions{});
    usb_.plugIn(falcon_);
  }
  bool lit(int lights) {
    return eventually([&] {
      return falcon_->with([&](FalconEmulator& f) {
        return !f.commands().empty() && f.commands().back().lights == lights;
      });
    });
  }
  void hold(const Triple& place) {
    falcon_->with([&](FalconEmulator& f) { f.body.carry(place); });
  }
  /// The hand as a spring that pulls the grip there and lets itself be pushed.
  void handTo(const Triple& place) {
    falcon_->with([&](FalconEmulator& f) { f.body.pullToward(place); });
  }
  void home() {
    ASSERT_TRUE(lit(falcon::red)) << "its firmware was not started";
    hold(kFarOut);
    hold(kFarIn);
    ASSERT_TRUE(lit(falcon::blue)) << "not homed";
    hold(kFarOut);
    // A hand takes its time; the driver has seen the grip fully out some exchanges later.
    ASSERT_TRUE(eventually([this] {
      return falcon_->with([](FalconEmulator& f) { return f.body.grip()[2] > kFarOut[2] - 1; });
    }));
    falcon_->with([](FalconEmulator& f) { f.forgetCommands(); });
    ASSERT_TRUE(eventually([this] {
      return falcon_->with([](FalconEmulator& f) { return f.commands().size() > 20; });
    }));
  }
  /// On a busy computer the mocked port may answer too late in the very moment of F5; forces then
  /// stay off, as they must, and one presses again.
  void switchForcesOn(test::ProgramWindow& program, std::size_t from) {
    constexpr auto kPatience = std::chrono::seconds(20);
    const auto switchedOn = [&] {
      program.key("F5");
      const auto pressed = std::chrono::steady_clock::now();
      while (std::chrono::steady_clock::now() - pressed < kPatience) {
        if (events(from).find("forces on") != std::string::npos) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
      }
      return false;
    };
    ASSERT_TRUE(stalls_.repeatAfterStalls(5, switchedOn)) << events();
  }
  bool pushed() {
    return falcon_->with([](FalconEmulator& f) { return f.body.force()[2] > 0.3; });
  }
  /// The surface pushes; or the mocked port stalled on a busy computer, and forces are off.
  bool pushedOrStalled(std::size_t from) {
    return eventually([this, from] {
      return pushed() || events(from).find("did not answer in time") != std::string::npos;
    });
  }
  /// Forces on, then down on the surface; again, as a person would, after a stall.
  void touch(test::ProgramWindow& program) {
    const auto pressed = [&] {
      handTo(kAbove);
      if (!eventually([this] { return !pushed(); })) return false;
      const std::size_t from = readRecording(file()).rows.size();
      switchForcesOn(program, from);
      if (HasFatalFailure()) return false;
      handTo(kBelow);
      return pushedOrStalled(from) && pushed();
    };
    ASSERT_TRUE(stalls_.repeatAfterStalls(10, pressed)) << events();
    ASSERT_TRUE(lit(falcon::green));
  }
  /// Plus, pressed shortly: 700 ms are another command. Again if a busy computer made it so long.
  bool plus() {
    return stalls_.repeatAfterStalls(5, [this] {
      falcon_->with([](FalconEmulator& f) { f.buttons = 1; });
      std::this_thread::sleep_for(std::chrono::milliseconds(150));
      falcon_->with([](FalconEmulator& f) { f.buttons = 0; });
      for (int looks = 0; looks < 200; ++looks) {
        if (events().find("of detail 2") != std::string::npos) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
      }
      return false;
    });
  }
  /// The newest recording's file; empty: there is none.
  fs::path file() const {
    fs::path newest;
    std::error_code error;
    for (const auto& entry :
         fs::directory_iterator(home_.path().toStdString() + "/Documents/relievo", error)) {
      if (newest < entry.path()) newest = entry.path();
    }
    return newest;
  }
  /// Of the recording so far, from the `begun_`th row on.
  std::string events() const { return events(begun_); }
  std::string events(std::size_t from) const {
    std::string text;
    const Recording recording = readRecording(file());
    for (std::size_t i = from; i < recording.rows.size(); ++i) {
      if (!recording.rows[i].event.empty()) text += recording.rows[i].event + '\n';
    }
    return text;
  }
  bool happens(const std::string& event) {
    return eventually([&] { return events().find(event) != std::string::npos; });
  }
  void picture(test::ProgramWindow& program, const std::string& name) {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));  // For whoever looks at it.
    program.picture(RELIEVO_BINARY_DIR "/screenshots/falcon_" + name + ".png");
  }

  QTemporaryDir home_;
  emulator::MockUsb usb_;
  std::shared_ptr<SharedFalcon> falcon_;
  emulator::StallWatch stalls_;
  fs::path firmware_;
  std::size_t begun_ = 0;
};

TEST_F(FalconWindowTest, OpenHomeTouchPlusUnplugReplugTouchAgain) {
  if (!emulator::MockUsb::works()) GTEST_SKIP() << "umockdev's library is not preloaded";
  plugIn();
  test::ProgramWindow program({RELIEVO_SOURCE_DIR "/data/samples/panel.ply"});
  home();
  ASSERT_TRUE(eventually([&] { return program.title().starts_with("panel.ply"); }))
      << program.title();
  picture(program, "1_homed");
  EXPECT_EQ(falcon::readSettings(falcon::settingsFile()).firmware, firmware_)
      << "the window's preference is the driver's setting";
  program.key("r", true);
  ASSERT_TRUE(eventually([this] { return !readRecording(file()).rows.empty(); })) << "no recording";
  touch(program);
  picture(program, "2_touching");

  const std::size_t before_plus = readRecording(file()).rows.size();
  ASSERT_TRUE(plus()) << events();
  ASSERT_TRUE(happens("button 0 down"));
  ASSERT_TRUE(pushedOrStalled(before_plus)) << "the touched point stays under the hand\n"
                                            << events();
  if (!pushed()) touch(program);
  picture(program, "3_plus");

  usb_.unplug();
  ASSERT_TRUE(happens("forces off")) << events();
  picture(program, "4_unplugged");
  ASSERT_TRUE(program.runs());
  begun_ = readRecording(file()).rows.size();

  plugIn();
  home();
  touch(program);
  picture(program, "5_again");
  program.key("r", true);
  ASSERT_TRUE(eventually(
      [this] { return readRecording(file()).comments.find("# audit") != std::string::npos; }));
  program.key("q", true);
  ASSERT_TRUE(eventually([&] { return !program.runs(); }));
  EXPECT_EQ(program.exitCode(), 0);
  falcon_->with([](FalconEmulator& f) { EXPECT_TRUE(f.commands().back().neutral()); });

  fs::copy_file(file(), RELIEVO_BINARY_DIR "/screenshots/falcon_touch.csv",
                fs::copy_options::overwrite_existing);
  const Recording recording = readRecording(file());
  const auto touched = [&](double detail, std::size_t from, std::size_t to) {
    double most = 0;
    for (std::size_t i = from; i < to; ++i) {
      const Row& row = recording.rows[i];
      if (row.detail == detail && row.contact == 1) most = std::max(most, row.force());
    }
    return most;
  };
  EXPECT_GT(touched(1, 0, begun_), 0.5);
  EXPECT_GT(touched(2, 0, begun_), 0.5);
  EXPECT_GT(touched(2, begun_, recording.rows.size()), 0.5) << "again, without a restart";
  const char* const clean = "zero violations 0, limit violations 0, step violations 0";
  EXPECT_NE(recording.comments.find(clean), std::string::npos) << recording.comments;
}

}  // namespace
}  // namespace relievo
