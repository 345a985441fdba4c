// SPDX-License-Identifier: BSD-3-Clause
// Plug-ins for devices by the command line: listed, allowed, tested, touched with, replayed.
#include <gmock/gmock.h>

#include <filesystem>

#include "tests/app/command_test.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using test::CommandResult;
using testing::HasSubstr;

const std::string kStandIns = RELIEVO_BINARY_DIR "/tests/stand_ins";
const std::string kExample = RELIEVO_BINARY_DIR "/device_example";
const std::string kForceDimension = "force_dimension";
const std::string kTheirLibrary = RELIEVO_BINARY_DIR "/tests/dhd_stand_ins/whole/libdhd.so.3";

class DevicePlugins : public test::CommandTest {
 protected:
  /// Beside nothing of the user's own.
  /// @param library  of Force Dimension's; none of this computer's is looked for
  CommandResult run(const std::vector<std::string>& words, const std::string& folders = {},
                    const std::string& library = "/no/libdhd.so.3") const {
    return test::runRelievo(
        words, {"XDG_DATA_HOME=" + path("data"), "XDG_CONFIG_HOME=" + path("config"),
                "RELIEVO_FORCE_DIMENSION_LIBRARY=" + library,
                folders.empty() ? "RELIEVO_DEVICE_PATH" : "RELIEVO_DEVICE_PATH=" + folders});
  }
  /// The plug-in that comes with the program, as only its user may change it.
  std::string ours() const { return folderWith(FORCE_DIMENSION); }
  /// A folder with one plug-in, as only its user may change it, wherever this was built.
  std::string folderWith(const std::string& file) const {
    const fs::path folder = path("plug-ins");
    fs::create_directories(folder);
    fs::permissions(folder, fs::perms(0755));
    const fs::path copy = folder / fs::path(file).filename();
    fs::copy_file(file, copy, fs::copy_options::overwrite_existing);
    fs::permissions(copy, fs::perms(0755));
    return folder;
  }
  nlohmann::json listed(const std::string& folders = {}) const {
    return nlohmann::json::parse(run({"devices", "--report", "json"}, folders).out, nullptr, false);
  }
  /// Of those that do not come with the program.
  nlohmann::json othersListed(const std::string& folders = {}) const {
    nlohmann::json others = nlohmann::json::array();
    const nlohmann::json report = listed(folders);
    for (const nlohmann::json& plugin : report["plugins"]) {
      if (plugin["name"] != kForceDimension) others.push_back(plugin);
    }
    return others;
  }
};

TEST_F(DevicePlugins, NoneIsThereUntilOneIsPutThere) {
  EXPECT_TRUE(othersListed().empty());
  const nlohmann::json plugins = othersListed(folderWith(kExample + "/spring_hand.so"));
  ASSERT_EQ(plugins.size(), 1U);
  const nlohmann::json& plugin = plugins[0];
  EXPECT_EQ(plugin["name"], "spring_hand");
  EXPECT_EQ(plugin["trusted"], true);
  EXPECT_EQ(plugin["title"], "Hand on a spring");
  EXPECT_EQ(plugin["devices"][0]["id"], "plugin:spring_hand/spring.1");
}

TEST_F(DevicePlugins, OnesThatCannotBeUsedAreSaidWithTheReason) {
  const std::string given = folderWith(kStandIns + "/other_major.so");
  fs::rename(given + "/other_major.so", given + "/old.so");
  const CommandResult result = run({"devices"}, given);
  EXPECT_EQ(result.exit_code, 6);
  EXPECT_THAT(result.out, HasSubstr("plug-in old: cannot be used"));
  EXPECT_THAT(result.err, HasSubstr("version 9 of the interface for devices"));
}

TEST_F(DevicePlugins, TheUsersOwnIsAskedForOnce) {
  const std::string file = path("data/relievo/devices/mine.so");
  fs::create_directories(fs::path(file).parent_path());
  fs::copy_file(kExample + "/spring_hand.so", file);
  fs::permissions(file, fs::perms(0755));
  fs::permissions(fs::path(file).parent_path(), fs::perms(0755));
  const CommandResult before = run({"devices"});
  EXPECT_EQ(before.exit_code, 0) << before.err;
  EXPECT_THAT(before.out, HasSubstr("plug-in mine: not allowed yet"));
  EXPECT_THAT(before.err, HasSubstr("relievo devices --trust"));
  const CommandResult record =
      run({"record", test::kReliefF, "--device", "plugin:mine/spring.1", "-o", path("log.csv")});
  EXPECT_EQ(record.exit_code, 6);
  EXPECT_FALSE(fs::exists(path("log.csv")));
  EXPECT_EQ(run({"devices", "--trust", file}).exit_code, 0);
  EXPECT_THAT(run({"devices"}).out, HasSubstr("plugin:mine/spring.1: Hand on a spring"));
  EXPECT_EQ(run({"devices", "--trust", path("nothing.so")}).exit_code, 2);
  EXPECT_EQ(run({"devices", "--distrust", file}).exit_code, 0);
  EXPECT_THAT(run({"devices"}).out, HasSubstr("plug-in mine: not allowed yet"));
  const CommandResult twice = run({"devices", "--distrust", file});
  EXPECT_EQ(twice.exit_code, 6);
  EXPECT_THAT(twice.err, HasSubstr("was not allowed, so that nothing was taken back"));
}

