// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace relievo::emulator {

/// What a service may do that it should not, or that a driver must stand. Each begins with the
/// message number `HaplyWorld::fault_after` and lasts until it is taken back.
enum class HaplyFault : std::uint8_t {
  none,
  // Of the connection.
  silent,
  late_3_ms,
  late_10_ms,
  late_30_ms,
  two_answers,
  byte_pieces,
  fragments,
  ping,
  huge_frame,
  closes,
  // Of what is said.
  truncated,
  null_place,
  number_too_large,
  wrong_type,
  deep,
  duplicate,
  member_order,
  members_missing,
  // Of the device and of others.
  device_absent,
  other_id,
  second_device,
  uncalibrated,
  no_power,
  not_started,
  jump,
  foreign_basis,  ///< Once: who sets it up anew has it.
  foreign_basis_always,
  foreign_force,
  disobedient,
  tells_late,    ///< The force of 40 ms before.
  tells_smooth,  ///< The force as it fades in and out, over 40 ms.
  // Of the channel of events.
  events_close,    ///< Each session ends after the first event.
  events_garbage,  ///< Half a message, no JSON, an unknown name, and a huge one before each.
  events_refused,  ///< Whoever asks for a session gets none.
};
std::string_view nameOf(HaplyFault fault);
/// All of them but `none`.
std::vector<HaplyFault> allHaplyFaults();

/// Haply's Inverse Service without its network, an arm, and the hand at its grip. What it knows is
/// written down a second time, from its documentation, so that it can disagree with the driver.
/// Places mm and forces N in our axes: right, up, toward the person.
class HaplyWorld {
 public:
  using Triple = std::array<double, 3>;

  std::string version = "3.5.0.0", id = "049D", type = "inverse3";

  std::string versionText() const;  ///< Of GET /version.
  /// A session begins: the first message.
  std::string inventory(std::int64_t now_ns);
  /// To one message of the client.
  std::string answer(std::string_view message, std::int64_t now_ns);
  void endSession(std::int64_t now_ns);  ///< Its force ends with it.
  void advance(std::int64_t now_ns);

  void hold(const Triple& place);  ///< The hand holds the grip exactly here.
  /// It pulls the grip toward a place like a spring and lets itself be pushed.
  void pullToward(const Triple& place);
  const Triple& grip() const { return grip_; }
  /// Of the motors, in our axes.
  const Triple& force() const { return force_; }

  bool button_a = false, button_b = false, button_c = false, wired_button = false;
  HaplyFault fault = HaplyFault::none;
  std::uint64_t fault_after = 0;
  bool hasFault(HaplyFault one) const { return fault == one && messages >= fault_after; }

  std::uint64_t messages = 0;        ///< That it was sent.
  std::uint64_t configurations = 0;  ///< Of those.
  std::uint64_t refused = 0;         ///< No JSON, or of no form that it knows.
  double largest_n = 0;              ///< That was ever shown.

  /// What its channel of events has told, the oldest first, as it was sent; who listens gets what
  /// comes from then on. By itself: plugs, and the emergency stop.
  std::vector<std::string> events;
  void tellEvent(const std::string& name, const std::string& safety_type = {});

  /// Every change of what the motors show.
  struct Shown {
    std::int64_t time_ns = 0;
    Triple force{};
    const char* why = "";
  };
  std::vector<Shown> log;

 private:
  void watchDevice();
  void take(std::string_view message, std::int64_t now_ns, bool& everything);
  void show(const Triple& force, std::int64_t now_ns, const char* why);
  std::string state(bool everything, std::int64_t now_ns);
  Triple toldForce(std::int64_t now_ns) const;
  Triple serviceAxes(const Triple& ours) const;
  Triple ourAxes(const Triple& services) const;

  Triple grip_{0, 0, 0}, wanted_{0, 0, 0}, velocity_{}, force_{}, smooth_{};
  bool held_ = true;
  std::string basis_ = "XYZ", preset_ = "defaults";
  bool foreign_done_ = false;
  bool was_absent_ = false, was_braked_ = false;  // As the events have told it.
  std::int64_t ordered_ns_ = 0, advanced_ns_ = 0;
};

}  // namespace relievo::emulator
