// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ui/window/controller.h"

namespace relievo {

class OpenController;

/// Maps on the web: asks for an address, and says what comes of the open map and what does not.
/// [GUI thread]
class WebController : public Controller {
  Q_OBJECT
 public:
  WebController(const ControllerParts& parts, OpenController& opening);

  /// Asks for an address. @param begun  stands in the line at first
  void choose(const QString& begun = {});

 private:
  void tell(const Message& message);

  OpenController& opening_;
  QString lost_;  ///< The sentence that stands above the views while the server gives no answer.
};

}  // namespace relievo
