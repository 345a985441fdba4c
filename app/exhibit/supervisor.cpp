// SPDX-License-Identifier: BSD-3-Clause
#include "app/exhibit/supervisor.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <optional>
#include <utility>

#include "core/base/failure.h"
#include "core/exhibit/exhibit.h"
#include "core/exhibit/restart_rule.h"
#include "core/exhibit/rotating_log.h"
#include "core/file/own_program.h"
#include "core/file/owned_fd.h"
#include "ui/translations/message_languages.h"

namespace relievo {
namespace {

constexpr int kUsage = 1, kCannotRead = 2, kNotAllDone = 4, kNoGraphics = 7, kEndedBySignal = 128;

double nowS() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// One datagram for systemd, if it asked for it (sd_notify(3)).
void notifySystem(const std::string& state) {
  const char* name = std::getenv("NOTIFY_SOCKET");
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (name == nullptr || (name[0] != '/' && name[0] != '@') ||
      std::strlen(name) >= sizeof(address.sun_path)) {
    return;
  }
  std::memcpy(address.sun_path, name, std::strlen(name));
  if (name[0] == '@') address.sun_path[0] = '\0';
  const OwnedFd socket(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + std::strlen(name));
  ::sendto(socket.get(), state.data(), state.size(), MSG_NOSIGNAL,
           reinterpret_cast<const sockaddr*>(&address), size);
}

/// How a run of the program ended.
struct End {
  int status = 0;           ///< As waitpid says it.
  bool was_silent = false;  ///< It was stopped because no heartbeat came.
  int asked_by = 0;         ///< The signal that asked the supervisor to end.
};

std::string wordsOf(const End& end) {
  const std::string how = WIFSIGNALED(end.status)
                              ? "signal " + std::to_string(WTERMSIG(end.status))
                              : "exit status " + std::to_string(WEXITSTATUS(end.status));
  return (end.was_silent ? "ended: no heartbeat came, " : "ended: ") + how;
}

class Supervisor {
 public:
  explicit Supervisor(const SupervisorOptions& options) : options_(options), log_(options.log) {
    sigemptyset(&signals_);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGCHLD}) sigaddset(&signals_, signal);
    sigprocmask(SIG_BLOCK, &signals_, &before_);
    news_ = OwnedFd(::signalfd(-1, &signals_, SFD_CLOEXEC | SFD_NONBLOCK));
  }
  ~Supervisor() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  int run() {
    for (int starts = 0;; ++starts) {
      const End end = runOnce(starts);
      note(wordsOf(end));
      if (end.asked_by != 0) return kEndedBySignal + end.asked_by;
      if (const auto code = meantEnd(end)) return *code;
      if (!rule_.ended(nowS())) return giveUp();
      if (const int signal = pause(RestartRule::kPauseS)) return kEndedBySignal + signal;
    }
  }

 private:
  void note(const std::string& words) { log_.write(utcNow(), words); }

  static std::optional<int> meantEnd(const End& end) {
    if (end.was_silent || !WIFEXITED(end.status)) return std::nullopt;
    const int code = WEXITSTATUS(end.status);
    // Its own words are on stderr; another start would say the same.
    const bool is_meant = code == 0 || code == kUsage || code == kCannotRead || code == kNoGraphics;
    return is_meant ? std::optional(code) : std::nullopt;
  }

  int giveUp() {
    const Message why = said<MessageId::exhibit_gave_up>(
        rule_.recentEnds(), static_cast<int>(RestartRule::kWithinS / 60), log_.file());
    note(englishText(why));
    std::cerr << "relievo: " << englishText(why) << '\n';
    return kNotAllDone;
  }

  /// @return the signal that came meanwhile, or 0
  int pause(double seconds) {
    const double until_s = nowS() + seconds;
    while (nowS() < until_s) {
      pollfd wait{news_.get(), POLLIN, 0};
      ::poll(&wait, 1, milliseconds(until_s - nowS()));
      if (const int signal = askedToEnd()) return signal;
    }
    return 0;
  }

  static int milliseconds(double seconds) {
    constexpr double kMs = 1000;
    return seconds <= 0 ? 0 : 1 + static_cast<int>(kMs * seconds);
  }

  /// A signal that asks for the end; 0: none came. That of a child is only a reason to look.
  int askedToEnd() {
    signalfd_siginfo news{};
    while (::read(news_.get(), &news, sizeof(news)) == sizeof(news)) {
      if (news.ssi_signo != SIGCHLD) return static_cast<int>(news.ssi_signo);
    }
    return 0;
  }

