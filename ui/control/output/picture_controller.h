// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "ui/views/picture_file.h"
#include "ui/window/controller.h"
#include "ui/work/work_queue.h"

namespace relievo {

class DetailView;
class ForeignFiles;
class ReferenceView;

/// Pictures of the views and of the window, and figures for print. [GUI thread]
class PictureController : public Controller {
  Q_OBJECT
 public:
  PictureController(const ControllerParts& parts, DetailView& detail, ReferenceView& reference,
                    const ForeignFiles& foreign);

  /// PNG of a view or the window, exactly `pixels` large, drawn and written in the background; the
  /// strip says what went wrong.
  /// @param both_eyes  of the detail: each eye's picture as a file of its own, too
  void save(ImageSource source, const QSize& pixels, const QString& file, bool both_eyes = false);
  bool busy() const { return work_.busy(); }
  /// Another file is open. @param restored_look  for a state with a figure whose look was chosen
  void begin(bool restored_look);

 Q_SIGNALS:
  void ended(bool written);  ///< A picture is written, or was not; after what was said of it.

 private:
  void chooseImage();
  void chooseFigure();
  void noteFigure(const QString& file);
  PictureOrder order(ImageSource source, const QSize& pixels, const QString& file);

  DetailView& detail_;
  ReferenceView& reference_;
  const ForeignFiles& foreign_;
  /// How the view looked when the figure's look was chosen; nothing: not chosen yet.
  std::optional<ReliefLook> figure_view_;
  WorkQueue work_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
