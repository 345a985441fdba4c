// SPDX-License-Identifier: BSD-3-Clause
// Stands in for Force Dimension's library: the functions that the plug-in asks for, with a
// simulated hand behind them. RELIEVO_DHD says what is different, as "WORD NUMBER WORD NUMBER":
//   type N        which type it is; 33 without
//   x|y|z N       it stays at that place, in micrometres of the library's axes
//   buttons N     the mask of its buttons, after some places
//   open N        opening fails with that error
//   error N       after some places asking for one fails with that error
//   force_error N likewise setting a force
//   too_soon 1    then no place is new
//   saturated 1   the motors cannot show all of a force
//   off N         after some places the force is off, for that reason, until it is switched on
//   again brake N       likewise the brakes hold, for so many looks at the state word N        that
//   word of the state is 0 devices N     how many are plugged in; 1 without
// Its calls go into the file RELIEVO_DHD_LOG as DhdCall.
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <mutex>
#include <sstream>
#include <string>
#include <utility>

#include "tests/haptics/device/dhd/dhd_log.h"

#define EXPORTED extern "C" __attribute__((visibility("default")))

namespace {

using relievo::test::DhdCall;
using What = DhdCall::What;

/// What RELIEVO_DHD says of a word.
int said(const std::string& word, int otherwise) {
  const char* const text = std::getenv("RELIEVO_DHD");
  std::istringstream stream(text == nullptr ? "" : text);
  std::string known;
  for (int number = 0; stream >> known >> number;) {
    if (known == word) return number;
  }
  return otherwise;
}

std::int64_t now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
}

/// As the device is now; whoever asks, from whichever thread.
struct Device {
  std::mutex lock;
  int log = -1;
  bool read = false, open = false, enabled = false;
  int type = 33, buttons = 0, open_error = -1, error = -1, force_error = -1, off = 0, brake = 0;
  int word = -1, devices = 1;
  bool too_soon = false, saturated = false, fixed = false;
  std::array<double, 3> place_m{}, speed_m_s{}, force_n{};
  std::int64_t moved_ns = 0;
  int places = 0;

  void note(What what, std::array<double, 3> given = {}) const {
    const DhdCall call{now(), what, static_cast<std::int32_t>(::syscall(SYS_gettid)), given};
    if (log >= 0 && ::write(log, &call, sizeof(call)) < 0) std::abort();
  }
  /// Before it is opened, so that nothing is read or allocated in a step.
  void begin() {
    if (std::exchange(read, true)) return;
    if (const char* const file = std::getenv("RELIEVO_DHD_LOG")) {
      log = ::open(file, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    }
    type = said("type", type);
    buttons = said("buttons", 0);
    open_error = said("open", -1);
    error = said("error", -1);
    force_error = said("force_error", -1);
    off = said("off", 0);
    brake = said("brake", 0);
    word = said("word", -1);
    devices = said("devices", 1);
    too_soon = said("too_soon", 0) != 0;
    saturated = said("saturated", 0) != 0;
    constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      const int at_um = said(kAxes[i], 0);
      place_m[i] = 1e-6 * at_um;
      fixed = fixed || at_um != 0;
    }
  }
  /// Faults begin a little later, so that a device that works is lost.
  bool isTime() const { return places > 20; }
  /// A hand of 0.2 kg on a soft spring.
  void move() {
    const std::int64_t time_ns = now();
    double seconds = 1e-9 * static_cast<double>(time_ns - moved_ns);
    if (seconds > 0.005) seconds = 0.005;
    moved_ns = time_ns;
    if (fixed) return;
    for (std::size_t i = 0; i < 3; ++i) {
      const double push_n = force_n[i] - 100 * place_m[i] - 4 * speed_m_s[i];
      speed_m_s[i] += push_n / 0.2 * seconds;
      place_m[i] += speed_m_s[i] * seconds;
    }
  }
};
Device device;
thread_local int last_error = 0;

