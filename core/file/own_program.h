// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace relievo {

/// The folder of the program that runs, or the one that was given.
/// @param does  what is not possible without the programs beside it, with a colon
/// @throw FileError  /proc, which tells it, is not there
std::filesystem::path ownFolder(const std::string& does);

/// For a program that is not relievo's, as a Python interpreter is not: relievo's programs are
/// looked for as if it lay there. [before any is started]
void setProgramFolder(const std::filesystem::path& folder);

/// Where relievo's program `name` lies for one that lies in `folder`: installed, beside it in the
/// build folder or among programs that relievo starts, or beside the build's tests.
/// @return empty: it is nowhere
std::filesystem::path programSeenFrom(const std::filesystem::path& folder,
                                      const std::filesystem::path& name);

/// Where it would lie if it were installed with what lies in `folder`.
std::filesystem::path placeOfPrograms(const std::filesystem::path& folder);

/// relievo's program `name`, for the one that runs. Parameters and errors as above.
std::filesystem::path ownProgram(const std::string& name, const std::string& does);

}  // namespace relievo
