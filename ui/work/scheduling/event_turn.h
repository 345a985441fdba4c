// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCoreApplication>
#include <QTimer>

namespace relievo {

/// Answers what has happened but the user's input, and sleeps until something has or so many
/// milliseconds are over: for the few places that must wait for a worker. [GUI thread]
inline void waitForEvents(int most_ms) {
  QTimer wake;
  wake.setSingleShot(true);
  wake.start(most_ms);
  QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents |
                                  QEventLoop::WaitForMoreEvents);
}

}  // namespace relievo
