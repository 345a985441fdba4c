// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/firmware.h"

#include <fnmatch.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "core/base/error.h"
#include "haptics/device/falcon/link/link_status.h"
#include "haptics/device/falcon/settings_file.h"
#include "haptics/device/hid/hid_reports.h"
#include "tests/emulator/made_image.h"
#include "tests/emulator/ordinary_account.h"

namespace relievo::falcon {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

class FirmwareTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "relievo-firmware-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    places_.data_home = folder_ / "home";
    places_.system = {folder_ / "local", folder_ / "share"};
    for (const char* sub : {"home", "local", "share", "named"}) fs::create_directory(folder_ / sub);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::vector<std::uint8_t>& bytes) {
    std::ofstream stream(folder_ / name, std::ios::binary);
    for (const std::uint8_t byte : bytes) stream.put(static_cast<char>(byte));
    return folder_ / name;
  }
  /// An image that was accepted before, told from others by its size.
  fs::path image(const std::string& name, std::uint16_t words) {
    const fs::path file = write(name, relievo::test::madeImage({words, 1500}));
    std::ofstream(places_.data_home / "accepted", std::ios::app)
        << readFirmware(file).sha256 << '\n';
    return file;
  }
  std::string failure() {
    try {
      return "found " + findFirmware(places_).file.string();
    } catch (const FileError& error) {
      return error.what();
    }
  }

  fs::path folder_;
  FirmwarePlaces places_;
};

TEST_F(FirmwareTest, IsFoundInTheDocumentedOrder) {
  const fs::path share = image("share/falcon.bin", 1);
  EXPECT_EQ(findFirmware(places_).file, share);
  const fs::path local = image("local/novint_T2.bin", 2);
  EXPECT_EQ(findFirmware(places_).file, local);
  const fs::path home = image("home/test_firmware.bin", 3);
  EXPECT_EQ(findFirmware(places_).file, home);
  const fs::path better = image("home/nvent_firmware.bin", 4);
  EXPECT_EQ(findFirmware(places_).file, better) << "names have an order, too";
  const fs::path named = image("named/novint_T0.bin", 5);
  places_.environment = (folder_ / "named").string();
  EXPECT_EQ(findFirmware(places_).file, named) << "a folder";
  places_.environment = named.string();
  EXPECT_EQ(findFirmware(places_).file, named) << "a file";
  places_.setting = share;
  EXPECT_EQ(findFirmware(places_).file, share);
}

TEST_F(FirmwareTest, WhatTheUserNamedIsNeverPassedOver) {
  image("home/nvent_firmware.bin", 4);
  places_.environment = (folder_ / "nowhere.bin").string();
  EXPECT_THAT(failure(), AllOf(HasSubstr("nowhere.bin"), HasSubstr("RELIEVO_FALCON_FIRMWARE"),
                               HasSubstr("does not exist")));
  places_.environment = (folder_ / "named").string();
  EXPECT_THAT(failure(), HasSubstr("has no Falcon firmware"));
  places_.environment.clear();
  places_.setting = write("text.bin", std::vector<std::uint8_t>(4000, 'x'));
  EXPECT_THAT(failure(), AllOf(HasSubstr("text.bin"), HasSubstr("does not begin with AA 08"),
                               HasSubstr("the setting Falcon firmware (Preferences > Device)")));
}

TEST_F(FirmwareTest, ABadOneInItsPlaceIsNotPassedOverEither) {
  write("home/nvent_firmware.bin", {1, 2, 3});
  image("share/falcon.bin", 1);
  EXPECT_THAT(failure(), HasSubstr("3 bytes"));
}

TEST_F(FirmwareTest, NamesEveryPlaceWhereItLooked) {
  const std::string text = failure();
  EXPECT_THAT(
      text, AllOf(HasSubstr("nvent_firmware.bin (8492 bytes)"), HasSubstr("Places searched"),
                  HasSubstr((folder_ / "home").string()), HasSubstr((folder_ / "share").string())));
}

TEST_F(FirmwareTest, AnImageThatNobodyKnowsIsAskedForOnce) {
  const fs::path file = write("home/falcon.bin", relievo::test::madeImage());
  EXPECT_THAT(failure(), AllOf(HasSubstr("nobody knows"), HasSubstr("--accept")));
  const Firmware firmware = readFirmware(file);
  EXPECT_FALSE(firmware.known_as);
  EXPECT_FALSE(isAccepted(firmware, places_));
  EXPECT_EQ(installFirmware(firmware, places_), places_.data_home / "nvent_firmware.bin");
  EXPECT_TRUE(isAccepted(firmware, places_));
  EXPECT_EQ(findFirmware(places_).bytes, relievo::test::madeImage());
}

