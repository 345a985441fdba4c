// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <stop_token>

#include "tests/emulator/falcon_emulator.h"

namespace relievo::emulator {

/// The emulated Falcon behind one USB/IP connection, as Linux's vhci_hcd speaks it (kernel
/// documentation, usb/usbip_protocol): a virtual Falcon on a real kernel.
class UsbipServer {
 public:
  /// @param socket  a stream; owned
  /// @param negotiate  answer the list and import requests of `usbip attach` first; false: the
  ///                   kernel holds the other end already
  UsbipServer(int socket, std::shared_ptr<SharedFalcon> falcon, bool negotiate);
  ~UsbipServer();
  UsbipServer(const UsbipServer&) = delete;
  UsbipServer& operator=(const UsbipServer&) = delete;

  /// Until the other side leaves, the Falcon is unplugged, or stopped.
  void serve(const std::stop_token& stop);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Gives this kernel's first virtual port one end of a pair of sockets (root; module vhci_hcd).
/// @return the other end; -1: errno says why
int attachToVhci();

}  // namespace relievo::emulator
