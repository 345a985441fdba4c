// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/project/project.h"

namespace relievo {

enum class FileState { as_before, missing, changed };
struct FileCheck {
  InputFile file;
  FileState state = FileState::as_before;
};
/// [worker] @throw Cancelled
FileCheck checkFile(const InputFile& file, const Task& task = {});
/// The input first, then the recordings. [worker] @throw Cancelled
std::vector<FileCheck> checkFiles(const Project& project, const Task& task = {});

/// Where the file is that a host file names: as stored, beside the host file, in the working
/// folder, or in the folder of inputs of a package. @throw FileError  E501, nowhere there
std::filesystem::path foundInput(const std::filesystem::path& host_file,
                                 const std::filesystem::path& stored);

/// The same of a file with this checksum, which may have a number before its name beside the
/// host file, as in packages; another one of that name if none has it. [worker]
/// @param sha256  empty: not known, any is taken
std::filesystem::path foundInput(const std::filesystem::path& host_file,
                                 const std::filesystem::path& stored, const std::string& sha256,
                                 const Task& task);

/// Does the file lie in the folder of what names it, or below, when links are followed?
bool isInFolderOf(const std::filesystem::path& host_file, const std::filesystem::path& file);

/// May a file be read that whoever wrote `host file` chose, not who opens it? One in the host
/// file's folder or below; and one with the very bytes that the host file states: whoever wrote
/// that had them (docs/adr/0136). [worker] @throw Cancelled
bool mayBeRead(const std::filesystem::path& host_file, const InputFile& named,
               const Task& task = {});

/// Files that a project names and that are there, but must not be read before somebody was asked:
/// the input first, then recordings and figures. Of a recording or figure without a checksum it is
/// enough that it carries a state of this very input. Each once. [worker] @throw Cancelled
std::vector<std::filesystem::path> foreignFiles(const std::filesystem::path& host_file,
                                                const Project& project, const Task& task = {});

/// A file with these very bytes in a folder or below it; the name does not count. Links to folders
/// are not followed. [worker] @throw Cancelled
std::optional<std::filesystem::path> foundByChecksum(const InputFile& wanted,
                                                     const std::filesystem::path& folder,
                                                     const Task& task = {});

}  // namespace relievo
