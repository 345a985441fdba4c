// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/rt/realtime_thread.h"

#include <link.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <ctime>

#include "haptics/rt/rtkit.h"
#include "haptics/rt/signal_stack.h"

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

constexpr std::size_t kPage = 4096;

/// What was asked to be locked, and how that went.
struct Locking {
  std::uint64_t wanted = 0, locked = 0;
  int reason = 0;  // errno of the first refusal.

  void lock(const void* data, std::size_t bytes) {
    wanted += bytes;
    if (::mlock(data, bytes) == 0) {
      locked += bytes;
      return;
    }
    if (reason == 0) reason = errno;
    const auto* page = static_cast<const volatile char*>(data);
    for (std::size_t i = 0; i < bytes; i += kPage) [[maybe_unused]] const char seen = page[i];
  }
};

/// The stack below this frame: written once, so that it exists, then locked.
[[gnu::noinline]] void lockStack(Locking& locking) {
  std::array<volatile char, kStackBytes> stack;  // NOLINT(*-member-init): that is the point.
  for (std::size_t i = 0; i < stack.size(); i += kPage) stack[i] = 0;
  locking.lock(const_cast<const char*>(stack.data()), stack.size());
}

/// Locks each segment of the library or program that holds one of the addresses.
struct CodeWanted {
  std::array<std::uintptr_t, 3> addresses;
  Locking* locking;
};
int lockObject(dl_phdr_info* object, std::size_t, void* data) {
  const auto& wanted = *static_cast<const CodeWanted*>(data);
  const std::span<const ElfW(Phdr)> segments(object->dlpi_phdr, object->dlpi_phnum);
  const auto holds = [&](const ElfW(Phdr) & segment) {
    const std::uintptr_t first = object->dlpi_addr + segment.p_vaddr;
    return segment.p_type == PT_LOAD &&
           std::any_of(wanted.addresses.begin(), wanted.addresses.end(), [&](std::uintptr_t at) {
             return at >= first && at < first + segment.p_memsz;
           });
  };
  if (std::none_of(segments.begin(), segments.end(), holds)) return 0;
  for (const ElfW(Phdr) & segment : segments) {
    if (segment.p_type != PT_LOAD || (segment.p_flags & PF_R) == 0) continue;
    const std::uintptr_t first = object->dlpi_addr + segment.p_vaddr;
    // The loader names addresses by numbers. NOLINTNEXTLINE(performance-no-int-to-ptr)
    wanted.locking->lock(reinterpret_cast<const void*>(first), segment.p_memsz);
  }
  return 0;
}

/// Our own code, the C library's and the mathematical one's.
void lockCode(Locking& locking) {
  using Root = double (*)(double, double);
  const Root power = &std::pow;
  CodeWanted wanted{{reinterpret_cast<std::uintptr_t>(&requestRealtime),
                     reinterpret_cast<std::uintptr_t>(&::clock_nanosleep),
                     reinterpret_cast<std::uintptr_t>(power)},
                    &locking};
  ::dl_iterate_phdr(lockObject, &wanted);
}

bool lockMemory(std::span<const MemoryRegion> regions, RealtimeGrant& grant) {
  Locking locking;
  for (const MemoryRegion& region : regions) locking.lock(region.data, region.bytes);
  lockStack(locking);
  lockCode(locking);
  grant.locked_bytes = locking.locked;
  if (locking.reason == 0) return true;
  const auto kilobytes = [](std::uint64_t bytes) { return std::to_string(bytes >> 10U); };
  addSentence(grant.note, "Memory could not be locked (" +
                              std::string(std::strerror(locking.reason)) + "; " +
                              kilobytes(locking.locked) + " of " + kilobytes(locking.wanted) +
                              " kB are); the forces may stutter when memory is short. A larger "
                              "memlock limit for this account helps.");
  return false;
}
}  // namespace

RealtimeGrant requestRealtime(int fifo_priority, std::span<const MemoryRegion> lock) {
  giveSignalStack();
  RealtimeGrant grant;
  if (fifo_priority > 0) {
    grant.realtime = askForFifo(fifo_priority, grant.note);
  } else {
    grant.note = "Real-time priority was not asked for.";
  }
  grant.memory_locked = lockMemory(lock, grant);
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
