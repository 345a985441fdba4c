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

/// 3Dconnexion: how far the cap is pushed and turned, as the user sees it; full deflection about 1,
/// at most 1.5.
struct CapMotion {
  double right = 0, up = 0, toward = 0;  ///< Pushed: toward the user.
  /// Turned about these three, by the right-hand rule: its top toward the user, its near side to
  /// the right, its right side up.
  double about_right = 0, about_up = 0, about_toward = 0;
  friend bool operator==(const CapMotion&, const CapMotion&) = default;
};

/// What report 1 (pushes; of wireless and newer ones the turns as well) or 2 (turns) of a
/// SpaceMouse changes of the motion before. Axes that a report has not, or not whole, stay.
/// Nothing: another report, or too short for any.
std::optional<CapMotion> capMotion(std::span<const std::uint8_t> report, const CapMotion& before);
/// Of a motion, what goes beyond 4 % of full deflection on each axis, so that a cap at rest that
/// is not quite centred moves nothing. Full deflection stays 1.
CapMotion beyondRest(const CapMotion& motion);
/// The cap of one SpaceMouse, as its reports tell of it.
class CapReports {
 public:
  /// A cap that is pushed reports every 8 ms, a wireless one every 16 ms, also if nothing changes;
  /// one that has told nothing for this long is out of reach and counts as at rest.
  static constexpr double kLastsS = 0.3;

  /// Another report, of any kind. @param now_s  of a clock that never goes back
  void take(std::span<const std::uint8_t> report, double now_s);
  /// What it does now, beyondRest().
  CapMotion motion(double now_s) const;

 private:
  CapMotion told_;
  double told_s_ = 0;
};
/// From report 3. Bit i: button i is down.
std::optional<std::uint32_t> capButtons(std::span<const std::uint8_t> report);

/// A 3Dconnexion six-axis device, by its ids.
bool isSpaceMouse(std::uint16_t vendor, std::uint16_t product);

}  // namespace relievo::hid
