// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/rt/realtime_thread.h"

#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <cerrno>
#include <cstring>
#include <ctime>

#include "haptics/rt/rtkit.h"

namespace relievo {

namespace {
constexpr std::int64_t kNsPerS = 1'000'000'000;

void addSentence(std::string& note, const std::string& sentence) {
  if (!note.empty()) note += ' ';
  note += sentence;
}

bool askForFifo(int priority, std::string& note) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  if (::sched_setscheduler(0, SCHED_FIFO, &parameters) == 0) return true;
  const int reason = errno;
  const std::string refusal = askRealtimeKit(priority);
  if (refusal.empty()) return true;
  addSentence(note, "Real-time priority was refused (" + std::string(std::strerror(reason)) +
                        "; RealtimeKit: " + refusal +
                        "); the forces may be less even while the computer is busy." +
                        (reason == EPERM ? " An administrator can allow it with an rtprio limit "
                                           "of 80 for this account."
                                         : ""));
  return false;
}

bool lockMemory(std::span<const MemoryRegion> regions, std::string& note) {
  for (const MemoryRegion& region : regions) {
    if (::mlock(region.data, region.bytes) == 0) continue;
    addSentence(note, "Memory could not be locked (" + std::string(std::strerror(errno)) +
                          "); the forces may stutter when memory is short.");
    return false;
  }
  return true;
}
}  // namespace

RealtimeGrant requestRealtime(int fifo_priority, std::span<const MemoryRegion> lock) {
  RealtimeGrant grant;
  if (fifo_priority > 0) {
    grant.realtime = askForFifo(fifo_priority, grant.note);
  } else {
    grant.note = "Real-time priority was not asked for.";
  }
  grant.memory_locked = lockMemory(lock, grant.note);
  // The default slack of 50 us is added to every wake-up of a thread without real-time priority.
  if (::prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL) != 0) {
    addSentence(grant.note,
                "The timer could not be made finer (" + std::string(std::strerror(errno)) + ").");
  }
  return grant;
}

std::int64_t monotonicNs() RELIEVO_REALTIME {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * kNsPerS + now.tv_nsec;
}

std::uint64_t threadPageFaults() RELIEVO_REALTIME {
  rusage usage{};
  ::getrusage(RUSAGE_THREAD, &usage);
  return static_cast<std::uint64_t>(usage.ru_minflt + usage.ru_majflt);
}

void sleepUntil(std::int64_t monotonic_ns) RELIEVO_REALTIME {
  timespec until{};
  until.tv_sec = static_cast<time_t>(monotonic_ns / kNsPerS);
  until.tv_nsec = static_cast<long>(monotonic_ns % kNsPerS);
  while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

}  // namespace relievo
