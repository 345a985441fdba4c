// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/plugin_files.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/base/failure.h"
#include "core/file/atomic_file.h"
#include "core/file/own_program.h"
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

bool isSum(std::string_view text) {
  constexpr std::size_t kDigits = 64;
  return text.size() == kDigits && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

constexpr const char* kBetween = "  ";

/// A line is a checksum, two spaces and a name for people. A list that others may write says
/// nothing.
std::vector<std::string> trustedLines(const fs::path& list) {
  std::vector<std::string> lines;
  std::ifstream stream(list);
  if (!stream || !openToOthers(list).empty()) return lines;
  for (std::string line; std::getline(stream, line);) {
    if (isSum(line.substr(0, line.find(kBetween)))) lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<std::string> trustedSums(const fs::path& list) {
  std::vector<std::string> sums = trustedLines(list);
  for (std::string& line : sums) line.erase(std::min(line.size(), line.find(kBetween)));
  return sums;
}

/// @throw WriteError  @throw DeviceError  others may write there, so that it would say nothing
void writeTrusted(const std::vector<std::string>& lines, const fs::path& list) {
  std::error_code error;
  // Where new folders are open to a group, a list in them would say nothing.
  const fs::path folder = list.parent_path();
  if (fs::create_directories(folder, error)) {
    fs::permissions(folder, fs::perms::owner_all, error);
  }
  AtomicFile written(list);
  for (const std::string& line : lines) written.write(line + '\n');
  written.commit();
  fs::permissions(list, fs::perms::owner_read | fs::perms::owner_write, error);
  if (const fs::path where = openToOthers(list); !where.empty()) {
    throw failure<MessageId::device_plugin_open_to_others>(list, where);
  }
}

bool isPlain(char c) {
  constexpr std::string_view kMarks = "._+-";
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         kMarks.find(c) != std::string_view::npos;
}

/// It stands in ids, in reports and on terminals.
bool isPlainName(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), isPlain);
}

/// For a line of the list: nothing in it ends the line or is a command of a terminal.
std::string shownName(const fs::path& file) {
  std::string name = file.filename().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !isPlain(c); }, '?');
  return name;
}

/// Whether bytes may run, and why not.
struct Judgement {
  bool by_place = false;          // Its folder is trusted.
  std::vector<std::string> sums;  // Else these bytes are.

  std::optional<Message> whyNot(const PluginImage& image) const {
    if (!image.open_to_others.empty()) {
      return said<MessageId::device_plugin_open_to_others>(image.file, image.open_to_others);
    }
    if (by_place || std::find(sums.begin(), sums.end(), image.sha256) != sums.end()) return {};
    return said<MessageId::device_plugin_not_trusted>(image.file);
  }
};

/// Of a file that is not run yet. One in a trusted place is not read for it.
std::optional<Message> whyNotTrusted(const fs::path& file, const Judgement& judgement) {
  if (judgement.by_place) {
    PluginImage unread;
    unread.file = file;
    unread.open_to_others = openToOthers(file);
    return judgement.whyNot(unread);
  }
  try {
    return judgement.whyNot(readPlugin(file));
  } catch (const FileError& error) {
    return messageOf(error);
  }
}

void addFrom(const fs::path& folder, const Judgement& judgement, std::vector<PluginFile>& files) {
  std::error_code error;
  std::vector<PluginFile> here;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".so" || !entry.is_regular_file(error)) continue;
    PluginFile file;
    file.name = entry.path().stem().string();
    if (!isPlainName(file.name)) continue;
    file.file = fs::absolute(entry.path(), error);
    here.push_back(std::move(file));
  }
  std::sort(here.begin(), here.end(),
            [](const PluginFile& a, const PluginFile& b) { return a.name < b.name; });
  for (PluginFile& file : here) {
    const bool known = std::any_of(files.begin(), files.end(),
                                   [&](const PluginFile& f) { return f.name == file.name; });
    if (known) continue;
    file.why_not = whyNotTrusted(file.file, judgement);
    file.trusted = !file.why_not;
    file.own = !judgement.by_place;
    files.push_back(std::move(file));
  }
}

/// Whether it lies in the user's own folder, where each file must be allowed.
bool isOwn(const PluginFile& plugin, const PluginPlaces& places) {
  std::error_code error;
  return plugin.file.parent_path() == fs::absolute(places.own, error);
}
}  // namespace

PluginPlaces pluginPlaces() {
  PluginPlaces places;
  std::istringstream given(variable("RELIEVO_DEVICE_PATH"));
  for (std::string folder; std::getline(given, folder, ':');) {
    if (!folder.empty()) places.trusted.emplace_back(folder);
  }
  // Beside the library of this module, as the programs lie beside theirs.
  const fs::path programs =
      placeOfPrograms(ownFolder("Plug-ins for devices cannot be looked for:"));
  places.trusted.push_back((programs / RELIEVO_DEVICE_PLUGINS).lexically_normal());
  places.own = userFolder("XDG_DATA_HOME", ".local/share") / "devices";
  places.list = userFolder("XDG_CONFIG_HOME", ".config") / "trusted-devices";
  return places;
}

std::vector<PluginFile> pluginFiles(const PluginPlaces& places) {
  std::vector<PluginFile> files;
  for (const fs::path& folder : places.trusted)
    addFrom(folder, {.by_place = true, .sums = {}}, files);
  addFrom(places.own, {.by_place = false, .sums = trustedSums(places.list)}, files);
  return files;
}

PluginImage trustedImage(const PluginFile& plugin, const PluginPlaces& places) {
  PluginImage image = readPlugin(plugin.file);
  const bool own = isOwn(plugin, places);
  const Judgement judgement{.by_place = !own,
                            .sums = own ? trustedSums(places.list) : std::vector<std::string>()};
  if (const auto message = judgement.whyNot(image)) throw DeviceError(*message);
  return image;
}

std::string trustPlugin(const fs::path& file, const PluginPlaces& places) {
  const PluginImage image = readPlugin(file);
  if (!image.open_to_others.empty()) {
    throw failure<MessageId::device_plugin_open_to_others>(file, image.open_to_others);
  }
  std::vector<std::string> lines = trustedLines(places.list);
  const bool known = std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
    return line.starts_with(image.sha256);
  });
  if (known) return image.sha256;
  lines.push_back(image.sha256 + kBetween + shownName(file));
  writeTrusted(lines, places.list);
  return image.sha256;
}

void distrustPlugin(const fs::path& file, const PluginPlaces& places) {
  std::string sum;  // Empty: it cannot be read any more.
  try {
    sum = readPlugin(file).sha256;
  } catch (const FileError&) {
    // Its name says which one is meant.
  }
  std::vector<std::string> lines = trustedLines(places.list);
  const std::string end = kBetween + shownName(file);
  const std::size_t taken = std::erase_if(lines, [&](const std::string& line) {
    return line.ends_with(end) || (!sum.empty() && line.starts_with(sum));
  });
  if (taken == 0) throw failure<MessageId::device_plugin_not_allowed_before>(file);
  writeTrusted(lines, places.list);
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
    std::string shown = own_id;
    shown.append(" (plug-in ").append(name).append(")");
    try {
      return std::make_unique<ForeignDevice>(trustedImage(plugin, places), own_id, id,
                                             std::move(shown));
    } catch (const FileError& error) {  // It went, or changed its rights, a moment ago.
      throw DeviceError(messageOf(error));
    }
  }
  throw failure<MessageId::device_plugin_missing>(name);
}

}  // namespace relievo::foreign
