// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/verbs/devices/verb_devices_plugins.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "app/cli/options/device_settings.h"
#include "app/cli/options/number_option.h"
#include "app/cli/report_text.h"
#include "app/cli/verbs/devices/live_device.h"
#include "core/base/failure.h"
#include "haptics/device/foreign/ask_host.h"
#include "haptics/device/foreign/plugin_files.h"
#include "haptics/device/foreign/plugin_settings.h"

namespace relievo::batch {

namespace {
constexpr int kFailedExit = 1;

using foreign::CheckResult;
using foreign::PluginFile;
using foreign::ScannedPlugin;
using foreign::Verdict;

std::string idOf(const PluginFile& file, const std::string& own_id) {
  return std::string(foreign::kPluginKind) + ":" + file.name + "/" + own_id;
}

/// What the plug-in calls it.
std::string ownId(const std::string& id) {
  const bool whole = id.starts_with(std::string(foreign::kPluginKind) + ":");
  const std::size_t slash = id.find('/');
  return whole && slash != std::string::npos ? id.substr(slash + 1) : id;
}

/// What is judged is what is asked: the file may have changed since it was listed.
ScannedPlugin scanned(const PluginFile& file, const Task& task) {
  ScannedPlugin none;
  try {
    return foreign::scanPlugin(foreign::trustedImage(file), task);
  } catch (const FileError& error) {
    none.trouble = messageOf(error);
  } catch (const DeviceError& error) {
    none.trouble = messageOf(error);
  }
  return none;
}

void tellTrusted(const PluginFile& file, Json& one, CommandResult& outcome, const Task& task) {
  const ScannedPlugin plugin = scanned(file, task);
  if (plugin.trouble) {
    one["trouble"] = englishText(*plugin.trouble);
    one["code"] = codeOf(*plugin.trouble);
    // One that comes with relievo is there, whether anybody has its device or not.
    if (plugin.trouble->id == MessageId::device_library_missing) {
      outcome.lines.push_back("plug-in " + file.name + ": " + englishText(*plugin.trouble) + " (" +
                              codeOf(*plugin.trouble) + ")");
      return;
    }
    outcome.lines.push_back("plug-in " + file.name + ": cannot be used");
    outcome.exit_code = kDeviceExit;
    return tell("The plug-in " + file.file.string() +
                " cannot be used: " + englishText(*plugin.trouble) + ".");
  }
  one["title"] = plugin.name;
  one["version"] = plugin.version;
  one["maker"] = plugin.maker;
  one["licence"] = plugin.licence;
  outcome.lines.push_back("plug-in " + file.name + ": " + plugin.name + " " + plugin.version +
                          ", by " + plugin.maker + (plugin.devices.empty() ? "; no device" : ""));
  for (const foreign::SeenDevice& device : plugin.devices) {
    const std::string id = idOf(file, device.id);
    one["devices"].push_back({{"id", id}, {"name", device.name}});
    outcome.lines.push_back(id + ": " + device.name);
  }
}

/// Only Enter is a yes; at a terminal only what is typed from now on.
bool isHeld(double newton, const Task& task) {
  std::array<char, 32> most{};
  std::snprintf(most.data(), most.size(), "%.3g", newton);
  tell("All other tests passed. Now the device pushes with up to " + std::string(most.data()) +
       " N. Hold the grip, with the other hand at the power switch, then press Enter.");
  for (pollfd old{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
       ::isatty(STDIN_FILENO) != 0 && ::poll(&old, 1, 0) > 0;) {
    char typed = 0;
    if (::read(STDIN_FILENO, &typed, 1) <= 0) return false;
  }
  constexpr int kLookMs = 50;
  while (true) {
    task.check();
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    if (::poll(&input, 1, kLookMs) <= 0) continue;
    char typed = 0;
    if (::read(STDIN_FILENO, &typed, 1) <= 0) return false;  // Nobody is there to say it.
    if (typed == '\n') return true;
  }
}

const char* wordOf(Verdict verdict) {
  constexpr std::array<const char*, 3> kWords{"passed", "FAILED", "skipped"};
  return kWords[static_cast<std::size_t>(verdict)];
}
}  // namespace

void declareLibrary(CLI::App& verb, LibraryArguments& arguments) {
  CLI::App* const library = verb.add_subcommand(
      "library", "Where the library lies that a plug-in's maker has; without FILE: which is used");
  library->add_option("PLUGIN", arguments.plugin, "Such as force_dimension")->required();
  CLI::Option* const file =
      library->add_option("FILE", arguments.file, "Such as libdhd.so.3; kept");
  library->add_flag("--forget", arguments.forget, "Look in the usual places again")->excludes(file);
  library->callback([&arguments] { arguments.asked = true; });
}

void declarePlugins(CLI::App& verb, PluginArguments& arguments) {
  CLI::Option* const trust = verb.add_option(
      "--trust", arguments.trust, "Allow this plug-in for devices, as it is, to run for you");
  CLI::Option* const distrust = verb.add_option(
      "--distrust", arguments.distrust, "Allow this plug-in for devices no longer to run for you");
  distrust->excludes(trust);
  CLI::Option* const test =
      verb.add_option("--conformance", arguments.conformance, "Test this plug-in for devices");
  test->excludes(trust)->excludes(distrust);
  verb.add_option("--device", arguments.device, "Its device, for the tests that open one")
      ->needs(test);
  takes(verb.add_option("--newton", arguments.newton,
                        "Largest force of the tests, with a hand at the grip; 0: none"),
        {.low = 0, .high = foreign::kMostForceN, .unit = "N"})
      .needs(test);
  takes(verb.add_option("--seconds", arguments.seconds, "How long each test watches the device; 2"),
        {.low = 0.05, .high = 60, .unit = "s"})
      .needs(test);
}

void listPlugins(Json& json, CommandResult& outcome, const Task& task) {
  json["plugins"] = Json::array();
  for (const PluginFile& file : foreign::pluginFiles()) {
    Json one{{"name", file.name},
             {"file", file.file.string()},
             {"trusted", file.trusted},
             {"own", file.own}};
    const std::string library = makersLibrary(file.name).string();
    one["makers_library"] = library.empty() ? Json() : Json(library);
    one["devices"] = Json::array();
    one["trouble"] = nullptr;
    if (file.trusted) {
      tellTrusted(file, one, outcome, task);
    } else {
      const bool can_be_allowed =
          file.why_not && file.why_not->id == MessageId::device_plugin_not_trusted;
      outcome.lines.push_back("plug-in " + file.name + ": " +
                              (can_be_allowed ? "not allowed yet" : "cannot be used"));
      if (file.why_not) {
        one["trouble"] = englishText(*file.why_not);
        tell(englishText(*file.why_not));
      }
    }
    json["plugins"].push_back(std::move(one));
  }
}

CommandResult makersLibraryOf(const LibraryArguments& arguments) {
  const std::vector<DevicePlugin> plugins = devicePlugins();
  const bool known = std::any_of(plugins.begin(), plugins.end(), [&](const DevicePlugin& plugin) {
    return plugin.name == arguments.plugin;
  });
  if (!known) throw failure<MessageId::device_plugin_missing>(arguments.plugin);
  if (arguments.forget || !arguments.file.empty()) {
    setMakersLibrary(arguments.plugin, arguments.file);
  }
  const std::string chosen = makersLibrary(arguments.plugin).string();
  const std::string variable = foreign::libraryVariable(arguments.plugin);
  const char* const value = std::getenv(variable.c_str());  // NOLINT(concurrency-mt-unsafe)
  const std::string named = value == nullptr ? "" : value;
  Json json{{"plugin", arguments.plugin},
            {"library", chosen.empty() ? Json() : Json(chosen)},
            {"variable", named.empty() ? Json() : Json(named)}};
  CommandResult outcome{.json = reportText(json), .lines = {}};
  if (!chosen.empty()) {
    outcome.lines = {arguments.plugin + ": " + chosen,
                     "kept in " + foreign::pluginSettingsFile().string()};
    if (!named.empty() && named != chosen) {
      tell(variable + " names \"" + named + "\", which is not used while a library is kept.");
    }
  } else {
    outcome.lines = {
        arguments.plugin + ": " +
        (named.empty() ? "where such libraries usually are" : named + ", by " + variable)};
  }
  return outcome;
}

CommandResult distrustPluginFile(const std::string& file) {
  allowDevicePlugin(file, false);
  return {.json = reportText(Json{{"file", file}, {"trusted", false}}),
          .lines = {"It may not run any more."}};
}

CommandResult trustPluginFile(const std::string& file) {
  const std::string sum = allowDevicePlugin(file, true);
  const std::filesystem::path folder = ownDevicePlugins();
  return {.json = reportText(Json{{"file", file}, {"sha256", sum}, {"folder", folder.string()}}),
          .lines = {"sha256 " + sum, "It may run from " + folder.string() + " until it changes."}};
}

CommandResult checkPluginFile(const PluginArguments& arguments, const Task& task) {
  const std::filesystem::path file = std::filesystem::absolute(arguments.conformance);
  const std::vector<CheckResult> results =
      foreign::checkPlugin(file,
                           {.device = ownId(arguments.device),
                            .newton = arguments.newton,
                            .seconds = arguments.seconds,
                            .is_held = [&] { return isHeld(arguments.newton, task); }},
                           task);
  CommandResult outcome;
  Json json{{"file", file.string()}, {"device", arguments.device}};
  json["checks"] = Json::array();
  for (const CheckResult& result : results) {
    const std::string code(result.check.code), title(result.check.title);
    const bool failed = result.verdict == Verdict::failed;
    json["checks"].push_back({{"code", code},
                              {"title", title},
                              {"verdict", failed ? "failed" : wordOf(result.verdict)},
                              {"why", result.why}});
    std::string line = code;
    line.append(" ").append(wordOf(result.verdict)).append(": ").append(title);
    if (!result.why.empty()) line.append(" (").append(result.why).append(")");
    outcome.lines.push_back(std::move(line));
    if (failed) outcome.exit_code = kFailedExit;
  }
  outcome.json = reportText(json);
  return outcome;
}

}  // namespace relievo::batch
