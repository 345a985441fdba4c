// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/exhibit/exhibit.h"
#include "ui/window/controller.h"

namespace relievo {

/// Opens the dialog in which an exhibit is made; a new one begins with the object that is open, in
/// the window's language. [GUI thread]
class ExhibitSetupController : public Controller {
  Q_OBJECT
 public:
  explicit ExhibitSetupController(const ControllerParts& parts);

 private:
  void show();
  Exhibit begun() const;
};

}  // namespace relievo
