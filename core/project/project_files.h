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
/// The input first, then the recordings. [worker] @throw Cancelled
std::vector<FileCheck> checkFiles(const Project& project, const Task& task = {});

/// A file with these very bytes in a folder or below it; the name does not count. Links to folders
/// are not followed. [worker] @throw Cancelled
std::optional<std::filesystem::path> foundByChecksum(const InputFile& wanted,
                                                     const std::filesystem::path& folder,
                                                     const Task& task = {});

}  // namespace relievo
