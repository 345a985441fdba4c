// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "haptics/device/falcon/port.h"

namespace relievo::falcon {

/// A Falcon that is plugged in, as far as can be seen without opening it.
struct SeenFalcon {
  int bus = 0, address = 0;
  int speed_mbit = 0;
};
/// None where USB cannot be used at all; opening says why.
std::vector<SeenFalcon> seenFalcons();

/// Tells when a Falcon was plugged in or pulled. Opens none. [one thread]
class PlugWatch {
 public:
  PlugWatch();  ///< Where USB cannot be used at all, nothing ever changes.
  ~PlugWatch();
  PlugWatch(const PlugWatch&) = delete;
  PlugWatch& operator=(const PlugWatch&) = delete;
  bool changed();  ///< Since the last call. Never waits.

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Falcons on USB through libusb. Made by one thread, then used by one; one port at a time is open.
class UsbBus : public Bus {
 public:
  UsbBus();  ///< @throw DeviceError  USB cannot be used at all
  ~UsbBus() override;
  Opening open() override;
  void waitForChange(std::int64_t until_ns) override;
  std::int64_t now() override;
  std::int64_t slept() override;

 private:
  Opening openSeen();

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo::falcon
