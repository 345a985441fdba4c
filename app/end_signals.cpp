// SPDX-License-Identifier: BSD-3-Clause
#include "app/end_signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <QSocketNotifier>

namespace relievo {
namespace {

constexpr std::array kSignals{SIGTERM, SIGINT, SIGHUP};

// A signal handler finds nothing but globals.
std::array<int, 2> pipe_ends{-1, -1};
std::atomic<std::int64_t> came_ns{0};  // 0: none yet.

// Longer than what MainWindow::endAtOnce waits for: the copy of the work and the end of a video.
constexpr std::int64_t kPatienceNs = 10'000'000'000;
// Nobody presses Ctrl+C twice as fast as this; a shell and the kernel send two at a time.
constexpr std::int64_t kTwiceNs = 500'000'000;

std::int64_t nowNs() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);  // Allowed in a handler (signal-safety(7)).
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

void onSignal(int signal) {
  std::int64_t first = 0;
  if (!came_ns.compare_exchange_strong(first, nowNs())) {
    // A terminal that closes sends SIGHUP by the shell and by the kernel, a session SIGTERM and
    // SIGHUP: they are one request. Where nobody answers it the window hangs; then the process is
    // ended by the standard action of a signal that an open device handles: it sends zero first
    // (haptics/device/falcon/emergency_stop.h).
    const std::int64_t since = nowNs() - first;
    if (since > kPatienceNs || (signal == SIGINT && since > kTwiceNs)) raise(SIGUSR1);
    return;
  }
  const int saved = errno;
  const auto number = static_cast<unsigned char>(signal);
  [[maybe_unused]] const auto written = ::write(pipe_ends[1], &number, 1);
  errno = saved;
}

}  // namespace

EndSignals::EndSignals(QObject* parent) : QObject(parent) {
  if (::pipe2(pipe_ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) return;  // They end it, as ever.
  came_ns = 0;
  notifier_ = std::make_unique<QSocketNotifier>(pipe_ends[0], QSocketNotifier::Read);
  connect(notifier_.get(), &QSocketNotifier::activated, this, [this] {
    unsigned char number = 0;
    if (::read(pipe_ends[0], &number, 1) == 1) Q_EMIT came(number);
  });
  for (const int signal : kSignals) {
    struct sigaction action {};
    if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART | SA_ONSTACK;
    sigaction(signal, &action, nullptr);
  }
}

EndSignals::~EndSignals() {
  for (const int signal : kSignals) {
    struct sigaction now {};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler == onSignal) {
      ::signal(signal, SIG_DFL);
    }
  }
  notifier_.reset();
  for (int& end : pipe_ends) {
    if (end >= 0) ::close(end);
    end = -1;
  }
}

}  // namespace relievo
