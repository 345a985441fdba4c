// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ui/window/controller.h"

namespace relievo {

class DetailView;
class TouchController;

/// The relief follows the turned view, if that is chosen: it is made anew from where the view
/// looks, and again for what the view was turned meanwhile, until the view is straight. What is
/// touched stays under the hand, and the force loop leads each surface over into the next, so that
/// a hand in contact feels the object turn. [GUI thread]
class TurnController : public Controller {
  Q_OBJECT
 public:
  TurnController(const ControllerParts& parts, DetailView& detail, const TouchController& touch);

 private:
  void follow();
  ViewMm about() const;

  DetailView& detail_;
  const TouchController& touch_;
};

}  // namespace relievo
