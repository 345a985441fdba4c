// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/project_files.h"

#include "core/base/error.h"

namespace relievo {
namespace {

FileState stateOf(const InputFile& file, const Task& task) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file.file, error)) return FileState::missing;
  // 0: not known.
  if (file.bytes != 0 && std::filesystem::file_size(file.file, error) != file.bytes) {
    return FileState::changed;
  }
  return sha256OfFile(file.file, task) == file.sha256 ? FileState::as_before : FileState::changed;
}

}  // namespace

std::vector<FileCheck> checkFiles(const Project& project, const Task& task) {
  const InputFile input{.file = project.file, .sha256 = project.sha256};
  std::vector<FileCheck> checks{{.file = input, .state = stateOf(input, task)}};
  for (const InputFile& file : project.recordings) {
    checks.push_back({.file = file, .state = stateOf(file, task)});
  }
  return checks;
}

std::optional<std::filesystem::path> foundByChecksum(const InputFile& wanted,
                                                     const std::filesystem::path& folder,
                                                     const Task& task) {
  namespace fs = std::filesystem;
  std::error_code error;
  const auto skip = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator it(folder, skip, error), end; it != end;
       it.increment(error)) {
    task.check();
    if (error) break;
    std::error_code unreadable;
    if (!it->is_regular_file(unreadable)) continue;
    if (wanted.bytes != 0 && it->file_size(unreadable) != wanted.bytes) continue;
    try {
      if (sha256OfFile(it->path(), task) == wanted.sha256) return it->path();
    } catch (const FileError&) {
      continue;  // Not readable: it cannot be the one that is opened next.
    }
  }
  return std::nullopt;
}

}  // namespace relievo
