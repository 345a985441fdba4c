// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "ui/control/foreign_files.h"
#include "ui/window/controller.h"

namespace relievo {

class PackageController;
struct PrepareStart;
class SaveController;

/// Opening: scans, several at once, projects and what else brings a state back, and what a crash
/// left. [GUI thread]
class OpenController : public Controller {
  Q_OBJECT
 public:
  OpenController(const ControllerParts& parts, SaveController& saving, ForeignFiles& foreign,
                 PackageController& packages);

  /// A file, or the address of a published map.
  void open(const OpenRequest& request);
  /// @param keeps_view  as OpenRequest, whatever the command says; of a state there is none to keep
  void open(const QString& file, bool keeps_view = false);
  /// Several scans of one object: the dialog Prepare joins them into the one that is opened.
  void openTogether(const QStringList& files);
  void openFolder(const QString& folder);
  /// What was dropped or named when the program started: a folder, a file, or several.
  void openPaths(const QStringList& paths, bool keeps_view = false);
  /// Brings a state back; `from` is the project or picture it came from. Files elsewhere are asked
  /// about before they are read.
  void restore(const Project& project, const QString& from);
  /// The scan that an old recording names, which says nothing else of a state.
  void openNamed(const Project& project, const QString& from);
  void choose();
  void offerLeftWork();
  /// What is opened next is no state, and holds nothing of what a crash left.
  void forgetState();
  void cancel();                                             ///< What is being opened.
  bool restoring() const { return restoring_.has_value(); }  ///< What is opened is a state.
  /// A file is open: what it begins, beside the state that the document has of it.
  /// @return it was a state with a figure whose look was chosen
  bool finish();

 Q_SIGNALS:
  void recordingChosen(const QString& file);  ///< It brings its state along.
  void begun();                               ///< Another file will be opened.
  void addressAsked(const QString& begun);    ///< Another address than this.

 private:
  void chooseFolder();
  void choosePrepare();
  /// @param then  with the file that was prepared
  void showPrepare(const PrepareStart& start, const std::function<void(const QString&)>& then);
  void relink(const Project& project, const QString& from);
  /// The state's map is on the web, and nothing of it is kept here.
  void offerAddress(const Project& project, const QString& from);
  /// As restore(), of a state in which the user chose the scan: all else is asked about as ever.
  void restoreOnChosen(const Project& project, const QString& from);
  void restoreNow(const Project& project, const QString& from);
  bool restoreFromFile(const QString& file);
  ForeignFiles::HostFile hostFileOf(const QString& from) const;
  void tellInputWithheld(const Project& project, const QString& host_file);
  void tellChanged(const Project& stored);
  void showDamaged(const QString& text);
  void showFailure(const QString& message, const QString& code, const QString& file);

  SaveController& saving_;
  ForeignFiles& foreign_;
  PackageController& packages_;
  std::optional<OpenRequest> restoring_;  ///< With a project, until its file is open.
  QString recovered_copy_;                ///< Of what a crash left, until it is open again.
};

}  // namespace relievo
