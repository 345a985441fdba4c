// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/vec3.h"
#include "core/message/message.h"
#include "haptics/rt/realtime.h"
#include "haptics/space/workspace.h"

namespace relievo {

struct DeviceInfo {
  std::string id;    ///< Stable: "mouse", "falcon:A1", "scripted".
  std::string name;  ///< For people.
  Workspace workspace;
  double max_force_n = 0;  ///< 0: no actuator; forces are computed and shown only.
  // Its data sheet; 0: none is known. All that is asked for is kept within it (withinDevice()).
  double max_stiffness_n_per_mm = 0;
  double max_damping_n_s_per_mm = 0;
  double max_slew_n_per_s = 0;  ///< Largest change of its force per second.
  bool simulated = false;       ///< Nobody holds it: it can hurt nobody.
  double position_step_mm = 0;  ///< One count of its encoders; 0: finer than matters.
  int force_delay_ticks = 0;    ///< Whole ticks from send() until the force is felt; 0 .. 2.
  double rate_hz = 1000;        ///< Largest rate of new places and forces.
  /// Of the grip, as a calibration found it, N; 0: not known.
  double grip_weight_n = 0;
  bool holds_its_grip = false;  ///< The device itself makes up for the grip's weight.
};

enum class DeviceFault : std::uint8_t {
  none,
  timeout,       ///< No answer in time.
  disconnected,  ///< Gone.
  protocol,      ///< Answers nonsense.
  overheated,
  not_finite,  ///< A position that is no number, or kilometres away; set by the core.
  not_ready,   ///< Its firmware does not run yet, or it is not homed.
};
Message messageOf(DeviceFault fault);                   ///< For people; a few words.
std::string_view describe(DeviceFault fault) noexcept;  ///< The same in English, for logs.

/// Of DeviceReading::buttons: the hand hovers. A mouse that is not pressed carries it through the
/// air, and it touches nothing on its way.
inline constexpr std::uint32_t kHoverBit = 1U << 4U;

struct DeviceReading {
  DeviceMm position;
  /// Bit i: button i is down (0 plus, 1 forward, 2 centre, 3 minus); and kHoverBit.
  std::uint32_t buttons = 0;
  std::int64_t time_ns = 0;  ///< Monotonic, when the position was sampled.
  DeviceFault fault = DeviceFault::none;
};

/// One haptic device. Life: closed -> open -> running -> open -> closed.
///   open/close        [any one thread but the loop]  may block, may throw
///   read, send        [haptic loop, running]         in turns, bounded time; one of them may wait
///   cutForce          [watchdog thread, running]     may block; also while those are stuck
class Device {
 public:
  Device() = default;
  virtual ~Device() = default;  ///< Implementations close, motors at zero force.
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  virtual const DeviceInfo& info() const noexcept = 0;
  virtual void open() = 0;  ///< Firmware, homing. @throw DeviceError
  virtual void close() noexcept = 0;
  /// Where the hand is. `now_ns` is the monotonic time of the tick, so that a device without a
  /// clock of its own needs none.
  virtual DeviceReading read(std::int64_t now_ns) RELIEVO_REALTIME = 0;
  /// Shows a force, made from the reading before it, until the next one.
  virtual void send(DeviceN force, std::int64_t now_ns) RELIEVO_REALTIME = 0;
  /// Both, for who has a force already: it was made from an earlier reading than this one.
  DeviceReading exchange(DeviceN force, std::int64_t now_ns) RELIEVO_REALTIME {
    const DeviceReading reading = read(now_ns);
    send(force, now_ns);
    return reading;
  }
  /// The loop has stalled: zero force now, until a force is sent that was made after this. Comes
  /// from another thread than read() and send() and possibly during them. Nothing to do where there
  /// is no actuator.
  virtual void cutForce() noexcept {}
};

/// A device that follows a target which a person sets by mouse or keys, or a stroke sets.
/// All calls: [one thread: GUI, or the loop's own where a stroke drives it].
class SteeredDevice : public Device {
 public:
  /// Where the hand is to go. A target that is not finite is passed on: the core latches a fault.
  virtual void moveTo(DeviceMm target) RELIEVO_REALTIME = 0;
  /// The hand is there at once, as after a change of window.
  virtual void placeAt(DeviceMm target) RELIEVO_REALTIME = 0;
  virtual void setButtons(std::uint32_t buttons) RELIEVO_REALTIME = 0;
  /// The hand hovers there, until moveTo() puts it down at that place. A hand with a mass has a way
  /// through the air like any other: it goes there as by moveTo().
  virtual void hoverAt(DeviceMm target) RELIEVO_REALTIME { moveTo(target); }
};

}  // namespace relievo
