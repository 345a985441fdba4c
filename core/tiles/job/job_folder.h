// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/file/owned_fd.h"

namespace relievo {

class Exchange;

/// What makes a piece of work the same: names for people ("an option"), and what each is.
using JobFacts = std::vector<std::pair<std::string, std::string>>;

/// A folder in which finished parts of long work lie, one file each, so that the work goes on where
/// it was stopped. A part is there whole or not at all: it is written beside its place, brought to
/// the disk and renamed. It ends in a checksum of its content, its name and the facts of the work,
/// so that what was damaged or belongs elsewhere is found and made anew. One process at a time has
/// the folder, or several that make the work together. [one thread, but for `load`, `keep` and
/// `readPart`]
class JobFolder {
 public:
  /// Makes the folder, or takes over what is in it.
  /// @param processes  that make the work together; null: this one alone
  /// @throw ArgumentError  it holds other work or other files, or another process has it, or the
  ///                       processes do not do the same; WriteError, OtherProcessStopped
  JobFolder(std::filesystem::path folder, const JobFacts& facts, Exchange* processes = nullptr);
  JobFolder(const JobFolder&) = delete;
  JobFolder& operator=(const JobFolder&) = delete;

  /// A part's content; nothing: it is not there, or not whole (then it is counted). [any thread]
  std::optional<std::string> load(const std::string& part);
  /// Its bytes one after the other. [any thread] @throw WriteError
  void keep(const std::string& part, std::initializer_list<std::string_view> content);
  std::filesystem::path fileOf(const std::string& part) const { return folder_ / part; }

  /// Nothing was in it.
  bool isNew() const noexcept { return is_new_; }
  int damaged() const noexcept { return damaged_; }  ///< Found by this process.

  /// Removes these parts of this and earlier processes: a folder's name.
  void remove(const std::string& parts);
  /// The work is done: all of it goes, and the folder, if nothing else is in it.
  void finish();

 private:
  std::string sumOf(std::string_view part, std::initializer_list<std::string_view> content) const;
  void begin(const JobFacts& facts);
  void join(const JobFacts& facts, const Exchange& processes);
  void takeLock();
  /// What of the facts is another than in the folder; empty: nothing.
  std::string differing(const JobFacts& facts) const;

  std::filesystem::path folder_;
  std::string sum_;  ///< Of the facts.
  OwnedFd lock_;
  bool is_new_ = false;  ///< As the first process found it.
  std::atomic<int> damaged_ = 0;
};

/// Bytes of a part that was loaded or kept. [any thread] @throw WriteError  the disk failed
void readPart(const std::filesystem::path& file, std::uint64_t at, std::span<std::byte> bytes);

}  // namespace relievo
