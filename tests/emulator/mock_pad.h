// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace relievo::emulator {

/// What a pad's motors were told.
struct RumbleCall {
  enum class What : std::uint8_t { upload, play, stop };
  What what = What::upload;
  std::int64_t time_ns = 0;
  int length_ms = 0;  ///< Of upload, as the next two.
  unsigned strong = 0, weak = 0;
  bool is_new = false;  ///< The kernel was to find a place for the effect.
};

/// Gamepads as the kernel's event devices: sysfs is umockdev's, each node a pipe with events and a
/// kernel's answers behind it. Processes must run with libumockdev-preload.
class MockPad {
 public:
  MockPad();
  ~MockPad();
  MockPad(const MockPad&) = delete;
  MockPad& operator=(const MockPad&) = delete;

  struct Kind {
    std::string name = "Mock pad";
    std::vector<int> keys;
    bool rumbles = true;
    bool has_hidraw = false;
  };
  /// @return the number of its node, which is never used twice
  int plugIn(const Kind& kind);
  /// The node goes; what is open of it fails from now on.
  void unplug(int pad);
  /// Its descriptors fail as after unplugging, and the system does not know yet.
  void pullCable(int pad);
  void forbid(int pad, bool forbidden);
  /// One event and the report's end.
  void press(int pad, int key, bool down);
  /// The kernel had no room for events; `down` is what it says when it is asked.
  void dropEvents(int pad, const std::vector<int>& down);
  /// Since it was plugged in.
  std::vector<RumbleCall> rumble(int pad) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo::emulator
