// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "core/base/error.h"
#include "haptics/device/device.h"
#include "haptics/device/falcon/link/link.h"

namespace relievo::falcon {

/// What is known of one Falcon and kept between sessions.
struct FalconSettings {
  /// Motor counts for one N mm. Half of the nominal value until a weight was hung on.
  double counts_per_n_mm = kNominalCountsPerNmm / 2;
  double grip_weight_n = 0;  ///< As the calibration found it; 0: not known.
  bool left_handed = false;  ///< Plus and minus change sides.
  std::string firmware;      ///< The file to load; empty: it is searched for.
};
/// No grip of a Falcon weighs more; a calibration that says so held something else.
inline constexpr double kMostGripN = 2;
inline constexpr double kLeastCountsPerNmm = 0.2 * kNominalCountsPerNmm;
/// Motors that give 8 N outward at full counts, as CHAI3D's table says, and not the 16.2 N that
/// the nominal gain and the arms' geometry make of them.
inline constexpr double kMostCountsPerNmm = 2 * kNominalCountsPerNmm;

/// One cannot be opened.
class OpeningError : public DeviceError {
 public:
  OpeningError(Presence presence, const Message& why) : DeviceError(why), presence_(presence) {}
  Presence presence() const { return presence_; }

 private:
  Presence presence_;
};

/// The Novint Falcon. `read` and `send` never wait: a thread of its own (docs/threads.md) keeps the
/// device going at its own pace and leaves the newest place of the hand for the loop. Until
/// firmware and homing are done, readings carry the fault `not_ready`; after an unplugging they
/// carry `disconnected` until it is back and homed. No force is shown meanwhile.
class FalconDevice : public Device {
 public:
  FalconDevice(std::unique_ptr<Bus> bus, FirmwareSource firmware, FalconSettings settings = {},
               LinkLimits limits = {});
  ~FalconDevice() override;

  /// Its name and id say which one it is as soon as that is known: after open(), or with status().
  const DeviceInfo& info() const noexcept override { return info_; }
  /// Finds it and starts its thread; does not wait for firmware and homing.
  /// @throw OpeningError  absent, forbidden (E301), busy (E304), or several and none chosen
  void open() override;
  /// As open(), but one that is absent, forbidden or busy is waited for.
  void openWhenPlugged();
  void close() noexcept override;
  DeviceReading read(std::int64_t now_ns) RELIEVO_REALTIME override;
  void send(DeviceN force, std::int64_t now_ns) RELIEVO_REALTIME override;
  void cutForce() noexcept override { mailbox_.cuts.fetch_add(1); }

  /// The newest. [owner]
  const LinkStatus& status();
  /// [owner] Tries again after a failure.
  void retry();
  /// [owner] The longest and the mean times of the status begin anew.
  void measureTimesAnew();
  /// [owner] Counts per N mm, kept within the possible.
  void setGain(double counts_per_n_mm);
  /// [owner] Shows these lights instead of those that tell the state.
  void showLights(std::uint8_t lights);
  void showStateLights();

 private:
  void start(Opening opening);
  void setName(const FalconChoice& which);

  DeviceInfo info_;  // [owner] writes its names; the loop reads its numbers.
  FalconSettings settings_;
  std::unique_ptr<Bus> bus_;
  FalconChoice chosen_;  // Before it was opened.
  FirmwareSource firmware_;
  LinkLimits limits_;
  LinkMailbox mailbox_;
  LinkCommand command_;  // [owner]
  LoopEnd loop_end_;     // [haptic loop]
  std::jthread thread_;
};

}  // namespace relievo::falcon
