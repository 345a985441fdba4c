// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ui/panels/measure_panel.h"
#include "ui/window/controller.h"

namespace relievo {

class DetailView;
class ProfileStrip;
class ReferenceView;

/// Measuring in the detail view, and the curve of a profile under the views. [GUI thread]
class MeasureController : public Controller {
  Q_OBJECT
 public:
  MeasureController(const ControllerParts& parts, MeasurePanel& panel, ProfileStrip& profile,
                    DetailView& detail, ReferenceView& reference);

 Q_SIGNALS:
  void profileChanged();  ///< There is another curve, or none.

 private:
  void makeCommands();
  void begin(MeasureKind kind);
  void show();
  void save();
  void showProfile();
  void showProfileMark();    ///< In both views, where the curve has its cursor.
  void showProfileCursor();  ///< And carries the hand there.
  void saveProfile();

  MeasurePanel& panel_;
  ProfileStrip& profile_;
  DetailView& detail_;
  ReferenceView& reference_;
};

}  // namespace relievo
