// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "core/project/project.h"

namespace relievo {

/// Keeps a copy of the work of one running program in a folder of its own. While the program lives
/// it holds a lock; a program that ended well takes its copy away; what is left without a lock is
/// what a crash left. [one thread]
class Autosave {
 public:
  /// @throw WriteError  the folder cannot be made or written
  explicit Autosave(const std::filesystem::path& folder);
  ~Autosave();  ///< Takes the copy away, unless it is left.
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// The copy stays when this goes, and is found as one that a crash left.
  void leave() { stays_ = true; }
  /// Replaces the copy. @throw WriteError  the old copy is as before
  void save(const Project& project) const;

 private:
  std::filesystem::path file_, lock_file_;
  int lock_ = -1;
  bool stays_ = false;
};

/// Copies that programs left that no longer run, newest first. Copies that cannot be read are
/// among them: opening one says why.
std::vector<std::filesystem::path> leftAutosaves(const std::filesystem::path& folder);

/// Takes a copy away, after it was restored or refused.
void removeAutosave(const std::filesystem::path& file);

/// Keeps a copy that cannot be read, of a newer program perhaps, under FILE.unreadable; it is not
/// found again.
void setAutosaveAside(const std::filesystem::path& file);

}  // namespace relievo
