// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "core/project/project.h"
#include "ui/window/controller.h"
#include "ui/work/work_queue.h"

namespace relievo {

class ForeignFiles;
struct PackageChoice;

/// Which files a recording needs to be repeated, beside its scan. [worker] @param scans  also other
/// scans that were touched
using DependenciesOf = std::function<std::vector<InputFile>(const std::filesystem::path& recording,
                                                            bool scans, const Task& task)>;

/// Packages for citation: packing, and unpacking one that is opened. [GUI thread]
class PackageController : public Controller {
  Q_OBJECT
 public:
  PackageController(const ControllerParts& parts, const ForeignFiles& foreign);

  /// Who knows what recordings need; without one packages hold the recordings alone.
  void setDependencies(DependenciesOf dependencies);
  /// Writes and checks a package in the background.
  void write(const PackageChoice& choice);
  bool busy() const { return work_.busy(); }
  /// Unpacks, if the file is a zip. @param into  empty: the folder that it lies in
  bool unpack(const QString& file, const QString& into = {});
  void cancelUnpacking() { unpack_work_.cancel(); }

 Q_SIGNALS:
  void ended(bool written);  ///< A package is written, or was not; after what was said of it.
  void unpacked(const QString& project);

 private:
  void choose();
  void chooseFolder(const QString& package);

  const ForeignFiles& foreign_;
  DependenciesOf dependencies_;
  WorkQueue work_, unpack_work_;  ///< Last: their jobs end before anything else goes.
};

}  // namespace relievo
