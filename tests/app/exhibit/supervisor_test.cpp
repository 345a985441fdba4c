// SPDX-License-Identifier: BSD-3-Clause
// The supervisor with small programs in the window's place, which crash, hang and end.
#include "app/exhibit/supervisor.h"

#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace relievo {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class SupervisorTest : public testing::Test {
 protected:
  SupervisorTest()
      : folder_(fs::path(testing::TempDir()) /
                testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~SupervisorTest() override { fs::remove_all(folder_); }

  /// @param script  after "beat", which sends a heartbeat, and "n", how often it was started again
  int run(const std::string& script, double silence_s = 30) {
    const std::string begin =
        "beat() { printf . >&$RELIEVO_HEARTBEAT_FD; }; n=$RELIEVO_EXHIBIT_STARTS; ";
    return supervise({.command = {"/bin/bash", "-c", begin + script},
                      .log = folder_ / "supervisor.log",
                      .first_beat_s = 30,
                      .silence_s = silence_s,
                      .abort_s = 0.2});
  }
  std::string log() const {
    std::ifstream in(folder_ / "supervisor.log");
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path folder_;
};

TEST_F(SupervisorTest, AProgramThatWasKilledIsStartedAgain) {
  EXPECT_EQ(run("beat; if [ $n = 0 ]; then kill -KILL $$; fi; exit 0"), 0);
  EXPECT_THAT(log(), testing::AllOf(HasSubstr("ended: signal 9"), HasSubstr(", again: 1"),
                                    HasSubstr("ended: exit status 0")));
}

TEST_F(SupervisorTest, AProgramThatHangsIsEndedAndStartedAgain) {
  EXPECT_EQ(run("beat; if [ $n = 0 ]; then exec sleep 600; fi; exit 0", 0.5), 0);
  EXPECT_THAT(log(),
              testing::AllOf(HasSubstr("no heartbeat came, signal 6"), HasSubstr(", again: 1")))
      << "SIGABRT, on which a device gets zero force";
}

TEST_F(SupervisorTest, AProgramThatIgnoresThatIsEndedByForce) {
  EXPECT_EQ(run("beat; if [ $n = 0 ]; then trap '' ABRT; exec sleep 600; fi; exit 0", 0.5), 0);
  EXPECT_THAT(log(), HasSubstr("no heartbeat came, signal 9"));
}

TEST_F(SupervisorTest, AProgramThatStandsStillIsEnded) {
  EXPECT_EQ(run("beat; if [ $n = 0 ]; then kill -STOP $$; fi; exit 0", 0.5), 0);
  EXPECT_THAT(log(), HasSubstr("no heartbeat came"));
}

TEST_F(SupervisorTest, OneThatBeatsIsLeftAlone) {
  EXPECT_EQ(run("for i in 1 2 3 4; do beat; sleep 0.3; done; exit 0", 30), 0);
  EXPECT_THAT(log(), Not(HasSubstr("again")));
}

TEST_F(SupervisorTest, ItGivesUpAfterRepeatedCrashesAndSaysSo) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(run("exit 134"), 4);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              HasSubstr("The exhibit ended 5 times within 10 minutes and was not started again."));
  EXPECT_THAT(log(), HasSubstr(", again: 4"));
  EXPECT_THAT(log(), Not(HasSubstr(", again: 5")));
}

TEST_F(SupervisorTest, WhatStartingAgainCannotMendIsHandedOn) {
  for (const int code : {1, 2, 7}) EXPECT_EQ(run("exit " + std::to_string(code)), code);
  EXPECT_THAT(log(), Not(HasSubstr("again")));
}

TEST_F(SupervisorTest, ASignalEndsTheProgramFirst) {
  const std::string ended = (folder_ / "ended").string();
  EXPECT_EQ(run("trap 'touch " + ended +
                "; exit 0' TERM; beat; kill -TERM $PPID; "
                "while :; do sleep 0.05; done"),
            128 + SIGTERM);
  EXPECT_TRUE(fs::exists(ended));
}

}  // namespace
}  // namespace relievo
