// SPDX-License-Identifier: BSD-3-Clause
// What a process that reads foreign bytes can still do, tried from within it; and that the real
// worker is such a process.
#include "core/io/worker/worker_sandbox.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>

#include "core/io/import.h"
#include "tests/core/io/sample_files.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using test::TemporaryFolder;

constexpr int kGood = 0;
constexpr int kNoGuard = 77;

/// Exit status of a child that entered the sandbox and then did something.
int inSandbox(const std::function<int()>& act, int last_fd = 1000) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(enterWorkerSandbox(last_fd) ? act() : kNoGuard);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// 0 if the call was refused; 1 if it went through; 2 if it failed for another reason.
int refused(long result) {
  if (result >= 0) return 1;
  return errno == EPERM ? kGood : 2;
}

class Sandbox : public ::testing::Test {
 protected:
  void SetUp() override {
    if (inSandbox([] { return kGood; }) == kNoGuard) {
      GTEST_SKIP() << "this kernel offers no seccomp filter";
    }
    file_ = folder_.write("there.txt", "as it was");
  }
  TemporaryFolder folder_;
  std::filesystem::path file_;
};

TEST_F(Sandbox, NetworkIsRefused) {
  EXPECT_EQ(inSandbox([] { return refused(::socket(AF_INET, SOCK_STREAM, 0)); }), kGood);
  EXPECT_EQ(inSandbox([] { return refused(::socket(AF_UNIX, SOCK_STREAM, 0)); }), kGood);
}

TEST_F(Sandbox, OtherProgramsAndProcessesAreRefused) {
  EXPECT_EQ(inSandbox([] {
              char name[] = "true";  // NOLINT(modernize-avoid-c-arrays): what execve takes.
              char* const arguments[] = {name, nullptr};
              return refused(::execve("/bin/true", arguments, environ));
            }),
            kGood);
  EXPECT_EQ(inSandbox([] { return refused(::kill(::getppid(), 0)); }), kGood);
  EXPECT_EQ(inSandbox([] { return ::kill(::getpid(), 0) == 0 ? kGood : 1; }), kGood);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_EQ(inSandbox([] {
              const pid_t made = ::fork();
              if (made == 0) ::_exit(0);
              return refused(made);
            }),
            kGood);
  EXPECT_EQ(inSandbox([] { return refused(::ptrace(PTRACE_ATTACH, ::getppid(), nullptr, 0)); }),
            kGood);
#endif
}

TEST_F(Sandbox, FilesAreReadButNeitherWrittenNorMadeNorRemoved) {
  const std::string file = file_.string();
  const std::string other = (folder_.path() / "other.txt").string();
  const auto opens = [](const std::string& name, int flags) {
    return [name, flags] { return refused(::open(name.c_str(), flags, 0600)); };
  };
  EXPECT_EQ(inSandbox(opens(file, O_WRONLY)), kGood);
  EXPECT_EQ(inSandbox(opens(file, O_RDWR)), kGood);
  EXPECT_EQ(inSandbox(opens(file, O_RDONLY | O_TRUNC)), kGood);
  EXPECT_EQ(inSandbox(opens(other, O_WRONLY | O_CREAT)), kGood);
  EXPECT_EQ(inSandbox(opens(folder_.path().string(), O_TMPFILE | O_RDWR)), kGood);
  EXPECT_EQ(inSandbox([&] { return refused(::unlink(file.c_str())); }), kGood);
  EXPECT_EQ(inSandbox([&] { return refused(::rename(file.c_str(), other.c_str())); }), kGood);
  EXPECT_EQ(inSandbox([&] { return refused(::truncate(file.c_str(), 0)); }), kGood);
  EXPECT_EQ(inSandbox([&] { return refused(::chmod(file.c_str(), 0)); }), kGood);
  EXPECT_EQ(inSandbox([&] { return refused(::symlink("x", other.c_str())); }), kGood);
  EXPECT_EQ(inSandbox([&] { return refused(::mkdir(other.c_str(), 0700)); }), kGood);
  EXPECT_EQ(inSandbox([&] {
              std::string text;
              std::getline(std::ifstream(file) >> std::ws, text);
              return text == "as it was" ? kGood : 1;
            }),
            kGood);
  EXPECT_FALSE(std::filesystem::exists(other));
}

