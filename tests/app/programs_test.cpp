// SPDX-License-Identifier: BSD-3-Clause
// `relievo` without the programs that draw beside it, as on a cluster: all verbs that draw nothing
// work, the others say what is not installed, and no library of graphics is loaded (docs/adr/0151).
#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string_view>

#include "tests/app/command_test.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::AnyOf;
using testing::Each;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

struct Said {
  int exit_code = -1;
  std::string text;  ///< Output and errors.
};

class Programs : public test::CommandTest {
 protected:
  void SetUp() override {
    test::CommandTest::SetUp();
    fs::create_directory(path("bin"));
    for (const char* name :
         {"relievo", "relievo-cli", "relievo-import", "relievo-import-pcl",
          "relievo-import-libraries", "relievo-import-web", "relievo-prepare", "relievo-gdal.so"}) {
      fs::copy_file(fs::path(RELIEVO_BINARY_DIR) / "bin" / name, path("bin") + "/" + name);
    }
  }
  /// Of this command of a shell.
  static Said said(const std::string& command) {
    FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
    Said said;
    std::array<char, 4096> buffer{};
    while (pipe != nullptr && std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) {
      said.text += buffer.data();
    }
    const int status = pipe == nullptr ? -1 : pclose(pipe);
    said.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return said;
  }
  Said alone(const std::string& words) const { return said(path("bin") + "/relievo " + words); }
};

TEST_F(Programs, TheCommandLineLoadsNoLibraryOfGraphics) {
  const Said needs = said("ldd " + path("bin") + "/relievo-cli");
  ASSERT_EQ(needs.exit_code, 0);
  for (const char* library :
       {"libQt5", "libvtkRendering", "libGL", "libX11", "libqwt", "libpcl_"}) {
    EXPECT_THAT(needs.text, Not(HasSubstr(library)));
  }
}

// GDAL and what it needs take longer to load than a small scan to read; most verbs never call it.
TEST_F(Programs, TheCommandLineLoadsGdalWhenItIsCalled) {
  const Said needs = said("ldd " + path("bin") + "/relievo-cli");
  ASSERT_EQ(needs.exit_code, 0);
  EXPECT_THAT(needs.text, Not(HasSubstr("libgdal")));
  const std::string map = path("map.tif");
  const std::string loads = "LD_DEBUG=files " + path("bin") + "/relievo-cli ";
  const std::string scan = "'" + plane() + "' --unit mm ";
  EXPECT_THAT(said(loads + "info " + scan).text, Not(HasSubstr("libgdal")));
  EXPECT_THAT(said(loads + "depthmap " + scan + "-o " + map).text, HasSubstr("libgdal"));
  EXPECT_TRUE(fs::exists(map));
}

TEST_F(Programs, WithoutItsGdalItSaysSoAndWritesNothing) {
  fs::remove(path("bin") + "/relievo-gdal.so");
  const std::string map = path("map.tif");
  const Said refused = alone("depthmap '" + plane() + "' --unit mm -o " + map);
  EXPECT_EQ(refused.exit_code, 2) << refused.text;
  EXPECT_THAT(refused.text, HasSubstr("The part relievo-gdal.so of relievo cannot be loaded"));
  EXPECT_FALSE(fs::exists(map));
  std::ofstream(path("bin") + "/relievo-gdal.so") << "no library";
  EXPECT_EQ(alone("depthmap '" + plane() + "' --unit mm -o " + map).exit_code, 2);
  EXPECT_EQ(alone("info '" + plane() + "' --unit mm").exit_code, 0) << "needs none";
}

