// SPDX-License-Identifier: BSD-3-Clause
// A plug-in for a device that is not there, with at most one fault, which FAULT names. It writes
// the forces that it gets into the file RELIEVO_STAND_IN_LOG, as StandInEntry.
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cfenv>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <limits>
#include <stdexcept>

#include "haptics/device/foreign/relievo_device.h"
#include "tests/haptics/device/foreign/stand_in_log.h"

namespace {

using relievo::test::StandInEntry;

enum class Fault {
  none,
  other_major,
  short_table,
  null_function,
  init_fails,
  scan_overruns,
  knows_everyone,
  false_extension,
  leaks,
  changes_rounding,
  takes_signals,
  prints,
  open_fails,
  open_hangs,
  no_limits,
  weak,  // Without a watchdog of its own.
  nan_place,
  far_place,
  frozen_time,
  future,
  jumps,
  sleeps,
  allocates,
  cut_fails,
  never_reopens,
  hangs,
  crashes,
  aborts,
  throws,
  ends_process,
  loses_device,
  close_hangs,
};
constexpr Fault kFault = Fault::FAULT;
constexpr bool is(Fault fault) {
  return kFault == fault;
}

std::int64_t now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
}

void pause(int ms) {
  const timespec time{ms / 1000, 1'000'000L * (ms % 1000)};
  ::nanosleep(&time, nullptr);
}

std::atomic<int> log_file{-1};
void note(StandInEntry::What what, double force_n) {
  const StandInEntry entry{now(), what, force_n};
  if (log_file.load() >= 0 && ::write(log_file.load(), &entry, sizeof(entry)) < 0) std::abort();
}

std::atomic<int> steps{0};
bool was_closed = false;

relievo_status openIt(void* /*self*/) {
  if (is(Fault::open_fails)) return RELIEVO_BUSY;
  if (is(Fault::open_hangs)) pause(600'000);
  if (is(Fault::never_reopens) && was_closed) return RELIEVO_BUSY;
  steps = 0;
  return RELIEVO_OK;
}

void closeIt(void* /*self*/) {
  if (is(Fault::close_hangs)) pause(600'000);
  was_closed = true;
  note(StandInEntry::What::close, 0);
}

relievo_status limitsOfIt(void* /*self*/, relievo_device_limits* out) {
  if (!is(Fault::weak)) out->flags = RELIEVO_HAS_OWN_WATCHDOG;
  for (double& extent : out->half_extent_mm) extent = 40;
  out->max_force_n = 9;
  out->max_stiffness_n_per_mm = 1.25;
  out->position_step_mm = 0.05;
  out->force_delay_ms = 1;
  out->rate_hz = is(Fault::no_limits) ? std::numeric_limits<double>::quiet_NaN() : 1000;
  return RELIEVO_OK;
}

/// Faults begin a little later, so that a device that works is lost.
bool isTime() {
  constexpr int kWellSteps = 20;
  return steps > kWellSteps;
}

void misbehave() {
  if (is(Fault::sleeps)) pause(50);
  if (is(Fault::hangs)) pause(600'000);
  if (is(Fault::crashes)) ::raise(SIGSEGV);
  if (is(Fault::aborts)) std::abort();
  if (is(Fault::throws)) throw std::runtime_error("no exception may leave");
  if (is(Fault::ends_process)) ::_exit(0);
  if (is(Fault::allocates)) {
    void* volatile memory = std::malloc(16);  // volatile: not left out.
    std::free(memory);
  }
}

relievo_status stepIt(void* /*self*/, const double force_n[3], std::int64_t now_ns,
                      relievo_sample* out) {
  ++steps;
  note(StandInEntry::What::step, std::hypot(force_n[0], force_n[1], force_n[2]));
  out->buttons = 0b10001;  // One button, and one that there is not.
  out->position_mm[0] = 1;
  out->position_mm[1] = 2;
  out->position_mm[2] = 3;
  out->time_ns = now_ns;
  if (!isTime()) return RELIEVO_OK;
  misbehave();
  if (is(Fault::nan_place)) out->position_mm[1] = std::numeric_limits<double>::quiet_NaN();
  if (is(Fault::far_place)) out->position_mm[2] = 1000;
  if (is(Fault::frozen_time)) out->time_ns = 1;
  if (is(Fault::future)) out->time_ns = now_ns + 60'000'000'000;
  if (is(Fault::jumps) && steps % 2 == 0) out->position_mm[0] = 21;
  return is(Fault::loses_device) ? RELIEVO_DISCONNECTED : RELIEVO_OK;
}

relievo_status cutIt(void* /*self*/) {
  note(StandInEntry::What::cut, 0);
  return is(Fault::cut_fails) ? RELIEVO_TIMEOUT : RELIEVO_OK;
}

const char* lastErrorOfIt(void* /*self*/) {
  return "another program\nholds it";
}
const void* extensionOfIt(void* self, const char* /*id*/) {
  return is(Fault::false_extension) ? self : nullptr;
}

relievo_device device{.struct_size = sizeof(relievo_device),
                      .reserved = 0,
                      .self = &device,
                      .open = openIt,
                      .close = closeIt,
                      .limits = limitsOfIt,
                      .step = stepIt,
                      .cut_force = cutIt,
                      .last_error = lastErrorOfIt,
                      .get_extension = extensionOfIt};

relievo_status init(const relievo_host* /*host*/, const char* /*own_path*/) {
  if (is(Fault::init_fails)) return RELIEVO_INTERNAL;
  if (const char* const file = std::getenv("RELIEVO_STAND_IN_LOG")) {
    log_file = ::open(file, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  }
  if (is(Fault::leaks)) [[maybe_unused]]
    const int kept = ::dup(0);
  if (is(Fault::changes_rounding)) std::fesetround(FE_UPWARD);
  if (is(Fault::takes_signals)) ::signal(SIGSEGV, SIG_IGN);
  if (is(Fault::prints)) std::puts("here I am");
  return RELIEVO_OK;
}
void deinit() {
  if (log_file >= 0) ::close(log_file.exchange(-1));
}

std::uint32_t scan(relievo_device_name* out, std::uint32_t capacity) {
  if (capacity > 0 || is(Fault::scan_overruns)) {
    std::strcpy(out[0].id, "stand-in.7");
    std::strcpy(out[0].name, "Stand-in");
  }
  return 1;
}
relievo_device* create(const char* id) {
  return is(Fault::knows_everyone) || std::strcmp(id, "stand-in.7") == 0 ? &device : nullptr;
}
void destroy(relievo_device* /*device*/) {}

}  // namespace

const relievo_device_entry_t relievo_device_entry{
    .struct_size = is(Fault::short_table) ? 24U : std::uint32_t{sizeof(relievo_device_entry_t)},
    .abi_major = is(Fault::other_major) ? 9U : RELIEVO_DEVICE_ABI_MAJOR,
    .abi_minor = RELIEVO_DEVICE_ABI_MINOR,
    .reserved = 0,
    .name = "Stand-in",
    .version = "3",
    .maker = "nobody",
    .licence = "BSD-3-Clause",
    .init = init,
    .deinit = deinit,
    .scan = is(Fault::null_function) ? nullptr : scan,
    .create = create,
    .destroy = destroy};
