// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "haptics/device/pad/rumbler.h"
#include "haptics/record/sample_drain.h"

namespace relievo {

/// What a pad rumbles for, of a sample: the hand meets the surface, or is at the edge of the window
/// or of what was measured. Without forces, and after whatever ended them, nothing.
pad::TouchMoment touchMoment(const HapticSample& sample);

/// Lets pads rumble for the samples of a loop. A SampleDrain takes it along.
SampleSink rumbleSink(std::shared_ptr<pad::Rumbler> rumbler);

}  // namespace relievo
