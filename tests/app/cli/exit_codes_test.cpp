// SPDX-License-Identifier: BSD-3-Clause
// How the command line ends where something refuses: a report that nobody can take, Ctrl+C, and
// what is said of a level that a region cannot carry.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <thread>

#include "tests/app/command_test.h"

namespace relievo {
namespace {

using test::CommandResult;
using test::kReliefF;
using test::runRelievo;
using testing::HasSubstr;
using testing::Not;

class ExitCodes : public test::CommandTest {
 protected:
  /// The built program with its output into these files. @return its process
  static pid_t started(std::vector<std::string> words, const std::string& out,
                       const std::string& err) {
    words.insert(words.begin(), RELIEVO_BINARY_DIR "/bin/relievo");
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    for (const auto& [file, to] : {std::pair{out, STDOUT_FILENO}, {err, STDERR_FILENO}}) {
      const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      if (opened < 0 || dup2(opened, to) < 0) _exit(125);
    }
    execv(argv[0], argv.data());
    _exit(126);
  }
  static int statusOf(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return status;
  }
  /// Does the process keep this signal for itself? Until then it would die of it.
  static bool takes(pid_t child, int signal) {
    std::ifstream status("/proc/" + std::to_string(child) + "/status");
    for (std::string line; std::getline(status, line);) {
      if (!line.starts_with("SigBlk:")) continue;
      const std::uint64_t blocked = std::stoull(line.substr(7), nullptr, 16);
      return (blocked >> static_cast<unsigned>(signal - 1) & 1U) != 0;
    }
    return false;
  }
};

TEST_F(ExitCodes, AWordThatIsNoVerbIsMisuseWithAndWithoutAScreen) {
  for (const std::vector<std::string>& unset : {std::vector<std::string>{}, {"DISPLAY"}}) {
    const CommandResult near = test::runRelievo({"figrue", plane(), "-o", path("f.png")}, unset);
    EXPECT_EQ(near.exit_code, 1);
    EXPECT_NE(near.err.find("Did you mean 'relievo figure'?"), std::string::npos) << near.err;
    const CommandResult far = test::runRelievo({"bogus"}, unset);
    EXPECT_EQ(far.exit_code, 1);
    EXPECT_EQ(far.err.find("Did you mean"), std::string::npos) << far.err;
    EXPECT_NE(far.err.find("'relievo --help' lists the verbs"), std::string::npos) << far.err;
  }
  // Also behind options of the window.
  for (const std::vector<std::string>& unset : {std::vector<std::string>{}, {"DISPLAY"}}) {
    const CommandResult late = test::runRelievo({"--lang", "de", "figrue"}, unset);
    EXPECT_EQ(late.exit_code, 1);
    EXPECT_THAT(late.err, HasSubstr("Did you mean 'relievo figure'?"));
    const CommandResult verb = test::runRelievo({"--lang", "de", "info", plane()}, unset);
    EXPECT_EQ(verb.exit_code, 1);
    EXPECT_THAT(verb.err, HasSubstr("The verb 'info' stands before all options."));
    EXPECT_EQ(test::runRelievo({"--lang", "de", "--", "figrue"}, {"DISPLAY"}).exit_code, 7);
  }
  // A file by its look is told about where files are, and none of these opens a window here.
  EXPECT_EQ(test::runRelievo({"scan.ply"}, {"DISPLAY"}).exit_code, 7);
  EXPECT_EQ(test::runRelievo({"./figrue"}, {"DISPLAY"}).exit_code, 7);
}

TEST_F(ExitCodes, AReportThatStandardOutputDoesNotTakeIsExitThree) {
  const std::string scan = plane();
  for (const char* format : {"text", "json"}) {
    const int status = statusOf(
        started({"info", scan, "--unit", "mm", "--report", format}, "/dev/full", path("err")));
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 3) << format;
    EXPECT_THAT(test::bytesOf(path("err")),
                HasSubstr("The report could not be written to standard output."));
  }
}

TEST_F(ExitCodes, CtrlCAndTerminationEndTheWorkWithExit130AndLeaveNoFile) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const std::string map = path("map.tif");
    const pid_t child =
        // Enough work that a busy machine cannot finish it before the signal.
        started({"depthmap", kReliefF, "--unit", "mm", "--cells", "5000", "--quality", "-o", map},
                path("out"), path("err"));
    while (!takes(child, signal) && kill(child, 0) == 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    kill(child, signal);
    const int status = statusOf(child);
    ASSERT_TRUE(WIFEXITED(status)) << "it ended by itself, not by signal " << signal;
    EXPECT_EQ(WEXITSTATUS(status), 130) << test::bytesOf(path("err"));
    EXPECT_FALSE(std::filesystem::exists(map));
  }
}

TEST_F(ExitCodes, OnlyALevelThatIsFinerThanTheRegionCarriesIsToldToAlias) {
  const auto touched = [this](const std::vector<std::string>& level) {
    return runRelievo(test::joined(
        {"touch", kReliefF, "--unit", "mm", "--view", "top", "--region", "100,20,150,150",
         "--stroke", test::kFlatStroke, "-o", path("log.csv"), "--report", "json"},
        level));
  };
  const CommandResult fitting = touched({});
  ASSERT_EQ(fitting.exit_code, 0) << fitting.err;
  const int level = nlohmann::json::parse(fitting.out)["level"].get<int>();
  ASSERT_GT(level, 0);
  EXPECT_THAT(fitting.err, Not(HasSubstr("aliases"))) << "chosen by itself";
  const CommandResult given = touched({"--level", std::to_string(level)});
  EXPECT_EQ(given.exit_code, 0);
  EXPECT_THAT(given.err, Not(HasSubstr("aliases"))) << "the same, given";
  const CommandResult finer = touched({"--level", std::to_string(level - 1)});
  EXPECT_EQ(finer.exit_code, 0);
  EXPECT_THAT(finer.err, HasSubstr("fine structure aliases. Level " + std::to_string(level) +
                                   " fits, or choose a smaller region."));
}

}  // namespace
}  // namespace relievo
