// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "ui/window/controller.h"
#include "ui/work/work_queue.h"

namespace relievo {

class DetailView;
struct MapExport;
class MeasurePanel;
struct OtherExport;
class PictureController;
class ReferenceView;

/// Maps, meshes, pictures, profiles and sections for other programs. [GUI thread]
class ExportController : public Controller {
  Q_OBJECT
 public:
  struct Sources {
    const DetailView& detail;
    const ReferenceView& reference;
    MeasurePanel& measure;
    PictureController& pictures;
  };
  ExportController(const ControllerParts& parts, const Sources& sources);

  /// Writes a part of the map in the background; the strip says what went wrong or had to be left
  /// out.
  void write(const MapExport& choice, const QString& file);
  bool busy() const { return work_.busy(); }

 Q_SIGNALS:
  void ended(bool written);  ///< A map is written as it was, or was not; after what was said of it.

 private:
  void choose();
  /// Pictures of the views, profiles and sections.
  std::vector<OtherExport> otherExports();

  Sources sources_;
  WorkQueue work_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
