// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace relievo {

/// Gives the calling thread a stack of its own for signal handlers, until it ends: without one, a
/// thread that has used up its stack ends without running any. A thread that has one keeps it;
/// where memory is short nothing happens. Threads that requestRealtime() have one. [any thread, not
/// in a loop]
void giveSignalStack();

}  // namespace relievo
