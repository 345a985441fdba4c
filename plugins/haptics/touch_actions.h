// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class QAction;

namespace relievo {

class Host;

/// The plugin's entries in the menus Touch and Record. Owned by the host.
struct TouchActions {
  QAction* forces = nullptr;      ///< "forces": on and off; F5, Ctrl+T.
  QAction* forces_off = nullptr;  ///< "forcesOff": off at once; the window runs it on Escape.
  QAction* stronger = nullptr;    ///< "stronger"
  QAction* weaker = nullptr;      ///< "weaker"
  QAction* setup = nullptr;       ///< "deviceSetup": the assistant for the Falcon.
  QAction* record = nullptr;      ///< "record": start and stop; Ctrl+R.
};

TouchActions addTouchActions(Host& host);

}  // namespace relievo
