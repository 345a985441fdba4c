// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace relievo {

/// The programs of relievo that `relievo` goes on as (docs/adr/0151): all that draws loads
/// libraries of graphics, which verbs that draw nothing neither wait for nor need installed.
enum class Program {
  command_line,  ///< `relievo-cli`: the verbs that draw nothing, and every word about options.
  draw,          ///< `relievo-draw`: the verbs that draw, and the depth buffer.
  window         ///< `relievo-window`.
};

/// Goes on as another program in the same process, with the same arguments, files and terminal.
/// [one thread left] @throw GraphicsError  it is not installed, or cannot be started
[[noreturn]] void goOnAs(Program program, char** argv);

}  // namespace relievo
