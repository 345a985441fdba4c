// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class QAction;

namespace relievo {

struct Host;

/// The plugin's entries in the menus Touch and Record. Owned by the host.
struct TouchActions {
  QAction* forces = nullptr;      ///< "forces": on and off; F5, Ctrl+T.
  QAction* forces_off = nullptr;  ///< "forcesOff": off at once; the window runs it on Escape.
  QAction* take_back = nullptr;   ///< "takeForcesBack": opens a device that was lost; Shift+F5.
  QAction* stronger = nullptr;    ///< "stronger"
  QAction* weaker = nullptr;      ///< "weaker"
  QAction* strength_preset = nullptr;  ///< "strengthPreset": the next one, round again.
  QAction* grip_position = nullptr;    ///< "gripPosition": likewise.
  QAction* setup = nullptr;            ///< "deviceSetup": the assistant for the Falcon.
  QAction* use_mouse = nullptr;        ///< "useMouse": the mouse is the hand; leaves a homing, too.
  QAction* move_mode = nullptr;        ///< "moveMode": on, or confirm and leave; Ctrl+Shift+M.
  QAction* move_back = nullptr;        ///< "moveBack": out of Move mode, to the old window.
  QAction* where_am_i = nullptr;       ///< "whereAmI": Ctrl+I.
  QAction* where_am_i_long = nullptr;  ///< "whereAmILong": Ctrl+Alt+I.
  QAction* say_detail = nullptr;       ///< "sayDetail": detail, window and scale; Ctrl+Shift+I.
  QAction* guide = nullptr;            ///< "guide": along the outline, or off; Ctrl+Alt+G.
  QAction* guide_along = nullptr;      ///< "guideAlong": along a recorded way.
  QAction* training = nullptr;         ///< "touchIntroduction": on and off; Ctrl+Alt+U.
  QAction* next_shape = nullptr;       ///< "nextShape": of the introduction; Ctrl+Alt+N.
  QAction* rumble = nullptr;           ///< "rumble": of gamepads, on and off.
  QAction* sound = nullptr;            ///< "touchSounds": on and off; Ctrl+Alt+A.
  QAction* louder = nullptr;           ///< "soundsLouder": Ctrl+Alt+Page up.
  QAction* quieter = nullptr;          ///< "soundsQuieter": Ctrl+Alt+Page down.
  QAction* felt = nullptr;             ///< "feltPatterns": on and off.
  QAction* button_help = nullptr;      ///< "buttonHelp": what the device's buttons do now.
  QAction* record = nullptr;           ///< "record": start and stop; Ctrl+R.
  QAction* note = nullptr;             ///< "addNote": into the running recording; Ctrl+Shift+N.
};

TouchActions addTouchActions(Host& host);

}  // namespace relievo
