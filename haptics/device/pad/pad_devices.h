// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "haptics/device/pad/rumbler.h"

namespace relievo::pad {

/// A press or a release on any pad.
struct PadEdge {
  std::uint8_t button = 0;  ///< 0 plus, 1 forward, 2 centre, 3 minus: the Falcon's.
  bool down = false;
};

struct PadNews {
  std::vector<PadEdge> edges;
  std::vector<std::string> arrived, left;  ///< Names, for people.
};

/// One that is plugged in.
struct SeenPad {
  std::string name;
  bool access = true;    ///< This account may open it.
  bool presses = false;  ///< Its buttons come this way; else hidraw has them.
  bool can_rumble = false;
};

/// Gamepads and joysticks by the kernel's event devices: buttons of those that hidraw does not
/// show, and the motors of all that rumble. Keyboards and mice are left to the window.
/// [one thread]
class PadDevices {
 public:
  /// @param rumbler  gets the motors; null: nothing rumbles
  explicit PadDevices(std::shared_ptr<Rumbler> rumbler = nullptr);
  ~PadDevices();  ///< Closes all; the rumbler keeps its motors.
  PadDevices(const PadDevices&) = delete;
  PadDevices& operator=(const PadDevices&) = delete;

  /// Has a worker look for what was plugged in: about once a second. A later poll() takes what it
  /// found; while it looks, this does nothing.
  void look();
  /// The same at once. [may wait]
  void rescan(PadNews& news);
  /// Takes all that came since the last call; about 60 times a second. One that was unplugged lets
  /// go of its buttons. Never waits.
  void poll(PadNews& news);

  std::vector<SeenPad> seen() const;  ///< By the last look.

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Whether this build can: it was made with the system's header linux/input.h.
bool hasPadDevices() noexcept;

}  // namespace relievo::pad
