// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/host/loaded_plugin.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

namespace relievo::foreign {

namespace {
constexpr std::uint32_t kMostDevices = 64;

constexpr std::int32_t kError = 2;
/// Of words that a report can hold.
constexpr std::size_t kMostWords = 180;

void printLine(std::int32_t level, const char* text) {
  constexpr std::array<const char*, 3> kLevels{"information", "warning", "error"};
  const auto index = static_cast<std::size_t>(std::clamp(level, 0, kError));
  std::fprintf(stderr, "relievo-device-host: %s: %.500s\n", kLevels[index], text);
}

const void* noExtension(void* /*self*/, const char* /*id*/) {
  return nullptr;
}

template <class... Pointers>
bool areThere(Pointers... pointers) noexcept {
  return (... && (pointers != nullptr));
}

bool isWhole(const relievo_device_entry_t& entry) noexcept {
  return entry.struct_size >= sizeof(relievo_device_entry_t) &&
         areThere(entry.name, entry.version, entry.maker, entry.licence, entry.init, entry.deinit,
                  entry.scan, entry.create, entry.destroy);
}
}  // namespace

void LoadedPlugin::log(void* self, std::int32_t level, const char* text) noexcept {
  if (text == nullptr) return;
  auto& plugin = *static_cast<LoadedPlugin*>(self);
  if (plugin.begun_ || level < kError) return printLine(level, text);
  plugin.last_words_.assign(text, ::strnlen(text, kMostWords));
}

LoadedPlugin::~LoadedPlugin() {
  end();
}

Trouble LoadedPlugin::load(const std::string& file) {
  file_ = file;
  // The bytes that relievo judged, whatever has become of the file.
  const std::string bytes = "/proc/self/fd/" + std::to_string(kPluginFd);
  void* const library = ::dlopen(bytes.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* const words = ::dlerror();
    std::string why = words == nullptr ? "" : words;
    if (why.starts_with(bytes)) why.replace(0, bytes.size(), file);
    return {HostTrouble::not_loaded, 0, why};
  }
  entry_ = static_cast<const relievo_device_entry_t*>(::dlsym(library, "relievo_device_entry"));
  if (entry_ == nullptr) return {HostTrouble::no_entry, 0, {}};
  // The version first: of another one nothing else is known.
  constexpr std::size_t kHead = offsetof(relievo_device_entry_t, name);
  if (entry_->struct_size < kHead) return {HostTrouble::incomplete, 0, {}};
  if (entry_->abi_major != RELIEVO_DEVICE_ABI_MAJOR) {
    return {HostTrouble::version, static_cast<std::int32_t>(entry_->abi_major), {}};
  }
  if (!isWhole(*entry_)) return {HostTrouble::incomplete, 0, {}};
  return {};
}

Trouble LoadedPlugin::begin() {
  host_ = {.struct_size = sizeof(relievo_host),
           .abi_major = RELIEVO_DEVICE_ABI_MAJOR,
           .abi_minor = RELIEVO_DEVICE_ABI_MINOR,
           .reserved = 0,
           .self = this,
           .log = log,
           .get_extension = noExtension};
  try {
    const relievo_status status = entry_->init(&host_, file_.c_str());
    if (status == RELIEVO_NO_LIBRARY) {
      return {HostTrouble::not_begun, status, std::string(entry_->name) + ": " + last_words_};
    }
    if (status < 0) return {HostTrouble::not_begun, status, last_words_};
  } catch (...) {
    return {HostTrouble::threw, 0, "init"};
  }
  begun_ = true;
  if (!last_words_.empty()) printLine(kError, last_words_.c_str());
  return {};
}

std::vector<relievo_device_name> LoadedPlugin::scan() const {
  std::vector<relievo_device_name> names(kMostDevices);
  for (relievo_device_name& name : names) name.struct_size = sizeof(relievo_device_name);
  const std::uint32_t found = called(std::uint32_t{0}, entry_->scan, names.data(), kMostDevices);
  names.resize(std::min(found, kMostDevices));
  for (relievo_device_name& name : names) {
    name.id[sizeof(name.id) - 1] = '\0';
    name.name[sizeof(name.name) - 1] = '\0';
  }
  return names;
}

relievo_device* LoadedPlugin::create(const std::string& id) const {
  return called(static_cast<relievo_device*>(nullptr), entry_->create, id.c_str());
}

void LoadedPlugin::destroy(relievo_device* device) const {
  if (device == nullptr) return;
  try {
    device->close(device->self);
    entry_->destroy(device);
  } catch (...) {
    std::fprintf(stderr, "relievo-device-host: an exception left close or destroy\n");
  }
}

void LoadedPlugin::end() {
  if (!begun_) return;
  begun_ = false;
  try {
    entry_->deinit();
  } catch (...) {
    std::fprintf(stderr, "relievo-device-host: an exception left deinit\n");
  }
}

bool isWhole(const relievo_device* device) noexcept {
  return device != nullptr && device->struct_size >= sizeof(relievo_device) &&
         areThere(device->open, device->close, device->limits, device->step, device->cut_force,
                  device->last_error, device->get_extension);
}

std::string lastError(const relievo_device* device) {
  const char* const text =
      called(static_cast<const char*>(nullptr), device->last_error, device->self);
  return text == nullptr ? std::string() : std::string(text, ::strnlen(text, kMostWords));
}

Trouble askLimits(relievo_device* device, ForeignLimits& limits) {
  relievo_device_limits told{};
  told.struct_size = sizeof(told);
  const relievo_status status =
      called(relievo_status{RELIEVO_INTERNAL}, device->limits, device->self, &told);
  if (status < 0) return {HostTrouble::refuses, status, lastError(device)};
  limits = {
      .half_extent_mm = {told.half_extent_mm[0], told.half_extent_mm[1], told.half_extent_mm[2]},
      .max_force_n = told.max_force_n,
      .continuous_force_n = told.continuous_force_n,
      .max_stiffness_n_per_mm = told.max_stiffness_n_per_mm,
      .position_step_mm = told.position_step_mm,
      .force_delay_ms = told.force_delay_ms,
      .rate_hz = told.rate_hz,
      .own_watchdog = static_cast<std::uint8_t>((told.flags & RELIEVO_HAS_OWN_WATCHDOG) != 0)};
  if (!arePossible(limits)) return {HostTrouble::limits, 0, {}};
  return {};
}

bool isId(const char* id) noexcept {
  const std::size_t length = std::strlen(id);
  return length > 0 && std::all_of(id, id + length, [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
                  c == '-';
         });
}

}  // namespace relievo::foreign
