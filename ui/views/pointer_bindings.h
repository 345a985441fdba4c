// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <QString>

namespace relievo {

/// What the left button in the detail view is for.
enum class PointerMode {
  look,   ///< It turns the view, as in other programs that show scans.
  touch,  ///< It presses the hand in.
};

/// What dragging with a button does.
enum class PointerAct { turn, move, zoom, none };
inline constexpr std::array<PointerAct, 4> kPointerActs{PointerAct::turn, PointerAct::move,
                                                        PointerAct::zoom, PointerAct::none};

/// What the buttons and the wheel do in the detail view. How somebody works, not part of a
/// document: kept with the preferences.
struct PointerBindings {
  PointerAct look_left = PointerAct::turn;
  PointerAct look_middle = PointerAct::turn;
  PointerAct look_right = PointerAct::move;
  PointerAct touch_middle = PointerAct::turn;  ///< The left button presses the hand in.
  PointerAct touch_right = PointerAct::move;
  bool forward_is_closer = true;  ///< Turning the wheel away from oneself zooms in.
};

/// "turn": as preferences keep it.
QString keptName(PointerAct act);
PointerAct pointerAct(const QString& kept, PointerAct otherwise);

/// "turn the view", of no button; "nothing".
QString actText(PointerAct act);
/// A sentence for the status bar: "Left turns, right moves, wheel zooms".
QString bindingsText(PointerMode mode, const PointerBindings& bindings);

}  // namespace relievo
