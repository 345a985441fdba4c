// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace relievo {

/// Lets whatever else wants the processor go first, from now on: the calling thread and the threads
/// and programs that it starts afterwards. Software OpenGL draws a window with threads of the
/// window's own priority, on every core; beside work of the same priority each picture waits for
/// its turn. Where the system refuses, nothing changes. [the worker's thread]
void workInBackground() noexcept;

}  // namespace relievo
