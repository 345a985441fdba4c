// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/worker/spawn.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "core/base/error.h"
#include "core/base/failure.h"
#include "core/io/formats/lines.h"

namespace relievo {
namespace {

constexpr std::size_t kReadAtOnce = 16384;

constexpr rlim_t kFilesNeeded = 64;

[[noreturn]] void refuseSpawn(int error) {
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) == 0 && files.rlim_cur < kFilesNeeded) {
    throw failure<MessageId::program_lacks_files>(files.rlim_cur, kFilesNeeded);
  }
  const bool lacks_room = error == EAGAIN || error == ENOMEM || error == EMFILE || error == ENFILE;
  if (lacks_room) throw failure<MessageId::program_lacks_room>(std::strerror(error));
  throw failure<MessageId::program_cannot_start>(std::strerror(error));
}

class SpawnSettings {
 public:
  SpawnSettings() {
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawnattr_init(&attributes);
  }
  ~SpawnSettings() {
    ::posix_spawn_file_actions_destroy(&actions);
    ::posix_spawnattr_destroy(&attributes);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
};

void setSignals(posix_spawnattr_t& attributes) {
  sigset_t none;
  sigset_t all;
  ::sigemptyset(&none);
  ::sigfillset(&all);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &all);
  ::posix_spawnattr_setpgroup(&attributes, 0);
  ::posix_spawnattr_setflags(
      &attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
}

/// In the C locale, for libraries that set the locale as they load.
std::vector<std::string> ours() {
  std::vector<std::string> environment;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    if (!std::string_view(*entry).starts_with("LC_ALL=")) environment.emplace_back(*entry);
  }
  environment.emplace_back("LC_ALL=C");
  return environment;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

int raised(int fd) {
  if (fd < 0) refuseSpawn(errno);
  const int high = ::fcntl(fd, F_DUPFD_CLOEXEC, 16);
  const int error = errno;
  ::close(fd);
  if (high < 0) refuseSpawn(error);
  return high;
}

void makePipe(OwnedFd& read_end, OwnedFd& write_end) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) refuseSpawn(errno);
  read_end.reset(ends[0]);
  write_end.reset(raised(ends[1]));
  ::fcntl(read_end.get(), F_SETFL, O_NONBLOCK);
}

bool readAvailable(int fd, std::string& text) {
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t got = ::read(fd, buffer.data(), buffer.size());
    if (got > 0) {
      text.append(buffer.data(), static_cast<std::size_t>(got));
      if (text.size() > kReadAtOnce) return true;
      continue;
    }
    if (got < 0 && errno == EINTR) continue;
    return got < 0 && errno == EAGAIN;
  }
}

std::string lastPrintableLine(std::string_view text) {
  std::string last;
  Lines lines(text);
  while (lines.next()) {
    std::string line;
    bool escape = false;
    for (const char c : lines.line()) {
      if (c == '\x1B') escape = true;
      if (!escape && static_cast<unsigned char>(c) >= 32) line += c;
      if (escape && c == 'm') escape = false;
    }
    const std::string_view shown = trimmed(line);
    if (!shown.empty()) last = shown.substr(0, 200);
  }
  return last;
}

ChildProcess::~ChildProcess() {
  kill();
}

void ChildProcess::start(ProgramStart how) {
  SpawnSettings settings;
  ::posix_spawn_file_actions_addopen(&settings.actions, 0, "/dev/null", O_RDONLY, 0);
  for (const FdForChild& fd : how.fds) {
    ::posix_spawn_file_actions_adddup2(&settings.actions, fd.fd, fd.as);
  }
  setSignals(settings.attributes);
  std::vector<std::string> environment = how.environment ? std::move(*how.environment) : ours();
  environment.insert(environment.end(), how.more_environment.begin(), how.more_environment.end());
  const std::vector<char*> argument_pointers = pointersTo(how.arguments);
  const std::vector<char*> environment_pointers = pointersTo(environment);
  pid_t pid = -1;
  const int error =
      ::posix_spawn(&pid, how.program.c_str(), &settings.actions, &settings.attributes,
                    argument_pointers.data(), environment_pointers.data());
  if (error != 0) refuseSpawn(error);
  pid_ = pid;
  // The header of the C library for it is none of C++. Such descriptors are closed by exec.
  end_.reset(static_cast<int>(::syscall(SYS_pidfd_open, pid, 0)));
}

bool ChildProcess::reap(bool wait) {
  if (pid_ < 0) return true;
  pid_t ended = 0;
  do {
    ended = ::waitpid(pid_, &status_, wait ? 0 : WNOHANG);
  } while (ended < 0 && errno == EINTR);
  if (ended == 0) return false;
  if (ended < 0) status_ = 0;  // Someone ignores SIGCHLD; what it wrote tells the rest.
  pid_ = -1;
  return true;
}

void ChildProcess::kill() {
  if (pid_ < 0) return;
  ::kill(-pid_, SIGKILL);  // With what it started itself, ...
  ::kill(pid_, SIGKILL);   // ... and if its group should not exist yet.
  reap(true);
}

bool ChildProcess::exited() const noexcept {
  return WIFEXITED(status_);
}

int ChildProcess::number() const noexcept {
  return exited() ? WEXITSTATUS(status_) : WTERMSIG(status_);
}

}  // namespace relievo
