// SPDX-License-Identifier: BSD-3-Clause
// relievo-draw: the whole command line in a program that draws. `relievo` goes on as it.
#include <csignal>
#include <QHash>

#include "app/batch/batch.h"
#include "app/draw/drawing_verbs.h"
#include "core/io/reader_guard.h"

int main(int argc, char** argv) {
  relievo::forbidReaders();
  // A file that may not grow is met like a full disk: what is written is completed.
  std::signal(SIGXFSZ, SIG_IGN);
  // The fonts of a PDF stand in the order of a hash: the same figure has the same bytes.
  qSetGlobalQHashSeed(0);
  relievo::batch::setDrawing(relievo::batch::ownDrawing());
  return relievo::runBatch(argc, argv);
}
