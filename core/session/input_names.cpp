// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/input_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/failure.h"
#include "core/base/json_nesting.h"
#include "core/io/file_check.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

constexpr std::array<std::string_view, 3> kClouds{".las", ".laz", ".ply"};
constexpr std::array<std::string_view, 3> kLists{".txt", ".lst", ".list"};
constexpr std::array<std::string_view, 3> kIndices{".vpc", ".geojson", ".json"};
constexpr std::size_t kMostListBytes = std::size_t{64} << 20U;  // A million names.
constexpr std::size_t kHeadBytes = 16384;                       // Says whether it is a list.

template <std::size_t N>
bool endsIn(const fs::path& file, const std::array<std::string_view, N>& endings) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

bool isFile(const fs::path& file) {
  std::error_code unknown;
  return fs::is_regular_file(file, unknown);
}
bool isFolder(const fs::path& file) {
  std::error_code unknown;
  return fs::is_directory(file, unknown);
}

bool hasWildcard(std::string_view name) {
  return name.find_first_of("*?") != std::string_view::npos;
}

/// Does a name fit, * for any letters and ? for one? Without going back further than the last *.
bool fits(std::string_view pattern, std::string_view name) {
  std::size_t p = 0, n = 0, star = std::string_view::npos, from = 0;
  while (n < name.size()) {
    if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n]) && pattern[p] != '*') {
      ++p;
      ++n;
    } else if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      from = n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++from;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

/// @throw FileError  it cannot be listed
Paths inFolder(const fs::path& folder) {
  std::error_code error;
  Paths found;
  fs::directory_iterator at(folder.empty() ? fs::path(".") : folder, error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    found.push_back(folder / at->path().filename());
  }
  if (error) throw failure<MessageId::folder_not_listed>(folder, error.message());
  return found;
}

Paths fitting(const fs::path& pattern) {
  Paths found{pattern.root_path()};
  for (const fs::path& part : pattern.relative_path()) {
    Paths next;
    for (const fs::path& folder : found) {
      if (!hasWildcard(part.string())) {
        next.push_back(folder / part);
        continue;
      }
      if (!folder.empty() && !isFolder(folder)) continue;
      for (fs::path& one : inFolder(folder)) {
        const std::string name = one.filename().string();
        const bool is_hidden = name.front() == '.' && part.string().front() != '.';
        if (!is_hidden && fits(part.string(), name)) next.push_back(std::move(one));
      }
    }
    found = std::move(next);
  }
  std::erase_if(found, [](const fs::path& file) { return !isFile(file); });
  return found;
}

/// @throw FileError  it is larger than any list
std::string textOf(const fs::path& file) {
  if (checkedFileSize(file) > kMostListBytes) throw failure<MessageId::list_too_long>(file);
  return readHead(file, kMostListBytes);
}

/// The entries of a list, or of its beginning.
std::vector<std::string_view> entriesOf(std::string_view text) {
  std::vector<std::string_view> entries;
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    if (!line.empty() && line.front() != '#') entries.push_back(line);
  }
  return entries;
}

/// What a text names, if it is a list: scans as text, which may be large, begin with numbers.
std::optional<Paths> listed(const fs::path& list) {
  const std::string head = readHead(list, kHeadBytes);
  const std::vector<std::string_view> begin = entriesOf(head);
  if (begin.empty() || !endsIn(fs::path(begin.front()), kClouds)) return std::nullopt;
  const std::string text = textOf(list);
  Paths found;
  for (const std::string_view entry : entriesOf(text)) {
    found.push_back(list.parent_path() / fs::path(entry));
  }
  return found;
}

/// Where a feature of an index says that its file is.
std::string placeIn(const nlohmann::json& feature) {
  const nlohmann::json none = nlohmann::json::object();
  const auto object = [&](const nlohmann::json& of, const char* key) -> const nlohmann::json& {
    return of.is_object() && of.contains(key) && of.at(key).is_object() ? of.at(key) : none;
  };
  const auto text = [](const nlohmann::json& of, const char* key) -> std::string {
    return of.contains(key) && of.at(key).is_string() ? of.at(key).get<std::string>() : "";
  };
  const nlohmann::json& assets = object(feature, "assets");
  if (std::string place = text(object(assets, "data"), "href"); !place.empty()) return place;
  for (const auto& [key, asset] : assets.items()) {
    if (!asset.is_object()) continue;
    if (std::string place = text(asset, "href"); !place.empty()) return place;
  }
  return text(object(feature, "properties"), "location");
}

/// What a tile index names, if it is one.
std::optional<Paths> indexed(const fs::path& index) {
  if (readHead(index, kHeadBytes).find("FeatureCollection") == std::string::npos) {
    return std::nullopt;
  }
  const std::string text = textOf(index);
  constexpr int kDeepest = 64;  // What is taken apart recurses.
  if (isNestedDeeper(text, kDeepest)) throw failure<MessageId::index_damaged>(index);
  Paths found;
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    for (const nlohmann::json& feature : json.at("features")) {
      std::string place = placeIn(feature);
      if (place.empty()) throw failure<MessageId::index_damaged>(index);
      constexpr std::string_view kFile = "file://";
      if (place.starts_with(kFile)) place.erase(0, kFile.size());
      if (place.find("://") != std::string::npos || place.starts_with("/vsi")) {
        throw failure<MessageId::list_names_address>(index, place);
      }
      found.push_back(index.parent_path() / place);
    }
  } catch (const nlohmann::json::exception&) {
    throw failure<MessageId::index_damaged>(index);
  }
  if (found.empty()) throw failure<MessageId::no_scans_there>(index);
  return found;
}

/// Nothing: the name stands for itself.
std::optional<Paths> meantBy(const fs::path& name) {
  if (isFolder(name)) {
    Paths found = inFolder(name);
    std::erase_if(found,
                  [](const fs::path& file) { return !isFile(file) || !endsIn(file, kClouds); });
    if (found.empty()) throw failure<MessageId::no_scans_there>(name);
    return found;
  }
  if (!isFile(name)) {
    if (!hasWildcard(name.string())) return std::nullopt;  // Whoever opens it says so.
    Paths found = fitting(name);
    if (found.empty()) throw failure<MessageId::nothing_fits>(name);
    return found;
  }
  std::optional<Paths> found;
  if (endsIn(name, kLists)) found = listed(name);
  if (endsIn(name, kIndices)) found = indexed(name);
  if (!found) return std::nullopt;
  for (const fs::path& file : *found) {
    if (!isFile(file)) throw failure<MessageId::listed_file_missing>(name, file);
  }
  return found;
}

}  // namespace

Paths filesNamed(const Paths& names) {
  std::map<fs::path, fs::path> sorted;  // By where a file is, through links.
  for (const fs::path& name : names) {
    const std::optional<Paths> meant = meantBy(name);
    if (!meant && names.size() == 1) return names;
    for (const fs::path& file : meant.value_or(Paths{name})) {
      std::error_code unknown;
      sorted.emplace(fs::weakly_canonical(fs::absolute(file), unknown), file);
    }
  }
  Paths files;
  for (auto& [place, file] : sorted) files.push_back(file);
  return files;
}

}  // namespace relievo
