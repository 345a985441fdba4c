// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "core/file/owned_fd.h"

namespace relievo::foreign {

/// One plug-in as it was when it was read: what is judged is what runs, whatever happens to its
/// file meanwhile.
struct PluginImage {
  std::filesystem::path file;  ///< Where it was; the plug-in is told so.
  OwnedFd bytes;               ///< A copy in memory that nobody can change; the host loads it.
  std::string sha256;          ///< Of those bytes.
  /// The file or a folder on the way to it that somebody besides this user and the administrator
  /// may write to; empty: there is none.
  std::filesystem::path open_to_others;
};

/// Opens the file once. Nothing of it is run. [worker]
/// @throw FileError  it is no file, may not be read, or is larger than any library
PluginImage readPlugin(const std::filesystem::path& file);

/// Of what was opened, and of the folders on the way to it: see PluginImage. Follows links.
std::filesystem::path openToOthers(int fd);
/// The same of a file that is not to be read. It counts as open to others if it cannot be opened.
std::filesystem::path openToOthers(const std::filesystem::path& file);

}  // namespace relievo::foreign
