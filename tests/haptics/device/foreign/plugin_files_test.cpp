// SPDX-License-Identifier: BSD-3-Clause
// Where plug-ins for devices are looked for, and which may run.
#include "haptics/device/foreign/plugin_files.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "core/base/error.h"
#include "haptics/device/foreign/ask_host.h"
#include "haptics/device_catalog.h"
#include "tests/haptics/device/foreign/foreign_fixture.h"

namespace relievo::foreign {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class PluginFilesTest : public test::ForeignTest {
 protected:
  void SetUp() override {
    ForeignTest::SetUp();
    places = {.trusted = {folder / "given", folder / "installed"},
              .own = folder / "own",
              .list = folder / "settings/trusted-devices"};
    for (const fs::path& place : {places.trusted[0], places.trusted[1], places.own}) {
      fs::create_directories(place);
      fs::permissions(place, fs::perms(0755));
    }
  }
  static void put(const fs::path& place) {
    fs::copy_file(test::standIn("none"), place);
    fs::permissions(place, fs::perms(0755));
  }
  std::string refusal(const std::string& id) const {
    try {
      makePluginDevice(id, places);
    } catch (const DeviceError& error) {
      return error.what();
    }
    return "it is there";
  }
  PluginPlaces places;
};

TEST_F(PluginFilesTest, AreSharedLibrariesInTheirFolders) {
  EXPECT_TRUE(pluginFiles(places).empty());
  put(places.trusted[0] / "b.so");
  put(places.trusted[1] / "a.so");
  put(places.trusted[1] / "b.so");
  std::ofstream(places.trusted[1] / "notes.txt") << "no plug-in";
  fs::create_directories(places.trusted[1] / "folder.so");
  const std::vector<PluginFile> files = pluginFiles(places);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].name, "b");
  EXPECT_EQ(files[0].file, places.trusted[0] / "b.so") << "the first of its name";
  EXPECT_EQ(files[1].name, "a");
  EXPECT_TRUE(files[0].trusted);
  EXPECT_TRUE(files[1].trusted);
}

TEST_F(PluginFilesTest, TheUsersOwnIsAllowedOnceAndNotWhenItChanged) {
  const fs::path file = places.own / "mine.so";
  put(file);
  EXPECT_FALSE(pluginFiles(places).at(0).trusted);
  EXPECT_THAT(refusal("plugin:mine/stand-in.7"), HasSubstr("was not allowed yet"));
  const std::string sum = trustPlugin(file, places);
  EXPECT_EQ(sum.size(), 64U);
  EXPECT_EQ(trustPlugin(file, places), sum) << "twice is once";
  EXPECT_TRUE(pluginFiles(places).at(0).trusted);
  EXPECT_EQ(refusal("plugin:mine/stand-in.7"), "it is there");
  std::ofstream(file, std::ios::app) << "changed";
  EXPECT_FALSE(pluginFiles(places).at(0).trusted);
  trustPlugin(file, places);
  EXPECT_TRUE(pluginFiles(places).at(0).trusted);
}

TEST_F(PluginFilesTest, WhatWasAllowedCanBeTakenBackAlsoOfAFileThatIsGone) {
  put(places.own / "mine.so");
  put(places.own / "other.so");
  std::ofstream(places.own / "other.so", std::ios::app) << "differs";
  EXPECT_TRUE(pluginFiles(places).at(0).own);
  EXPECT_THROW(distrustPlugin(places.own / "mine.so", places), DeviceError) << "it was not allowed";
  trustPlugin(places.own / "mine.so", places);
  trustPlugin(places.own / "other.so", places);
  distrustPlugin(places.own / "mine.so", places);
  EXPECT_FALSE(pluginFiles(places).at(0).trusted);
  EXPECT_TRUE(pluginFiles(places).at(1).trusted) << "that of others stays";
  fs::remove(places.own / "other.so");
  distrustPlugin(places.own / "other.so", places);
  put(places.own / "other.so");
  std::ofstream(places.own / "other.so", std::ios::app) << "differs";
  EXPECT_FALSE(pluginFiles(places).at(1).trusted) << "and it comes back";
  // An earlier form of it is meant as well.
  trustPlugin(places.own / "mine.so", places);
  std::ofstream(places.own / "mine.so", std::ios::app) << "newer";
  distrustPlugin(places.own / "mine.so", places);
  fs::remove(places.own / "mine.so");
  put(places.own / "mine.so");
  EXPECT_FALSE(pluginFiles(places).at(0).trusted);
}

TEST_F(PluginFilesTest, AListThatWasCutShortTrustsNothing) {
  put(places.own / "mine.so");
  fs::create_directories(places.list.parent_path());
  const std::string sum = trustPlugin(places.own / "mine.so", places);
  std::ofstream(places.list) << sum.substr(0, 63) << "\n\n";
  EXPECT_FALSE(pluginFiles(places).at(0).trusted);
}