  [[noreturn]] void becomeProgram(int beats, int starts) const {
    sigprocmask(SIG_SETMASK, &before_, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
    // It must not go on alone, with nobody to see it hang.
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != supervisor_) ::_exit(kNotAllDone);
    const rlimit no_core{0, 0};  // Writing one takes longer than a visitor should wait.
    ::setrlimit(RLIMIT_CORE, &no_core);
    ::fcntl(beats, F_SETFD, 0);
    ::setenv("RELIEVO_HEARTBEAT_FD", std::to_string(beats).c_str(), 1);
    ::setenv("RELIEVO_EXHIBIT_STARTS", std::to_string(starts).c_str(), 1);
    ::unsetenv("NOTIFY_SOCKET");
    std::vector<char*> words;
    for (const std::string& word : options_.command)
      words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    ::execv(words.front(), words.data());
    constexpr int kNotThere = 127;
    ::_exit(kNotThere);
  }

  End runOnce(int starts) {
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw failure<MessageId::program_not_started>(PathArgument(options_.command.front()),
                                                    TextArgument(std::strerror(errno)));
    }
    const OwnedFd reading(ends[0]);
    OwnedFd writing(ends[1]);
    ::fcntl(reading.get(), F_SETFL, O_NONBLOCK);
    const pid_t child = ::fork();
    if (child == 0) becomeProgram(writing.get(), starts);
    if (child < 0) {
      throw failure<MessageId::program_not_started>(PathArgument(options_.command.front()),
                                                    TextArgument(std::strerror(errno)));
    }
    writing = OwnedFd(-1);
    note("started as process " + std::to_string(child) +
         (starts > 0 ? ", again: " + std::to_string(starts) : std::string()));
    return watch(child, reading.get());
  }

  /// Everything that has come; true: something.
  static bool beats(int pipe) {
    std::array<char, 64> bytes{};
    bool any = false;
    while (::read(pipe, bytes.data(), bytes.size()) > 0) any = true;
    return any;
  }

  End watch(pid_t child, int pipe) {
    End end;
    bool alive = false, aborted = false, closed = false;
    double due_s = nowS() + options_.first_beat_s;
    for (;;) {
      std::array<pollfd, 2> waits{{{news_.get(), POLLIN, 0}, {pipe, POLLIN, 0}}};
      constexpr double kSystemPeriodS = 1;  // systemd hears of us meanwhile.
      // A pipe that was closed at its other end would be news all the time.
      ::poll(waits.data(), closed ? 1 : 2, milliseconds(std::min(due_s - nowS(), kSystemPeriodS)));
      closed = closed || (waits[1].revents & POLLHUP) != 0;
      if (const int signal = askedToEnd()) {
        end.asked_by = signal;
        ::kill(child, SIGTERM);
        due_s = nowS() + options_.silence_s;  // Then it is ended by force.
        alive = false;
      }
      if (beats(pipe) && !aborted && end.asked_by == 0) {
        if (!std::exchange(alive, true)) notifySystem("READY=1");
        due_s = nowS() + options_.silence_s;
      }
      notifySystem("WATCHDOG=1");
      if (::waitpid(child, &end.status, WNOHANG) == child) return end;
      if (nowS() < due_s) continue;
      end.was_silent = end.asked_by == 0;
      // Its last words are sent on SIGABRT: the device gets zero force (docs/adr/0068).
      ::kill(child, aborted ? SIGKILL : SIGABRT);
      ::kill(child, SIGCONT);
      aborted = true;
      due_s = nowS() + options_.abort_s;
    }
  }

  const SupervisorOptions& options_;
  RotatingLog log_;
  RestartRule rule_;
  const pid_t supervisor_ = ::getpid();
  sigset_t signals_{}, before_{};
  OwnedFd news_{-1};
};

}  // namespace

int supervise(const SupervisorOptions& options) {
  return Supervisor(options).run();
}

int runExhibit(const std::filesystem::path& file, const std::vector<std::string>& arguments) {
  std::vector<std::string> tags;
  for (const MessageLanguage& language : messageLanguages()) tags.emplace_back(language.tag);
  const Exhibit exhibit = readExhibit(file, tags);
  const std::filesystem::path window = ownProgram("relievo-window", "The window cannot be opened:");
  if (window.empty()) throw failure<MessageId::window_not_installed>();
  SupervisorOptions options{.command = {window.string()},
                            .log = recordsFolder(exhibit) / "supervisor.log"};
  options.command.insert(options.command.end(), arguments.begin(), arguments.end());
  return supervise(options);
}

}  // namespace relievo
