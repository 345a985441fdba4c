// SPDX-License-Identifier: BSD-3-Clause
// `relievo devices` with a Falcon on a mocked port, through the real libusb.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/app/command_test.h"
#include "tests/emulator/made_image.h"
#include "tests/emulator/mock_hid.h"
#include "tests/emulator/mock_pad.h"
#include "tests/emulator/mock_usb.h"
#include "tests/emulator/stall_watch.h"
#include "tests/realtime/fake_logind.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using emulator::SharedFalcon;
using nlohmann::json;
using test::CommandResult;
using test::RunAs;
using testing::HasSubstr;

constexpr int kUsage = 1, kUnreadable = 2, kDevice = 6;

/// The program while it runs: what it says is read, Enter is pressed.
class Child {
 public:
  Child(const std::vector<std::string>& arguments, const fs::path& home) : keys_(home / "keys") {
    if (mkfifo(keys_.c_str(), 0600) != 0) throw std::runtime_error("no fifo");
    std::string line = "HOME=" + home.string() +
                       " exec env -u XDG_DATA_HOME -u XDG_CONFIG_HOME " RELIEVO_BINARY_DIR
                       "/bin/relievo";
    for (const std::string& word : arguments) line += " " + word;
    line += " 2>&1 < " + keys_.string();
    {
      const emulator::Urgent urgent;  // As is whoever starts a program that keeps time.
      program_ = popen(line.c_str(), "r");
    }
    key_ = open(keys_.c_str(), O_WRONLY | O_CLOEXEC);  // Once the program has opened it.
  }
  ~Child() {
    exitCode();
    fs::remove(keys_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Reads on until it says so. @return false: it ended without
  bool says(const std::string& text) {
    std::array<char, 400> line{};
    while (said.find(text) == std::string::npos) {
      if (std::fgets(line.data(), line.size(), program_) == nullptr) return false;
      said += line.data();
    }
    return true;
  }
  void enter() { EXPECT_EQ(write(key_, "\n", 1), 1); }
  void endInput() {
    if (key_ >= 0) close(std::exchange(key_, -1));
  }
  int exitCode() {
    endInput();
    if (program_ == nullptr) return -1;
    while (std::fgetc(program_) != EOF) {
    }
    return WEXITSTATUS(pclose(std::exchange(program_, nullptr)));
  }

  std::string said;

 private:
  fs::path keys_;
  FILE* program_ = nullptr;
  int key_ = -1;
};

class DevicesVerbTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!emulator::MockUsb::works()) GTEST_SKIP() << "umockdev's library is not preloaded";
    std::string folder = (fs::temp_directory_path() / "relievo-home-XXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    home_ = folder;
  }
  void TearDown() override { fs::remove_all(home_); }
  CommandResult run(std::vector<std::string> arguments, RunAs as = RunAs::self,
                    const std::string& firmware = "RELIEVO_FALCON_FIRMWARE") {
    arguments.insert(arguments.begin(), "devices");
    return test::runRelievo(
        arguments, {"HOME=" + home_.string(), "XDG_DATA_HOME", "XDG_CONFIG_HOME", firmware}, as);
  }
  /// As the window's preferences or the set-up would.
  void setFirmware(const std::string& file) {
    fs::create_directories(home_ / ".config/relievo");
    std::ofstream(home_ / ".config/relievo/falcon.conf") << "firmware " << file << '\n';
  }
  /// Begins again, as a person would, after a stall of the mocked Falcon on a busy computer.
  CommandResult selfTest(std::vector<std::string> options) {
    options.insert(options.begin(), "selftest");
    options.insert(options.end(), {"--report", "json"});
    CommandResult result;
    stalls_.repeatAfterStalls(20, [&] {
      result = run(options);
      return result.out.find("did not answer in time") == std::string::npos;
    });
    return result;
  }
  CommandResult listed(RunAs as = RunAs::self) { return run({"--report", "json"}, as); }
  void plugIn() { usb_.plugIn(std::make_shared<SharedFalcon>(emulator::EmulatorOptions{})); }
  std::string written(const std::vector<std::uint8_t>& bytes) {
    const fs::path file = home_ / "image.bin";
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    return file.string();
  }

  fs::path home_;
  emulator::MockUsb usb_;
  emulator::StallWatch stalls_;
};

TEST_F(DevicesVerbTest, WithoutAFalconTheMouseAndTheVirtualHandsAreThere) {
  const CommandResult result = listed();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["falcons"].size(), 0U);
  EXPECT_EQ(report["devices"][0]["id"], "mouse");
  EXPECT_THAT(result.out, HasSubstr("virtual:light"));
}

