// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <thread>

#include "haptics/device/device.h"
#include "haptics/device/haply/link.h"
#include "haptics/device/haply/port.h"

namespace relievo::haply {

/// An Inverse3 or Minverse of Haply's, by its maker's Inverse Service (docs/adr/0165). `read` and
/// `send` never wait: a thread of its own (docs/threads.md) talks to the service. Until the device
/// is set up, calibrated and has power, readings carry `not_ready`; after the service or the device
/// went away they carry `disconnected` until it is back. No force is shown meanwhile.
class HaplyDevice : public Device {
 public:
  /// @param chosen  id of the device as the service has it; empty: the only one
  HaplyDevice(std::unique_ptr<Service> service, std::string chosen);
  ~HaplyDevice() override;

  /// Its limits, name and id are known after open().
  const DeviceInfo& info() const noexcept override { return info_; }
  /// Finds the device and starts the thread; does not wait until it is ready.
  /// @throw DeviceError  no service, another one, no device, or several (E311 to E313)
  void open() override;
  /// open() waits no longer. [any thread]
  void giveUp() noexcept { looking_.request_stop(); }
  void close() noexcept override;
  DeviceReading read(std::int64_t now_ns) RELIEVO_REALTIME override;
  void send(DeviceN force, std::int64_t now_ns) RELIEVO_REALTIME override;
  void cutForce() noexcept override { mailbox_.cuts.fetch_add(1); }

  const LinkStatus& status();  ///< The newest. [owner]
  void retry();                ///< [owner] After a fault that does not heal by itself.

 private:
  void takeLimits(std::string_view type, std::string_view id);

  std::stop_source looking_;
  std::unique_ptr<Service> service_;
  std::string chosen_;
  DeviceInfo info_;  // [owner] writes while it is closed; the loop reads its numbers.
  LinkMailbox mailbox_;
  LinkCommand command_;  // [owner]
  LoopEnd loop_end_;     // [haptic loop]
  std::jthread thread_;
};

}  // namespace relievo::haply
