// SPDX-License-Identifier: BSD-3-Clause
// Where plug-ins for devices are looked for, and which may run.
#include "haptics/device/foreign/plugin_files.h"

#include <fstream>

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
    }
  }
  void put(const fs::path& place) const { fs::copy_file(test::standIn("none"), place); }
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

TEST_F(PluginFilesTest, AListThatWasCutShortTrustsNothing) {
  put(places.own / "mine.so");
  fs::create_directories(places.list.parent_path());
  const std::string sum = trustPlugin(places.own / "mine.so", places);
  std::ofstream(places.list) << sum.substr(0, 63) << "\n\n";
  EXPECT_FALSE(pluginFiles(places).at(0).trusted);
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
  ASSERT_EQ(::setenv("RELIEVO_DEVICE_PATH", test::standIn("none").parent_path().c_str(), 1), 0);
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
