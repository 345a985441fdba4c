// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "core/base/origin.h"
#include "core/base/vec3.h"
#include "haptics/rt/realtime.h"
#include "haptics/sound/sound_laws.h"

namespace relievo::sound {

/// What a touch is at one moment, as far as it sounds.
struct TouchSample {
  double t_s = 0;
  DeviceMm hand, proxy;
  ViewMm normal{0, 0, 1};  ///< Of the surface at the proxy; its axes are the hand's.
  double force_n = 0;
  bool contact = false;
  bool led = false;      ///< By a guide, which is felt in place of the surface.
  bool at_edge = false;  ///< The proxy is where the window ends.
  CellStatus origin = CellStatus::outside;
  int detail = 1;
  double height = 0;   ///< Of the proxy, 0 lowest .. 1 highest of the object.
  double place = 0.5;  ///< Across the window, 0 left .. 1 right.
};

/// An earcon, and how fast the hand came.
struct Struck {
  Earcon earcon = Earcon::contact;
  double approach_mm_per_s = 0;
};

/// How a touch sounds from one moment to the next.
struct Heard {
  bool contact = false;
  bool led = false;           ///< The tone sounds in contact or not; of the surface nothing does.
  double slide_mm_per_s = 0;  ///< Of the proxy along the surface.
  double force_n = 0;
  double height = 0, place = 0.5;
  std::array<Struck, 4> struck{};
  std::size_t count = 0;  ///< Of struck.
};

/// Finds in samples what is to be heard: each happening once, nothing that is not in them. It looks
/// back over kSpanS for speeds. [one thread, realtime]
class TouchEvents {
 public:
  static constexpr double kSpanS = 0.008;

  Heard next(const TouchSample& given) RELIEVO_REALTIME;

 private:
  static constexpr std::size_t kMost =
      16;  // Samples in the span, at 1 kHz twice as many as needed.
  struct Velocity {
    double x = 0, y = 0, z = 0;
  };

  void keep(const TouchSample& sample) RELIEVO_REALTIME;
  Velocity speedOf(DeviceMm TouchSample::*member) const RELIEVO_REALTIME;

  std::array<TouchSample, kMost> kept_{};  // Oldest first.
  std::size_t count_ = 0;
};

}  // namespace relievo::sound
