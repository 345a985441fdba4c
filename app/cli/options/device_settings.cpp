// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/options/device_settings.h"

#include <utility>

#include "haptics/device/foreign/plugin_files.h"
#include "haptics/device/foreign/plugin_settings.h"

namespace relievo::batch {

namespace fs = std::filesystem;

fs::path makersLibrary(const std::string& plugin) {
  const foreign::PluginSettings settings = foreign::readPluginSettings();
  const auto found = settings.libraries.find(plugin);
  return found == settings.libraries.end() ? fs::path() : found->second;
}

void setMakersLibrary(const std::string& plugin, const fs::path& library) {
  foreign::setMakersLibrary(plugin, library);
}

std::vector<DevicePlugin> devicePlugins() {
  std::vector<DevicePlugin> plugins;
  for (foreign::PluginFile& found : foreign::pluginFiles()) {
    plugins.push_back({std::move(found.name), std::move(found.file), found.trusted, found.own,
                       std::move(found.why_not)});
  }
  return plugins;
}

fs::path ownDevicePlugins() {
  return foreign::pluginPlaces().own;
}

std::string allowDevicePlugin(const fs::path& file, bool allowed) {
  if (allowed) return foreign::trustPlugin(file);
  foreign::distrustPlugin(file);
  return {};
}

}  // namespace relievo::batch
