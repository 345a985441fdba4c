// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace relievo::pad {

// What sysfs says of an input device, as text; no input or output happens here.

/// The bits that are set in a file of "capabilities": words of the kernel's long in hexadecimal,
/// the highest first. Whatever the text, it ends; what is no number counts as 0. Only the lowest
/// 1024 bits are read.
std::vector<int> bitsOf(std::string_view text);

struct PadFacts {
  std::vector<int> keys;  ///< Codes of its joystick's or gamepad's buttons, ascending.
  bool can_rumble = false;
  bool isPad() const noexcept { return !keys.empty(); }
};
/// @param keys, effects  its capabilities/key and capabilities/ff
/// Keyboards and mice are none, whatever else they press.
PadFacts factsOf(std::string_view keys, std::string_view effects);

/// The Falcon's button of a pad's: its first four are plus, forward, centre, minus, and one that is
/// alone is centre, as for HID devices. -1: none.
int falconButton(const PadFacts& facts, int key) noexcept;

}  // namespace relievo::pad
