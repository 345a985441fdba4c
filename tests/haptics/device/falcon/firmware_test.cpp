// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/firmware.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "core/base/error.h"
#include "haptics/device/falcon/link_status.h"
#include "haptics/device/falcon/settings_file.h"
#include "tests/emulator/made_image.h"

namespace relievo::falcon {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
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
  EXPECT_THAT(failure(), AllOf(HasSubstr("text.bin"), HasSubstr("does not begin with AA 08")));
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
  EXPECT_EQ(firmware.known_as, "");
  EXPECT_FALSE(isAccepted(firmware, places_));
  EXPECT_EQ(installFirmware(firmware, places_), places_.data_home / "nvent_firmware.bin");
  EXPECT_TRUE(isAccepted(firmware, places_));
  EXPECT_EQ(findFirmware(places_).bytes, relievo::test::madeImage());
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
  const fs::path hidden = write("hidden", relievo::test::madeImage());
  fs::permissions(hidden, fs::perms::none);
  if (geteuid() != 0) {
    EXPECT_THAT(reason(hidden), HasSubstr("cannot be read"));
  }
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
  EXPECT_THROW(writeSettings({}, "/dev/null/falcon.conf"), WriteError);
}

TEST_F(FirmwareTest, TheRuleThatIsInstalledIsTheOneThatIsShown) {
  std::ifstream stream(RELIEVO_SOURCE_DIR "/haptics/device/falcon/60-relievo-falcon.rules");
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  EXPECT_THAT(text, HasSubstr(udevRule()));
}

}  // namespace
}  // namespace relievo::falcon
