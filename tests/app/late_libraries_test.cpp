// SPDX-License-Identifier: BSD-3-Clause
// The program starts and views where libusb and hidapi are not: the loader finds stand-ins that are
// no libraries. What needs them says so.
#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <cstdlib>

#include "tests/app/command_test.h"
#include "tests/app/program_window.h"

namespace relievo {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class LateLibraries : public test::CommandTest {
 protected:
  void SetUp() override {
    test::CommandTest::SetUp();
    for (const char* variable : {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME"}) {
      ASSERT_EQ(::setenv(variable, path(variable).c_str(), 1), 0);
    }
    std::filesystem::create_directory(path("broken"));
    for (const char* library : {"libusb-1.0.so.0", "libhidapi-hidraw.so.0"}) {
      write(std::string("broken/") + library, "this is no library");
    }
    ASSERT_EQ(::setenv("LD_LIBRARY_PATH", path("broken").c_str(), 1), 0);
  }
  void TearDown() override { ::unsetenv("LD_LIBRARY_PATH"); }
};

TEST_F(LateLibraries, TheWindowShowsAScanWithoutThem) {
  test::ProgramWindow window({plane(), "--unit", "mm"});
  EXPECT_TRUE(test::eventually([&] { return window.title().starts_with("plane.xyz"); }));
  const std::string maps = test::bytesOf("/proc/" + std::to_string(window.process()) + "/maps");
  EXPECT_THAT(maps, HasSubstr("/haptics_plugin.so")) << "the mouse is its hand";
}

TEST_F(LateLibraries, TheCommandLineWorksWithoutThem) {
  EXPECT_EQ(
      test::runRelievo({"depthmap", plane(), "--unit", "mm", "-o", path("map.tif")}).exit_code, 0);
  const test::CommandResult version = test::runRelievo({"--libraries"});
  EXPECT_EQ(version.exit_code, 0) << version.err;
  EXPECT_THAT(version.out, HasSubstr("libusb not installed"));
  EXPECT_THAT(version.out, HasSubstr("hidapi not installed"));
}

TEST_F(LateLibraries, DevicesAreListedAndTheReasonIsSaid) {
  const test::CommandResult listed = test::runRelievo({"devices"});
  EXPECT_EQ(listed.exit_code, 0) << listed.err;
  EXPECT_THAT(listed.out, HasSubstr("mouse"));
  EXPECT_THAT(listed.out + listed.err, HasSubstr("libhidapi-hidraw.so.0"));
  const test::CommandResult falcon =
      test::runRelievo({"record", plane(), "--unit", "mm", "--device", "falcon", "--seconds", "0.1",
                        "-o", path("log.csv")});
  EXPECT_EQ(falcon.exit_code, 6) << falcon.err;
  EXPECT_THAT(falcon.err, AllOf(HasSubstr("USB cannot be used"), HasSubstr("libusb-1.0.so.0")));
}

}  // namespace
}  // namespace relievo
