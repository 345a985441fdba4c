// SPDX-License-Identifier: BSD-3-Clause
// The program itself, started with a file: a project or a picture brings back its state.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/app/command_test.h"
#include "tests/app/program_window.h"

namespace relievo {
namespace {

class OpenArgument : public test::CommandTest {
 protected:
  void SetUp() override {
    for (const char* variable : {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME"}) {
      ASSERT_EQ(::setenv(variable, path(variable).c_str(), 1), 0);
    }
    ASSERT_EQ(test::runRelievo({"render", plane(), "-o", path("fig.png")}).exit_code, 0);
    ASSERT_EQ(test::runRelievo({"project", "new", path("fig.png"), "-o", path("work.relievo.json")})
                  .exit_code,
              0);
  }
  /// The window names what is open as soon as its scan is.
  bool opens(const std::string& file, const std::string& title) const {
    test::ProgramWindow window({path(file)});
    return test::eventually([&] { return window.title().starts_with(title); });
  }
};

TEST_F(OpenArgument, OpensWhatAProjectShows) {
  EXPECT_TRUE(opens("work.relievo.json", "work.relievo.json \u2013 relievo"));
}

TEST_F(OpenArgument, OpensWhatAPictureShows) {
  EXPECT_TRUE(opens("fig.png", "plane.xyz"));
}

}  // namespace
}  // namespace relievo
