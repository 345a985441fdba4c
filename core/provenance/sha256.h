// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/hash/sha256.h"

namespace relievo {

/// A file's checksum, read in pieces; reports its progress. [worker]
/// @throw FileError  missing, not a regular file, or unreadable  @throw Cancelled
std::string sha256OfFile(const std::filesystem::path& file, const Task& task = {});

/// How `file` is found from `folder`, "/" between names; links are followed. Its absolute path
/// where there is no relative one. Of a published map its address, wherever its map.json is kept.
std::string relativePath(const std::filesystem::path& file, const std::filesystem::path& folder);
/// The other way round: where a file is that a file in `folder` names. An address stays one.
std::string namedFrom(const std::filesystem::path& folder, const std::string& name);

/// Which file something was made from.
struct InputFile {
  std::string file;         ///< As it is found from the folder of what was made; "/" between names.
  std::string sha256;       ///< 64 hexadecimal digits; empty: not known.
  std::uint64_t bytes = 0;  ///< Its size.
  friend bool operator==(const InputFile&, const InputFile&) = default;
};

/// @param from  folder that `file` of the result is relative to; empty: the name alone
/// @throw FileError, Cancelled
InputFile inputFile(const std::filesystem::path& file, const std::filesystem::path& from,
                    const Task& task = {});

/// What several files are together: `name` with the checksum of their checksums, one a line in
/// their order, and all their bytes.
InputFile togetherOf(const std::filesystem::path& name, const std::filesystem::path& from,
                     const std::vector<InputFile>& files);

}  // namespace relievo
