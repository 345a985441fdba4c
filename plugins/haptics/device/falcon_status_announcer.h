// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <QString>
#include <QStringList>

#include "haptics/device/falcon/link/link_status.h"

namespace relievo {

/// Code and sentence, for the screen.
QString screenText(const Message& message);

/// The same of a Falcon in the window, with the command that helps.
QString windowText(const falcon::LinkStatus& status);

/// What is to be said of a Falcon, in words for speech: each state once as long as it lasts, and
/// each arm that has found its place.
class FalconStatusAnnouncer {
 public:
  /// New since the last call, oldest first.
  QStringList take(const falcon::LinkStatus& status);

 private:
  QString said_;
  std::uint8_t homed_said_ = 0;
};

}  // namespace relievo
