// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/file/atomic_file.h"

namespace relievo {

/// Writes a file beside its place, brings it to the disk and renames it: whatever happens, either
/// the old file or the whole new one is there; a member of a set waits for the others. [any thread]
/// @throw WriteError
void writeTextFile(const OutputFile& file, std::string_view text);

/// A whole file. [any thread]
/// @throw FileError  missing, not a regular file, empty, unreadable, or longer than `most_bytes`
std::string readTextFile(const std::filesystem::path& file, std::size_t most_bytes);

}  // namespace relievo
