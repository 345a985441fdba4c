// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace relievo::emulator {

/// HID devices that the real hidapi finds: sysfs is umockdev's, each node a pipe that keeps reports
/// apart. Processes must run with libumockdev-preload.
class MockHid {
 public:
  MockHid();
  ~MockHid();
  MockHid(const MockHid&) = delete;
  MockHid& operator=(const MockHid&) = delete;

  /// @param slot  0 to 9: which hidraw node it gets
  void plugIn(int slot, std::uint16_t vendor, std::uint16_t product, const std::string& name,
              const std::vector<std::uint8_t>& report_descriptor);
  void unplug(int slot);
  /// Takes the rights to the node away from everybody, or gives them back.
  void forbid(int slot, bool forbidden);
  void send(int slot, const std::vector<std::uint8_t>& report);
  /// The same again every 16 ms, as the cap of a SpaceMouse that is held does, until the next
  /// send(), hold() or unplug().
  void hold(int slot, const std::vector<std::uint8_t>& report);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo::emulator
