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
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

#include "haptics/device/foreign/relievo_device.h"
#include "tests/haptics/device/foreign/stand_in_log.h"

namespace {

using relievo::test::StandInEntry;

enum class Fault {
  none,
  no_table,  // Its name is another's: in CMakeLists.txt.
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
  hangs_pushed,      // As soon as it is pushed.
  fails_pushed,      // Likewise, once.
  starts_program,    // That writes which descriptors it has.
  allocates_beside,  // In a thread of its own.
  cut_needs_open,
  warms,  // Motors that can show 1 N for good.
  hot,    // At its limit.
  wants_guard,
  takes_force,  // Away, once the file beside its log is there, until it is opened again; its
                // button Centre is held while another file is there.
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
bool force_taken = false;

/// Whether a thread of this process has that name.
bool hasThread(const char* name) {
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream stream(task.path() / "comm");
    std::string comm;
    if (std::getline(stream, comm) && comm == name) return true;
  }
  return false;
}

bool is_open = false;
std::atomic<bool> working{false};
std::thread worker;

/// What a maker's library may do beside.
void allocateUntilClosed() {
  working = true;
  worker = std::thread([] {
    while (working) {
      void* volatile memory = std::malloc(16);
      std::free(memory);
    }
  });
}
void endWorker() {
  working = false;
  if (worker.joinable()) worker.join();
}

relievo_status openIt(void* /*self*/) {
  if (is(Fault::wants_guard) && !hasThread("guard")) return RELIEVO_INTERNAL;
  if (is(Fault::allocates_beside) && !working) allocateUntilClosed();
  is_open = true;
  if (is(Fault::open_fails)) return RELIEVO_BUSY;
  if (is(Fault::open_hangs)) pause(600'000);
  if (is(Fault::never_reopens) && was_closed) return RELIEVO_BUSY;
  steps = 0;
  force_taken = false;
  return RELIEVO_OK;
}

void closeIt(void* /*self*/) {
  if (is(Fault::close_hangs)) pause(600'000);
  was_closed = true;
  is_open = false;
  endWorker();
  note(StandInEntry::What::close, 0);
}

relievo_status limitsOfIt(void* /*self*/, relievo_device_limits* out) {
  if (!is(Fault::weak)) out->flags = RELIEVO_HAS_OWN_WATCHDOG;
  for (double& extent : out->half_extent_mm) extent = 40;
  out->max_force_n = 9;
  out->continuous_force_n = is(Fault::warms) ? 1 : 9;
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

/// Whether there is a file beside the log, of the log's name with that at its end.
bool isSigned(const char* end) {
  const std::string file = std::string(std::getenv("RELIEVO_STAND_IN_LOG")) + end;
  return ::access(file.c_str(), F_OK) == 0;
}

/// Of those that work until they are pushed.
relievo_status pushed() {
  if (is(Fault::hangs_pushed)) pause(600'000);
  return is(Fault::fails_pushed) ? RELIEVO_PROTOCOL : RELIEVO_OK;
}

relievo_status stepIt(void* /*self*/, const double force_n[3], std::int64_t now_ns,
                      relievo_sample* out) {
  ++steps;
  note(StandInEntry::What::step, std::hypot(force_n[0], force_n[1], force_n[2]));
  constexpr int kUntilPressed = 5;
  out->buttons = steps > kUntilPressed ? 0b10001 : 0;  // One button, and one that there is not.
  out->position_mm[0] = 1;
  out->position_mm[1] = 2;
  out->position_mm[2] = 3;
  out->time_ns = now_ns;
  out->hottest_motor = is(Fault::hot) && isTime() ? 1 : -1;
  if (is(Fault::takes_force)) {
    constexpr std::uint32_t kCentre = 0b100;
    out->buttons = isSigned(".holds") ? kCentre : 0;
    force_taken = force_taken || isSigned(".takes");
    if (force_taken) return RELIEVO_FORCE_OFF;
  }
  constexpr double kPushedN = 0.2;
  if (std::abs(force_n[0]) > kPushedN) {
    if (const relievo_status status = pushed(); status < 0) return status;
  }
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
  if (is(Fault::cut_needs_open) && !is_open) std::abort();
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
  if (is(Fault::starts_program)) {
    [[maybe_unused]] const int status = std::system(
        "exec >\"$RELIEVO_STAND_IN_LOG.descriptors\"; for fd in 3 4 5; do [ -e /proc/self/fd/$fd ] "
        "&& echo $fd; done; echo end");
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
