// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace relievo::architecture {

/// What allowed_includes.txt says about one folder.
struct ModuleRule {
  std::string name;                        ///< "core/depth"
  std::vector<std::string> modules;        ///< It may include these and itself.
  std::vector<std::string> libraries;      ///< In every file.
  std::vector<std::string> cpp_libraries;  ///< In .cpp files only.
};

struct LibraryRule {
  std::string name;
  std::vector<std::string> patterns;  ///< Of header names, as in a shell.
};

/// A header that only its own module, tests and those modules may include.
struct InternalRule {
  std::string header;
  std::vector<std::string> also;
};

/// Folders within one folder, in rows from below to above: a file may include those of its own row
/// and of the rows below it.
struct RoomsRule {
  std::string folder;                          ///< "ui"
  std::vector<std::vector<std::string>> rows;  ///< Names of folders within it.
};

struct IncludeTable {
  std::vector<LibraryRule> libraries;
  std::vector<ModuleRule> modules;
  std::vector<InternalRule> internals;
  std::vector<RoomsRule> rooms;
  std::vector<std::pair<std::string, std::string>> singles;  ///< Library, folder.
};

/// @throw std::runtime_error  a line that is neither comment nor rule
IncludeTable parseTable(const std::string& text);

struct Include {
  std::string header;
  bool quoted = false;  ///< "..." rather than <...>
};
std::vector<Include> includesOf(const std::string& source);

/// The library a header belongs to; empty if the table names none.
std::string libraryOf(const IncludeTable& table, const std::string& header);

/// Forbidden includes of one file, a sentence for each. @param path  from the root of the tree
std::vector<std::string> violations(const IncludeTable& table, const std::string& path,
                                    const std::string& source);

/// Libraries that more files include than the table's `single` lines allow.
/// @param sources  path -> text
std::vector<std::string> spreadLibraries(const IncludeTable& table,
                                         const std::map<std::string, std::string>& sources);

}  // namespace relievo::architecture