TEST_F(DevicesVerbTest, AFalconThatIsFreeIsListedAndMissingFirmwareIsSaid) {
  plugIn();
  const CommandResult result = listed();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const json report = json::parse(result.out);
  ASSERT_EQ(report["falcons"].size(), 1U);
  EXPECT_EQ(report["falcons"][0]["presence"], "present");
  EXPECT_EQ(report["devices"].back()["id"], "falcon:NV000001");
  EXPECT_EQ(report["falcons"][0]["serial"], "NV000001");
  EXPECT_EQ(report["falcons"][0]["port"], "1-1");
  EXPECT_TRUE(report["falcon_firmware"].is_null());
  EXPECT_THAT(result.err, HasSubstr("nvent_firmware.bin (8492 bytes)"));
}

TEST_F(DevicesVerbTest, AllAreListedWithSerialNumberAndPortAndNoneIsTakenForAnother) {
  plugIn();
  usb_.plugInAnother("NV000002");
  const json report = json::parse(listed().out);
  ASSERT_EQ(report["falcons"].size(), 2U);
  EXPECT_EQ(report["falcons"][1]["id"], "falcon:NV000002");
  EXPECT_EQ(report["falcons"][1]["serial"], "NV000002");
  EXPECT_EQ(report["falcons"][1]["port"], "1-2");
  EXPECT_EQ(report["devices"].back()["id"], "falcon:NV000002");
  const CommandResult unclear = run({"selftest"});
  EXPECT_EQ(unclear.exit_code, kDevice);
  EXPECT_THAT(unclear.err, HasSubstr("Several Falcons are plugged in: NV000001 (USB 1-1), "
                                     "NV000002 (USB 1-2)."));
  const CommandResult gone = run({"selftest", "--device", "falcon:NV000003"});
  EXPECT_EQ(gone.exit_code, kDevice);
  EXPECT_THAT(gone.err, HasSubstr("Falcon NV000003 was chosen and is not plugged in."));
  EXPECT_EQ(run({"selftest", "--device", "mouse"}).exit_code, kUsage);
}

TEST_F(DevicesVerbTest, OneThatAnotherProgramUsesIsBusy) {
  plugIn();
  usb_.set({.claimed_by_other = true});
  const CommandResult result = listed();
  EXPECT_EQ(result.exit_code, kDevice);
  EXPECT_EQ(json::parse(result.out)["falcons"][0]["presence"], "busy");
  EXPECT_THAT(result.err, HasSubstr("E304: Another program is using the Falcon."));
}

TEST_F(DevicesVerbTest, OneThatThisAccountMayNotUseIsForbidden) {
  plugIn();
  usb_.forbid();
  const CommandResult result = listed(RunAs::nobody);
  ASSERT_EQ(result.exit_code, kDevice) << result.err;
  EXPECT_EQ(json::parse(result.out)["falcons"][0]["presence"], "forbidden");
  EXPECT_THAT(result.err, HasSubstr("E301: A Falcon is plugged in but this account may not use it. "
                                    "Install the rule that the device set-up shows and 'relievo "
                                    "devices rule' prints, once"));
  const CommandResult tested = run({"selftest"}, RunAs::nobody);
  EXPECT_EQ(tested.exit_code, kDevice);
  EXPECT_THAT(tested.err, HasSubstr("E301"));
}

TEST_F(DevicesVerbTest, HidDevicesAreListedAndAClosedOneIsSaid) {
  const std::vector<std::uint8_t> foot_switch{
      0x05, 0x01, 0x09, 0x04, 0xa1, 0x01, 0x05, 0x09, 0x19, 0x01, 0x29, 0x01, 0x15, 0x00, 0x25,
      0x01, 0x75, 0x01, 0x95, 0x01, 0x81, 0x02, 0x75, 0x07, 0x95, 0x01, 0x81, 0x03, 0xc0};
  emulator::MockHid hid;
  hid.plugIn(0, 0x256f, 0xc635, "SpaceMouse Compact", {0x05, 0x01, 0x09, 0x08, 0xa1, 0x01, 0xc0});
  hid.plugIn(1, 0x1234, 0x0001, "Foot switch", foot_switch);
  const json open = json::parse(listed().out)["hid"];
  ASSERT_EQ(open.size(), 2U) << open;
  EXPECT_EQ(open[0], (json{{"name", "SpaceMouse Compact"}, {"access", true}}));
  hid.forbid(1, true);
  // Other accounts see the rest of the testbed as they see the real /sys.
  const fs::path testbed = std::getenv("UMOCKDEV_DIR");
  fs::permissions(testbed, fs::perms::all);
  for (const auto& node : fs::directory_iterator(testbed / "ioctl/dev")) {
    fs::permissions(node.path(), fs::perms::all);  // Asked even where opening it failed.
  }
  const CommandResult result = listed(RunAs::nobody);
  const json closed = json::parse(result.out)["hid"];
  EXPECT_EQ(result.exit_code, 0) << "it is not needed";
  EXPECT_THAT(closed, testing::Contains(json{{"name", "Foot switch"}, {"access", false}}));
  EXPECT_THAT(result.err, HasSubstr("Foot switch is plugged in but this account may not use it. "
                                    "Install the rule that 'relievo devices rule' prints"));
}

