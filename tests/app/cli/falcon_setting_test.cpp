// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/options/falcon_setting.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "core/base/error.h"
#include "haptics/device/falcon/firmware.h"
#include "haptics/device/falcon/settings_file.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

TEST(FalconSetting, IsTheFirstPlaceOfTheSearchAndKeepsWhatTheSetUpFound) {
  std::string folder = (fs::temp_directory_path() / "relievo-conf-XXXXXX").string();
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
  setenv("RELIEVO_FALCON_FIRMWARE", "/by/variable.bin", 1);
  falcon::writeSettings({.counts_per_n_mm = 7, .left_handed = true, .firmware = {}},
                        falcon::settingsFile());
  EXPECT_EQ(batch::falconFirmware(), "");
  batch::setFalconFirmware("/by/preference.bin");
  EXPECT_EQ(batch::falconFirmware(), "/by/preference.bin");
  const falcon::FalconSettings kept = falcon::readSettings(falcon::settingsFile());
  EXPECT_EQ(kept.counts_per_n_mm, 7);
  EXPECT_TRUE(kept.left_handed);
  try {
    falcon::storedFirmwareSource()();
    FAIL() << "there is no such file";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("/by/preference.bin"), std::string::npos)
        << error.what();
  }
  batch::setFalconFirmware({});
  EXPECT_EQ(batch::falconFirmware(), "");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace relievo
