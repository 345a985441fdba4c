// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/session/surface.h"

namespace relievo {

/// The window on a surface that shows the same of the object as a window on another surface of it,
/// which was made from another side: the same side length, and the place about which the object was
/// turned at the same place of the window, so that it stays under the hand. The whole object stays
/// the whole; so does a window that has become larger than the map, and one that would show nothing
/// of it is moved on to it.
/// @param about  a place of the object, in view mm of `from`
/// @return its level is that of `to` whose spacing is nearest to the one of before
Region turnedRegion(const Surface& from, const Region& region, const ViewMm& about,
                    const Surface& to);

}  // namespace relievo
