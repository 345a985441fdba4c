// SPDX-License-Identifier: BSD-3-Clause
// `relievo devices` with a Falcon on a mocked port, through the real libusb.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/app/command.h"
#include "tests/emulator/made_image.h"
#include "tests/emulator/mock_usb.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using emulator::SharedFalcon;
using nlohmann::json;
using test::CommandResult;
using test::RunAs;
using testing::HasSubstr;

constexpr int kUsage = 1, kUnreadable = 2, kDevice = 6;

class DevicesVerbTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!emulator::MockUsb::works()) GTEST_SKIP() << "umockdev's library is not preloaded";
    std::string folder = (fs::temp_directory_path() / "relievo-home-XXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    home_ = folder;
  }
  void TearDown() override { fs::remove_all(home_); }
  CommandResult run(std::vector<std::string> arguments, RunAs as = RunAs::self) {
    arguments.insert(arguments.begin(), "devices");
    return test::runRelievo(
        arguments,
        {"HOME=" + home_.string(), "XDG_DATA_HOME", "XDG_CONFIG_HOME", "RELIEVO_FALCON_FIRMWARE"},
        as);
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
  EXPECT_EQ(report["devices"].back()["id"], "falcon:0");
  EXPECT_TRUE(report["falcon_firmware"].is_null());
  EXPECT_THAT(result.err, HasSubstr("nvent_firmware.bin (8492 bytes)"));
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
  const CommandResult result = run({"selftest", "--wait", "1", "--report", "json"});
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

TEST_F(DevicesVerbTest, TheRuleIsPrinted) {
  const CommandResult result = run({"rule"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("ATTR{idVendor}==\"0403\""));
}

}  // namespace
}  // namespace relievo
