// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

namespace relievo {

/// What the window says about touch; told by whoever runs the force loop.
struct TouchReadout {
  QString device;
  double rate_hz = 0;
  double worst_period_ms = 0;
  quint64 late_ticks = 0;
  bool realtime = false;
  QString realtime_note;  ///< Why real-time priority was not granted.
  bool forces_on = false;
  bool recording = false;
  quint64 recorded_samples = 0;
};

}  // namespace relievo
