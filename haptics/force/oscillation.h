// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "core/base/vec3.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// Watches the force for a swing between 20 and 300 Hz that goes on: a hand and a surface that
/// excite each other. A hand that moves feels the relief at the same frequencies; therefore what is
/// allowed grows with its speed, of which an oscillation in place has none. A hand that is thrown
/// off and comes back swings more slowly than a tapping finger; it is known by the energy that the
/// surface owes.
struct OscillationOptions {
  bool on = true;
  double peak_to_peak_n = 0.5;         ///< Allowed of a hand that rests.
  double per_speed_n_s_per_mm = 0.02;  ///< And so much more per mm/s of the hand.
  double least_factor = 0.125;         ///< The stiffness is halved, down to this.
};

struct OscillationState {
  struct Axis {
    double mean = 0, band = 0;  ///< Below 20 Hz; 20 .. 300 Hz.
    double low = 0, high = 0;   ///< Extremes of the band in this block.
    int crossings = 0;          ///< Of the band's zero in this block.
    bool above = false;
  };
  std::array<Axis, 3> axes{};
  DeviceMm block_start;       ///< Where the hand was.
  int ticks = 0;              ///< Of this block.
  bool owed = false;          ///< In this block the passivity stage owed all that it may.
  int swinging_blocks = 0;    ///< In a row.
  std::uint8_t softened = 0;  ///< How often since forces were switched on.
  double factor = 1;          ///< Of the stiffness.
  bool started = false;
};

/// A block holds one period of the lowest frequency; two swinging blocks in a row, 100 ms, count.
inline constexpr int kOscillationBlockTicks = 50;

struct OscillationInput {
  DeviceN force;              ///< As it was sent.
  DeviceMm hip;               ///< The hand.
  bool deep_in_debt = false;  ///< The passivity stage owes all that it may.
};

/// One tick of the nominal 1 kHz. After 100 ms of swing or of deep debt the stiffness's factor is
/// halved; it stays so until forces go off.
OscillationState watchOscillation(const OscillationOptions& options, const OscillationInput& input,
                                  OscillationState state) RELIEVO_REALTIME;

}  // namespace relievo
