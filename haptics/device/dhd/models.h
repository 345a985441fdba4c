// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "haptics/rt/realtime.h"

namespace relievo::dhd {

/// A place or a force. The library's x points towards the person, y to the right, z up; relievo's x
/// to the right, y up, z towards the person.
using Three = std::array<double, 3>;

/// One type that is driven, with limits below those that others drive it with: half of CHAI3D's
/// stiffness, at most 6 N, a box inside its reach. No data sheet is public (docs/adr/0180).
struct Model {
  int type = 0;  ///< As the library numbers them.
  double max_force_n = 0, max_stiffness_n_per_mm = 0;
  Three half_extent_mm{};  ///< In relievo's axes.
};
/// Null: not a type that is driven. [any thread]
const Model* modelOf(int type) noexcept;

/// Why a type is not, in English, for a message of the plug-in.
const char* whyNot(int type) noexcept;

/// Metres of the library as relievo's millimetres.
Three placeMm(const Three& place_m) RELIEVO_REALTIME;
/// Some arms reach farther than twice the box that is used, and a place there would count as
/// nonsense: it is shown at the end of what is believed, far beyond the cushion at the box's edge.
/// What no arm reaches stays as it is.
Three withinSight(const Three& place_mm, const Three& half_extent_mm) RELIEVO_REALTIME;
/// A force in relievo's axes in the library's.
Three forceForLibrary(const Three& force_n) RELIEVO_REALTIME;

/// The library's buttons as relievo's: the first, which every grip has, is Centre; then Plus,
/// Minus, Forward.
std::uint32_t buttonsOf(unsigned int mask) RELIEVO_REALTIME;

}  // namespace relievo::dhd
