// SPDX-License-Identifier: BSD-3-Clause
// Instead of pad_devices.cpp, in a build without linux/input.h.
#include "haptics/device/pad/pad_devices.h"

namespace relievo::pad {

struct PadDevices::Impl {};

PadDevices::PadDevices(std::shared_ptr<Rumbler> /*rumbler*/) {}
PadDevices::~PadDevices() = default;
void PadDevices::look() {}
void PadDevices::rescan(PadNews& /*news*/) {}
void PadDevices::poll(PadNews& /*news*/) {}
std::vector<SeenPad> PadDevices::seen() const {
  return {};
}

bool hasPadDevices() noexcept {
  return false;
}

}  // namespace relievo::pad
