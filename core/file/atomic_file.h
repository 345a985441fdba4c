// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "core/file/owned_fd.h"

namespace relievo {

/// "Cannot write FILE: <reason>." with what to look at. @throw WriteError
[[noreturn]] void cannotWrite(const std::filesystem::path& file, const std::string& reason);

/// Removes temporary files of ours whose writer was killed: known by their name, by the number of a
/// process that is no more, and by nobody's holding their lock. Anything else stays. [any thread]
void removeLeftFiles(const std::filesystem::path& folder);

/// A file under a temporary name beside its final one; removed unless `keep` was called. So a
/// failure leaves nothing half done, and what was there before: with its mode and its owner, and
/// where the final name is a symbolic link, behind it. What a killed process left in the folder
/// goes when the next one begins to write there.
class AtomicFile {
 public:
  /// @throw WriteError  what is there must not be replaced
  explicit AtomicFile(const std::filesystem::path& final_name);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::filesystem::path& path() const noexcept { return temporary_; }
  /// What was written is on the disk, under its final name, when this returns. The writer has
  /// closed it before. @throw WriteError
  void keep();

 private:
  std::filesystem::path final_, temporary_;
  OwnedFd lock_;  ///< Of the temporary file, while it is written.
  bool kept_ = false;
};

}  // namespace relievo