// PCL's parser of PLY comes without the libraries that PCL's other readers bring.
TEST_F(Programs, PlyNeedsNoneOfTheLargerImportPrograms) {
  const std::string ply = path("three.ply");
  const std::array<float, 9> points{0, 0, 0, 1, 0, 0.5, 0, 1, 0.25};
  std::ofstream(ply, std::ios::binary)
      << "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
         "property float y\nproperty float z\nend_header\n"
      << std::string_view(reinterpret_cast<const char*>(points.data()), sizeof(points));
  fs::remove(path("bin") + "/relievo-import-pcl");
  fs::remove(path("bin") + "/relievo-import-libraries");
  const Said read = alone("info '" + ply + "' --unit mm --report json");
  EXPECT_EQ(read.exit_code, 0) << read.text;
  EXPECT_THAT(read.text, HasSubstr("PCL 1."));
  const Said loads = said("ldd " + path("bin") + "/relievo-import");
  EXPECT_THAT(loads.text, AllOf(HasSubstr("libpcl_io_ply"), Not(HasSubstr("libvtk"))));
}

// It chooses the program, and answers --version: nothing is loaded for that but the language's own.
TEST_F(Programs, WhatPeopleStartLoadsNoLibraryOfAnybody) {
  const Said needs = said("ldd " + path("bin") + "/relievo | grep '=>' | sed 's/[.]so.*//'");
  ASSERT_EQ(needs.exit_code, 0);
  std::istringstream lines(needs.text);
  std::vector<std::string> libraries;
  for (std::string line; lines >> line;) libraries.push_back(line);
  EXPECT_THAT(libraries, Each(AnyOf("libstdc++", "libm", "libgcc_s", "libc")));
  fs::remove(path("bin") + "/relievo-cli");
  const Said version = alone("--version");
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.text, AllOf(StartsWith("relievo "), HasSubstr("\ncommit ")));
  const Said refused = alone("info '" + plane() + "'");
  EXPECT_EQ(refused.exit_code, 7) << refused.text;
  EXPECT_THAT(refused.text, HasSubstr("The program relievo-cli cannot be started"));
}

TEST_F(Programs, LibrariesAreThoseThatAreThere) {
  const Said own = alone("--libraries");
  EXPECT_EQ(own.exit_code, 0) << own.text;
  EXPECT_THAT(own.text, AllOf(StartsWith("relievo "), HasSubstr("GDAL "), Not(HasSubstr("VTK "))));
}

TEST_F(Programs, VerbsThatDrawNothingNeedNoOther) {
  const std::string scan = "'" + plane() + "' --unit mm ", map = path("map.tif");
  EXPECT_EQ(alone("--version").exit_code, 0);
  EXPECT_THAT(alone("--help").text, HasSubstr("  video "));
  const std::vector<std::string> commands{"info " + scan,
                                          "depthmap " + scan + "-o " + map,
                                          "pyramid " + scan + "-o " + path("levels"),
                                          "convert " + scan + path("map.asc"),
                                          "measure " + scan + "--report json --profile 1,1,5,5",
                                          "devices --report json"};
  for (const std::string& words : commands) {
    const Said done = alone(words);
    EXPECT_EQ(done.exit_code, 0) << words << '\n' << done.text;
  }
  EXPECT_TRUE(fs::exists(map));
}

TEST_F(Programs, VerbsThatDrawSayWhatIsMissing) {
  const std::string scan = "'" + plane() + "' --unit mm ", out = path("out.png");
  for (const char* words : {"render ", "figure "}) {
    const Said refused = alone(words + scan + "-o " + out);
    EXPECT_EQ(refused.exit_code, 7) << refused.text;
    EXPECT_THAT(refused.text,
                HasSubstr("the program relievo-draw, which does it, is not installed"));
  }
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(Programs, TheDepthBufferIsOfTheProgramThatDraws) {
  const std::string map = path("map.tif");
  const Said refused = alone("depthmap '" + plane() + "' --unit mm --engine depthbuffer -o " + map);
  EXPECT_EQ(refused.exit_code, 7) << refused.text;
  EXPECT_THAT(refused.text, HasSubstr("relievo-draw"));
  EXPECT_FALSE(fs::exists(map));
}

TEST_F(Programs, WithoutAVerbTheWindowIsMissing) {
  const Said refused = alone("'" + plane() + "'");
  EXPECT_EQ(refused.exit_code, 7) << refused.text;
  EXPECT_THAT(refused.text, HasSubstr("The window is not installed."));
}

}  // namespace
}  // namespace relievo
