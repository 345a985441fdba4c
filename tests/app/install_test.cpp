// SPDX-License-Identifier: BSD-3-Clause
// The program where `cmake --install` puts it needs nothing of the build folder.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "tests/app/command_test.h"
#include "tests/app/program_window.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

std::string saidBy(const std::string& command) {
  std::string text;
  FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  for (int c = 0; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0) << command << ": " << text;
  return text;
}

class Install : public test::CommandTest {
 protected:
  void SetUp() override {
    for (const char* variable : {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME"}) {
      ASSERT_EQ(::setenv(variable, path(variable).c_str(), 1), 0);
    }
    ASSERT_EQ(::unsetenv("MESA_SHADER_CACHE_DIR"), 0);  // In the build's folder.
    saidBy(CMAKE_PROGRAM " --install " RELIEVO_BINARY_DIR " --prefix " + path("usr"));
  }
  std::string installed(const std::string& name) const { return path("usr/" + name); }
};

TEST_F(Install, ProgramPluginAndRuleNeedNothingOfTheBuild) {
  for (const char* name :
       {"bin/relievo", "bin/relievo-falcon-emulator", "libexec/relievo/relievo-import",
        "libexec/relievo/relievo-cli", "libexec/relievo/relievo-device-host",
        "libexec/relievo/relievo-import-pcl", "libexec/relievo/relievo-import-libraries",
        "libexec/relievo/relievo-import-web", "libexec/relievo/relievo-gdal.so",
        RELIEVO_LIBDIR "/relievo/devices/force_dimension.so",
        RELIEVO_LIBDIR "/relievo/plugins/haptics_plugin.so"}) {
    const std::string needs = saidBy("ldd " + installed(name));
    EXPECT_EQ(needs.find("not found"), std::string::npos) << name << '\n' << needs;
    EXPECT_EQ(needs.find(RELIEVO_BINARY_DIR), std::string::npos) << name << '\n' << needs;
  }
  EXPECT_TRUE(fs::exists(installed("lib/udev/rules.d/60-relievo-falcon.rules")));
  EXPECT_TRUE(fs::exists(installed("share/relievo/data/panel.ply"))) << "for the start page";
  EXPECT_TRUE(fs::exists(installed("share/doc/relievo/html/docs/user/touch.html")))
      << "for Help > Manual";
  EXPECT_TRUE(fs::exists(installed("share/man/man1/relievo.1.gz")));
  EXPECT_FALSE(fs::exists(installed("share/man/man1/relievo.1"))) << "compressed, as Debian wants";
  EXPECT_NE(saidBy(installed("bin/relievo") + " info " + plane()).find("plane.xyz"),
            std::string::npos);
}

TEST_F(Install, TheWindowOpensAScanAndHasThePlugin) {
  test::ProgramWindow window({plane(), "--unit", "mm"}, installed("bin/relievo"));
  EXPECT_TRUE(test::eventually([&] { return window.title().starts_with("plane.xyz"); }));
  const std::string maps = test::bytesOf("/proc/" + std::to_string(window.process()) + "/maps");
  EXPECT_NE(maps.find(installed(RELIEVO_LIBDIR "/relievo/plugins/haptics_plugin.so")),
            std::string::npos);
  EXPECT_EQ(maps.find(RELIEVO_BINARY_DIR), std::string::npos);
}

}  // namespace
}  // namespace relievo
