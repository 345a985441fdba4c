// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>

#include <X11/Xlib.h>

#include "core/base/failure.h"
#include "ui/vtk/display_connection.h"
#include "ui/vtk/offscreen.h"

namespace relievo {
namespace {

constexpr int kStartTimeoutMs = 20'000;

// Between fork and exec only async-signal-safe calls: the process may have threads.
[[noreturn]] void becomeXvfb(int display_fd, pid_t parent, const char* fd_text) {
  // A blocked signal is inherited through exec: Xvfb would never hear its SIGTERM.
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  // Out of the terminal's reach: Ctrl+C is for us, who still draw until we have cleaned up.
  setsid();
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(127);
  fcntl(display_fd, F_SETFD, 0);
  const int null = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (null >= 0) {
    dup2(null, STDIN_FILENO);
    dup2(null, STDOUT_FILENO);
    dup2(null, STDERR_FILENO);
  }
  execlp("Xvfb", "Xvfb", "-displayfd", fd_text, "-screen", "0", "1280x1024x24", "-nolisten", "tcp",
         "-noreset", static_cast<char*>(nullptr));
  _exit(127);
}

void stop(int pid) {
  kill(pid, SIGTERM);
  while (waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
  }
}

/// What Xvfb writes once it accepts connections: its display number and a line feed.
std::string readDisplayNumber(int fd) {
  std::string text;
  pollfd waiting{fd, POLLIN, 0};
  while (poll(&waiting, 1, kStartTimeoutMs) > 0) {
    std::array<char, 32> buffer{};
    const ssize_t n = read(fd, buffer.data(), buffer.size());
    if (n <= 0) return {};
    text.append(buffer.data(), static_cast<std::size_t>(n));
    if (text.back() == '\n') return text.substr(0, text.size() - 1);
  }
  return {};
}

}  // namespace

DisplayConnection::DisplayConnection() : display_(XOpenDisplay(nullptr)) {
  const char* const name = std::getenv("DISPLAY");
  if (!name || !*name) return;
  for (int tries = 0; !display_ && tries < 5; ++tries) {
    poll(nullptr, 0, 40);
    display_ = XOpenDisplay(nullptr);
  }
}

DisplayConnection::~DisplayConnection() {
  if (display_) XCloseDisplay(display_);
}

bool haveDisplay() {
  return DisplayConnection().isOpen();
}

DisplayGuard::DisplayGuard() {
  if (haveDisplay()) return;
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw failure<MessageId::no_pipe_for_xvfb>();
  }
  const std::string fd_text = std::to_string(ends[1]);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) becomeXvfb(ends[1], parent, fd_text.c_str());
  close(ends[1]);
  const std::string number = pid_ > 0 ? readDisplayNumber(ends[0]) : std::string{};
  close(ends[0]);
  if (number.empty()) {
    if (pid_ > 0) stop(pid_);
    throw failure<MessageId::xvfb_not_started>();
  }
  if (const char* before = std::getenv("DISPLAY")) display_before_ = before;
  setenv("DISPLAY", (":" + number).c_str(), 1);
}

DisplayGuard::~DisplayGuard() {
  if (pid_ <= 0) return;
  if (display_before_) {
    setenv("DISPLAY", display_before_->c_str(), 1);
  } else {
    unsetenv("DISPLAY");
  }
  stop(pid_);
}

}  // namespace relievo