TEST_F(Sandbox, WhatAReaderNeedsWorks) {
  const int answer = ::open((folder_.path() / "answer").c_str(), O_RDWR | O_CREAT, 0600);
  EXPECT_EQ(inSandbox([&] {
              int sum = 0;
              std::thread([&] { sum = 7; }).join();
              void* const memory = std::malloc(64U << 20U);
              const bool written = ::write(answer, "yes", 3) == 3 && ::ftruncate(answer, 2) == 0;
              const bool good = sum == 7 && memory != nullptr && written;
              std::free(memory);
              return good ? kGood : 1;
            }),
            kGood);
  ::close(answer);
  EXPECT_EQ(std::filesystem::file_size(folder_.path() / "answer"), 2U);
}

TEST_F(Sandbox, DescriptorsOfTheParentAreClosed) {
  const int fd = ::open(file_.c_str(), O_RDONLY);
  const int high = ::fcntl(fd, F_DUPFD, 200);
  EXPECT_EQ(inSandbox(
                [&] {
                  return ::fcntl(high, F_GETFD) < 0 && errno == EBADF && ::fcntl(2, F_GETFD) >= 0
                             ? kGood
                             : 1;
                },
                4),
            kGood);
  ::close(high);
  ::close(fd);
}

TEST(WorkerEnvironment, HoldsNothingThatIsNotNeeded) {
  ::setenv("RELIEVO_TEST_SECRET", "token", 1);
  ::setenv("PROJ_LIB", "/somewhere", 1);
  const std::vector<std::string> environment = workerEnvironment();
  ::unsetenv("PROJ_LIB");
  EXPECT_THAT(environment, ::testing::Contains("LC_ALL=C"));
  EXPECT_THAT(environment, ::testing::Contains("PROJ_LIB=/somewhere"));
  for (const std::string& entry : environment) {
    EXPECT_EQ(entry.find("SECRET"), std::string::npos) << entry;
    EXPECT_FALSE(entry.starts_with("HOME=") || entry.starts_with("PATH=")) << entry;
  }
}

pid_t onlyChild() {
  std::ifstream list("/proc/thread-self/children");
  pid_t pid = -1;
  list >> pid;
  return list ? pid : -1;
}

std::string fileText(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Looked at from outside, while it reads.
TEST(Worker, RunsWithoutOurEnvironmentDescriptorsAndRights) {
  const TemporaryFolder folder;
  std::string rows;
  const std::string block = test::textRows(1000);
  for (int i = 0; i < 500; ++i) rows += block;
  const auto file = folder.write("a.xyz", rows);
  ::setenv("RELIEVO_TEST_SECRET", "token", 1);
  // Not closed on exec, as a library may leave one.
  const int ours = ::fcntl(::open(file.c_str(), O_RDONLY | O_CLOEXEC), F_DUPFD, 100);
  ASSERT_GE(ours, 100);
  std::string status, environment;
  bool has_ours = false;
  Task task;
  task.progress = [&](std::string_view step, double) {
    const pid_t child = onlyChild();
    if (step != "reading points" || child < 0 || !status.empty()) return;
    const std::string place = "/proc/" + std::to_string(child);
    ::kill(child, SIGSTOP);
    status = fileText(place + "/status");
    environment = fileText(place + "/environ");
    has_ours = ::access((place + "/fd/" + std::to_string(ours)).c_str(), F_OK) == 0;
    ::kill(child, SIGCONT);
  };
  EXPECT_EQ(importScan(file, {}, task).points.size(), 500'000U);
  ::close(ours);
  if (status.empty()) GTEST_SKIP() << "the system does not list child processes";
  EXPECT_THAT(status, ::testing::HasSubstr("NoNewPrivs:\t1"));
  EXPECT_THAT(status, ::testing::HasSubstr("Seccomp:\t2"));
  EXPECT_THAT(environment, ::testing::HasSubstr("LC_ALL=C"));
  EXPECT_EQ(environment.find("SECRET"), std::string::npos);
  EXPECT_FALSE(has_ours);
}

/// In a container the program may well be process 1.
TEST(Worker, ServesAParentThatIsProcessOne) {
  if (std::getenv("RELIEVO_TEST_AS_PROCESS_ONE") != nullptr) {
    EXPECT_EQ(::getpid(), 1);
    const TemporaryFolder folder;
    EXPECT_EQ(importScan(folder.write("a.xyz", test::textRows(5))).points.size(), 5U);
    return;
  }
  const std::string unshare = "unshare --user --map-root-user --pid --fork --mount-proc ";
  if (std::system((unshare + "true 2>/dev/null").c_str()) != 0) {
    GTEST_SKIP() << "this account may not make a process namespace";
  }
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command = "RELIEVO_TEST_AS_PROCESS_ONE=1 " + unshare + "'" + self +
                              "' --gtest_filter=Worker.ServesAParentThatIsProcessOne";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

}  // namespace
}  // namespace relievo