TEST_F(FirmwareTest, WhatCannotBeInstalledChangesNothing) {
  const Firmware firmware = readFirmware(write("falcon.bin", relievo::test::madeImage()));
  const auto files = [this] {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(places_.data_home)) {
      names.push_back(entry.path().filename());
    }
    return names;
  };
  fs::create_directory(places_.data_home / "nvent_firmware.bin");  // Where the image should go.
  EXPECT_THROW(installFirmware(firmware, places_), WriteError);
  EXPECT_THAT(files(), testing::ElementsAre("nvent_firmware.bin"));
  EXPECT_FALSE(isAccepted(firmware, places_));
  std::ofstream(places_.data_home / "accepted") << "another\n";
  EXPECT_THROW(installFirmware(firmware, places_), WriteError);
  EXPECT_FALSE(isAccepted(firmware, places_));
  fs::remove(places_.data_home / "nvent_firmware.bin");

  fs::remove(places_.data_home / "accepted");
  fs::create_directory(places_.data_home / "accepted");
  EXPECT_THROW(installFirmware(firmware, places_), WriteError);
  EXPECT_THAT(files(), testing::ElementsAre("accepted"));
  fs::remove(places_.data_home / "accepted");
  installFirmware(firmware, places_);
  EXPECT_THAT(files(), testing::UnorderedElementsAre("accepted", "nvent_firmware.bin"));
}

TEST_F(FirmwareTest, ItsHashIsTheOneThatSha256sumPrints) {
  // printf of AA 08, then zeros up to 2048 bytes is no image; the hash of a good one is checked by
  // its own program.
  const fs::path file = write("falcon.bin", relievo::test::madeImage());
  const std::string command =
      "sha256sum '" + file.string() + "' > '" + (folder_ / "sum").string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);  // NOLINT(cert-env33-c,concurrency-mt-unsafe)
  std::ifstream sum(folder_ / "sum");
  std::string hash;
  sum >> hash;
  EXPECT_EQ(readFirmware(file).sha256, hash);
}