#ifdef RELIEVO_PADS
TEST_F(DevicesVerbTest, GamepadsAreListedWithWhatTheyAreGoodFor) {
  emulator::MockPad pads;
  const std::vector<int> keys{0x130, 0x131, 0x133, 0x134};
  pads.plugIn({.name = "Xbox pad", .keys = keys});
  pads.plugIn({.name = "Stick", .keys = {0x120, 0x121}, .rumbles = false});
  pads.plugIn({.name = "DualShock", .keys = keys, .has_hidraw = true});
  pads.plugIn({.name = "Old pad", .keys = keys, .rumbles = false, .has_hidraw = true});
  const json listed_pads = json::parse(listed().out)["pads"];
  ASSERT_EQ(listed_pads.size(), 3U) << "hidraw has all that the old pad is good for";
  const auto one = [](const char* name, bool buttons, bool rumble) {
    return json{{"name", name}, {"access", true}, {"buttons", buttons}, {"rumble", rumble}};
  };
  EXPECT_THAT(listed_pads, testing::Contains(one("Xbox pad", true, true)));
  EXPECT_THAT(listed_pads, testing::Contains(one("Stick", true, false)));
  EXPECT_THAT(listed_pads, testing::Contains(one("DualShock", false, true)));
  EXPECT_THAT(run({}).out, HasSubstr("Gamepad: Xbox pad, buttons, rumble as a cue, no force\n"));
}
#else
TEST_F(DevicesVerbTest, ABuildWithoutGamepadsSaysSo) {
  const CommandResult result = listed();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(json::parse(result.out)["pads"].empty());
  EXPECT_THAT(result.err, HasSubstr("built without the system's header linux/input.h"));
}
#endif

TEST_F(DevicesVerbTest, FirmwareIsCheckedAndInstalledForThisUser) {
  EXPECT_EQ(run({"firmware", (home_ / "none.bin").string()}).exit_code, kUnreadable);
  const CommandResult cut = run({"firmware", written({0xaa, 0x08, 1})});
  EXPECT_EQ(cut.exit_code, kUnreadable);
  EXPECT_THAT(cut.err, HasSubstr("3 bytes"));
  const std::string image = written(test::madeImage());
  const CommandResult unknown = run({"firmware", image});
  EXPECT_EQ(unknown.exit_code, kUsage);
  EXPECT_THAT(unknown.err, HasSubstr("--accept"));
  EXPECT_FALSE(fs::exists(home_ / ".local/share/relievo/falcon/nvent_firmware.bin"));
  const CommandResult installed = run({"firmware", image, "--accept"});
  EXPECT_EQ(installed.exit_code, 0) << installed.err;
  EXPECT_EQ(fs::file_size(home_ / ".local/share/relievo/falcon/nvent_firmware.bin"),
            test::madeImage().size());
  plugIn();
  EXPECT_EQ(json::parse(listed().out)["falcon_firmware"]["bytes"], test::madeImage().size());
}

TEST_F(DevicesVerbTest, AFirmwareFileThatWasNamedAndIsBadIsToldWithoutAFalcon) {
  const CommandResult by_variable =
      run({"--report", "json"}, RunAs::self, "RELIEVO_FALCON_FIRMWARE=/nonexist");
  EXPECT_EQ(by_variable.exit_code, kUnreadable);
  EXPECT_TRUE(json::parse(by_variable.out)["falcon_firmware"].is_null());
  EXPECT_THAT(by_variable.err, AllOf(HasSubstr("RELIEVO_FALCON_FIRMWARE"), HasSubstr("/nonexist")));
  const std::string cut = written({0xaa, 0x08, 1});
  setFirmware(cut);
  const CommandResult by_setting = run({});
  EXPECT_EQ(by_setting.exit_code, kUnreadable);
  EXPECT_THAT(by_setting.err, HasSubstr(cut));
  EXPECT_THAT(by_setting.out, HasSubstr("the file that was named cannot be used"));
}

