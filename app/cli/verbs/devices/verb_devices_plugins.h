// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/cli/json.h"
#include "app/cli/verb.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name.
class App;
}

namespace relievo::batch {

struct PluginArguments {
  std::string trust;        ///< A file that may run from now on.
  std::string distrust;     ///< One that may not any more.
  std::string conformance;  ///< A file that is tested.
  std::string device;       ///< Its id in the plug-in, or "plugin:FILE/ID".
  double newton = 0;        ///< 0: no force is shown.
  double seconds = 2;       ///< How long each test watches.
};
/// Where the maker's library of a plug-in lies.
struct LibraryArguments {
  std::string plugin;  ///< Its name.
  std::string file;    ///< Empty: nothing is changed.
  bool forget = false;
  bool asked = false;  ///< The command was given.
};
void declareLibrary(CLI::App& verb, LibraryArguments& arguments);
void declarePlugins(CLI::App& verb, PluginArguments& arguments);

/// Every plug-in for devices that was found, and the devices of those that may run; each is asked
/// in a process of its own. Adds "plugins" to the report. @throw Cancelled
void listPlugins(Json& json, CommandResult& outcome, const Task& task);

/// @throw FileError, WriteError, DeviceError
CommandResult trustPluginFile(const std::string& file);
CommandResult distrustPluginFile(const std::string& file);
/// Keeps a library, forgets it, or says which is used. @throw FileError, WriteError
CommandResult makersLibraryOf(const LibraryArguments& arguments);
/// Runs all tests; exit status 1 if one failed. @throw FileError, DeviceError  no host
CommandResult checkPluginFile(const PluginArguments& arguments, const Task& task);

}  // namespace relievo::batch
