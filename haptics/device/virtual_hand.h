// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <string_view>

#include "haptics/device/device.h"
#include "haptics/device/mouse_device.h"
#include "haptics/rt/triple_buffer.h"

namespace relievo {

/// How a hand holds the device: its own mass, and a spring and a damper between the device and the
/// place where the person means to be.
struct HandImpedance {
  std::string_view name;  ///< "light", "relaxed", "firm"
  double mass_kg = 0;
  double stiffness_n_per_mm = 0;
  double damping_n_s_per_mm = 0;
};

/// Fingertips, a resting hand, a tight grip. Orders of magnitude of measured grips: tens of grams,
/// 0.1 to 1 N/mm, 2 to 8 N s/m; the lightest is the hardest to keep stable.
inline constexpr std::array<HandImpedance, 3> kHandPresets{
    {{"light", 0.02, 0.05, 0.001}, {"relaxed", 0.05, 0.2, 0.003}, {"firm", 0.1, 0.8, 0.008}}};

/// A small parallel-arm device: what it weighs, how it rubs, what its encoders and motors can do.
struct VirtualHandOptions {
  HandImpedance hand = kHandPresets[1];
  double device_mass_kg = 0.2;
  double device_damping_n_s_per_mm = 0.001;
  double coulomb_n = 0.1;            ///< Dry friction of the device's joints.
  double position_step_mm = 0.0635;  ///< 400 counts per inch; 0: exact positions.
  int delay_ticks = 1;               ///< 0 .. 2, from send() until the force is felt.
  double max_force_n = 8;
  double follow_s = MouseDevice::kFollowSeconds;  ///< Of the target; 0: it jumps.
};

/// A simulated device in a simulated hand: the closed loop without hardware. The person's aim is
/// the target; where the hand is follows from masses, dampers, dry friction and the force that the
/// loop sends, one tick of transport later. The same times and targets give the same positions, bit
/// by bit. Source: haptics on a flat wall, Colgate and Brown 1994; Abbott and Okamura 2005.
class VirtualHand : public SteeredDevice {
 public:
  /// @throw ArgumentError  an option that is no number or out of its range
  explicit VirtualHand(const VirtualHandOptions& options = {});
  const DeviceInfo& info() const noexcept override { return info_; }
  void open() override;
  void close() noexcept override {}
  DeviceReading read(std::int64_t now_ns) RELIEVO_REALTIME override;
  void send(DeviceN force, std::int64_t now_ns) RELIEVO_REALTIME override;
  void cutForce() noexcept override;

  void moveTo(DeviceMm target) RELIEVO_REALTIME override;
  void placeAt(DeviceMm target) RELIEVO_REALTIME override;
  void setButtons(std::uint32_t buttons) RELIEVO_REALTIME override;

  DeviceMm position() const noexcept { return position_; }  ///< Not rounded. [loop stopped, loop]
  DeviceMmPerS velocity() const noexcept { return velocity_; }  ///< Likewise.

 private:
  void advance(double seconds, DeviceN force, const HandWish& wish) RELIEVO_REALTIME;
  void step(double seconds, DeviceN force) RELIEVO_REALTIME;

  VirtualHandOptions options_;
  DeviceInfo info_;
  TripleBuffer<HandWish> wishes_;
  HandWish wanted_;                      // [GUI thread]
  std::atomic<std::int64_t> cut_ns_{0};  // When the watchdog cut; 0: it did not.
  // [haptic loop]
  DeviceMm position_, aim_;
  DeviceMmPerS velocity_;
  std::array<DeviceN, 3> under_way_{};  // [0] is felt now, [delay_ticks] was handed over last.
  std::uint32_t jumps_ = 0;
  std::int64_t last_ns_ = 0;
  bool started_ = false;
};

/// The device in one of the grips of kHandPresets. @throw DeviceError  there is no such grip
VirtualHandOptions virtualHandNamed(std::string_view grip);

}  // namespace relievo
