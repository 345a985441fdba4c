// SPDX-License-Identifier: BSD-3-Clause
// The plug-in for devices of Force Dimension, by relievo_device.h.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <optional>
#include <string_view>

#include "haptics/device/dhd/dhd_device.h"
#include "haptics/device/dhd/dhd_library.h"
#include "haptics/device/foreign/relievo_device.h"

namespace relievo::dhd {
namespace {

DhdLibrary library;  // From init on.

/// A device and the table of its functions.
struct Made {
  explicit Made(Which which) noexcept : device(library, which) {}

  DhdDevice device;
  relievo_device table{};
};

DhdDevice& deviceOf(void* self) noexcept {
  return static_cast<Made*>(self)->device;
}

relievo_status openIt(void* self) {
  return deviceOf(self).open();
}
void closeIt(void* self) {
  deviceOf(self).close();
}
relievo_status limitsOfIt(void* self, relievo_device_limits* out) {
  return deviceOf(self).limits(*out);
}
relievo_status stepIt(void* self, const double force_n[3], std::int64_t now_ns,
                      relievo_sample* out) {
  return deviceOf(self).step({force_n[0], force_n[1], force_n[2]}, now_ns, *out);
}
relievo_status cutIt(void* self) {
  return deviceOf(self).cut();
}
const char* lastErrorOfIt(void* self) {
  return deviceOf(self).lastError();
}
const void* noExtension(void* /*self*/, const char* /*id*/) {
  return nullptr;
}

constexpr std::string_view kByPlace = "device.", kBySerial = "serial.";
constexpr int kMostDevices = 32;

std::optional<int> numberAfter(std::string_view id, std::string_view prefix) {
  if (!id.starts_with(prefix)) return {};
  id.remove_prefix(prefix.size());
  int number = 0;
  const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), number);
  const bool whole = error == std::errc() && end == id.data() + id.size() && number >= 0;
  return whole ? std::optional(number) : std::nullopt;
}

std::optional<Which> whichBy(std::string_view id) {
  if (const auto place = numberAfter(id, kByPlace)) {
    return *place < kMostDevices ? std::optional(Which{false, *place}) : std::nullopt;
  }
  const auto serial = numberAfter(id, kBySerial);
  return serial ? std::optional(Which{true, *serial}) : std::nullopt;
}

const char* variable(const char* name) {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): before threads.
  return value == nullptr ? "" : value;
}

/// The reason is the last error that is logged.
relievo_status init(const relievo_host* host, const char* /*own_path*/) {
  try {
    library = loadLibrary(variable("RELIEVO_FORCE_DIMENSION_LIBRARY"), variable("HOME"));
    if (library.problem.empty()) return RELIEVO_OK;
    host->log(host->self, 2, library.problem.c_str());
    return RELIEVO_NO_LIBRARY;
  } catch (...) {
    return RELIEVO_INTERNAL;
  }
}
void deinit() {}  // The library stays loaded: it may have threads of its own.

/// Which type one is, the library tells only of an open one.
std::uint32_t scan(relievo_device_name* out, std::uint32_t capacity) {
  const int count = std::clamp(library.device_count(), 0, kMostDevices);
  for (int i = 0; i < count && static_cast<std::uint32_t>(i) < capacity; ++i) {
    std::snprintf(out[i].id, sizeof(out[i].id), "device.%d", i);
    std::snprintf(out[i].name, sizeof(out[i].name), "Force Dimension device %d", i + 1);
  }
  return static_cast<std::uint32_t>(count);
}

relievo_device* create(const char* id) {
  const auto which = whichBy(id);
  if (!which) return nullptr;
  auto* const made = new (std::nothrow) Made(*which);
  if (made == nullptr) return nullptr;
  made->table = {.struct_size = sizeof(relievo_device),
                 .reserved = 0,
                 .self = made,
                 .open = openIt,
                 .close = closeIt,
                 .limits = limitsOfIt,
                 .step = stepIt,
                 .cut_force = cutIt,
                 .last_error = lastErrorOfIt,
                 .get_extension = noExtension};
  return &made->table;
}
void destroy(relievo_device* device) {
  delete static_cast<Made*>(device->self);
}

}  // namespace
}  // namespace relievo::dhd

const relievo_device_entry_t relievo_device_entry{.struct_size = sizeof(relievo_device_entry_t),
                                                  .abi_major = RELIEVO_DEVICE_ABI_MAJOR,
                                                  .abi_minor = RELIEVO_DEVICE_ABI_MINOR,
                                                  .reserved = 0,
                                                  .name = "Force Dimension",
                                                  .version = RELIEVO_VERSION_STRING,
                                                  .maker = "the relievo authors",
                                                  .licence = "BSD-3-Clause",
                                                  .init = relievo::dhd::init,
                                                  .deinit = relievo::dhd::deinit,
                                                  .scan = relievo::dhd::scan,
                                                  .create = relievo::dhd::create,
                                                  .destroy = relievo::dhd::destroy};
