// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/device.h"

#include "core/message/catalogue.h"

namespace relievo {

namespace {
MessageId idOf(DeviceFault fault) noexcept {
  switch (fault) {
    case DeviceFault::none:
      break;
    case DeviceFault::timeout:
      return MessageId::fault_timeout;
    case DeviceFault::disconnected:
      return MessageId::fault_disconnected;
    case DeviceFault::protocol:
      return MessageId::fault_protocol;
    case DeviceFault::overheated:
      return MessageId::fault_overheated;
    case DeviceFault::not_finite:
      return MessageId::fault_not_finite;
    case DeviceFault::not_ready:
      return MessageId::fault_not_ready;
  }
  return MessageId::no_fault;
}
}  // namespace

Message messageOf(DeviceFault fault) {
  return {idOf(fault), {}};
}

std::string_view describe(DeviceFault fault) noexcept {
  return rowOf(idOf(fault)).screen;
}

}  // namespace relievo
