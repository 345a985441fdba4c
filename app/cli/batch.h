// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace relievo {

/// Is this word a verb of the command line ("info", "depthmap", ...)?
bool isVerb(std::string_view word);

/// Of a word where files are expected that is a verb, or neither a verb nor, by its look or on the
/// disk, a file: what is wrong and what may have been meant. Empty for all others.
std::string unknownVerb(const std::string& word);

/// Every verb with a line about it, and the exit codes.
std::string verbHelp();

/// For --libraries: the program's on the first line, its commit, then one library a line.
std::string versionText();

/// `relievo VERB ...`: same functions as the window, no window. Same input, same output bytes.
/// @return exit code: 0 done, 1 usage, 2 cannot read, 3 cannot write, 4 finished with warnings,
///         5 verify mismatch, 6 device, 7 no graphics, 130 interrupted; one line on stderr says why
int runBatch(int argc, char** argv);

}  // namespace relievo
