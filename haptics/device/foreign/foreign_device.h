// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "haptics/device/device.h"
#include "haptics/device/foreign/device_page.h"
#include "haptics/device/foreign/host_process.h"
#include "haptics/device/foreign/page_end.h"
#include "haptics/device/foreign/plugin_image.h"

namespace relievo::foreign {

/// How long is waited for whom.
struct Patience {
  int open_s = 60;                           ///< Until the plug-in has opened its device.
  int silence_ms = 100;                      ///< A host whose steps do not come back is killed.
  int close_ms = 2000;                       ///< A host that does not go is killed.
  std::int64_t stale_place_ns = 20'000'000;  ///< An older place is a timeout.
};

/// A device that a plug-in drives in a process of its own (relievo_device.h, docs/adr/0157). `read`
/// and `send` never wait: they copy a few words from and to memory that both processes see. If the
/// plug-in hangs, its host cuts the force; if its steps do not come back, the host is killed; if it
/// crashes, or relievo does, the other side notices by a closed pipe. No force is shown after that
/// until the device is opened anew.
class ForeignDevice : public Device {
 public:
  /// @param id    in relievo: "plugin:FILE/ID"
  /// @param name  for people
  /// @param own_id  as the plug-in knows it
  ForeignDevice(std::filesystem::path file, std::string own_id, std::string id, std::string name,
                Patience patience = {});
  /// Of what was read, and judged, before.
  ForeignDevice(PluginImage image, std::string own_id, std::string id, std::string name,
                Patience patience = {});
  ~ForeignDevice() override;

  /// Its limits are known after open().
  const DeviceInfo& info() const noexcept override { return info_; }
  /// Starts the host and waits until the plug-in has opened its device.
  /// @throw DeviceError, FileError  why not
  void open() override;
  void close() noexcept override;
  DeviceReading read(std::int64_t now_ns) RELIEVO_REALTIME override;
  void send(DeviceN force, std::int64_t now_ns) RELIEVO_REALTIME override;
  void cutForce() noexcept override;

  int hostPid() const noexcept { return host_pid_; }  ///< Of an open one. [owner]
  /// Of an open one, once its host has told it. [owner]
  std::optional<HeatReport> heat() const;
  /// Its host is no more, or was let go: nothing comes until it is opened anew. [any thread]
  bool isLost() const noexcept { return lost_.load() != DeviceFault::none; }
  /// open() waits no longer, and throws. [any thread]
  void giveUp() noexcept { given_up_.store(true); }

 private:
  HostReport waitUntilOpen();
  void watch(const std::stop_token& stop);

  std::filesystem::path file_;
  std::optional<PluginImage> image_;  // Nothing: it is read when it is opened.
  std::string own_id_;
  DeviceInfo info_;  // [owner] writes while it is closed; the loop reads its numbers.
  Patience patience_;
  std::atomic<bool> given_up_{false};
  std::unique_ptr<MappedPage> page_;
  HostProcess host_;  // [owner]; while it is open, [device thread].
  int host_pid_ = 0;
  PageEnd page_end_;  // [haptic loop]
  /// Whatever the page says: the host is no more. [device thread writes]
  std::atomic<DeviceFault> lost_{DeviceFault::none};
  std::jthread watching_;
};

}  // namespace relievo::foreign
