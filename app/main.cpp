// SPDX-License-Identifier: BSD-3-Clause
// relievo: what people start. It loads no library and goes on as the program that does what is
// asked, so that each loads only what it uses (docs/adr/0151).
#include <iostream>
#include <string_view>

#include "app/cli/drawing.h"
#include "app/cli/other_program.h"
#include "core/base/error.h"
#include "core/provenance/program.h"

namespace {

/// The command line's program knows what is wrong with words; only what is plain is decided here.
relievo::Program programFor(int argc, char** argv) {
  if (argc < 2) return relievo::Program::window;
  return relievo::batch::isDrawingVerb(argv[1]) ? relievo::Program::draw
                                                : relievo::Program::command_line;
}

/// A part that is not installed, or no /proc to find it by.
int exitCodeOf(const relievo::Error& error) {
  constexpr int kCannotRead = 2, kNoProgram = 7;
  return dynamic_cast<const relievo::GraphicsError*>(&error) == nullptr ? kCannotRead : kNoProgram;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && argv[1] == std::string_view("--version")) {
    std::cout << relievo::versionLines();
    return std::cout.flush() ? 0 : 3;
  }
  try {
    relievo::goOnAs(programFor(argc, argv), argv);
  } catch (const relievo::Error& error) {
    std::cerr << "relievo: " << error.what() << '\n';
    return exitCodeOf(error);
  }
}
