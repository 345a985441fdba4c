// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace relievo::foreign {

/// What people choose of devices with plug-ins, for window and command line alike. Which plug-ins
/// may run stands in a list of its own (PluginPlaces::list).
struct PluginSettings {
  /// Where the maker's library of a plug-in lies, by the plug-in's name: an absolute path. None:
  /// the plug-in looks where it always does.
  std::map<std::string, std::filesystem::path> libraries;
};

/// $XDG_CONFIG_HOME/relievo/devices.conf. [any one thread]
std::filesystem::path pluginSettingsFile();

/// One "library PLUGIN FILE" per line. What is missing, unknown or no absolute path is left out.
PluginSettings readPluginSettings(const std::filesystem::path& file = pluginSettingsFile());

/// From the next start of the plug-in on its maker's library is this file; empty: the usual places
/// again. Whole or not at all. @pre plugin is a plug-in's name
/// @throw FileError  there is no such file  @throw WriteError
void setMakersLibrary(const std::string& plugin, const std::filesystem::path& library,
                      const std::filesystem::path& file = pluginSettingsFile());

/// Of the variable by which a plug-in is told: RELIEVO_FORCE_DIMENSION_LIBRARY of
/// "force_dimension".
std::string libraryVariable(const std::string& plugin);
/// What the host of a plug-in gets in its environment, besides what this process has, as
/// "NAME=VALUE". A library that was chosen goes before one that the environment names.
std::vector<std::string> variablesFor(const std::filesystem::path& plugin_file,
                                      const PluginSettings& settings = readPluginSettings());

}  // namespace relievo::foreign