int failing(int error) {
  last_error = error;
  return -1;
}
}  // namespace

EXPORTED int dhdGetDeviceCount() {
  const std::lock_guard held(device.lock);
  device.begin();
  return device.devices;
}
EXPORTED int dhdErrorGetLast() {
  return last_error;
}
EXPORTED const char* dhdErrorGetLastStr() {
  return "the stand-in says why";
}
EXPORTED int dhdOpenID(char id) {
  const std::lock_guard held(device.lock);
  device.begin();
  if (device.open_error >= 0) return failing(device.open_error);
  device.open = true;
  device.note(What::open, {static_cast<double>(id), 0, 0});
  return id;
}
EXPORTED int dhdOpenSerial(int serial) {
  constexpr int kSerial = 1234, kNoDevice = 5;
  return serial == kSerial ? dhdOpenID(0) : failing(kNoDevice);
}
EXPORTED int dhdClose(char /*id*/) {
  const std::lock_guard held(device.lock);
  device.open = false;
  device.places = 0;
  device.note(What::close);
  return 0;
}
EXPORTED int dhdGetSystemType(char /*id*/) {
  return device.type;
}
EXPORTED const char* dhdGetSystemName(char /*id*/) {
  return "Stand-in";
}
EXPORTED int dhdGetPosition(double* x, double* y, double* z, char /*id*/) {
  const std::lock_guard held(device.lock);
  ++device.places;
  if (device.isTime() && device.error >= 0) return failing(device.error);
  if (device.isTime() && device.too_soon) return 1;
  device.move();
  *x = device.place_m[0];
  *y = device.place_m[1];
  *z = device.place_m[2];
  return 0;
}
#ifndef WITHOUT_FORCE
EXPORTED int dhdSetForce(double x, double y, double z, char /*id*/) {
  const std::lock_guard held(device.lock);
  device.note(What::force, {x, y, z});
  if (device.isTime() && device.force_error >= 0) return failing(device.force_error);
  device.force_n = {x, y, z};
  return device.saturated ? 2 : 0;
}
#endif
EXPORTED unsigned int dhdGetButtonMask(char /*id*/) {
  const std::lock_guard held(device.lock);
  return device.isTime() ? static_cast<unsigned int>(device.buttons) : 0;
}
EXPORTED int dhdGetStatus(int* words, char /*id*/) {
  const std::lock_guard held(device.lock);
  constexpr std::size_t kWords = 17, kIdle = 4, kForce = 5, kBrake = 6, kError = 9, kWhyOff = 14;
  for (std::size_t i = 0; i < kWords; ++i) words[i] = 1;
  words[kIdle] = words[kBrake] = words[kError] = words[kWhyOff] = 0;
  if (device.isTime() && device.off > 0) {
    words[kForce] = 0;
    words[kWhyOff] = device.off;
  }
  if (device.isTime() && device.brake > 0) {
    --device.brake;
    words[kForce] = 0;
    words[kBrake] = 1;
  }
  if (device.isTime() && device.word >= 0) words[device.word] = 0;
  return 0;
}
EXPORTED int dhdEnableForce(unsigned char on, char /*id*/) {
  const std::lock_guard held(device.lock);
  device.note(What::enable, {static_cast<double>(on), 0, 0});
  if (device.isTime() && on != 0) device.off = 0;
  return 0;
}
EXPORTED int dhdSetGravityCompensation(int on, char /*id*/) {
  device.note(What::gravity, {static_cast<double>(on), 0, 0});
  return 0;
}
EXPORTED int dhdEnableExpertMode() {
  return 0;
}
#ifndef WITHOUT_WATCHDOG
EXPORTED int dhdSetWatchdog(unsigned char units, char /*id*/) {
  device.note(What::watchdog, {static_cast<double>(units), 0, 0});
  return 0;
}
#endif
EXPORTED int dhdSetMaxForce(double newton, char /*id*/) {
  device.note(What::most_force, {newton, 0, 0});
  return 0;
}
