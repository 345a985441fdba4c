// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>

#include "tests/emulator/in_process.h"
#include "tests/emulator/usbip_server.h"

namespace relievo::emulator {

/// A whole emulated Falcon with its cable, on the first virtual port of this kernel.
class Plugged {
 public:
  /// @throw std::runtime_error  the kernel has no such port, or it is taken
  explicit Plugged(std::shared_ptr<SharedFalcon> falcon) : falcon_(std::move(falcon)) {
    falcon_->with([](auto& f) { f.plugIn(); });
    const int socket = attachToVhci();
    if (socket < 0) throw std::runtime_error("the kernel takes the virtual port");
    thread_ = std::jthread([this, socket](const std::stop_token& stop) {
      UsbipServer(socket, falcon_, false).serve(stop);
    });
  }
  /// The server leaves, the kernel sees the cable pulled.
  void unplug() {
    falcon_->with([](auto& f) { f.unplug(); });
    if (thread_.joinable()) thread_.join();
  }
  ~Plugged() { unplug(); }
  Plugged(const Plugged&) = delete;
  Plugged& operator=(const Plugged&) = delete;

 private:
  std::shared_ptr<SharedFalcon> falcon_;
  std::jthread thread_;
};

}  // namespace relievo::emulator
