// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/last_words.h"

#include <sys/ioctl.h>
#include <csignal>
#include <ctime>

#include <linux/usbdevice_fs.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>

#include "haptics/device/falcon/protocol.h"

namespace relievo::falcon {

namespace {
constexpr std::array<int, 10> kSignals{SIGSEGV, SIGBUS,  SIGILL, SIGFPE,  SIGABRT,
                                       SIGINT,  SIGTERM, SIGHUP, SIGQUIT, SIGTSTP};

// A signal handler finds nothing but globals.
std::atomic<int> descriptor_of_falcon{-1};
std::atomic<bool> has_spoken{false};
std::array<bool, kSignals.size()> installed{};
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
  if (signal == SIGTSTP) {
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

LastWords::LastWords(int descriptor) {
  last_frame = encode({.homing = true, .lights = red});
  descriptor_of_falcon.store(descriptor);
  has_spoken.store(false);
  // exit() from anywhere runs no destructor of what lives on a stack.
  static const bool kAtExit = std::atexit(sayZero) == 0;
  (void)kAtExit;
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    struct sigaction before {};
    if (sigaction(kSignals[i], nullptr, &before) != 0) continue;
    if ((before.sa_flags & SA_SIGINFO) != 0 || before.sa_handler != SIG_DFL) continue;
    struct sigaction action {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_ONSTACK;
    installed[i] = sigaction(kSignals[i], &action, nullptr) == 0;
  }
}

LastWords::~LastWords() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    if (!installed[i]) continue;
    struct sigaction now {};
    sigaction(kSignals[i], nullptr, &now);
    if (now.sa_handler == onSignal) signal(kSignals[i], SIG_DFL);
    installed[i] = false;
  }
  descriptor_of_falcon.store(-1);
}

bool LastWords::spoken() RELIEVO_REALTIME {
  return has_spoken.load(std::memory_order_relaxed);
}

}  // namespace relievo::falcon
