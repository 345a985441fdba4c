// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/other_program.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>

#include "core/base/failure.h"
#include "core/file/own_program.h"

namespace relievo {

namespace {

std::filesystem::path placeOf(Program program) {
  switch (program) {
    case Program::command_line:
      return ownProgram("relievo-cli", "Commands cannot be run:");
    case Program::draw:
      return ownProgram("relievo-draw", "Pictures cannot be drawn:");
    case Program::window:
      break;
  }
  return ownProgram("relievo-window", "The window cannot be opened:");
}

[[noreturn]] void refuseMissing(Program program) {
  if (program == Program::draw) throw failure<MessageId::drawing_not_installed>();
  if (program == Program::window) throw failure<MessageId::window_not_installed>();
  // No part of a whole installation lacks it.
  throw failure<MessageId::program_not_started>(PathArgument{"relievo-cli"},
                                                TextArgument{std::strerror(ENOENT)});
}

}  // namespace

void goOnAs(Program program, char** argv) {
  const std::filesystem::path file = placeOf(program);
  if (file.empty()) refuseMissing(program);
  std::cout.flush();
  std::cerr.flush();
  execv(file.c_str(), argv);
  throw failure<MessageId::program_not_started>(PathArgument{file},
                                                TextArgument{std::strerror(errno)});
}

}  // namespace relievo
