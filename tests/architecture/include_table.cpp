// SPDX-License-Identifier: BSD-3-Clause
#include "tests/architecture/include_table.h"

#include <fnmatch.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace relievo::architecture {
namespace {

std::vector<std::string> words(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> result;
  for (std::string word; in >> word;) result.push_back(word);
  return result;
}

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ':');) result.push_back(field);
  result.resize(4);
  return result;
}

bool isWithin(const std::string& path, const std::string& folder) {
  return path.starts_with(folder + "/");
}

bool contains(const std::vector<std::string>& list, const std::string& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

const ModuleRule* moduleOf(const IncludeTable& table, const std::string& path) {
  const ModuleRule* longest = nullptr;
  for (const ModuleRule& rule : table.modules) {
    if (!isWithin(path, rule.name)) continue;
    if (longest == nullptr || rule.name.size() > longest->name.size()) longest = &rule;
  }
  return longest;
}

const InternalRule* internalRule(const IncludeTable& table, const std::string& header) {
  const auto found = std::find_if(table.internals.begin(), table.internals.end(),
                                  [&](const InternalRule& rule) { return rule.header == header; });
  return found == table.internals.end() ? nullptr : &*found;
}

bool mayIncludeProject(const IncludeTable& table, const ModuleRule& from,
                       const std::string& header) {
  const ModuleRule* to = moduleOf(table, header);
  if (to == nullptr) return false;
  if (to == &from) return true;
  const InternalRule* const internal = internalRule(table, header);
  if (internal != nullptr && from.name != "tests" && !contains(internal->also, from.name)) {
    return false;
  }
  return std::any_of(from.modules.begin(), from.modules.end(),
                     [&](const auto& m) { return to->name == m || isWithin(to->name, m); });
}

RoomsRule roomsRule(const std::string& folder, const std::string& rows) {
  RoomsRule rule{folder, {}};
  for (const std::string& row : words(rows)) {
    std::istringstream in(row);
    rule.rows.emplace_back();
    for (std::string room; std::getline(in, room, '+');) rule.rows.back().push_back(room);
  }
  return rule;
}

/// Which row of `rule` has the room that a file is in; nothing: none has.
std::optional<std::size_t> rowOf(const RoomsRule& rule, const std::string& path) {
  for (std::size_t row = 0; row < rule.rows.size(); ++row) {
    for (const std::string& room : rule.rows[row]) {
      if (isWithin(path, std::string(rule.folder).append("/").append(room))) return row;
    }
  }
  return std::nullopt;
}

bool mayIncludeRoom(const IncludeTable& table, const std::string& path, const std::string& header) {
  return std::all_of(table.rooms.begin(), table.rooms.end(), [&](const RoomsRule& rule) {
    if (!isWithin(path, rule.folder) || !isWithin(header, rule.folder)) return true;
    const std::optional<std::size_t> from = rowOf(rule, path);
    const std::optional<std::size_t> to = rowOf(rule, header);
    return from.has_value() && to.has_value() && *to <= *from;
  });
}

}  // namespace

IncludeTable parseTable(const std::string& text) {
  IncludeTable table;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string> field = fields(line);
    const std::vector<std::string> head = words(field[0]);
    if (head.size() != 2) throw std::runtime_error("Not a rule: " + line);
    if (head[0] == "library") {
      table.libraries.push_back({head[1], words(field[1])});
    } else if (head[0] == "module") {
      table.modules.push_back({head[1], words(field[1]), words(field[2]), words(field[3])});
    } else if (head[0] == "internal") {
      table.internals.push_back({head[1], words(field[1])});
    } else if (head[0] == "rooms") {
      table.rooms.push_back(roomsRule(head[1], field[1]));
    } else if (head[0] == "single") {
      table.singles.emplace_back(head[1], words(field[1]).at(0));
    } else {
      throw std::runtime_error("Not a rule: " + line);
    }
  }
  return table;
}

std::vector<Include> includesOf(const std::string& source) {
  std::vector<Include> found;
  std::istringstream in(source);
  for (std::string line; std::getline(in, line);) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') continue;
    const std::size_t word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) continue;
    const std::size_t open = line.find_first_of("<\"", word);
    if (open == std::string::npos) continue;
    const bool quoted = line[open] == '"';
    const std::size_t close = line.find(quoted ? '"' : '>', open + 1);
    if (close == std::string::npos) continue;
    found.push_back({line.substr(open + 1, close - open - 1), quoted});
  }
  return found;
}

std::string libraryOf(const IncludeTable& table, const std::string& header) {
  for (const LibraryRule& library : table.libraries) {
    for (const std::string& pattern : library.patterns) {
      // A C++ standard header has neither folder nor extension.
      if (library.name == "std" && header.find_first_of("./") != std::string::npos) continue;
      if (fnmatch(pattern.c_str(), header.c_str(), 0) == 0) return library.name;
    }
  }
  return {};
}

std::vector<std::string> violations(const IncludeTable& table, const std::string& path,
                                    const std::string& source) {
  std::vector<std::string> found;
  const ModuleRule* from = moduleOf(table, path);
  if (from == nullptr) return {path + " belongs to no module of the table"};
  const bool is_cpp = path.ends_with(".cpp") || internalRule(table, path) != nullptr;
  for (const Include& include : includesOf(source)) {
    if (include.quoted) {
      // Files that the build makes from the file itself stand beside it.
      if (include.header.ends_with(".moc")) continue;
      if (!mayIncludeProject(table, *from, include.header) ||
          !mayIncludeRoom(table, path, include.header)) {
        found.push_back(path + " may not include " + include.header);
      }
      continue;
    }
    const std::string library = libraryOf(table, include.header);
    const bool allowed =
        contains(from->libraries, library) || (is_cpp && contains(from->cpp_libraries, library));
    if (!allowed) {
      found.push_back(path + " may not include <" + include.header + "> (" +
                      (library.empty() ? "a library the table does not name" : library) + ")");
    }
  }
  return found;
}

std::vector<std::string> spreadLibraries(const IncludeTable& table,
                                         const std::map<std::string, std::string>& sources) {
  std::vector<std::string> found;
  for (const auto& [library, folder] : table.singles) {
    std::string users;
    int count = 0;
    for (const auto& [path, source] : sources) {
      if (!isWithin(path, folder)) continue;
      const std::vector<Include> includes = includesOf(source);
      if (std::any_of(includes.begin(), includes.end(), [&, &name = library](const Include& i) {
            return !i.quoted && libraryOf(table, i.header) == name;
          })) {
        ++count;
        users += ' ';
        users += path;
      }
    }
    if (count > 1)
      found.push_back(std::string(library).append(" is in more than one file:").append(users));
  }
  return found;
}

}  // namespace relievo::architecture
