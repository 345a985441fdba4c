// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "haptics/force/force_model.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// Why the loop itself ended the forces.
enum class StopReason : std::uint8_t {
  none,
  held,           ///< A button of ForceStopOptions::buttons was held for kHeldS.
  window_silent,  ///< Who switched the forces on has not said for too long that he is there.
};

struct ForceStopOptions {
  std::uint32_t buttons = 1U << 2U;  ///< Any of these, held, stops the forces; the Falcon's centre.
  /// The loop fades the forces out if nobody has said for so long that the window lives; 0: never.
  double window_silence_s = 0;
  bool window_silent = false;  ///< Set by the loop: it is so.
};

/// The way out that needs nobody but the loop: it switches forces off and keeps them off until they
/// were not asked for in a tick. A press that began while forces were off, as one that switches
/// them on, does not stop them. [haptic loop]
class ForceStop {
 public:
  static constexpr double kHeldS = 1.5;
  static constexpr double kFadeS = 0.5;

  /// What is left of what was asked for.
  /// @param buttons  of this reading
  /// @param now_ns   time of the tick
  ForceOptions applied(ForceOptions asked, const ForceStopOptions& options, std::uint32_t buttons,
                       std::int64_t now_ns) RELIEVO_REALTIME;
  StopReason reason() const RELIEVO_REALTIME { return reason_; }

 private:
  friend struct NamedFields;  // Recordings hold every member by its name.
  bool heldLong(bool down, bool asked, std::int64_t now_ns) RELIEVO_REALTIME;

  StopReason reason_ = StopReason::none;
  bool down_ = false, counts_ = false;  // The press; it began while forces were asked for.
  std::int64_t down_ns_ = 0;            // It began.
  std::int64_t silent_ns_ = 0;          // The fading began.
};

}  // namespace relievo
