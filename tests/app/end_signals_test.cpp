// SPDX-License-Identifier: BSD-3-Clause
// The program with its window, told to end from outside: by a session that closes, a terminal that
// is closed, or Ctrl+C in it.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/project/autosave.h"
#include "tests/app/command_test.h"
#include "tests/app/program_window.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using test::eventually;
using test::ProgramWindow;

class EndSignalsTest : public test::CommandTest, public testing::WithParamInterface<int> {
 protected:
  void SetUp() override {
    for (const char* variable : {"HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME",
                                 "XDG_RUNTIME_DIR", "TMPDIR"}) {
      ASSERT_EQ(::setenv(variable, path(variable).c_str(), 1), 0);
      fs::create_directories(path(variable));
      fs::permissions(path(variable), fs::perms::owner_all);  // Qt makes one of its own else.
    }
  }
  void TearDown() override { ::unsetenv("TMPDIR"); }  // The next folder is made where it points.
  fs::path copies() const { return fs::path(path("XDG_STATE_HOME")) / "relievo/autosave"; }
  /// Sets a beacon, which no file holds, in the scan that is open.
  static bool works(ProgramWindow& window) {
    // While it is being opened, its title may have a star for a moment.
    if (!eventually([&] { return window.title() == "plane.xyz \u2013 relievo"; })) return false;
    window.key("b", true);
    return eventually([&] { return window.title().starts_with("plane.xyz*"); });
  }
  static bool endsBy(ProgramWindow& window, int signal, int next = 0) {
    ::kill(window.process(), signal);
    if (next != 0) ::kill(window.process(), next);
    return eventually([&] { return !window.runs(); });
  }
};

TEST_P(EndSignalsTest, WhatNoFileHoldsIsKeptWithoutAQuestion) {
  ProgramWindow window({plane()});
  ASSERT_TRUE(works(window));
  ASSERT_TRUE(endsBy(window, GetParam()));
  EXPECT_EQ(window.exitCode(), 128 + GetParam());
  const auto left = leftAutosaves(copies());
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(readProject(left.front()).places.size(), 1U) << "with the last step";
}

TEST_P(EndSignalsTest, WithoutWorkNothingIsLeft) {
  ProgramWindow window({plane()});
  ASSERT_TRUE(eventually([&] { return window.title().starts_with("plane.xyz"); }));
  ASSERT_TRUE(endsBy(window, GetParam()));
  EXPECT_EQ(window.exitCode(), 128 + GetParam());
  EXPECT_TRUE(leftAutosaves(copies()).empty());
  for (const auto& left : fs::directory_iterator(path("TMPDIR"))) ADD_FAILURE() << left.path();
}

TEST_P(EndSignalsTest, AVideoOfTheViewEndsWholeAndNothingIsHalfWritten) {
  ProgramWindow window({plane()});
  ASSERT_TRUE(eventually([&] { return window.title().starts_with("plane.xyz"); }));
  const fs::path videos = fs::path(path("HOME")) / "Videos/relievo";
  window.key("r", true, true);
  ASSERT_TRUE(eventually([&] { return fs::exists(videos); }));
  ASSERT_TRUE(endsBy(window, GetParam()));
  ASSERT_EQ(std::distance(fs::directory_iterator(videos), fs::directory_iterator()), 1);
  std::ifstream file(fs::directory_iterator(videos)->path(), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(bytes.find("moov"), std::string::npos) << "without it a video cannot be played";
  for (const auto& left : fs::directory_iterator(path("TMPDIR"))) ADD_FAILURE() << left.path();
}

/// A shell hands SIGHUP on and the kernel sends it as well; a session sends SIGTERM and SIGHUP.
TEST_P(EndSignalsTest, ASecondOneAtOnceBelongsToTheFirst) {
  ProgramWindow window({plane()});
  ASSERT_TRUE(works(window));
  ASSERT_TRUE(endsBy(window, GetParam(), SIGHUP));
  const int code = window.exitCode();
  EXPECT_TRUE(code == 128 + GetParam() || code == 128 + SIGHUP) << code;
  const auto left = leftAutosaves(copies());
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(readProject(left.front()).places.size(), 1U) << "with the last step";
}

INSTANTIATE_TEST_SUITE_P(Each, EndSignalsTest, testing::Values(SIGTERM, SIGHUP, SIGINT),
                         [](const testing::TestParamInfo<int>& signal) {
                           return std::string(::sigabbrev_np(signal.param));
                         });

}  // namespace
}  // namespace relievo
