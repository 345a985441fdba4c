// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "haptics/device/foreign/device_page.h"
#include "haptics/device/foreign/relievo_device.h"

namespace relievo::foreign {

/// Calls a function of a plug-in. What it must not do, and one in C++ may do all the same, is
/// throw.
/// @return `instead` if it did
template <class Result, class Function, class... Given>
Result called(Result instead, Function* function, Given... given) noexcept {
  try {
    return function(given...);
  } catch (...) {
    return instead;
  }
}

/// What went wrong, for a report.
struct Trouble {
  HostTrouble what = HostTrouble::none;
  std::int32_t number = 0;
  std::string text;
};

/// One plug-in, loaded for the life of this process. [main]
class LoadedPlugin {
 public:
  LoadedPlugin() = default;
  ~LoadedPlugin();
  LoadedPlugin(const LoadedPlugin&) = delete;
  LoadedPlugin& operator=(const LoadedPlugin&) = delete;

  /// Loads it from its descriptor and looks at its table.
  /// @param file  where it was before, for the plug-in and for people  @return what is wrong with
  /// it
  Trouble load(const std::string& file);
  /// Its init. @return what is wrong
  Trouble begin();
  const relievo_device_entry_t& entry() const { return *entry_; }
  /// Devices that are there. @pre begun
  std::vector<relievo_device_name> scan() const;
  /// Null: unknown. @pre begun
  relievo_device* create(const std::string& id) const;
  /// Closes and destroys one. @pre begun
  void destroy(relievo_device* device) const;
  void end();

 private:
  /// Of the plug-in. What it says of an error before it has begun is why it did not.
  static void log(void* self, std::int32_t level, const char* text) noexcept;

  std::string file_;
  std::string last_words_;
  const relievo_device_entry_t* entry_ = nullptr;
  relievo_host host_{};
  bool begun_ = false;
};

/// Whether a device has all functions of this version.
bool isWhole(const relievo_device* device) noexcept;
/// What it says of its last failure; never more than a report can hold.
std::string lastError(const relievo_device* device);
/// Asks an open device. @return what is wrong with it, or the limits
Trouble askLimits(relievo_device* device, ForeignLimits& limits);
/// A name that a device's id may have.
bool isId(const char* id) noexcept;

}  // namespace relievo::foreign
