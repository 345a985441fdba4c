// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/project/project.h"
#include "ui/window/controller.h"

namespace relievo {

class LookController;
class PlacesPanel;
class ReferenceView;
class ReplayControl;
class SidePanels;
class SuggestPanel;
class TouchController;

/// Where one goes on the map: named places, markers, views as text, and suggested windows.
/// [GUI thread]
class PlaceController : public Controller {
  Q_OBJECT
 public:
  struct Panels {
    SidePanels& all;
    PlacesPanel& places;
    SuggestPanel& suggestions;
  };
  PlaceController(const ControllerParts& parts, const Panels& panels, ReferenceView& reference,
                  LookController& look, const TouchController& touch);

 Q_SIGNALS:
  void wentToMarker(double x_mm, double y_mm);  ///< View mm.

 private:
  void makeCommands();
  void connectSuggestions(ReferenceView& reference);
  void name();
  void toggleMarker();
  void goToPoint(const NamedRegion& marker);
  void goTo(const NamedRegion& place);
  void copyView();
  void pasteView();

  Panels panels_;
  LookController& look_;
  const TouchController& touch_;
};

}  // namespace relievo
