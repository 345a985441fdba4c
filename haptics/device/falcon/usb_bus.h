// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "haptics/device/falcon/port.h"

struct libusb_device;

namespace relievo::falcon {

/// All of them, in the order of their ports. None where USB cannot be used at all; opening says
/// why.
std::vector<SeenFalcon> seenFalcons();

/// Of the libusb that this process has loaded, which this does: "1.0.26" or "not installed".
std::string libusbVersion();
/// Why it cannot be loaded, in the system's words; empty: it can.
std::string libusbProblem();

/// Where any is meant and one is plugged in, that one; so that its own settings can be read.
FalconChoice settled(const FalconChoice& choice);

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
  /// @param choice  the one that is meant; any: the only one, to which it keeps then
  /// @throw DeviceError  USB cannot be used at all
  explicit UsbBus(FalconChoice choice = {});
  ~UsbBus() override;
  Opening open() override;
  FalconChoice choice() const override { return search_.choice(); }
  void waitForChange(std::int64_t until_ns) override;
  std::int64_t now() override;
  std::int64_t slept() override;

 private:
  Opening openSeen();
  void open(libusb_device* device, Opening& opening);

  struct Impl;
  std::unique_ptr<Impl> impl_;
  FalconSearch search_;
};

}  // namespace relievo::falcon
