// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/exchange.h"

namespace relievo {

/// MPI from its begin to its end; one in a program. [main thread]
class Mpi {
 public:
  Mpi(int& argc, char**& argv);
  ~Mpi();
  Mpi(const Mpi&) = delete;
  Mpi& operator=(const Mpi&) = delete;
};

/// The processes that mpirun or a scheduler started together. What it does not say by MPI's own
/// means ends all of them: a process that is lost cannot be gone on without. [main thread]
class MpiExchange : public Exchange {
 public:
  /// @pre an Mpi is there
  MpiExchange();

 private:
  std::vector<std::string> gather(const std::string& mine) override;
  std::vector<std::string> gathered(const std::string& mine) const;
};

}  // namespace relievo