TEST_F(PluginFilesTest, WhatOthersMayChangeIsNotRun) {
  const fs::path file = places.trusted[0] / "a.so", mine = places.own / "mine.so";
  put(file);
  put(mine);
  fs::create_directories(places.list.parent_path());
  trustPlugin(mine, places);
  const auto trusted = [&](std::size_t i) { return pluginFiles(places).at(i).trusted; };
  EXPECT_TRUE(trusted(0));
  EXPECT_TRUE(trusted(1));
  for (const fs::path& open : {file, mine, places.trusted[0], places.own}) {
    fs::permissions(open, fs::perms(0775));
    const std::size_t which = open == file || open == places.trusted[0] ? 0 : 1;
    EXPECT_FALSE(trusted(which)) << open;
    EXPECT_THAT(englishText(*pluginFiles(places).at(which).why_not), HasSubstr(open.string()));
    EXPECT_THAT(refusal(which == 0 ? "plugin:a/stand-in.7" : "plugin:mine/stand-in.7"),
                HasSubstr("others may change"));
    if (which == 1) {
      EXPECT_THROW(trustPlugin(mine, places), DeviceError);
    }
    fs::permissions(open, fs::perms(0755));
  }
  fs::permissions(places.list, fs::perms(0666));
  EXPECT_FALSE(trusted(1)) << "a list that others write";
}

TEST_F(PluginFilesTest, WhatIsChangedAfterItWasListedIsNotTrusted) {
  put(places.own / "mine.so");
  fs::create_directories(places.list.parent_path());
  trustPlugin(places.own / "mine.so", places);
  const PluginFile listed = pluginFiles(places).at(0);
  EXPECT_EQ(trustedImage(listed, places).sha256.size(), 64U);
  std::ofstream(places.own / "mine.so", std::ios::app) << "changed";
  EXPECT_THROW(trustedImage(listed, places), DeviceError);
}

TEST_F(PluginFilesTest, ANameCannotWriteALineOfTheList) {
  const fs::path other = places.own / "other.so";
  put(other);
  const std::string sum = readPlugin(other).sha256;
  const fs::path named = folder / ("x\n" + sum + "  y\033[2J.so");
  fs::copy_file(test::standIn("weak"), named);
  fs::permissions(named, fs::perms(0755));
  fs::create_directories(places.list.parent_path());
  trustPlugin(named, places);
  EXPECT_FALSE(pluginFiles(places).at(0).trusted);
  std::string text(std::istreambuf_iterator<char>(std::ifstream(places.list).rdbuf()), {});
  EXPECT_EQ(text.find('\033'), std::string::npos);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  fs::copy_file(named, places.own / ("a\033b.so"));
  EXPECT_EQ(pluginFiles(places).size(), 1U) << "a name that no id can have";
}

TEST_F(PluginFilesTest, WhatCannotBeReadIsNotTrusted) {
  EXPECT_THROW(trustPlugin(folder / "nothing.so", places), FileError);
  EXPECT_THROW(trustPlugin(folder, places), FileError);
}

TEST_F(PluginFilesTest, NamesThatAreNoneAreRefused) {
  for (const char* const id : {"plugin", "plugin:", "plugin:x", "plugin:x/", "other:x/y"}) {
    EXPECT_THAT(refusal(id), HasSubstr("names no device of a plug-in")) << id;
  }
  EXPECT_THAT(refusal("plugin:nothing/stand-in.7"), HasSubstr("no plug-in \"nothing\""));
  EXPECT_THAT(refusal("plugin:../none/stand-in.7"), HasSubstr("no plug-in \"..\""));
}

/// As `--device plugin:none/stand-in.7` does.
TEST_F(PluginFilesTest, ADeviceIsMadeByItsNameAndRuns) {
  put(places.trusted[0] / "none.so");
  ASSERT_EQ(::setenv("RELIEVO_DEVICE_PATH", places.trusted[0].c_str(), 1), 0);
  const std::unique_ptr<Device> device = makeDevice("plugin:none/stand-in.7");
  EXPECT_EQ(device->info().id, "plugin:none/stand-in.7");
  // On a busy computer the host may be silent for longer than a hand can wait: then it is opened
  // again.
  DeviceFault seen = DeviceFault::timeout;
  while (seen != DeviceFault::none) {
    device->open();
    test::exchangeUntil(*device, {}, [&seen](const DeviceReading& reading) {
      seen = reading.fault;
      return seen == DeviceFault::none || seen == DeviceFault::timeout ||
             seen == DeviceFault::disconnected;
    });
    device->close();
  }
  EXPECT_THROW(makeDevice("plugin:none/stand-in.8")->open(), DeviceError);
}

}  // namespace
}  // namespace relievo::foreign
