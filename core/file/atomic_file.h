// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/error.h"

namespace relievo {

class OutputSet;  // core/file/output_set.h

/// "Cannot write FILE: <reason>." with what to look at.
struct CannotWrite : WriteError {
  CannotWrite(const std::filesystem::path& file, const std::string& why);
  std::string reason;  ///< For whoever says it in a sentence of his own.
};
/// @throw CannotWrite
[[noreturn]] void cannotWrite(const std::filesystem::path& file, const std::string& reason);

/// Removes temporary files of ours whose writer was killed: known by their name, by the number of a
/// process that is no more, and by nobody's holding their lock. Anything else stays. [any thread]
void removeLeftFiles(const std::filesystem::path& folder);

/// Where a writer puts a file: a path alone, or a path as a member of a set whose files all take
/// their places together.
struct OutputFile {
  // A path alone, however it is written, is a place, too.
  OutputFile(std::filesystem::path file) : path(std::move(file)) {}  // NOLINT(*-explicit-*)
  OutputFile(const std::string& file) : path(file) {}                // NOLINT(*-explicit-*)
  OutputFile(const char* file) : path(file) {}                       // NOLINT(*-explicit-*)
  OutputFile(std::filesystem::path file, OutputSet* of) : path(std::move(file)), set(of) {}

  std::filesystem::path path;
  OutputSet* set = nullptr;  ///< Null: the file takes its place by itself.
};

/// What a file is called while it is written.
enum class TemporaryName {
  /// Nothing, where the file system knows such files: it vanishes with the process, however that
  /// ends. `AtomicFile::path` leads to it through /proc.
  none,
  /// A hidden name beside its place, for libraries that write other files beside the one they are
  /// given or replace it themselves.
  beside,
};

/// Files in the folder of one that is written that somebody who was killed may have left.
enum class LeftFiles {
  go,
  /// Several computers write there, and one does not know whether another's writer lives.
  stay,
};

/// A file that is written beside its place and takes it at the end; it vanishes unless `commit` was
/// called. So a failure leaves nothing half done, and what was there before: with its mode and its
/// owner, and where the place is a symbolic link, behind it. What a killed process left in the
/// folder goes when the next one begins to write there.
class AtomicFile {
 public:
  /// @throw WriteError  what is there must not be replaced
  explicit AtomicFile(const OutputFile& file, TemporaryName name = TemporaryName::none,
                      LeftFiles left = LeftFiles::go);
  ~AtomicFile();
  AtomicFile(AtomicFile&&) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;

  /// What the writer opens. No other process finds the file by it.
  const std::filesystem::path& path() const noexcept;
  /// For writers without a library of their own: what follows what was written so far.
  /// @throw CannotWrite
  void write(std::string_view bytes);
  /// What was written is on the disk, under its final name, when this returns; as a member of a set
  /// it is on the disk and waits for the others. The writer has closed it before.
  /// @throw WriteError
  void commit();

 private:
  friend class OutputSet;
  struct Impl;
  void bringToDisk();
  void giveNameBeside();
  void takePlace();
  std::filesystem::path folder() const;

  std::unique_ptr<Impl> impl_;
};

/// The same end for a file that was written under a name of its own, which it loses. Nothing but
/// the disk is asked if it is in its place already. [any thread] @throw CannotWrite
void putInPlace(const std::filesystem::path& written, const std::filesystem::path& place);

}  // namespace relievo
