// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "core/file/atomic_file.h"

namespace relievo {

/// Several files that belong together: every one is written beside its place and is on the disk
/// before the first takes its place. Then all take their places, one after the other in the order
/// in which they were committed, the main file last. A process that is killed between two of these
/// steps leaves files of two sets; that is why the members carry what they are made of, and whoever
/// reads several compares it (docs/adr/0131). [one thread at a time]
class OutputSet {
 public:
  OutputSet() = default;
  OutputSet(const OutputSet&) = delete;
  OutputSet& operator=(const OutputSet&) = delete;

  /// A place for a writer; what it commits becomes a member.
  OutputFile file(std::filesystem::path path) { return {std::move(path), this}; }

  /// A file that has no part in the set and would be taken for one goes after all are in place.
  void removes(std::filesystem::path stale);

  /// The members of another set come before those that follow here.
  void takes(OutputSet& other);

  /// Are there members that wait?
  bool empty() const noexcept { return members_.empty(); }

  /// All members are in their places, on the disk, when this returns. @throw WriteError
  void commit();

 private:
  friend class AtomicFile;
  void add(AtomicFile&& member);

  std::vector<AtomicFile> members_;
  std::vector<std::filesystem::path> stale_;
};

/// The names in a folder are on its disk when this returns. Some network file systems have no such
/// call for folders. [any thread]
void bringNamesToDisk(const std::filesystem::path& folder);

}  // namespace relievo
