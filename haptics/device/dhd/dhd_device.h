// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "haptics/device/dhd/dhd_library.h"
#include "haptics/device/dhd/models.h"
#include "haptics/device/foreign/relievo_device.h"
#include "haptics/rt/realtime.h"

namespace relievo::dhd {

/// Which device is meant: the one of that place in the library's list, or of that serial number.
struct Which {
  bool by_serial = false;
  int number = 0;
};

/// One device of Force Dimension, by their library. Its functions are those of relievo_device.h,
/// with the threads that are named there.
class DhdDevice {
 public:
  /// @param library  outlives this
  DhdDevice(const DhdLibrary& library, Which which) noexcept : library_(library), which_(which) {}

  relievo_status open() noexcept;
  void close() noexcept;
  relievo_status limits(relievo_device_limits& out) noexcept;
  relievo_status step(const Three& force_n, std::int64_t now_ns,
                      relievo_sample& out) RELIEVO_REALTIME;
  relievo_status cut() RELIEVO_REALTIME;
  const char* lastError() const noexcept { return error_.data(); }

 private:
  static constexpr int kClosed = -1;

  void say(const char* what, const char* detail = "") noexcept;
  relievo_status failed(const char* what) noexcept;
  relievo_status prepare(char id) noexcept;
  relievo_status lookAtState(std::int64_t now_ns, char id) RELIEVO_REALTIME;
  bool send(const Three& force_n, unsigned int cuts, char id) RELIEVO_REALTIME;

  const DhdLibrary& library_;
  Which which_;
  std::atomic<int> id_{kClosed};       // As the library counts; cut() may ask at any time.
  std::atomic<unsigned int> cuts_{0};  // A step that was under way sends nothing more.
  const Model* model_ = nullptr;       // Of an open one.
  bool own_watchdog_ = false;          // Its motors go free without us.
  std::array<char, 200> error_{"nothing went wrong"};
  // [device]
  unsigned int steps_ = 0;
  std::uint32_t buttons_ = 0;
  relievo_status state_ = RELIEVO_OK;  // As it was looked at last.
  std::int64_t enabled_ns_ = 0;        // When forces were last switched on again.
};

}  // namespace relievo::dhd
