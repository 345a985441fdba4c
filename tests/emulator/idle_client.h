// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace relievo::emulator {

/// What a process that does nothing but look at the Falcon 60 times a second, as a window does,
/// costs the processor: user and system time, seconds per second. The loop is stopped.
/// @param open  whether it has the Falcon open, ready and resting; else it never opened it
/// @return nothing: the Falcon did not become ready in a minute
std::optional<double> idleProcessorShare(bool open, double seconds);

}  // namespace relievo::emulator
