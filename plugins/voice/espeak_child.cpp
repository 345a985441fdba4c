// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/voice/espeak_child.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <QFile>
#include <QSocketNotifier>
#include <string>
#include <thread>
#include <utility>

#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr int kBurialMs = 10;

/// For which signals the child stops, however this process takes them, and where its words go.
class SpawnSettings {
 public:
  explicit SpawnSettings(int input) {
    sigset_t none, all;
    ::sigemptyset(&none);
    ::sigfillset(&all);
    ::posix_spawnattr_init(&attributes);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &all);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO}) {
      ::posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_WRONLY, 0);
    }
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

}  // namespace

/// A child and the socket that it reads: the other end is closed when nobody reads any more.
struct EspeakChild::Process {
  Process() = default;
  ~Process() {
    watch.reset();
    if (words >= 0) ::close(words);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  pid_t id = -1;  // -1: there is none, or it is buried.
  int words = -1;
  int status = 0;  // Once it is buried.
  std::unique_ptr<QSocketNotifier> watch;

  /// @return true: it has ended, and the system knows it no more
  bool isBuried() {
    if (id > 0 && ::waitpid(id, &status, WNOHANG) != 0) id = -1;
    return id < 0;
  }
};

EspeakChild::EspeakChild(SpeakingProgram program, QObject* parent)
    : QObject(parent), program_(std::move(program)) {
  burial_.setInterval(kBurialMs);
  connect(&burial_, &QTimer::timeout, this, &EspeakChild::reap);
}

EspeakChild::~EspeakChild() {
  cancel();
  // What was killed ends at once.
  constexpr int kMostMs = 100;
  for (int ms = 0; ms < kMostMs && !leaving_.empty(); ++ms) {
    std::erase_if(leaving_, [](const auto& process) { return process->isBuried(); });
    if (!leaving_.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void EspeakChild::speak(const QString& text, const SpeechStyle& style) {
  cancel();
  child_ = std::make_unique<Process>();
  start(*child_,
        program_.more + QStringList{QStringLiteral("-v"), QString::fromStdString(style.language),
                                    QStringLiteral("-s"), QString::number(style.words_per_minute),
                                    QStringLiteral("-a"),
                                    QString::number(std::clamp(style.volume_percent, 0, 100)),
                                    QStringLiteral("--stdin")});
  if (child_->id < 0) {
    // Told later, as every other failure: whoever asked is still in the middle of it.
    QTimer::singleShot(0, this, [this, process = child_.get()] {
      if (process != child_.get()) return;
      child_.reset();
      Q_EMIT failed(
          said<MessageId::voice_no_program>(std::filesystem::path(program_.name.toStdString())));
    });
    return;
  }
  // It fits into the socket; what does not is more than one listens to.
  const QByteArray words = text.toUtf8() + '\n';
  [[maybe_unused]] const ssize_t sent = ::send(
      child_->words, words.constData(), static_cast<std::size_t>(words.size()), MSG_NOSIGNAL);
  ::shutdown(child_->words, SHUT_WR);
}

void EspeakChild::start(Process& process, const QStringList& arguments) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends.data()) != 0) {
    return;
  }
  process.words = ends[0];
  // The child's end waits, as programs expect it.
  ::fcntl(ends[1], F_SETFL, 0);
  std::vector<std::string> texts{QFile::encodeName(program_.name).toStdString()};
  for (const QString& argument : arguments) texts.push_back(argument.toStdString());
  std::vector<char*> words;
  for (std::string& text : texts) words.push_back(text.data());
  words.push_back(nullptr);
  const SpawnSettings settings(ends[1]);
  pid_t id = -1;
  if (::posix_spawnp(&id, words[0], &settings.actions, &settings.attributes, words.data(),
                     environ) == 0) {
    process.id = id;
    process.watch = std::make_unique<QSocketNotifier>(process.words, QSocketNotifier::Read);
    connect(process.watch.get(), &QSocketNotifier::activated, this,
            [this, &process] { hasEnded(process); });
  }
  ::close(ends[1]);
}

void EspeakChild::hasEnded(const Process& process) {
  process.watch->setEnabled(false);
  burial_.start();
  reap();
}

void EspeakChild::cancel() {
  if (child_ == nullptr) return;
  if (child_->id > 0) {
    ::kill(child_->id, SIGKILL);
    leaving_.push_back(std::move(child_));
    leaving_.back()->watch.reset();
    burial_.start();
  }
  child_.reset();
}

void EspeakChild::reap() {
  std::erase_if(leaving_, [](const auto& process) { return process->isBuried(); });
  // It reads no more: it ends, or has ended.
  const bool is_ending = child_ != nullptr && child_->watch && !child_->watch->isEnabled();
  if (leaving_.empty() && !is_ending) burial_.stop();
  if (!is_ending || !child_->isBuried()) return;
  const std::unique_ptr<Process> process = std::move(child_);
  if (WIFEXITED(process->status) && WEXITSTATUS(process->status) == 0) {
    Q_EMIT ended();
  } else {
    Q_EMIT failed(
        said<MessageId::voice_program_failed>(std::filesystem::path(program_.name.toStdString())));
  }
}

}  // namespace relievo
