// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "core/project/project.h"
#include "ui/window/controller.h"
#include "ui/work/latest_worker.h"

namespace relievo {

/// Files that a project from elsewhere names: asked about before they are read
/// (docs/adr/0136-outside-files.md). [GUI thread]
class ForeignFiles : public Controller {
  Q_OBJECT
 public:
  using Files = std::vector<std::filesystem::path>;
  /// Gets the files that are not to be read.
  using Withhold = std::function<void(const Files& files)>;
  /// What names the files.
  struct HostFile {
    QString file;
    bool is_autosaved = false;  ///< Not a file of the user's: what a crash left.
  };

  explicit ForeignFiles(const ControllerParts& parts);

  /// Calls `then`, at once if all that the project names is in the folder of `host file`; else
  /// after its checksums were compared, and after somebody was asked where they differ.
  void whenTheyMayBeRead(const Project& project, const HostFile& host_file, const Withhold& then);
  /// Files that the open project names and that nobody wanted read.
  const Files& withheld() const { return withheld_; }
  void withhold(Files files) { withheld_ = std::move(files); }
  bool isWithheld(const std::string& file) const;
  bool cancel();  ///< @return false: there was nothing to do

 private:
  void ask(const Files& files, const HostFile& host_file, const Withhold& then);

  Files withheld_;
  LatestWorker worker_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
