// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/cli/command_table.h"

namespace relievo::manual {

/// All that the command line takes: the window's options, and each verb's.
struct CommandLine {
  std::vector<OptionRow> window;
  std::vector<CommandRow> verbs;
};

/// From the same rows that --help is made of.
CommandLine commandLine();

/// Manual pages by their file names: relievo.1 and relievo-VERB.1 (roff, man(7); ASCII and
/// escapes).
std::map<std::string, std::string> pages(const CommandLine& line);

// What completes the command line in a shell: verbs, options, the words that an option takes, and
// files where it may take a file.
std::string bashCompletion(const CommandLine& line);
std::string zshCompletion(const CommandLine& line);
std::string fishCompletion(const CommandLine& line);

}  // namespace relievo::manual
