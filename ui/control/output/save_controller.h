// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "ui/window/controller.h"
#include "ui/work/autosave_controller.h"

namespace relievo {

class ExportController;
class PackageController;
class PictureController;
class TilesController;
class VideoController;

/// Saving the work, what would be lost if the window closed or showed another scan, and how it
/// closes. [GUI thread]
class SaveController : public Controller {
  Q_OBJECT
 public:
  explicit SaveController(const ControllerParts& parts);

  /// What writes files in the background: the window closes after it.
  struct Writers {
    const PictureController& pictures;
    const PackageController& packages;
    const ExportController& exports;
    const TilesController& tiles;
    VideoController& videos;
  };
  void watch(const Writers& writers);

  void save(const QString& file);
  /// Calls `then`, at once if nothing is unsaved; else after Save and Discard.
  void whenNothingIsUnsaved(const std::function<void()>& then);
  /// Which project or scan, and whether a file holds all of the work.
  void showTitle();
  AutosaveController& autosave() { return autosave_; }

  /// Nobody waits for the end any more; the next close asks again what it has to ask.
  void stayOpen() { closes_when_saved_ = closes_anyway_ = false; }
  bool closesWhenSaved() const { return closes_when_saved_; }
  /// Asks what has to be asked. @return false: the window closes by itself later, or stays
  bool mayClose();
  /// With the language that was chosen; asks first, as closing does.
  void restartWhenNothingIsUnsaved();
  /// See MainWindow::endAtOnce.
  void endAtOnce();

 Q_SIGNALS:
  void saved(const QString& file);

 private:
  void saveNow();
  void restart();
  /// @param then  once it is saved
  void saveAs(const std::function<void()>& then = {});
  void keepWork();
  Project autosavedProject() const;  ///< For an automatic copy.
  bool writing() const;              ///< Pictures, packages, exports and videos.
  /// The window has to wait for what is being written, and closes by itself after it.
  bool closesWhenAllIsWritten();
  /// A file is written, or was not: then nobody closes before the sentence was read.
  void closeIfAwaited(bool written);

  std::optional<Writers> writers_;
  bool closes_anyway_ = false;
  bool closes_when_saved_ = false;
  bool ends_at_once_ = false;
  bool title_due_ = false;
  AutosaveController autosave_;
};

}  // namespace relievo
