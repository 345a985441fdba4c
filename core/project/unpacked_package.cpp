// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/unpacked_package.h"

#include <string>
#include <system_error>

#include "core/base/failure.h"
#include "core/io/formats/text_file.h"
#include "core/project/package.h"
#include "core/project/project_files.h"
#include "core/provenance/name_text.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProjectName = "project.json";
constexpr int kMostFolders = 1000;

/// A hidden folder that goes unless it was given a name.
class NewFolder {
 public:
  explicit NewFolder(const fs::path& parent) {
    std::error_code refused;
    for (int n = 0; n < kMostFolders && path_.empty(); ++n) {
      const fs::path name = parent / (".relievo-package-" + std::to_string(n));
      if (fs::create_directory(name, refused)) path_ = name;
    }
    if (path_.empty()) {
      throw failure<MessageId::package_not_unpacked>(escapedName(parent.string()));
    }
  }
  ~NewFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  const fs::path& path() const { return path_; }
  /// @return false: there is such a file or a folder that is not empty
  bool becomes(const fs::path& name) {
    std::error_code taken;
    fs::rename(path_, name, taken);
    if (taken) return false;
    path_.clear();
    return true;
  }

 private:
  fs::path path_;
};

bool holdsTheSame(const fs::path& there, const fs::path& fresh, const Task& task) {
  std::error_code unknown;
  if (!fs::is_regular_file(there / kProjectName, unknown)) return false;
  try {
    constexpr std::size_t kMostBytes = 64U << 20U;
    const std::string project = readTextFile(fresh / kProjectName, kMostBytes);
    if (readTextFile(there / kProjectName, kMostBytes) != project) return false;
    for (const FileCheck& check : checkFiles(readProject(there / kProjectName), task)) {
      // What the package left out is missing in both.
      if (check.state == FileState::as_before) continue;
      const fs::path inside = fs::path(check.file.file).lexically_relative(there);
      if (check.state == FileState::changed || fs::exists(fresh / inside, unknown)) return false;
    }
    return true;
  } catch (const FileError&) {
    return false;
  }
}

}  // namespace

fs::path unpackedPackage(const fs::path& package, const fs::path& parent, const Task& task) {
  NewFolder fresh(parent);
  unpackPackage(package, fresh.path(), task);
  const std::string stem = package.stem().string();
  for (int n = 1; n <= kMostFolders; ++n) {
    const fs::path folder = parent / (n == 1 ? stem : stem + "-" + std::to_string(n));
    if (holdsTheSame(folder, fresh.path(), task)) return folder;
    if (fresh.becomes(folder)) return folder;
  }
  throw failure<MessageId::package_not_unpacked>(escapedName(stem));
}

}  // namespace relievo
