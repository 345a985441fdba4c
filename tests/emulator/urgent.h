// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pthread.h>
#include <sched.h>

namespace relievo::emulator {

/// A lock whose holder is as urgent as the most urgent thread that waits for it: a test that looks
/// at an emulated device keeps nobody waiting for longer than the look takes.
class UrgentMutex {
 public:
  UrgentMutex() {
    pthread_mutexattr_t kind;
    pthread_mutexattr_init(&kind);
    pthread_mutexattr_setprotocol(&kind, PTHREAD_PRIO_INHERIT);
    pthread_mutex_init(&mutex_, &kind);
    pthread_mutexattr_destroy(&kind);
  }
  ~UrgentMutex() { pthread_mutex_destroy(&mutex_); }
  UrgentMutex(const UrgentMutex&) = delete;
  UrgentMutex& operator=(const UrgentMutex&) = delete;
  // NOLINTBEGIN(readability-identifier-naming): names that std::lock_guard looks for.
  void lock() { pthread_mutex_lock(&mutex_); }
  void unlock() { pthread_mutex_unlock(&mutex_); }
  // NOLINTEND(readability-identifier-naming)

 private:
  pthread_mutex_t mutex_{};
};

/// A real device answers however busy the computer is. The thread that calls is more urgent than
/// any of the program's from now on, where the system grants that; else nothing changes.
inline void beUrgentAsADevice() {
  sched_param parameters{};
  parameters.sched_priority = 90;  // The loop's watchdog, the most urgent one, has 81.
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
}

/// While it lives the calling thread, and what it starts, is as urgent as a loop that keeps time,
/// where the system grants that: for what is measured on the computer's clock by a thread that is
/// not urgent by itself.
class Urgent {
 public:
  Urgent() {
    pthread_getschedparam(pthread_self(), &policy_, &before_);
    sched_param parameters{};
    parameters.sched_priority = 60;  // The Falcon's thread has 75.
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  }
  ~Urgent() { pthread_setschedparam(pthread_self(), policy_, &before_); }
  Urgent(const Urgent&) = delete;
  Urgent& operator=(const Urgent&) = delete;

 private:
  int policy_ = SCHED_OTHER;
  sched_param before_{};
};

}  // namespace relievo::emulator
