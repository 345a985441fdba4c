// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <QString>

#include "core/project/project.h"

namespace relievo {

class Document;

/// What a file holds of a document's work: whether closing it would lose any. [GUI thread]
class SavedWork {
 public:
  explicit SavedWork(const Document& document) : document_(document) {}

  /// The project file that the state goes on from; empty: none.
  const QString& projectFile() const { return project_file_; }
  /// The state is in this project file now; empty: in none, but nothing of it is work.
  void noteSaved(const QString& project_file);
  /// The state is work, whatever it is: what a crash left.
  void noteUnsaved() { is_in_no_file_ = true; }
  /// Another file is being shown; nothing of it is work before noteSaved().
  void forget() { saved_.reset(); }
  /// Nothing is open any more.
  void clear();
  /// Places, measurements, camera paths or, in a project, settings that no file holds.
  bool hasUnsaved() const;

 private:
  const Document& document_;
  QString project_file_;
  std::optional<Project> saved_;  ///< What a file holds of the work; see workIn.
  bool is_in_no_file_ = false;    ///< See noteUnsaved().
};

}  // namespace relievo