TEST_F(FirmwareTest, FilesThatAreNoneAreRefusedWithAReason) {
  const auto reason = [this](const fs::path& file) {
    try {
      readFirmware(file);
      return std::string("accepted");
    } catch (const FileError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_THAT(reason(folder_ / "no"), HasSubstr("There is no file"));
  EXPECT_THAT(reason(folder_), HasSubstr("not a regular file"));
  EXPECT_THAT(reason(write("big", std::vector<std::uint8_t>(70'000))), HasSubstr("65536"));
  // What happened, what was done, what helps.
  for (const std::string& why :
       {reason(folder_ / "no"), reason(folder_), reason(folder_ / "big")}) {
    EXPECT_THAT(why, ContainsRegex("Nothing was loaded|was not read")) << why;
    EXPECT_THAT(why, ContainsRegex("(Check|Name|Choose) [^.]*\\.(bin\\.)?$")) << why;
  }
}

TEST_F(FirmwareTest, UnreadableIsNotAbsent) {
  const fs::path file = image("home/falcon.bin", 1);
  image("share/falcon.bin", 2);
  const auto whyNot = [this] {
    std::string why;
    relievo::test::asOrdinaryAccount([&] { why = failure(); });
    return why;
  };
  EXPECT_EQ(whyNot(), "found " + file.string());
  fs::permissions(file, fs::perms::none);
  EXPECT_THAT(whyNot(), AllOf(HasSubstr(file.string()), HasSubstr("cannot be read: Permission")));
  fs::permissions(file, fs::perms::owner_read);
  fs::permissions(places_.data_home, fs::perms::none);
  EXPECT_THAT(whyNot(), AllOf(HasSubstr("home/"), HasSubstr("cannot be read: Permission")));
  places_.environment = file.string();
  EXPECT_THAT(whyNot(), AllOf(HasSubstr("cannot be read: Permission"),
                              HasSubstr("It is what RELIEVO_FALCON_FIRMWARE names")));
  fs::permissions(places_.data_home, fs::perms::owner_all);
}

TEST_F(FirmwareTest, WhatIsLoadedIsTold) {
  const fs::path file = image("named/falcon.bin", 1);
  places_.setting = file;
  const std::string hash = findFirmware(places_).sha256;
  fs::create_directories(folder_ / "data/relievo/falcon");
  fs::rename(places_.data_home / "accepted", folder_ / "data/relievo/falcon/accepted");
  setenv("XDG_DATA_HOME", (folder_ / "data").c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
  testing::internal::CaptureStderr();
  EXPECT_EQ(firmwareSource(file)(), readFirmware(file).bytes);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "relievo: Loading the Falcon's firmware \"" + file.string() + "\", " +
                std::to_string(fs::file_size(file)) + " bytes, sha256 " + hash + ".\n");
  testing::internal::CaptureStderr();
  EXPECT_THROW(firmwareSource(folder_ / "no")(), FileError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "asked again every second";
  unsetenv("XDG_DATA_HOME");  // NOLINT(concurrency-mt-unsafe)
}

TEST_F(FirmwareTest, SettingsComeBackAndNonsenseKeepsDefaults) {
  const fs::path file = folder_ / "config/relievo/falcon.conf";
  EXPECT_EQ(readSettings(file).counts_per_n_mm, 5) << "half until it is calibrated";
  writeSettings({.counts_per_n_mm = 4.237518, .left_handed = true, .firmware = "fw.bin"}, file);
  EXPECT_EQ(readSettings(file).counts_per_n_mm, 4.237518);
  EXPECT_TRUE(readSettings(file).left_handed);
  EXPECT_EQ(readSettings(file).firmware, "fw.bin");
  std::ofstream(file) << "counts_per_n_mm 1000\nleft_handed maybe\nnonsense\n\n";
  EXPECT_EQ(readSettings(file).counts_per_n_mm, 5);
  EXPECT_FALSE(readSettings(file).left_handed);
  writeSettings({.counts_per_n_mm = 6, .grip_weight_n = 0.7, .firmware = {}}, file, "A1");
  writeSettings({.counts_per_n_mm = 8, .grip_weight_n = 0.2, .firmware = "fw.bin"}, file, "B2");
  writeSettings({.counts_per_n_mm = 7, .firmware = {}}, file);
  EXPECT_EQ(readSettings(file, "A1").counts_per_n_mm, 6);
  EXPECT_EQ(readSettings(file, "A1").grip_weight_n, 0.7);
  EXPECT_EQ(readSettings(file, "B2").counts_per_n_mm, 8);
  EXPECT_EQ(readSettings(file, "C3").counts_per_n_mm, 7) << "what is said of no other";
  EXPECT_EQ(readSettings(file, "C3").grip_weight_n, 0);
  EXPECT_THROW(writeSettings({}, "/dev/null/falcon.conf"), WriteError);
}

TEST(UdevRule, IsInstalledAsItIsShown) {
  std::ifstream stream(RELIEVO_SOURCE_DIR "/haptics/device/falcon/60-relievo-falcon.rules");
  std::string rules;
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with('#')) rules += line + "\n";
  }
  EXPECT_EQ(rules, udevRule());
}

/// The value behind `key==` or `key=` in the rules.
std::string ruleValue(const std::string& key) {
  const std::string rules = udevRule();
  const std::size_t quote = rules.find('"', rules.find(key + "="));
  return rules.substr(quote + 1, rules.find('"', quote + 1) - quote - 1);
}
/// As udev does: alternatives are patterns of a shell.
bool matches(const std::string& patterns, const std::string& text) {
  std::istringstream stream(patterns);
  for (std::string pattern; std::getline(stream, pattern, '|');) {
    if (fnmatch(pattern.c_str(), text.c_str(), 0) == 0) return true;
  }
  return false;
}

TEST(UdevRule, OpensWhatCountsAsASpaceMouse) {
  const std::string kernels = ruleValue("KERNELS");
  for (const unsigned vendor : {0x256fU, 0x046dU, 0x1234U}) {
    for (unsigned product = 0xc000; product < 0xd000; ++product) {
      std::array<char, 32> name{};  // As the kernel makes it.
      std::snprintf(name.data(), name.size(), "0003:%04X:%04X.0007", vendor, product);
      EXPECT_EQ(matches(kernels, name.data()),
                hid::isSpaceMouse(static_cast<std::uint16_t>(vendor),
                                  static_cast<std::uint16_t>(product)))
          << name.data();
    }
  }
}

TEST_F(FirmwareTest, TheRuleOpensWhatHasAJoysticksDescriptorAndNoKeyboard) {
  const auto isOpened = [this](const std::vector<std::uint8_t>& descriptor) {
    std::string program = ruleValue("PROGRAM");
    const std::string node = "/sys%p/device/report_descriptor";
    program.replace(program.find(node), node.size(), write("descriptor", descriptor).string());
    std::FILE* pipe = popen(program.c_str(), "r");  // NOLINT(cert-env33-c)
    std::array<char, 100> line{};
    const bool answered = std::fgets(line.data(), line.size(), pipe) != nullptr;
    EXPECT_EQ(pclose(pipe), 0);
    return answered && matches(ruleValue("RESULT"), line.data());
  };
  for (const std::uint8_t use :
       std::vector<std::uint8_t>{4, 5, 8}) {  // Joystick, gamepad, multi-axis controller.
    EXPECT_TRUE(isOpened({0x05, 0x01, 0x09, use, 0xa1, 0x01, 0x85, 0x01, 0x75}));
    EXPECT_TRUE(isOpened({0x05, 0x01, 0x15, 0x00, 0x09, use, 0xa1, 0x01, 0xa1}));
  }
  for (const std::uint8_t use : std::vector<std::uint8_t>{2, 6, 7}) {  // Mouse, keyboard, keypad.
    EXPECT_FALSE(isOpened({0x05, 0x01, 0x09, use, 0xa1, 0x01, 0x85, 0x01, 0x75}));
  }
}

}  // namespace
}  // namespace relievo::falcon
