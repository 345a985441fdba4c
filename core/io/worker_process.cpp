// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/worker_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <vector>

#include "core/base/error.h"
#include "core/io/lines.h"
#include "core/io/number_text.h"

namespace relievo {
namespace {

constexpr int kPollMs = 50;
constexpr std::size_t kWordsKept = 4096;

[[noreturn]] void refuseSpawn(int error) {
  throw FileError(std::string("The import cannot start a process of its own: ") +
                  std::strerror(error) + ". Close other programs and try again.");
}

/// Above the numbers that the child uses, so that dup2 in the child overwrites nothing.
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

/// Appends what is there. @return  false once the other end is closed
bool readAvailable(int fd, std::string& text) {
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t got = ::read(fd, buffer.data(), buffer.size());
    if (got > 0) {
      text.append(buffer.data(), static_cast<std::size_t>(got));
      if (text.size() > 4 * kWordsKept) return true;
      continue;
    }
    if (got < 0 && errno == EINTR) continue;
    return got < 0 && errno == EAGAIN;
  }
}

/// The last line with something to read in it, without the colours that libraries print.
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

/// A group of its own, so that ^C reaches us and not the child; no signal blocked or ignored.
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

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

WorkerProcess::WorkerProcess(const std::filesystem::path& file, const ImportOptions& options) {
  child_answer_.reset(raised(::memfd_create("relievo-import", MFD_CLOEXEC)));
  answer_.reset(::fcntl(child_answer_.get(), F_DUPFD_CLOEXEC, 16));
  if (answer_.get() < 0) refuseSpawn(errno);
  makePipe(progress_, child_progress_);
  makePipe(words_, child_words_);
  spawn(file, options);
  child_answer_.reset();
  child_progress_.reset();
  child_words_.reset();
}

WorkerProcess::~WorkerProcess() {
  kill();
}

void WorkerProcess::spawn(const std::filesystem::path& file, const ImportOptions& options) {
  SpawnSettings settings;
  ::posix_spawn_file_actions_addopen(&settings.actions, 0, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&settings.actions, child_words_.get(), 1);
  ::posix_spawn_file_actions_adddup2(&settings.actions, child_words_.get(), 2);
  ::posix_spawn_file_actions_adddup2(&settings.actions, child_progress_.get(), kProgressFd);
  ::posix_spawn_file_actions_adddup2(&settings.actions, child_answer_.get(), kAnswerFd);
  setSignals(settings.attributes);

  std::vector<std::string> arguments{"relievo",
                                     kWorkerArgument,
                                     std::filesystem::absolute(file).string(),
                                     options.accept_incomplete ? "1" : "0",
                                     std::to_string(options.max_points),
                                     std::to_string(options.max_memory_bytes),
                                     roundTripText(std::array{options.max_cpu_s})};
  std::vector<std::string> environment;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    if (!std::string_view(*entry).starts_with("LC_ALL=")) environment.emplace_back(*entry);
  }
  environment.emplace_back("LC_ALL=C");  // For libraries that set the locale as they load.
  environment.push_back(std::string(kWorkerMark) + "=1");
  const std::vector<char*> argument_pointers = pointersTo(arguments);
  const std::vector<char*> environment_pointers = pointersTo(environment);
  pid_t pid = -1;
  const int error = ::posix_spawn(&pid, "/proc/self/exe", &settings.actions, &settings.attributes,
                                  argument_pointers.data(), environment_pointers.data());
  if (error != 0) refuseSpawn(error);
  pid_ = pid;
}

bool WorkerProcess::reap(bool block) {
  if (pid_ < 0) return true;
  pid_t ended = 0;
  do {
    ended = ::waitpid(pid_, &status_, block ? 0 : WNOHANG);
  } while (ended < 0 && errno == EINTR);
  if (ended == 0) return false;
  if (ended < 0) status_ = 0;  // Someone ignores SIGCHLD; the answer itself tells the rest.
  pid_ = -1;
  return true;
}

void WorkerProcess::kill() {
  if (pid_ < 0) return;
  ::kill(pid_, SIGKILL);
  reap(true);
}

void WorkerProcess::passProgress(const Task& task) {
  for (std::size_t end = progress_text_.find('\n'); end != std::string::npos;
       end = progress_text_.find('\n')) {
    std::string_view step = std::string_view(progress_text_).substr(0, end);
    const auto fraction = parseNumber(takeWord(step));
    if (fraction) task.report(trimmed(step), std::clamp(*fraction, 0.0, 1.0));
    progress_text_.erase(0, end + 1);
  }
  if (progress_text_.size() > kWordsKept) progress_text_.clear();
}

void WorkerProcess::drain(const Task& task) {
  if (progress_.get() >= 0 && !readAvailable(progress_.get(), progress_text_)) progress_.reset();
  if (words_.get() >= 0 && !readAvailable(words_.get(), words_text_)) words_.reset();
  if (words_text_.size() > kWordsKept) words_text_.erase(0, words_text_.size() - kWordsKept);
  passProgress(task);
}

WorkerEnd WorkerProcess::wait(const Task& task) {
  while (!reap(false)) {
    if (task.stop.stop_requested()) {
      kill();
      task.check();
    }
    std::array<pollfd, 2> sources{pollfd{progress_.get(), POLLIN, 0},
                                  pollfd{words_.get(), POLLIN, 0}};
    // Once both are closed the child is about to end: a short nap between looks.
    const bool closing = progress_.get() < 0 && words_.get() < 0;
    ::poll(sources.data(), sources.size(), closing ? 2 : kPollMs);
    drain(task);
  }
  drain(task);
  WorkerEnd end;
  end.exited = WIFEXITED(status_);
  end.number = end.exited ? WEXITSTATUS(status_) : WTERMSIG(status_);
  end.last_words = lastPrintableLine(words_text_);
  return end;
}

}  // namespace relievo
