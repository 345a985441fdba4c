// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ui/views/pointer_bindings.h"
#include "ui/views/pointer_feel.h"
#include "ui/views/touch_readout.h"
#include "ui/window/controller.h"

namespace relievo {

class DetailView;

/// Look or touch: what the buttons of the mouse do in the detail view. [GUI thread]
class PointerController : public Controller {
  Q_OBJECT
 public:
  PointerController(const ControllerParts& parts, DetailView& detail);

  void showKeptMode();  ///< As preferences say.
  void showBindings();  ///< The same.
  /// Touches while forces are on, if the pointer carries the hand.
  void follow(const TouchReadout& readout);
  void touchWhileForcesAreOn(bool on);
  PointerBindings bindings() const;  ///< As preferences say.
  /// @return whether the mouse felt the surface until now
  bool stopFeeling();

 private:
  void feel(bool on);
  void choose(PointerMode mode);
  void show(PointerMode mode);

  DetailView& detail_;
  PointerFeel feel_;
  QString device_;  ///< That touches.
  bool forces_were_on_ = false;
  bool looks_after_forces_ = false;  ///< Touch was chosen by the forces, not by the person.
};

}  // namespace relievo
