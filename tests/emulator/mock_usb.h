// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "tests/emulator/falcon_emulator.h"

namespace relievo::emulator {

/// How the kernel's side of the mocked port behaves.
struct MockPortState {
  bool claimed_by_other = false;  ///< Another program has the interface.
  bool kernel_driver = false;     ///< ftdi_sio is bound.
};

/// What programs have asked of it.
struct MockPortCounts {
  std::uint64_t reaps = 0, submits = 0, detached = 0, attached = 0;
};

/// The emulated Falcon on a USB port that the real libusb finds: sysfs, the device node's requests
/// and the events of plugging are umockdev's. The process, and every client, must run with
/// libumockdev-preload.
class MockUsb {
 public:
  MockUsb();
  ~MockUsb();
  MockUsb(const MockUsb&) = delete;
  MockUsb& operator=(const MockUsb&) = delete;
  /// false: umockdev's library is not preloaded here, and programs would see the real ports.
  static bool works();

  static constexpr const char* kSerial = "NV000001";
  void plugIn(std::shared_ptr<SharedFalcon> falcon);
  /// On the next port: it is seen, and cannot be opened. Stays.
  void plugInAnother(const std::string& serial);
  /// No account but root may open the node any more; until it is plugged in anew.
  void forbid();
  /// Pulls the plug: transfers under way fail, the node goes away, the event is sent.
  void unplug();
  /// Safe from the test's thread.
  void set(const MockPortState& state);
  MockPortCounts counts();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo::emulator
