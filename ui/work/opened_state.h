// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "ui/work/document.h"

namespace relievo {

/// The state that a file was read for, without its window.
/// @param present  goes on where the request says so @return the step's, or a new beginning's
/// @pre the job's outcome is a surface
DocumentState openedState(const LoadJob& job, const DocumentState& present);

/// Sets the window on the whole object, unless the request says otherwise and the map has it.
/// @return why the window that was asked for is none of this map's; empty: it was not refused
QString placeWindow(const LoadJob& job, DocumentState& next);

/// The view that a surface is seen from, also where it was found automatically. @pre a surface
std::optional<ViewChoice> shownView(const DocumentState& state);

double turnedBack(double azimuth_deg);  ///< Within half a turn to either side.
double tilted(double elevation_deg);    ///< At most as far as kMostTiltDeg.

}  // namespace relievo
