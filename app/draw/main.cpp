// SPDX-License-Identifier: BSD-3-Clause
// relievo-draw: the whole command line in a program that draws. `relievo` goes on as it. Programs
// that want the pixels of what it drew ask it for them.
#include <algorithm>
#include <csignal>
#include <iostream>
#include <QHash>
#include <string_view>

#include "app/cli/batch.h"
#include "app/draw/drawing_verbs.h"
#include "app/draw/hand_back.h"
#include "core/io/worker/reader_guard.h"

int main(int argc, char** argv) {
  relievo::forbidReaders();
  // A file that may not grow is met like a full disk: what is written is completed.
  std::signal(SIGXFSZ, SIG_IGN);
  // The fonts of a PDF stand in the order of a hash: the same figure has the same bytes.
  qSetGlobalQHashSeed(0);
  if (argc == 3 && argv[1] == std::string_view(relievo::kPixelsArgument)) {
    return relievo::handBackPixels(argv[2]);
  }
  relievo::batch::setDrawing(relievo::batch::ownDrawing());
  const bool libraries = std::any_of(argv + 1, argv + argc,
                                     [](std::string_view word) { return word == "--libraries"; });
  if (libraries && !relievo::isVerb(argv[1])) {
    std::cout << relievo::versionText();
    return 0;
  }
  return relievo::runBatch(argc, argv);
}
