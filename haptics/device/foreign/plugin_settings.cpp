// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/plugin_settings.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string_view>
#include <utility>

#include "core/base/failure.h"
#include "core/file/atomic_file.h"
#include "haptics/device/foreign/plugin_files.h"

namespace relievo::foreign {

namespace fs = std::filesystem;

namespace {
constexpr std::string_view kLibrary = "library ";

bool endsALine(char c) {
  return c == '\n' || c == '\r' || c == '\0';
}
}  // namespace

fs::path pluginSettingsFile() {
  return pluginPlaces().list.parent_path() / "devices.conf";
}

PluginSettings readPluginSettings(const fs::path& file) {
  PluginSettings settings;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(kLibrary)) continue;
    line.erase(0, kLibrary.size());
    const std::size_t space = line.find(' ');
    if (space == std::string::npos || space == 0) continue;
    fs::path library = line.substr(space + 1);
    if (library.is_absolute()) settings.libraries[line.substr(0, space)] = std::move(library);
  }
  return settings;
}

void setMakersLibrary(const std::string& plugin, const fs::path& library, const fs::path& file) {
  std::error_code error;
  PluginSettings settings = readPluginSettings(file);
  if (library.empty()) {
    settings.libraries.erase(plugin);
  } else {
    const fs::path whole = fs::absolute(library, error).lexically_normal();
    const std::string& name = whole.native();
    if (!fs::is_regular_file(whole, error) || std::any_of(name.begin(), name.end(), endsALine)) {
      throw failure<MessageId::makers_library_no_file>(library);
    }
    settings.libraries[plugin] = whole;
  }
  fs::create_directories(file.parent_path(), error);
  try {
    AtomicFile written(file);
    for (const auto& [of, where] : settings.libraries) {
      written.write(std::string(kLibrary) + of + ' ' + where.string() + '\n');
    }
    written.commit();
  } catch (const WriteError&) {
    throw failure<MessageId::device_settings_not_written>(file);
  }
}

std::string libraryVariable(const std::string& plugin) {
  std::string name = "RELIEVO_";
  for (const char c : plugin) {
    const auto byte = static_cast<unsigned char>(c);
    name += std::isalnum(byte) != 0 ? static_cast<char>(std::toupper(byte)) : '_';
  }
  return name + "_LIBRARY";
}

std::vector<std::string> variablesFor(const fs::path& plugin_file, const PluginSettings& settings) {
  const auto found = settings.libraries.find(plugin_file.stem().string());
  if (found == settings.libraries.end()) return {};
  return {libraryVariable(found->first) + "=" + found->second.string()};
}

}  // namespace relievo::foreign
