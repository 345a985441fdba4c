// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "haptics/device/hid/hid_reports.h"

namespace relievo::hid {

/// A press or a release on any device.
struct ButtonEdge {
  std::uint8_t button = 0;  ///< 0 plus, 1 forward, 2 centre, 3 minus: the Falcon's.
  bool down = false;
};

struct HidEvents {
  std::vector<ButtonEdge> edges;
  CapMotion motion;                        ///< Of the SpaceMouse now: CapReports::motion().
  std::vector<std::string> arrived, left;  ///< Names, for people.
  /// Came, and this account may not open it: told once, at the second look, because the system
  /// hands out access a moment after the plug. The hint is falcon::udevRule().
  std::vector<std::string> forbidden;
};

/// SpaceMouse, button boxes, foot switches and gamepads through hidapi. It is asked.
/// Keyboards and mice are left to the window. [one thread]
///
/// A SpaceMouse's left button is minus, its right one plus; of other devices the first four buttons
/// are plus, forward, centre, minus; one that has a single button gives centre.
class HidDevices {
 public:
  HidDevices();   ///< @throw DeviceError  HID cannot be used at all
  ~HidDevices();  ///< Closes all.
  HidDevices(const HidDevices&) = delete;
  HidDevices& operator=(const HidDevices&) = delete;

  /// Has a worker look for what was plugged in, which may take long: about once a second. A later
  /// poll() takes what it found; while it looks, this does nothing.
  void look();
  /// The same at once. [may wait]
  void rescan(HidEvents& news);
  /// Takes all that came since the last call; about 60 times a second. One that was unplugged lets
  /// go of its buttons; a cap that tells nothing any more is at rest (CapReports). Never waits.
  /// @param now_s  of a clock that never goes back
  void poll(HidEvents& news, double now_s);

  /// Of those that are open.
  std::vector<std::string> names() const;
  /// Of those that the last rescan() saw and this account may not open.
  std::vector<std::string> forbidden() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Of the hidapi that this process has loaded: "0.13.1".
std::string hidapiVersion();

}  // namespace relievo::hid
