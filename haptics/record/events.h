// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "haptics/loop/haptic_core.h"
#include "haptics/loop/loop_meter.h"

namespace relievo {

/// What happened from one sample to the next, for the event column, on the samples' own clock:
/// lost samples, faults, pauses, forces on and off, softening, window, detail, stiffness, buttons.
/// Several are separated by "; "; no commas. Empty: nothing.
std::string eventBetween(const HapticSample& before, const HapticSample& now);

/// In events of a log: the hand is led from the first of these on until the second, which goes on
/// with why; the third is a corner at which the guide waits. What the guide sounds like depends on
/// them.
inline constexpr std::string_view kLedEvent = "the hand is led";
inline constexpr std::string_view kLetGoEvent = "the guide lets go";
inline constexpr std::string_view kCornerEvent = "the guide waits at a corner";

/// What the first sample of a log starts from.
std::string eventAtStart(const HapticSample& first);

/// How the loop ran, as lines for a log: rate, late ticks, wake-up and work times, what was
/// audited.
std::string loopLines(const LoopStats& stats);

/// The same as far as samples tell it: rate, late ticks, times from tick to tick and of work.
/// @param samples  in order; at least one
std::string sampleLines(std::span<const HapticSample> samples);

}  // namespace relievo
