// SPDX-License-Identifier: BSD-3-Clause
// The exhibit's own window under its supervisor, on this screen: killed, and standing still. How
// long visitors wait is printed; what happens is tested.
#include <gmock/gmock.h>

#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "tests/app/command_test.h"
#include "tests/app/program_window.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ExhibitProgram : public testing::Test {
 protected:
  ExhibitProgram() : folder_(fs::path(testing::TempDir()) / "exhibit_program") {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "bin");
    for (const char* variable :
         {"HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_RUNTIME_DIR"}) {
      ::setenv(variable, folder_.c_str(), 1);
    }
    // No service speaks; a program in espeak-ng's place writes down what it would say.
    ::setenv("SPEECHD_ADDRESS", ("unix_socket:" + (folder_ / "nobody").string()).c_str(), 1);
    const fs::path speaker = folder_ / "bin/espeak-ng";
    std::ofstream(speaker) << "#!/bin/sh\ncat >>" << said().string() << "\necho >>"
                           << said().string() << '\n';
    ::chmod(speaker.c_str(), S_IRWXU);
    const char* path = std::getenv("PATH");
    ::setenv("PATH", ((folder_ / "bin").string() + ":" + (path == nullptr ? "" : path)).c_str(), 1);
    std::ofstream(folder_ / "exhibit.json")
        << R"({"relievo_exhibit": 1, "languages": ["en"], "records": "records",
  "objects": [{"file": ")" RELIEVO_SOURCE_DIR R"(/data/samples/coin.ply", "unit": "mm",
               "view": "top", "title": {"en": "A coin"}}],
  "staff_pin": {"salt": "salt", "sha256": ")"
        << std::string(64, '0') << "\"}}\n";
  }
  ~ExhibitProgram() override { fs::remove_all(folder_); }

  fs::path said() const { return folder_ / "said"; }
  std::string log() const { return test::bytesOf(folder_ / "records/supervisor.log"); }
  /// Of the window that was started last; 0: none was.
  int window() const {
    const std::string text = log(), before = "started as process ";
    const std::size_t at = text.rfind(before);
    return at == std::string::npos ? 0 : std::stoi(text.substr(at + before.size()));
  }
  std::size_t moments() const {
    const std::string text = fs::exists(said()) ? test::bytesOf(said()) : std::string();
    std::size_t count = 0;
    for (std::size_t at = text.find("One moment please."); at != std::string::npos;
         at = text.find("One moment please.", at + 1)) {
      ++count;
    }
    return count;
  }
  /// Sends a signal to the window; another one must come, and say so to whoever waits.
  void loseWindow(int signal, const std::string& start) {
    const int lost = window();
    ASSERT_GT(lost, 0);
    const std::size_t before = moments();
    const auto began = std::chrono::steady_clock::now();
    ASSERT_EQ(::kill(lost, signal), 0);
    ASSERT_TRUE(test::eventually([&] { return moments() > before; })) << log();
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - began;
    std::cout << "after signal " << signal << " visitors heard of it in " << waited.count()
              << " s\n";
    EXPECT_THAT(log(), HasSubstr(start));
    EXPECT_NE(window(), lost);
    EXPECT_NE(::kill(lost, 0), 0) << "the lost one is gone";
  }

  fs::path folder_;
};

TEST_F(ExhibitProgram, AWindowThatIsKilledOrStandsStillIsBackAndSaysSo) {
  test::ProgramWindow exhibit({"--exhibit", (folder_ / "exhibit.json").string()});
  ASSERT_TRUE(test::eventually([&] {
    return fs::exists(folder_ / "records/health.log") && !exhibit.title().empty();
  })) << log();
  EXPECT_EQ(moments(), 0U) << "nothing was lost yet";
  loseWindow(SIGKILL, ", again: 1");
  if (HasFatalFailure()) return;
  EXPECT_THAT(log(), HasSubstr("signal 9"));
  loseWindow(SIGSTOP, ", again: 2");
  if (HasFatalFailure()) return;
  EXPECT_THAT(log(), HasSubstr("no heartbeat came"));
  EXPECT_THAT(test::bytesOf(folder_ / "records/health.log"), HasSubstr("again: 2"));
  ASSERT_EQ(::kill(exhibit.process(), SIGTERM), 0);
  ASSERT_TRUE(test::eventually([&] { return !exhibit.runs(); }));
  EXPECT_EQ(exhibit.exitCode(), 128 + SIGTERM);
}

}  // namespace
}  // namespace relievo
