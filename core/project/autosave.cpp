// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/autosave.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "core/base/failure.h"
#include "core/file/output_set.h"

namespace relievo {
namespace {

constexpr std::string_view kStem = "autosave-";
constexpr const char* kLockEnd = ".lock";
constexpr const char* kCopyEnd = ".json";

/// The lock of a copy that nobody holds; -1 if somebody does.
int takenLock(const std::filesystem::path& lock_file) {
  const int descriptor = ::open(lock_file.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return -1;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

}  // namespace

Autosave::Autosave(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  std::string name = (folder / (std::string(kStem) + "XXXXXX" + kLockEnd)).string();
  lock_ = ::mkostemps(name.data(), static_cast<int>(std::strlen(kLockEnd)), O_CLOEXEC);
  if (lock_ < 0 || ::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    const std::string reason = std::strerror(errno);
    if (lock_ >= 0) ::close(lock_);
    throw failure<MessageId::copies_not_written>(folder, reason);
  }
  lock_file_ = name;
  file_ = lock_file_;
  file_.replace_extension(kCopyEnd);
}

Autosave::~Autosave() {
  if (!stays_) {
    ::unlink(file_.c_str());
    ::unlink(lock_file_.c_str());
  }
  ::close(lock_);
}

void Autosave::save(const Project& project) const {
  writeProject(file_, project);
}

std::vector<std::filesystem::path> leftAutosaves(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::vector<fs::path> left;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    fs::path file = it->path();
    if (file.extension() != kLockEnd || !file.filename().string().starts_with(kStem)) continue;
    const int lock = takenLock(file);
    if (lock < 0) continue;
    file.replace_extension(kCopyEnd);
    std::error_code missing;
    if (fs::exists(file, missing)) {
      left.push_back(file);
    } else {
      ::unlink(it->path().c_str());  // Ended before its first copy.
    }
    ::close(lock);
  }
  std::sort(left.begin(), left.end(), [](const fs::path& a, const fs::path& b) {
    std::error_code gone;
    return fs::last_write_time(a, gone) > fs::last_write_time(b, gone);
  });
  return left;
}

void removeAutosave(const std::filesystem::path& file) {
  std::filesystem::path lock_file = file;
  lock_file.replace_extension(kLockEnd);
  ::unlink(file.c_str());
  ::unlink(lock_file.c_str());
}

void setAutosaveAside(const std::filesystem::path& file) {
  std::filesystem::path aside = file;
  aside += ".unreadable";
  std::error_code error;
  std::filesystem::rename(file, aside, error);
  if (error) return;
  bringNamesToDisk(aside.parent_path());  // Before the lock goes, which leads to it.
  removeAutosave(file);
}

}  // namespace relievo
