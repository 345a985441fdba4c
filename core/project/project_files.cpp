// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/project_files.h"

#include <algorithm>
#include <utility>

#include "core/base/failure.h"
#include "core/project/embedded_state.h"
#include "core/tiles/published/published_tiles.h"

namespace relievo {
namespace {

FileState stateOf(const InputFile& file, const Task& task) {
  std::error_code error;
  // Of an address what was opened before is looked at: nobody is asked.
  std::filesystem::path there = file.file;
  if (isWebAddress(file.file)) there = keptMap(file.file).value_or(std::filesystem::path());
  if (!std::filesystem::is_regular_file(there, error)) return FileState::missing;
  // 0: not known.
  if (file.bytes != 0 && std::filesystem::file_size(there, error) != file.bytes) {
    return FileState::changed;
  }
  return sha256OfFile(there, task) == file.sha256 ? FileState::as_before : FileState::changed;
}

/// Does the file carry a state of the project's very input, as what relievo made of it does?
bool showsInputOf(const Project& project, const std::filesystem::path& file) {
  std::error_code unknown;
  if (project.sha256.empty() || !std::filesystem::is_regular_file(file, unknown)) return false;
  try {
    const std::optional<Project> shown = embeddedProject(file);
    return shown && shown->sha256 == project.sha256;
  } catch (const FileError&) {
    return false;
  }
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

std::filesystem::path foundInput(const std::filesystem::path& host_file,
                                 const std::filesystem::path& stored) {
  std::error_code error;
  // Who wrote the host file does not decide which server is asked: people open addresses
  // themselves.
  if (isWebAddress(stored.string())) {
    if (const auto kept = keptMap(stored.string())) return *kept;
    throw failure<MessageId::input_is_not_there>(host_file.filename(), stored);
  }
  const std::filesystem::path folder = std::filesystem::absolute(host_file, error).parent_path();
  for (const std::filesystem::path& candidate :
       {stored, folder / stored.filename(), stored.filename(),
        (folder / "../input" / stored.filename()).lexically_normal()}) {
    if (std::filesystem::is_regular_file(candidate, error)) return candidate;
  }
  throw failure<MessageId::input_is_not_there>(host_file.filename(), stored.filename());
}

std::filesystem::path foundInput(const std::filesystem::path& host_file,
                                 const std::filesystem::path& stored, const std::string& sha256,
                                 const Task& task) {
  std::filesystem::path first = foundInput(host_file, stored);
  const auto is_it = [&](const std::filesystem::path& file) {
    return sha256.empty() || sha256OfFile(file, task) == sha256;
  };
  if (is_it(first)) return first;
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::absolute(host_file, error).parent_path();
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

bool isInFolderOf(const std::filesystem::path& host_file, const std::filesystem::path& file) {
  std::error_code unknown;
  const auto real = std::filesystem::weakly_canonical(file, unknown);
  if (unknown) return false;
  const auto home = std::filesystem::canonical(
      std::filesystem::absolute(host_file, unknown).parent_path(), unknown);
  if (unknown) return false;
  const auto [rest, at] = std::mismatch(home.begin(), home.end(), real.begin(), real.end());
  return rest == home.end() && at != real.end();
}

bool mayBeRead(const std::filesystem::path& host_file, const InputFile& named, const Task& task) {
  if (isInFolderOf(host_file, named.file)) return true;
  std::error_code unknown;
  if (!std::filesystem::exists(named.file, unknown)) return true;  // Nothing is read.
  // Of a device, or a file without a size as in /proc, not even a checksum is made.
  if (!std::filesystem::is_regular_file(named.file, unknown) || named.sha256.empty()) return false;
  if (const auto bytes = std::filesystem::file_size(named.file, unknown);
      unknown || bytes == 0 || (named.bytes != 0 && named.bytes != bytes)) {
    return false;
  }
  try {
    return sha256OfFile(named.file, task) == named.sha256;
  } catch (const FileError&) {
    return false;
  }
}

std::vector<std::filesystem::path> foreignFiles(const std::filesystem::path& host_file,
                                                const Project& project, const Task& task) {
  std::vector<std::filesystem::path> foreign;
  const auto add = [&](const std::string& file) {
    if (std::find(foreign.begin(), foreign.end(), file) == foreign.end())
      foreign.emplace_back(file);
  };
  if (!mayBeRead(host_file,
                 {.file = project.file, .sha256 = project.sha256, .bytes = project.bytes}, task)) {
    add(project.file);
  }
  std::vector<std::string> without_checksum = project.figures;
  const std::string& plotted = project.figure.recording;
  if (!plotted.empty()) without_checksum.push_back(plotted);
  for (const InputFile& recording : project.recordings) {
    if (!mayBeRead(host_file, recording, task)) add(recording.file);
    std::erase(without_checksum, recording.file);
  }
  for (const std::string& file : without_checksum) {
    task.check();
    if (!mayBeRead(host_file, {.file = file, .sha256 = {}}, task) && !showsInputOf(project, file))
      add(file);
  }
  return foreign;
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
