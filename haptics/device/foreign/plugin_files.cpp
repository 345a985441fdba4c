// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/plugin_files.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

#include "core/base/failure.h"
#include "core/file/atomic_file.h"
#include "core/file/own_program.h"
#include "core/hash/sha256.h"
#include "haptics/device/foreign/foreign_device.h"

namespace relievo::foreign {

namespace fs = std::filesystem;

namespace {
constexpr std::string_view kPrefix = "plugin:";

std::string variable(const char* name) {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
  return value == nullptr ? "" : value;
}

/// Of the user: what XDG_... says, or where it is without.
fs::path userFolder(const char* name, const char* otherwise) {
  const std::string given = variable(name);
  if (given.starts_with("/")) return fs::path(given) / "relievo";
  const std::string home = variable("HOME");
  return fs::path(home.empty() ? "/" : home) / otherwise / "relievo";
}

std::vector<std::string> trustedSums(const fs::path& list) {
  std::vector<std::string> sums;
  std::ifstream stream(list);
  for (std::string line; std::getline(stream, line);) {
    constexpr std::size_t kDigits = 64;
    if (line.size() >= kDigits) sums.push_back(line.substr(0, kDigits));
  }
  return sums;
}

/// @throw FileError
std::string sumOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::error_code error;
  if (!stream || !fs::is_regular_file(file, error)) {
    throw failure<MessageId::device_plugin_unreadable>(file, "it is no file, or may not be read");
  }
  Sha256 sum;
  std::array<char, 65536> bytes{};
  while (stream) {
    stream.read(bytes.data(), bytes.size());
    sum.add(std::string_view(bytes.data(), static_cast<std::size_t>(stream.gcount())));
  }
  return sum.finish();
}

bool isListed(const fs::path& file, const std::vector<std::string>& sums) {
  if (sums.empty()) return false;
  try {
    return std::find(sums.begin(), sums.end(), sumOf(file)) != sums.end();
  } catch (const FileError&) {
    return false;
  }
}

template <class IsTrusted>
void addFrom(const fs::path& folder, const IsTrusted& is_trusted, std::vector<PluginFile>& files) {
  std::error_code error;
  std::vector<PluginFile> here;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".so" || !entry.is_regular_file(error)) continue;
    here.push_back({entry.path().stem().string(), fs::absolute(entry.path(), error), false});
  }
  std::sort(here.begin(), here.end(),
            [](const PluginFile& a, const PluginFile& b) { return a.name < b.name; });
  for (PluginFile& file : here) {
    const bool known = std::any_of(files.begin(), files.end(),
                                   [&](const PluginFile& f) { return f.name == file.name; });
    if (known) continue;
    file.trusted = is_trusted(file.file);
    files.push_back(std::move(file));
  }
}
}  // namespace

PluginPlaces pluginPlaces() {
  PluginPlaces places;
  std::istringstream given(variable("RELIEVO_DEVICE_PATH"));
  for (std::string folder; std::getline(given, folder, ':');) {
    if (!folder.empty()) places.trusted.emplace_back(folder);
  }
  // Beside the library of this module, as the programs lie beside theirs.
  const fs::path programs = ownFolder("Plug-ins for devices cannot be looked for:");
  places.trusted.push_back((programs / RELIEVO_DEVICE_PLUGINS).lexically_normal());
  places.own = userFolder("XDG_DATA_HOME", ".local/share") / "devices";
  places.list = userFolder("XDG_CONFIG_HOME", ".config") / "trusted-devices";
  return places;
}

std::vector<PluginFile> pluginFiles(const PluginPlaces& places) {
  std::vector<PluginFile> files;
  for (const fs::path& folder : places.trusted) {
    addFrom(
        folder, [](const fs::path&) { return true; }, files);
  }
  const std::vector<std::string> sums = trustedSums(places.list);
  addFrom(
      places.own, [&](const fs::path& file) { return isListed(file, sums); }, files);
  return files;
}

std::string trustPlugin(const fs::path& file, const PluginPlaces& places) {
  std::string sum = sumOf(file);
  std::ostringstream kept;
  if (std::ifstream stream(places.list); stream) kept << stream.rdbuf();
  std::string text = kept.str();
  if (text.find(sum) != std::string::npos) return sum;
  if (!text.empty() && text.back() != '\n') text += '\n';
  std::error_code error;
  fs::create_directories(places.list.parent_path(), error);
  AtomicFile written(places.list);
  written.write(text + sum + "  " + file.filename().string() + "\n");
  written.commit();
  return sum;
}

std::unique_ptr<Device> makePluginDevice(const std::string& id, const PluginPlaces& places) {
  const std::size_t slash = id.find('/');
  if (!id.starts_with(kPrefix) || slash == std::string::npos || slash + 1 == id.size()) {
    throw failure<MessageId::device_plugin_id>(id);
  }
  const std::string name = id.substr(kPrefix.size(), slash - kPrefix.size());
  const std::string own_id = id.substr(slash + 1);
  for (const PluginFile& plugin : pluginFiles(places)) {
    if (plugin.name != name) continue;
    if (!plugin.trusted) throw failure<MessageId::device_plugin_not_trusted>(plugin.file);
    std::string shown = own_id;
    shown.append(" (plug-in ").append(name).append(")");
    return std::make_unique<ForeignDevice>(plugin.file, own_id, id, std::move(shown));
  }
  throw failure<MessageId::device_plugin_missing>(name);
}

}  // namespace relievo::foreign