TEST_F(DevicePlugins, ConformanceNamesTheFaultAndSaysSoByItsStatus) {
  const CommandResult good = run({"devices", "--conformance", kExample + "/spring_hand.so",
                                  "--device", "spring.1", "--seconds", "0.1"});
  EXPECT_EQ(good.exit_code, 0) << good.out << good.err;
  EXPECT_THAT(good.out, HasSubstr("C23 passed"));
  EXPECT_THAT(good.out, HasSubstr("C27 skipped"));
  const CommandResult bad = run({"devices", "--conformance", kStandIns + "/crashes.so", "--device",
                                 "stand-in.7", "--seconds", "0.1"});
  EXPECT_EQ(bad.exit_code, 1) << bad.out << bad.err;
  EXPECT_THAT(bad.out, HasSubstr("C04 passed"));
  EXPECT_THAT(bad.out, HasSubstr("C21 FAILED"));
  EXPECT_THAT(bad.out, HasSubstr("crashed (signal 11)"));
}

TEST_F(DevicePlugins, ARecordingIsReplayedWithoutThePlugIn) {
  const CommandResult record =
      run({"record", test::kReliefF, "--unit", "mm", "--device", "plugin:spring_hand/spring.1",
           "--seconds", "0.3", "-o", path("log.csv"), "--report", "json"},
          folderWith(kExample + "/spring_hand.so"));
  const nlohmann::json report = nlohmann::json::parse(record.out, nullptr, false);
  ASSERT_FALSE(report.is_discarded()) << record.out << record.err;
  EXPECT_EQ(report["device"], "plugin:spring_hand/spring.1");
  EXPECT_EQ(report["violations"], 0);
  EXPECT_THAT(test::bytesOf(path("log.csv")), HasSubstr("device told {"));
  const nlohmann::json replayed =
      test::reportOf(run({"replay", path("log.csv"), "--report", "json"}));
  EXPECT_EQ(replayed["identical"], true) << replayed;
}

TEST_F(DevicePlugins, TheOneThatComesWithTheProgramIsFoundBesideIt) {
  const nlohmann::json plugins = listed()["plugins"];
  ASSERT_EQ(plugins.size(), 1U);
  EXPECT_EQ(plugins[0]["name"], kForceDimension);
}

TEST_F(DevicePlugins, AMakersLibraryThatIsNotThereIsSaidAndIsNoFailure) {
  const CommandResult result = run({"devices"}, ours());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out,
              HasSubstr("plug-in force_dimension: Force Dimension's library was not found"));
  EXPECT_THAT(result.out, HasSubstr("(E321)"));
  const CommandResult record = run({"record", test::kReliefF, "--device",
                                    "plugin:force_dimension/device.0", "-o", path("log.csv")},
                                   ours());
  EXPECT_EQ(record.exit_code, 6);
  EXPECT_THAT(record.err, HasSubstr("Force Dimension's library was not found"));
  EXPECT_FALSE(fs::exists(path("log.csv")));
}

TEST_F(DevicePlugins, ADeviceOfForceDimensionIsListedAndTouchedWith) {
  const CommandResult list = run({"devices"}, ours(), kTheirLibrary);
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_THAT(list.out, HasSubstr("plugin:force_dimension/device.0: Force Dimension device 1"));
  const CommandResult record =
      run({"record", test::kReliefF, "--unit", "mm", "--device", "plugin:force_dimension/device.0",
           "--seconds", "0.3", "-o", path("log.csv"), "--report", "json"},
          ours(), kTheirLibrary);
  const nlohmann::json report = nlohmann::json::parse(record.out, nullptr, false);
  ASSERT_FALSE(report.is_discarded()) << record.out << record.err;
  EXPECT_EQ(report["violations"], 0);
  EXPECT_THAT(test::bytesOf(path("log.csv")), HasSubstr("device told {"));
  const nlohmann::json replayed =
      test::reportOf(run({"replay", path("log.csv"), "--report", "json"}));
  EXPECT_EQ(replayed["identical"], true) << replayed;
}

TEST_F(DevicePlugins, WhereTheirLibraryLiesIsKept) {
  const std::vector<std::string> ask{"devices", "library", "force_dimension"};
  EXPECT_THAT(run(ask).out, HasSubstr("/no/libdhd.so.3, by RELIEVO_FORCE_DIMENSION_LIBRARY"));
  const CommandResult set = run({"devices", "library", "force_dimension", kTheirLibrary});
  EXPECT_EQ(set.exit_code, 0) << set.err;
  EXPECT_THAT(set.out, HasSubstr(path("config/relievo/devices.conf")));
  EXPECT_THAT(set.err, HasSubstr("not used while a library is kept"));
  EXPECT_EQ(
      test::reportOf(run({"devices", "library", "force_dimension", "--report", "json"}))["library"],
      kTheirLibrary);
  EXPECT_THAT(run({"devices"}, ours()).out, HasSubstr("plugin:force_dimension/device.0"));
  const CommandResult missing = run({"devices", "library", "force_dimension", path("none.so")});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.err, HasSubstr("There is no file"));
  EXPECT_THAT(run({"devices"}, ours()).out, HasSubstr("plugin:force_dimension/device.0"))
      << "what was kept stays";
  EXPECT_EQ(run({"devices", "library", "nothing", kTheirLibrary}).exit_code, 6);
  EXPECT_EQ(run({"devices", "library", "force_dimension", "--forget"}).exit_code, 0);
  EXPECT_THAT(run({"devices"}, ours()).out, HasSubstr("(E321)"));
}

TEST_F(DevicePlugins, WhatWasNeverTriedOnHardwareIsSaid) {
  EXPECT_EQ(listed()["tried_on_hardware"]["falcon"], "never");
  EXPECT_EQ(listed()["tried_on_hardware"]["force_dimension"], "never");
  EXPECT_THAT(run({"devices"}).out, HasSubstr("falcon: tried on hardware: never"));
}

}  // namespace
}  // namespace relievo
