// SPDX-License-Identifier: BSD-3-Clause
// A plugin outside of the tree: the example as a project of its own, built against what
// `cmake --install` puts there, and loaded by the program that is installed with it.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tests/app/command_test.h"
#include "tests/app/program_window.h"
#include "tests/architecture/include_table.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Said {
  int status = -1;
  std::string text;  ///< Output and errors.
};

Said said(const std::string& command) {
  Said said;
  FILE* const pipe = popen(("(" + command + ") 2>&1").c_str(), "r");
  if (pipe == nullptr) return {.status = -1, .text = "There is no shell."};
  for (int c = 0; (c = std::fgetc(pipe)) != EOF;) said.text += static_cast<char>(c);
  said.status = pclose(pipe);
  return said;
}

class PluginProject : public test::CommandTest {
 protected:
  void SetUp() override {
    for (const char* variable : {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME"}) {
      ASSERT_EQ(::setenv(variable, path(variable).c_str(), 1), 0);
    }
    ASSERT_EQ(::unsetenv("MESA_SHADER_CACHE_DIR"), 0);  // In the build's folder.
    const Said done = said(CMAKE_PROGRAM " --install " RELIEVO_BINARY_DIR " --prefix " + prefix());
    ASSERT_EQ(done.status, 0) << done.text;
  }
  std::string prefix() const { return path("usr"); }
  std::string headers() const { return prefix() + "/include/relievo"; }
  std::string example() const { return prefix() + "/share/doc/relievo-dev/examples/plugin"; }

  /// Configures and builds a project beside the installed tree.
  Said built(const std::string& source, const std::string& folder) const {
    return said(CMAKE_PROGRAM " -G Ninja -S " + source + " -B " + folder +
                " -DCMAKE_PREFIX_PATH=" + prefix() + " && " CMAKE_PROGRAM " --build " + folder);
  }
  /// A project that asks for some of relievo.
  std::string project(const std::string& asks) const {
    fs::create_directories(path("asks"));
    write("asks/CMakeLists.txt",
          "cmake_minimum_required(VERSION 3.25)\nproject(asks LANGUAGES CXX)\n" + asks);
    return path("asks");
  }
};

TEST_F(PluginProject, TheExampleIsBuiltAndLoadedByTheInstalledProgram) {
  const Said done = built(example(), path("build"));
  ASSERT_EQ(done.status, 0) << done.text;
  const std::string plugin = path("build/example_plugin.so");
  ASSERT_TRUE(fs::exists(plugin));
  ASSERT_EQ(::setenv("RELIEVO_PLUGIN_PATH", path("build").c_str(), 1), 0);
  test::ProgramWindow window({plane(), "--unit", "mm"}, prefix() + "/bin/relievo");
  EXPECT_TRUE(test::eventually([&] { return window.title().starts_with("plane.xyz"); }));
  const std::string maps = test::bytesOf("/proc/" + std::to_string(window.process()) + "/maps");
  EXPECT_THAT(maps, HasSubstr(plugin));
  EXPECT_THAT(maps, testing::Not(HasSubstr(RELIEVO_BINARY_DIR)));
}

TEST_F(PluginProject, EveryInstalledHeaderCompilesAloneAndIncludesOnlyInstalledOnes) {
  std::string sources;
  std::vector<std::string> found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(headers())) {
    if (!entry.is_regular_file()) continue;
    const std::string header = fs::relative(entry.path(), headers());
    found.push_back(header);
    for (const auto& include : architecture::includesOf(test::bytesOf(entry.path()))) {
      if (!include.quoted) continue;
      EXPECT_TRUE(fs::exists(headers() + "/" + include.header))
          << header << " includes " << include.header << ", which is not installed";
    }
    const std::string source = "header" + std::to_string(found.size()) + ".cpp";
    fs::create_directories(path("asks"));
    write("asks/" + source, "#include \"" + header + "\"\n");
    sources += ' ' + source;
  }
  EXPECT_THAT(found, testing::Contains("plugins/api/plugin.h"));
  const Said done = built(project("find_package(relievo REQUIRED COMPONENTS plugins)\n"
                                  "add_library(headers OBJECT" +
                                  sources +
                                  ")\n"
                                  "target_link_libraries(headers PRIVATE relievo::plugins_api)\n"),
                          path("build"));
  EXPECT_EQ(done.status, 0) << done.text;
}

TEST_F(PluginProject, SaysWhatItHasNot) {
  const Said component =
      built(project("find_package(relievo REQUIRED COMPONENTS sails)\n"), path("build"));
  EXPECT_NE(component.status, 0);
  EXPECT_THAT(component.text, HasSubstr("relievo has no component \"sails\""));
  const Said version = built(project("find_package(relievo 99 REQUIRED)\n"), path("build99"));
  EXPECT_NE(version.status, 0);
  EXPECT_THAT(version.text, HasSubstr("requested version \"99\""));
}

TEST_F(PluginProject, TellsItsVersions) {
  const Said done =
      built(project("find_package(relievo " RELIEVO_VERSION_STRING " REQUIRED COMPONENTS plugins)\n"
                    "message(\"interface ${relievo_PLUGIN_VERSION} in "
                    "${relievo_PLUGIN_DIR}\")\nadd_custom_target(all_of_it ALL)\n"),
            path("build"));
  EXPECT_EQ(done.status, 0) << done.text;
  EXPECT_THAT(done.text, HasSubstr("interface 2 in " + prefix()));
}

}  // namespace
}  // namespace relievo
