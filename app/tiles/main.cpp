// SPDX-License-Identifier: BSD-3-Clause
// relievo-tiles: `relievo depthmap --memory` by several processes that mpirun or a scheduler
// starts, on one machine or on many (docs/adr/0232). Options, report and files are the same; the
// first process alone writes and speaks.
#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/batch.h"
#include "app/cli/processes.h"
#include "app/tiles/mpi_exchange.h"
#include "core/io/worker/reader_guard.h"
#include "core/provenance/program.h"

namespace {

/// What each of many says would come as many times.
void beSilent() {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

}  // namespace

int main(int argc, char** argv) {
  relievo::forbidReaders();
  // A file that may not grow is met like a full disk: what is written is completed.
  std::signal(SIGXFSZ, SIG_IGN);
  // Before MPI's own threads are there, so that none of them is ended by what runBatch waits for.
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  const relievo::Mpi mpi(argc, argv);
  relievo::MpiExchange processes;
  if (!processes.isFirst()) beSilent();
  if (argc > 1 && std::string_view(argv[1]) == "--version") {
    std::cout << relievo::versionLines();
    return 0;
  }
  relievo::batch::workTogether(processes);
  std::string verb = "depthmap";
  std::vector<char*> words{argv[0], verb.data()};
  words.insert(words.end(), argv + 1, argv + argc);
  words.push_back(nullptr);
  return relievo::runBatch(static_cast<int>(words.size()) - 1, words.data());
}