TEST_F(DevicesVerbTest, InstallingSaysWhatIsUsedInsteadOfTheInstalledFile) {
  const std::string image = written(test::madeImage());
  const std::vector<std::string> install{"firmware", image, "--accept", "--report", "json"};
  const CommandResult plain = run(install);
  EXPECT_EQ(plain.err, "");
  EXPECT_TRUE(json::parse(plain.out)["overridden_by"].is_null());
  const CommandResult by_variable = run(install, RunAs::self, "RELIEVO_FALCON_FIRMWARE=/nonexist");
  EXPECT_EQ(by_variable.exit_code, 0) << "it is installed";
  EXPECT_THAT(by_variable.err, HasSubstr("RELIEVO_FALCON_FIRMWARE names \"/nonexist\", which is "
                                         "used instead. Unset it"));
  setFirmware("/elsewhere/falcon.bin");
  const CommandResult by_setting = run(install);
  EXPECT_EQ(json::parse(by_setting.out)["overridden_by"], "/elsewhere/falcon.bin");
  EXPECT_THAT(by_setting.err, HasSubstr("names \"/elsewhere/falcon.bin\", which is used instead. "
                                        "Clear it"));
  setFirmware(json::parse(plain.out)["installed"]);
  EXPECT_EQ(run(install).err, "") << "the set-up names the installed file";
}

TEST_F(DevicesVerbTest, ASelfTestWithoutAFalconSaysSo) {
  const CommandResult result = run({"selftest", "--no-nudges"});
  EXPECT_EQ(result.exit_code, kDevice);
  EXPECT_THAT(result.err, HasSubstr("No Falcon is plugged in."));
}

