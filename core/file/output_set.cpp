// SPDX-License-Identifier: BSD-3-Clause
#include "core/file/output_set.h"

#include <fcntl.h>
#include <unistd.h>

#include <set>
#include <system_error>
#include <utility>

#include "core/file/owned_fd.h"

namespace relievo {

void OutputSet::removes(std::filesystem::path stale) {
  stale_.push_back(std::move(stale));
}

/// A full disk shows itself here at the latest, while everything is as it was.
void OutputSet::add(AtomicFile&& member) {
  member.bringToDisk();
  members_.push_back(std::move(member));
}

void OutputSet::takes(OutputSet& other) {
  for (AtomicFile& member : other.members_) members_.push_back(std::move(member));
  for (std::filesystem::path& file : other.stale_) stale_.push_back(std::move(file));
  other.members_.clear();
  other.stale_.clear();
}

void OutputSet::commit() {
  // All that can fail for lack of room comes before the first step that changes anything.
  for (AtomicFile& member : members_) member.giveNameBeside();
  std::set<std::filesystem::path> folders;
  for (AtomicFile& member : members_) {
    member.takePlace();
    folders.insert(member.folder());
  }
  members_.clear();
  std::error_code ignored;
  for (const std::filesystem::path& file : stale_) {
    if (std::filesystem::remove(file, ignored)) folders.insert(file.parent_path());
  }
  stale_.clear();
  for (const std::filesystem::path& folder : folders) bringNamesToDisk(folder);
}

void bringNamesToDisk(const std::filesystem::path& folder) {
  const OwnedFd names(
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (names.get() >= 0) ::fsync(names.get());
}

}  // namespace relievo
