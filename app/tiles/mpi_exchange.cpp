// SPDX-License-Identifier: BSD-3-Clause
#include "app/tiles/mpi_exchange.h"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <new>
#include <thread>

namespace relievo {
namespace {

constexpr int kCannotRead = 2;

int rankOfThis() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int ranksOfAll() {
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks;
}

/// Waits for all without keeping a core busy: MPI's own waiting does, and the core may be one that
/// another of the processes works on.
void waitForAll() {
  MPI_Request all = MPI_REQUEST_NULL;
  MPI_Ibarrier(MPI_COMM_WORLD, &all);
  constexpr std::chrono::milliseconds kMost{10};
  std::chrono::microseconds pause{20};
  for (int is_done = 0;;) {
    MPI_Test(&all, &is_done, MPI_STATUS_IGNORE);
    if (is_done != 0) return;
    std::this_thread::sleep_for(pause);
    pause = std::min<std::chrono::microseconds>(2 * pause, kMost);
  }
}

}  // namespace

Mpi::Mpi(int& argc, char**& argv) {
  int given = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &given);
}

Mpi::~Mpi() {
  MPI_Finalize();
}

MpiExchange::MpiExchange() : Exchange(rankOfThis(), ranksOfAll()) {}

std::vector<std::string> MpiExchange::gather(const std::string& mine) {
  try {
    return gathered(mine);
  } catch (const std::bad_alloc&) {
    // The others are in the middle of MPI's own steps, where nothing can be told them.
    std::cerr << "relievo: Process " << rank() + 1 << " of " << ranks()
              << " has no memory for what the others told. All end. Start fewer processes.\n";
    MPI_Abort(MPI_COMM_WORLD, kCannotRead);
    throw;
  }
}

std::vector<std::string> MpiExchange::gathered(const std::string& mine) const {
  waitForAll();
  const std::uint64_t size = mine.size();
  std::vector<std::uint64_t> sizes(static_cast<std::size_t>(ranks()));
  MPI_Allgather(&size, 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD);
  std::vector<std::string> all(sizes.size());
  for (int rank = 0; rank < ranks(); ++rank) {
    std::string& one = all[static_cast<std::size_t>(rank)];
    one = rank == this->rank() ? mine : std::string(sizes[static_cast<std::size_t>(rank)], '\0');
    constexpr std::size_t kAtOnce = std::size_t{1} << 30U;  // MPI counts with int.
    for (std::size_t at = 0; at < one.size(); at += kAtOnce) {
      const std::size_t count = std::min(kAtOnce, one.size() - at);
      MPI_Bcast(one.data() + at, static_cast<int>(count), MPI_BYTE, rank, MPI_COMM_WORLD);
    }
  }
  return all;
}

}  // namespace relievo
