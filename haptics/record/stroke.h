// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "core/base/task.h"
#include "core/base/vec3.h"
#include "haptics/loop/haptic_core.h"

namespace relievo {

/// Where the hand is at a time; in view mm or hand mm, as StrokeOptions::frame says.
struct StrokePoint {
  double t_s = 0;
  double x_mm = 0, y_mm = 0, z_mm = 0;
};

/// A movement of the hand, linear between its points.
struct Stroke {
  std::vector<StrokePoint> points;  ///< At least one; finite; times increase.
};

/// Reads a CSV with the header t_s,x_mm,y_mm,z_mm. Lines that are empty or start with # are passed
/// over.
/// @throw FileError  unreadable, another header, no rows; a value that is no finite number, or a
///                   time that does not increase: the message names the row
Stroke readStroke(const std::filesystem::path& file);

enum class StrokeFrame : std::uint8_t { view, device };

/// `relievo touch` (conventions.md 5.4b): no device is attached, so that every limit is off unless
/// asked for.
struct StrokeOptions {
  ProxyOptions proxy;
  double stiffness_n_per_mm = 0.5;   ///< N per mm of hand, > 0.
  double damping_n_s_per_mm = 0;     ///< Of the surface, >= 0.
  bool stiffness_by_detail = false;  ///< true: detail_stiffness instead.
  DetailStiffness detail_stiffness = kDetailStiffness;
  FieldOptions fields;
  TransientOptions transient;
  ForceChain chain = ForceChain::bare;  ///< `whole`: ramp, slew, cap, as in the window.
  double strength = 1;                  ///< Of the whole chain, 0 .. 1.
  StrokeFrame frame = StrokeFrame::view;
  /// An open device that follows the stroke and feels the force; null: the hand is the stroke.
  SteeredDevice* device = nullptr;
};

/// The same for the core; forces are on from the first tick.
HapticOptions strokeHapticOptions(const StrokeOptions& options);

/// Where it leads the hand at a time, in its own frame; before its start and after its end the
/// first and the last point. Precondition: it has points.
ViewMm strokePlaceAt(const Stroke& stroke, double t_s);

/// Ticks that a stroke takes: one at its start, then one per millisecond up to its end.
/// @throw ArgumentError  longer than 1e7 s
std::uint64_t strokeTicks(const Stroke& stroke);

/// Runs the loop's core along a stroke on a clock of exactly 1 kHz: the same input gives the same
/// samples, bit by bit. Tick 0 is the placement (free at the HIP, or on the surface straight above
/// it); solving starts with tick 1.
/// @param each  called for every tick, with its time on the stroke's clock
/// @return ticks
/// @throw ArgumentError  no points, stiffness not finite and > 0, damping not
///                       finite and >= 0
/// @throw Cancelled
std::uint64_t runStroke(const HapticSpace& space, const StrokeOptions& options,
                        const Stroke& stroke,
                        const std::function<void(const HapticSample&, double t_s)>& each,
                        const Task& task = {});

}  // namespace relievo
