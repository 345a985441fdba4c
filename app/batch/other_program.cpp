// SPDX-License-Identifier: BSD-3-Clause
#include "app/batch/other_program.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>

#include "core/base/failure.h"
#include "core/io/worker_process.h"

namespace relievo {

void goOnAs(Program program, char** argv) {
  const bool draws = program == Program::draw;
  const std::filesystem::path file =
      ownProgram(draws ? "relievo-draw" : "relievo-window",
                 draws ? "Pictures cannot be drawn:" : "The window cannot be opened:");
  if (file.empty()) {
    if (draws) throw failure<MessageId::drawing_not_installed>();
    throw failure<MessageId::window_not_installed>();
  }
  std::cout.flush();
  std::cerr.flush();
  execv(file.c_str(), argv);
  throw failure<MessageId::program_not_started>(PathArgument{file},
                                                TextArgument{std::strerror(errno)});
}

}  // namespace relievo
