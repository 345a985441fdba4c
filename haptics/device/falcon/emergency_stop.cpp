// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/emergency_stop.h"

#include <sys/ioctl.h>
#include <csignal>
#include <ctime>

#include <linux/usbdevice_fs.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <utility>

#include "haptics/device/falcon/protocol.h"

namespace relievo::falcon {

namespace {
constexpr int kSignals = _NSIG;

bool halts(int signal) {
  return signal == SIGTSTP || signal == SIGTTIN || signal == SIGTTOU;
}

/// Would the process end or halt, and can that be handled?
bool isLast(int signal) {
  constexpr std::array<int, 6> kOthers{SIGKILL, SIGSTOP, SIGCHLD, SIGCONT, SIGURG, SIGWINCH};
  return std::find(kOthers.begin(), kOthers.end(), signal) == kOthers.end();
}

// A signal handler finds nothing but globals.
std::atomic<int> descriptor_of_falcon{-1};
std::atomic<bool> has_spoken{false};
std::array<bool, kSignals> installed{};
Frame last_frame{};

void sayZero() {
  const int descriptor = descriptor_of_falcon.load();
  if (descriptor < 0) return;
  const int saved = errno;
  has_spoken.store(true);
  // Twice: the device's thread may be sending a force at this moment. It sends no more after it.
  for (int i = 0; i < 2; ++i) {
    usbdevfs_bulktransfer transfer{};
    transfer.ep = kEndpointOut;
    transfer.len = kFrameBytes;
    transfer.timeout = 50;  // ms
    transfer.data = last_frame.data();
    ioctl(descriptor, USBDEVFS_BULK, &transfer);
    if (i > 0) break;
    const timespec pause{.tv_sec = 0, .tv_nsec = 5'000'000};
    nanosleep(&pause, nullptr);
  }
  errno = saved;
}

void onSignal(int signal) {
  sayZero();
  if (halts(signal)) {
    raise(SIGSTOP);  // Returns when it is continued.
    has_spoken.store(false);
    return;
  }
  struct sigaction standard {};
  standard.sa_handler = SIG_DFL;
  sigaction(signal, &standard, nullptr);
  raise(signal);  // Pending until the handler returns.
}
}  // namespace

EmergencyStop::EmergencyStop(int descriptor) {
  last_frame = encode({.homing = true, .lights = red});
  descriptor_of_falcon.store(descriptor);
  has_spoken.store(false);
  // exit() from anywhere runs no destructor of what lives on a stack.
  static const bool kAtExit = std::atexit(sayZero) == 0;
  (void)kAtExit;
  for (int signal = 1; signal < kSignals; ++signal) {
    struct sigaction before {};
    // The C library keeps some to itself, and says so.
    if (!isLast(signal) || sigaction(signal, nullptr, &before) != 0) continue;
    if ((before.sa_flags & SA_SIGINFO) != 0 || before.sa_handler != SIG_DFL) continue;
    struct sigaction action {};
    action.sa_handler = onSignal;
    action.sa_flags = halts(signal) ? SA_ONSTACK | SA_RESTART : SA_ONSTACK;
    installed[static_cast<std::size_t>(signal)] = sigaction(signal, &action, nullptr) == 0;
  }
}

EmergencyStop::~EmergencyStop() {
  for (int signal = 1; signal < kSignals; ++signal) {
    bool& mine = installed[static_cast<std::size_t>(signal)];
    if (!std::exchange(mine, false)) continue;
    struct sigaction now {};
    sigaction(signal, nullptr, &now);
    if (now.sa_handler == onSignal) ::signal(signal, SIG_DFL);
  }
  descriptor_of_falcon.store(-1);
}

bool EmergencyStop::spoken() RELIEVO_REALTIME {
  return has_spoken.load(std::memory_order_relaxed);
}

}  // namespace relievo::falcon
