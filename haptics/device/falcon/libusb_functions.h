// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <libusb.h>

#include <string>

// What usb_bus.cpp needs of libusb, which is loaded when USB is first looked at: everything but
// Falcons works where it is not installed.
namespace relievo::falcon {

#define RELIEVO_LIBUSB_FUNCTIONS(FUNCTION)  \
  FUNCTION(alloc_transfer)                  \
  FUNCTION(cancel_transfer)                 \
  FUNCTION(claim_interface)                 \
  FUNCTION(clear_halt)                      \
  FUNCTION(close)                           \
  FUNCTION(control_transfer)                \
  FUNCTION(exit)                            \
  FUNCTION(free_device_list)                \
  FUNCTION(free_pollfds)                    \
  FUNCTION(free_transfer)                   \
  FUNCTION(get_bus_number)                  \
  FUNCTION(get_device_address)              \
  FUNCTION(get_device_descriptor)           \
  FUNCTION(get_device_list)                 \
  FUNCTION(get_device_speed)                \
  FUNCTION(get_pollfds)                     \
  FUNCTION(get_port_numbers)                \
  FUNCTION(get_version)                     \
  FUNCTION(handle_events_timeout_completed) \
  FUNCTION(has_capability)                  \
  FUNCTION(hotplug_deregister_callback)     \
  FUNCTION(hotplug_register_callback)       \
  FUNCTION(init)                            \
  FUNCTION(open)                            \
  FUNCTION(release_interface)               \
  FUNCTION(set_auto_detach_kernel_driver)   \
  FUNCTION(strerror)                        \
  FUNCTION(submit_transfer)

/// libusb_init is usb().init, and so on.
struct LibusbFunctions {
// NOLINTNEXTLINE(bugprone-macro-parentheses): the name that a member gets.
#define RELIEVO_MEMBER(name) decltype(&::libusb_##name) name = nullptr;
  RELIEVO_LIBUSB_FUNCTIONS(RELIEVO_MEMBER)
#undef RELIEVO_MEMBER
  std::string problem;  ///< Why there are none, in the system's words; empty: they are there.
};

/// Loads it at the first call. [any thread]
const LibusbFunctions& usb();

}  // namespace relievo::falcon
