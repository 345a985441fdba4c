// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/dhd/dhd_device.h"

#include <cstdio>
#include <ctime>

namespace relievo::dhd {

namespace {
// What its functions return, and its errors, as its documentation numbers them.
constexpr int kAskedTooSoon = 1;
enum Error : int {
  kCommunication = 2,
  kBusy = 3,
  kNoDriver = 4,
  kNoDevice = 5,
  kTimeout = 7,
  kNotReady = 12,
  kInUse = 20
};
// Places of its status words, and why a force is off.
constexpr std::size_t kStatusWords = 17;
enum Word : std::size_t {
  kPower = 0,
  kConnected = 1,
  kStarted = 2,
  kReset = 3,
  kForce = 5,
  kBrake = 6,
  kErrorWord = 9,
  kWhyOff = 14
};
constexpr int kOffByWatchdog = 3;

constexpr unsigned char kOn = 1, kOff = 0;
constexpr unsigned char kWatchdog125us = 160;  // 20 ms.
/// Buttons and state are asked for in turn: eight steps each.
constexpr unsigned int kSteps = 8, kStateStep = 4;
constexpr std::int64_t kEnableAgainNs = 250'000'000;

relievo_status statusOf(int error) RELIEVO_REALTIME {
  switch (error) {
    case kCommunication:
    case kTimeout:
      return RELIEVO_TIMEOUT;
    case kNoDevice:
      return RELIEVO_DISCONNECTED;
    case kBusy:
    case kInUse:
      return RELIEVO_BUSY;
    case kNoDriver:
      return RELIEVO_FORBIDDEN;
    case kNotReady:
      return RELIEVO_NOT_READY;
    default:
      return RELIEVO_INTERNAL;
  }
}

std::int64_t nowNs() RELIEVO_REALTIME {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
}
}  // namespace

void DhdDevice::say(const char* what, const char* detail) noexcept {
  std::snprintf(error_.data(), error_.size(), "%s%s%s", what, *detail == '\0' ? "" : ": ", detail);
}

/// Right after the call that failed: the library keeps the last error of each thread.
relievo_status DhdDevice::failed(const char* what) noexcept {
  const relievo_status status = statusOf(library_.last_error());
  const char* const words = library_.last_error_text();
  say(what, words == nullptr ? "" : words);
  return status;
}

relievo_status DhdDevice::open() noexcept {
  if (id_.load() != kClosed) return RELIEVO_OK;
  const int count = library_.device_count();
  if (count < 0) return failed("devices cannot be looked for");
  if (count == 0 || (!which_.by_serial && which_.number >= count)) {
    say("it is not plugged in");
    return RELIEVO_DISCONNECTED;
  }
  if (which_.by_serial && library_.open_serial == nullptr) {
    say("this library opens none by its serial number: it has no function dhdOpenSerial");
    return RELIEVO_NO_LIBRARY;
  }
  const int opened = which_.by_serial ? library_.open_serial(which_.number)
                                      : library_.open_id(static_cast<char>(which_.number));
  if (opened < 0) return failed("it was not opened");
  const char id = static_cast<char>(opened);
  const relievo_status status = prepare(id);
  if (status < 0) {
    library_.set_force(0, 0, 0, id);
    library_.enable_force(kOff, id);
    library_.close(id);
    return status;
  }
  steps_ = 0;
  buttons_ = 0;
  state_ = RELIEVO_OK;
  enabled_ns_ = 0;
  id_.store(opened, std::memory_order_release);
  return RELIEVO_OK;
}

/// Returns with forces on and at zero.
relievo_status DhdDevice::prepare(char id) noexcept {
  const int type = library_.system_type(id);
  if (type < 0) return failed("its type is not told");
  model_ = modelOf(type);
  if (model_ == nullptr) {
    const char* const name = library_.system_name(id);
    std::snprintf(error_.data(), error_.size(), "%.80s (type %d) is not driven: %s",
                  name == nullptr ? "this device" : name, type, whyNot(type));
    return RELIEVO_INTERNAL;
  }
  // Without it a killed process would leave the last force on: limits() says which it is.
  const bool may_set = library_.enable_expert_mode != nullptr && library_.set_watchdog != nullptr;
  own_watchdog_ = may_set && library_.enable_expert_mode() >= 0 &&
                  library_.set_watchdog(kWatchdog125us, id) >= 0;
  if (library_.set_max_force != nullptr) library_.set_max_force(model_->max_force_n, id);
  if (library_.set_gravity_compensation(kOn, id) < 0) return failed("its arm is not held");
  if (library_.enable_force(kOn, id) < 0) return failed("its forces are not switched on");
  return library_.set_force(0, 0, 0, id) < 0 ? failed("it takes no force") : RELIEVO_OK;
}

void DhdDevice::close() noexcept {
  const int opened = id_.load(std::memory_order_acquire);
  if (opened == kClosed) return;
  const char id = static_cast<char>(opened);
  library_.set_force(0, 0, 0, id);
  library_.enable_force(kOff, id);
  id_.store(kClosed, std::memory_order_release);
  library_.close(id);
}

relievo_status DhdDevice::limits(relievo_device_limits& out) noexcept {
  if (model_ == nullptr) return RELIEVO_DISCONNECTED;
  constexpr double kStepMm = 0.05, kDelayMs = 1, kRateHz = 1000;  // Until somebody measures them.
  out.flags = own_watchdog_ ? RELIEVO_HAS_OWN_WATCHDOG : 0;
  for (std::size_t i = 0; i < 3; ++i) out.half_extent_mm[i] = model_->half_extent_mm[i];
  out.max_force_n = model_->max_force_n;
  out.continuous_force_n = 0;
  out.max_stiffness_n_per_mm = model_->max_stiffness_n_per_mm;
  out.position_step_mm = kStepMm;
  out.force_delay_ms = kDelayMs;
  out.rate_hz = kRateHz;
  return RELIEVO_OK;
}

/// A force that the watchdog ended, because this computer was busy, is switched on again: it rises
/// from zero with orders that were made since. Brakes, the button at the device and whatever else
/// took it away are for a person.
relievo_status DhdDevice::lookAtState(std::int64_t now_ns, char id) RELIEVO_REALTIME {
  std::array<int, kStatusWords> words{};
  if (library_.status(words.data(), id) < 0) return statusOf(library_.last_error());
  if (words[kConnected] == 0) return RELIEVO_DISCONNECTED;
  if (words[kPower] == 0 || words[kStarted] == 0 || words[kReset] == 0) return RELIEVO_NOT_READY;
  if (words[kErrorWord] > 0) return RELIEVO_INTERNAL;
  if (words[kForce] != 0 && words[kBrake] <= 0) return RELIEVO_OK;
  if (words[kWhyOff] == kOffByWatchdog && now_ns - enabled_ns_ > kEnableAgainNs) {
    enabled_ns_ = now_ns;
    library_.set_force(0, 0, 0, id);
    library_.enable_force(kOn, id);
  }
  return RELIEVO_FORCE_OFF;
}

/// Whether the library took it. Motors that cannot show all of it count as that.
bool DhdDevice::send(const Three& force_n, unsigned int cuts, char id) RELIEVO_REALTIME {
  const bool cut = cuts_.load(std::memory_order_acquire) != cuts;
  const Three shown = cut ? Three{} : forceForLibrary(force_n);
  const bool taken = library_.set_force(shown[0], shown[1], shown[2], id) >= 0;
  // The cut may have come between the look and the call.
  if (!cut && cuts_.load(std::memory_order_acquire) != cuts) library_.set_force(0, 0, 0, id);
  return taken;
}

relievo_status DhdDevice::step(const Three& force_n, std::int64_t now_ns,
                               relievo_sample& out) RELIEVO_REALTIME {
  const int opened = id_.load(std::memory_order_acquire);
  if (opened == kClosed) return RELIEVO_DISCONNECTED;
  const char id = static_cast<char>(opened);
  const unsigned int cuts = cuts_.load(std::memory_order_acquire);
  if (steps_ % kSteps == 0) buttons_ = buttonsOf(library_.button_mask(id));
  if (steps_ % kSteps == kStateStep) state_ = lookAtState(now_ns, id);
  ++steps_;
  Three place_m{};
  const int got = library_.position(place_m.data(), place_m.data() + 1, place_m.data() + 2, id);
  relievo_status status = got < 0 ? statusOf(library_.last_error()) : state_;
  if (!send(status < 0 ? Three{} : force_n, cuts, id) && status >= 0) {
    status = statusOf(library_.last_error());
    library_.set_force(0, 0, 0, id);
  }
  out.buttons = buttons_;  // Also where it shows no force.
  if (status < 0) return status;
  if (got == kAskedTooSoon) return RELIEVO_NO_NEWS;
  const Three place_mm = withinSight(placeMm(place_m), model_->half_extent_mm);
  for (std::size_t i = 0; i < 3; ++i) out.position_mm[i] = place_mm[i];
  out.time_ns = nowNs();
  out.hottest_motor = -1;
  return RELIEVO_OK;
}

relievo_status DhdDevice::cut() RELIEVO_REALTIME {
  cuts_.fetch_add(1, std::memory_order_acq_rel);
  const int opened = id_.load(std::memory_order_acquire);
  if (opened == kClosed) return RELIEVO_OK;
  // Not EnableForce off: the arm would drop.
  return library_.set_force(0, 0, 0, static_cast<char>(opened)) < 0 ? RELIEVO_TIMEOUT : RELIEVO_OK;
}

}  // namespace relievo::dhd
