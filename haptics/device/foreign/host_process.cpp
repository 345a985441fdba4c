// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/host_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "core/base/failure.h"
#include "core/file/own_program.h"
#include "haptics/device/foreign/device_page.h"

namespace relievo::foreign {

namespace {
constexpr const char* kHost = "relievo-device-host";

[[noreturn]] void refuse(int error) {
  throw failure<MessageId::device_host_not_started>(std::strerror(error));
}

/// Above the numbers that the child uses, so that dup2 in it overwrites nothing.
OwnedFd raised(int fd) {
  constexpr int kFirst = 16;
  OwnedFd high(::fcntl(fd, F_DUPFD_CLOEXEC, kFirst));
  if (high.get() < 0) refuse(errno);
  return high;
}

/// The C library's own declaration is none of C's in Debian 12.
int openPid(int pid) {
  return static_cast<int>(::syscall(SYS_pidfd_open, pid, 0));
}

class Settings {
 public:
  Settings() {
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawnattr_init(&attributes);
  }
  ~Settings() {
    ::posix_spawn_file_actions_destroy(&actions);
    ::posix_spawnattr_destroy(&attributes);
  }
  Settings(const Settings&) = delete;
  Settings& operator=(const Settings&) = delete;

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

/// Of this process, without the variables that are set anew, and those.
std::vector<std::string> environmentWith(const std::vector<std::string>& variables) {
  std::vector<std::string> all = variables;
  for (char* const* entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text(*entry);
    const std::string_view name = text.substr(0, text.find('=') + 1);
    const bool anew = std::any_of(variables.begin(), variables.end(),
                                  [&](const std::string& one) { return one.starts_with(name); });
    if (!anew || name.empty()) all.emplace_back(text);
  }
  return all;
}

/// As the system wants them; they live as long as the words do.
std::vector<char*> pointersTo(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}
}  // namespace

HostProcess::~HostProcess() {
  kill();
}

void HostProcess::start(const Start& how) {
  const std::filesystem::path program = ownProgram(kHost, "Plug-ins for devices cannot be used:");
  if (program.empty()) refuse(ENOENT);
  std::array<int, 2> life{};
  if (::pipe2(life.data(), O_CLOEXEC) != 0) refuse(errno);
  const OwnedFd life_end(life[0]);
  life_ = OwnedFd(life[1]);
  const OwnedFd child_life = raised(life_end.get());
  const OwnedFd child_shared = raised(how.shared_fd);
  const OwnedFd child_plugin = raised(how.plugin_fd);
  const OwnedFd child_output = raised(how.output_fd >= 0 ? how.output_fd : STDERR_FILENO);
  Settings settings;
  ::posix_spawn_file_actions_addopen(&settings.actions, 0, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&settings.actions, child_output.get(), 1);
  ::posix_spawn_file_actions_adddup2(&settings.actions, child_shared.get(), kPageFd);
  ::posix_spawn_file_actions_adddup2(&settings.actions, child_life.get(), kLifeFd);
  ::posix_spawn_file_actions_adddup2(&settings.actions, child_plugin.get(), kPluginFd);
  setSignals(settings.attributes);
  std::vector<std::string> words{kHost};
  words.insert(words.end(), how.arguments.begin(), how.arguments.end());
  std::vector<std::string> variables = environmentWith(how.variables);
  const int error = ::posix_spawn(&pid_, program.c_str(), &settings.actions, &settings.attributes,
                                  pointersTo(words).data(), pointersTo(variables).data());
  if (error != 0) {
    pid_ = -1;
    refuse(error);
  }
  pidfd_ = OwnedFd(openPid(pid_));
  if (pidfd_.get() < 0) {
    const int reason = errno;
    kill();
    refuse(reason);
  }
}

bool HostProcess::ended(int wait_ms) noexcept {
  if (pid_ < 0) return true;
  if (pidfd_.get() >= 0) {
    pollfd end{.fd = pidfd_.get(), .events = POLLIN, .revents = 0};
    int ready = 0;
    do {
      ready = ::poll(&end, 1, wait_ms);
    } while (ready < 0 && errno == EINTR);
    if (ready <= 0) return false;
  }
  int status = 0;
  pid_t reaped = 0;
  do {
    reaped = ::waitpid(pid_, &status, 0);
  } while (reaped < 0 && errno == EINTR);
  signal_ = reaped > 0 && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  exit_status_ = reaped > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  pid_ = -1;
  life_.reset();
  return true;
}

void HostProcess::kill() noexcept {
  if (pid_ < 0) return;
  ::kill(-pid_, SIGKILL);  // With what it started itself, ...
  ::kill(pid_, SIGKILL);   // ... and if its group should not exist yet.
  ended(-1);
}

}  // namespace relievo::foreign
