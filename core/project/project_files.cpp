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

FileCheck checkFile(const InputFile& file, const Task& task) {
  return {.file = file, .state = stateOf(file, task)};
}

std::vector<FileCheck> checkFiles(const Project& project, const Task& task) {
  std::vector<FileCheck> checks{checkFile({.file = project.file, .sha256 = project.sha256}, task)};
  for (const InputFile& file : project.recordings) checks.push_back(checkFile(file, task));
  return checks;
}

std::filesystem::path foundInput(const std::filesystem::path& carrier,
                                 const std::filesystem::path& stored) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::absolute(carrier, error).parent_path();
  for (const std::filesystem::path& candidate :
       {stored, folder / stored.filename(), stored.filename(),
        (folder / "../input" / stored.filename()).lexically_normal()}) {
    if (std::filesystem::is_regular_file(candidate, error)) return candidate;
  }
  throw FileError(carrier.filename().string() + " was made from '" + stored.filename().string() +
                      "', which is not there (E501). Nothing was made. Give its place as FILE.",
                  "E501");
}

std::filesystem::path foundInput(const std::filesystem::path& carrier,
                                 const std::filesystem::path& stored, const std::string& sha256,
                                 const Task& task) {
  std::filesystem::path first = foundInput(carrier, stored);
  const auto is_it = [&](const std::filesystem::path& file) {
    return sha256.empty() || sha256OfFile(file, task) == sha256;
  };
  if (is_it(first)) return first;
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::absolute(carrier, error).parent_path();
  if (std::filesystem::path beside = folder / stored.filename();
      std::filesystem::is_regular_file(beside, error) && is_it(beside)) {
    return beside;
  }
  for (int i = 2;; ++i) {
    std::filesystem::path numbered =
        folder / (std::to_string(i) + "-" + stored.filename().string());
    if (!std::filesystem::is_regular_file(numbered, error)) return first;
    if (is_it(numbered)) return numbered;
  }
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
