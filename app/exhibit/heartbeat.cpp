// SPDX-License-Identifier: BSD-3-Clause
#include "app/exhibit/heartbeat.h"

#include <fcntl.h>
#include <unistd.h>

namespace relievo {

Heartbeat::Heartbeat(QObject* parent) : QObject(parent) {
  bool is_number = false;
  const int given = qEnvironmentVariableIntValue("RELIEVO_HEARTBEAT_FD", &is_number);
  if (!is_number || given < 0 || ::fcntl(given, F_GETFD) < 0) return;
  pipe_ = given;
  // Programs that this one starts must not keep it open; and a pipe that nobody reads from must
  // never stop the window.
  ::fcntl(pipe_, F_SETFD, FD_CLOEXEC);
  ::fcntl(pipe_, F_SETFL, O_NONBLOCK);
  constexpr int kPeriodMs = 1000;
  connect(&timer_, &QTimer::timeout, this, &Heartbeat::beat);
  timer_.start(kPeriodMs);
  beat();
}

Heartbeat::~Heartbeat() {
  if (pipe_ >= 0) ::close(pipe_);
}

// A full pipe has beats enough in it; SIGPIPE is ignored where the supervisor starts this program.
void Heartbeat::beat() const {
  const char one = '.';
  [[maybe_unused]] const auto written = ::write(pipe_, &one, 1);
}

}  // namespace relievo
