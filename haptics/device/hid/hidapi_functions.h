// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hidapi.h>

#include <string>

// What hid_devices.cpp needs of hidapi, which is loaded when such devices are first looked for:
// everything else works where it is not installed.
namespace relievo::hid {

#define RELIEVO_HIDAPI_FUNCTIONS(FUNCTION) \
  FUNCTION(close)                          \
  FUNCTION(enumerate)                      \
  FUNCTION(free_enumeration)               \
  FUNCTION(init)                           \
  FUNCTION(open_path)                      \
  FUNCTION(read)                           \
  FUNCTION(set_nonblocking)                \
  FUNCTION(version_str)

/// hid_init is hidapi().init, and so on.
struct HidapiFunctions {
// NOLINTNEXTLINE(bugprone-macro-parentheses): the name that a member gets.
#define RELIEVO_MEMBER(name) decltype(&::hid_##name) name = nullptr;
  RELIEVO_HIDAPI_FUNCTIONS(RELIEVO_MEMBER)
#undef RELIEVO_MEMBER
  std::string problem;  ///< Why there are none, in the system's words; empty: they are there.
};

/// Loads it at the first call. [any thread]
const HidapiFunctions& hidapi();

}  // namespace relievo::hid