TEST_F(DevicesVerbTest, AFalconIsTestedFromTheTerminal) {
  const auto falcon = std::make_shared<SharedFalcon>(
      emulator::EmulatorOptions{.firmware_loaded = true, .homed = true});
  falcon->with([](auto& f) { f.body.pullToward({0, 0, 125}); });
  usb_.plugIn(falcon);
  const CommandResult result = selfTest({"--wait", "1"});
  // How evenly a busy computer asks decides whether it passes; that it says so is tested.
  const json report = json::parse(result.out);
  EXPECT_EQ(result.exit_code, report["passed"] == true ? 0 : kDevice) << result.err;
  std::string text;
  for (const json& line : report["lines"]) text += line["text"].get<std::string>() + "\n";
  for (const char* part : {"Rate: ", "From question to answer: ", "Lights: ", "Nudges of 0.5 N",
                           "Buttons that were not pressed: plus", "Encoder of the top arm"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  EXPECT_THAT(result.err, HasSubstr("Hold the grip loosely"));
  falcon->with([](auto& f) {
    EXPECT_TRUE(std::any_of(f.commands().begin(), f.commands().end(),
                            [](const auto& c) { return !c.neutral(); }));
    EXPECT_TRUE(f.commands().back().neutral());
  });
}

TEST_F(DevicesVerbTest, ARateIsMeasuredForAsLongAsIsAsked) {
  usb_.plugIn(std::make_shared<SharedFalcon>(
      emulator::EmulatorOptions{.firmware_loaded = true, .homed = true}));
  // How long, by the answers that were counted and the rate that is told: a busy machine has fewer.
  const auto measured_s = [this](const std::string& seconds) {
    std::uint64_t sum = 0;
    double rate_hz = 0;
    const json report = json::parse(selfTest({"--no-nudges", "--seconds", seconds}).out);
    for (const json& line : report["lines"]) {
      const std::string text = line["text"];
      if (text.starts_with("Rate: ")) rate_hz = std::stod(text.substr(6));
      if (!text.starts_with("Times from answer")) continue;
      // "... up to 0.8 ms 12, up to 1.0 ms 7"
      for (std::size_t at = text.find(" ms "); at != std::string::npos;
           at = text.find(" ms ", at + 1)) {
        sum += std::stoull(text.substr(at + 4));
      }
    }
    return static_cast<double>(sum) / rate_hz;
  };
  // The rate that is told is rounded; a phase ends with the first answer after its time.
  const double short_s = measured_s("0.5"), long_s = measured_s("4");
  EXPECT_GE(short_s, 0.45);
  EXPECT_LT(short_s, 3.5);
  EXPECT_GE(long_s, 3.6);
}

TEST_F(DevicesVerbTest, AFalconThatIsNotHomedInTimeIsNamedWithItsArms) {
  usb_.plugIn(std::make_shared<SharedFalcon>(emulator::EmulatorOptions{.firmware_loaded = true}));
  const CommandResult result = run({"selftest", "--ready", "1"});
  EXPECT_EQ(result.exit_code, kDevice);
  EXPECT_THAT(result.err, HasSubstr("Top arm missing, right arm missing, left arm missing."));
  EXPECT_THAT(result.err,
              HasSubstr("E308: The Falcon was not homed within 1 s, and nothing was tried."));
}

TEST_F(DevicesVerbTest, TheForceIsCalibratedByAWeightAndKept) {
  const auto falcon = std::make_shared<SharedFalcon>(
      emulator::EmulatorOptions{.firmware_loaded = true, .homed = true});
  falcon->with([](auto& f) {
    f.body.counts_per_n_mm = 6;
    f.body.hold({0, 0, 125});
    f.body.letGo(0.3);
  });
  usb_.plugIn(falcon);
  setFirmware("/kept.bin");
  // A busy computer may ask so late that the grip swings or is let go; a person would begin again.
  std::string said;
  const auto calibrated = [&] {
    falcon->with([](auto& f) { f.body.letGo(0.3); });
    Child child({"devices", "calibrate", "--weight", "100"}, home_);
    bool is_calibrated = false;
    if (child.says("Hang the weight on the grip, let it come to rest, then press Enter.")) {
      falcon->with([](auto& f) { f.body.letGo(0.3 + 0.980665); });
      child.enter();
      is_calibrated = child.says("The force is calibrated: ");
    }
    said = child.said;
    EXPECT_EQ(child.exitCode(), is_calibrated ? 0 : kDevice);
    if (!is_calibrated) {
      EXPECT_THAT(said, HasSubstr("The old setting is kept."));
    }
    return is_calibrated;
  };
  ASSERT_TRUE(stalls_.repeatAfterStalls(20, calibrated)) << said;
  const json report = json::parse(listed().out);
  EXPECT_NEAR(report["falcons"][0]["counts_per_n_mm"], 6, 0.3) << "its own";
  EXPECT_NEAR(report["falcons"][0]["grip_weight_n"], 0.3, 0.1);
  EXPECT_EQ(report["falcon_settings"]["counts_per_n_mm"], 5) << "of any other";
  std::ifstream conf(home_ / ".config/relievo/falcon.conf");
  EXPECT_THAT(std::string(std::istreambuf_iterator<char>(conf), {}), HasSubstr("/kept.bin"));
  falcon->with([](auto& f) { EXPECT_TRUE(f.commands().back().neutral()); });
}

TEST_F(DevicesVerbTest, ACalibrationThatNobodyCanConfirmEndsWithTheOldSetting) {
  const auto falcon = std::make_shared<SharedFalcon>(
      emulator::EmulatorOptions{.firmware_loaded = true, .homed = true});
  usb_.plugIn(falcon);
  const char* const unconfirmed =
      "The input ended before Enter said that the weight hangs. The old setting is kept.";
  std::string said;
  // As above: on a busy computer the Falcon's own reasons may come first.
  stalls_.repeatAfterStalls(20, [&] {
    falcon->with([](auto& f) {
      f.body.hold({0, 0, 125});
      f.body.letGo(0.3);
    });
    Child child({"devices", "calibrate", "--weight", "100"}, home_);
    child.endInput();
    const bool ended_so = child.says(unconfirmed);
    said = child.said;
    EXPECT_EQ(child.exitCode(), ended_so ? kUsage : kDevice) << said;
    return ended_so;
  });
  EXPECT_THAT(said, HasSubstr(unconfirmed));
  EXPECT_FALSE(fs::exists(home_ / ".config/relievo/falcon.conf"));
}

TEST_F(DevicesVerbTest, ACalibrationEndsBeforeTheComputerSleeps) {
  const test::MessageBus bus;
  ASSERT_FALSE(bus.address().empty()) << "no dbus-daemon";
  const auto falcon = std::make_shared<SharedFalcon>(
      emulator::EmulatorOptions{.firmware_loaded = true, .homed = true});
  usb_.plugIn(falcon);
  std::string said;
  stalls_.repeatAfterStalls(20, [&] {
    test::FakeLogind logind(bus.address());
    falcon->with([](auto& f) {
      f.body.hold({0, 0, 125});
      f.body.letGo(0.3);
    });
    Child child({"devices", "calibrate", "--weight", "100"}, home_);
    if (child.says("Hang the weight on the grip")) {
      logind.tell(true);
      child.says("goes to sleep");
    }
    said = child.said;
    EXPECT_EQ(child.exitCode(), kDevice);
    EXPECT_FALSE(logind.isDelayed());
    return said.find("goes to sleep") != std::string::npos;
  });
  EXPECT_THAT(said, HasSubstr("The computer goes to sleep; the forces are off and this has ended. "
                              "The old setting is kept. Begin again when it is awake."));
  falcon->with([](auto& f) { EXPECT_TRUE(f.commands().back().neutral()); });
}

TEST_F(DevicesVerbTest, ARecordingWithAFalconPushes) {
  const auto falcon = std::make_shared<SharedFalcon>(
      emulator::EmulatorOptions{.firmware_loaded = true, .homed = true});
  usb_.plugIn(falcon);
  const std::string log = (home_ / "touch.csv").string();
  const auto rows = [&log] {
    std::ifstream in(log);
    return std::count(std::istreambuf_iterator<char>(in), {}, '\n');
  };
  json report;
  stalls_.repeatAfterStalls(20, [&] {  // A stall of the mocked port takes the force.
    fs::remove(log);
    falcon->with([](auto& f) { f.body.pullToward({0, 0, 160}); });
    Child child({"record", test::kReliefF, "--unit", "mm", "--device", "falcon", "--seconds", "4",
                 "--report", "json", "-o", log},
                home_);
    for (int looks = 0; rows() < 600 && looks < 3000; ++looks) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    falcon->with([](auto& f) { f.body.pullToward({0, 0, 90}); });  // Into whatever is there.
    child.says("\n}");
    report = json::parse(child.said.substr(child.said.find('{')), nullptr, false);
    const int exit_code = child.exitCode();
    EXPECT_FALSE(report.is_discarded()) << child.said;
    if (report.is_discarded()) return false;
    EXPECT_EQ(exit_code, report["fault"].is_null() ? 0 : kDevice) << child.said;
    return report["fault"].is_null();
  });
  ASSERT_TRUE(report.is_object());
  EXPECT_EQ(report["ticks"], 4000);
  EXPECT_GT(report["largest_force_n"], 0.2);
  falcon->with([](auto& f) {
    EXPECT_TRUE(std::any_of(f.commands().begin(), f.commands().end(),
                            [](const auto& c) { return !c.neutral(); }));
    EXPECT_TRUE(f.commands().back().neutral());
  });
}

TEST_F(DevicesVerbTest, NothingIsRecordedWithAFalconThatIsNotHomed) {
  usb_.plugIn(std::make_shared<SharedFalcon>(emulator::EmulatorOptions{.firmware_loaded = true}));
  const fs::path log = home_ / "touch.csv";
  const CommandResult result =
      test::runRelievo({"record", test::kReliefF, "--unit", "mm", "--device", "falcon", "--ready",
                        "1", "-o", log.string()},
                       {"HOME=" + home_.string()});
  EXPECT_EQ(result.exit_code, kDevice);
  EXPECT_THAT(result.err,
              HasSubstr("E308: The Falcon was not homed within 1 s, and nothing was recorded."));
  EXPECT_FALSE(fs::exists(log));
}

TEST_F(DevicesVerbTest, TheHandIsChosenAndKept) {
  EXPECT_FALSE(json::parse(listed().out)["falcon_settings"]["left_handed"]);
  EXPECT_THAT(run({"--left-handed", "yes"}).out, HasSubstr("plus and minus change sides"));
  EXPECT_TRUE(json::parse(listed().out)["falcon_settings"]["left_handed"]);
  EXPECT_EQ(run({"--left-handed", "no"}).exit_code, 0);
  EXPECT_FALSE(json::parse(listed().out)["falcon_settings"]["left_handed"]);
  EXPECT_EQ(run({"--left-handed", "perhaps"}).exit_code, kUsage);
}

TEST_F(DevicesVerbTest, TheRuleIsPrinted) {
  const CommandResult result = run({"rule"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("ATTR{idVendor}==\"0403\""));
}

}  // namespace
}  // namespace relievo
