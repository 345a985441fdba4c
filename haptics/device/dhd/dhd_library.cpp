// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/dhd/dhd_library.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>

namespace relievo::dhd {

namespace fs = std::filesystem;

namespace {
/// libdrd has everything that libdhd has.
constexpr std::array<const char*, 2> kNames{"libdhd.so.3", "libdrd.so.3"};

/// Of a folder, the newest first: people copy libdhd.so.3.17.6 without the link libdhd.so.3.
void addFrom(const fs::path& folder, const std::string& name, std::vector<std::string>& places) {
  std::error_code error;
  std::vector<std::string> here;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string file = entry.path().filename().string();
    if (file == name || file.starts_with(name + ".")) here.push_back(entry.path().string());
  }
  std::sort(here.begin(), here.end(), std::greater<>());
  places.insert(places.end(), here.begin(), here.end());
}

/// Fills a table from one library.
class Finder {
 public:
  explicit Finder(void* handle) : handle_(handle) {}

  template <class Function>
  void find(const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(::dlsym(handle_, name));
    if (function == nullptr && missing_.empty()) missing_ = name;
  }
  template <class Function>
  void mayFind(const char* name, Function*& function) const {
    function = reinterpret_cast<Function*>(::dlsym(handle_, name));
  }
  const std::string& missing() const { return missing_; }

 private:
  void* handle_;
  std::string missing_;
};

/// @return the name of a function that is missing
std::string fill(void* handle, DhdLibrary& library) {
  Finder finder(handle);
  finder.find("dhdGetDeviceCount", library.device_count);
  finder.find("dhdOpenID", library.open_id);
  finder.find("dhdClose", library.close);
  finder.find("dhdGetSystemType", library.system_type);
  finder.find("dhdGetSystemName", library.system_name);
  finder.find("dhdGetPosition", library.position);
  finder.find("dhdSetForce", library.set_force);
  finder.find("dhdGetButtonMask", library.button_mask);
  finder.find("dhdGetStatus", library.status);
  finder.find("dhdErrorGetLast", library.last_error);
  finder.find("dhdErrorGetLastStr", library.last_error_text);
  finder.find("dhdEnableForce", library.enable_force);
  finder.find("dhdSetGravityCompensation", library.set_gravity_compensation);
  finder.mayFind("dhdOpenSerial", library.open_serial);
  finder.mayFind("dhdEnableExpertMode", library.enable_expert_mode);
  finder.mayFind("dhdSetWatchdog", library.set_watchdog);
  finder.mayFind("dhdSetMaxForce", library.set_max_force);
  return finder.missing();
}

std::string lastProblem() {
  const char* const words = ::dlerror();  // NOLINT(concurrency-mt-unsafe): of this thread.
  return words == nullptr ? "the system does not say why" : words;
}

/// Whether the system says more than that there is no such file.
bool isThere(const std::string& place) {
  std::error_code error;
  return place.starts_with("/") && fs::exists(place, error);
}
}  // namespace

std::vector<std::string> libraryPlaces(const std::string& setting, const std::string& home) {
  if (!setting.empty()) return {setting};
  std::vector<std::string> places(kNames.begin(), kNames.end());
  std::vector<fs::path> folders{"/usr/local/lib"};
  if (home.starts_with("/")) folders.push_back(fs::path(home) / ".local/lib");
  for (const char* const name : kNames) {
    for (const fs::path& folder : folders) addFrom(folder, name, places);
  }
  return places;
}

DhdLibrary loadLibrary(const std::string& setting, const std::string& home) {
  DhdLibrary none;
  if (!setting.empty() && !setting.starts_with("/")) {
    none.problem = "RELIEVO_FORCE_DIMENSION_LIBRARY is no absolute path: " + setting;
    return none;
  }
  for (const std::string& place : libraryPlaces(setting, home)) {
    void* const handle = ::dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) {
      const std::string why = lastProblem();
      if (none.problem.empty() && (isThere(place) || !setting.empty())) none.problem = why;
      continue;
    }
    DhdLibrary library;
    library.file = place;
    const std::string missing = fill(handle, library);
    if (missing.empty()) return library;
    ::dlclose(handle);
    if (none.problem.empty()) none.problem = "no function " + missing + " in " + place;
  }
  if (none.problem.empty()) none.problem = "libdhd.so.3, libdrd.so.3";
  return none;
}

}  // namespace relievo::dhd
