// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace relievo::hid {

// What HID devices send, as bytes; no input or output happens here.

/// Where a device's buttons are in its input reports, from its report descriptor.
struct ButtonField {
  std::uint8_t report_id = 0;  ///< 0: reports begin without an id.
  std::size_t first_bit = 0;   ///< After the id.
  std::size_t count = 0;
  std::uint16_t first_button = 1;  ///< Usage of the first one.
};

/// All input fields of the button page with one bit each. Whatever the bytes, it ends; a
/// descriptor that is damaged gives what stood before the damage. At most 64 fields.
std::vector<ButtonField> buttonFields(std::span<const std::uint8_t> descriptor);

/// Bit i: button i + 1 is down. Nothing: this report has no buttons, or is too short for them.
std::optional<std::uint32_t> buttonsOf(std::span<const std::uint8_t> report,
                                       std::span<const ButtonField> fields);

/// 3Dconnexion: how far the cap is pushed, full deflection about 1.
struct CapMotion {
  double right = 0, up = 0, toward = 0;  ///< As the user sees it: toward the user.
};

/// From report 1 of a SpaceMouse, wired or wireless. Nothing: another report.
std::optional<CapMotion> capMotion(std::span<const std::uint8_t> report);
/// From report 3. Bit i: button i is down.
std::optional<std::uint32_t> capButtons(std::span<const std::uint8_t> report);

/// A 3Dconnexion six-axis device, by its ids.
bool isSpaceMouse(std::uint16_t vendor, std::uint16_t product);

}  // namespace relievo::hid
