// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

#include "core/replay/touch_recording.h"

namespace relievo {

/// What happened, in the window's language; the words of a recording are English. What is not known
/// stays as it is.
QString eventText(const TouchEvent& event);

}  // namespace relievo
