// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace relievo {

/// An option as --help, the manual pages and the completions of shells tell it.
struct OptionRow {
  std::vector<std::string> names;  ///< "-o", "--output"; of a positional "FILE".
  std::string value;               ///< "TEXT", "FLOAT:0 to 1 N"; empty: it takes none.
  std::vector<std::string> words;  ///< All that it takes; empty: not a choice of words.
  std::string help;
  bool required = false;
  bool repeated = false;  ///< It takes several values.

  /// Does it take a text that may be a file?
  bool takesText() const { return value.starts_with("TEXT") && words.empty(); }
};

struct CommandRow {
  std::string name, help;
  std::vector<OptionRow> positionals, options;
  std::vector<CommandRow> parts = {};  ///< "firmware" of `devices`, with options of their own.
};

/// Every verb with all that it takes, from the very parser that reads the command line.
std::vector<CommandRow> commandTable();

}  // namespace relievo
