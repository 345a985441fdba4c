// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/processes.h"

namespace relievo::batch {
namespace {

Exchange*& processesOfThisProgram() {
  static Alone alone;
  static Exchange* processes = &alone;
  return processes;
}

}  // namespace

void workTogether(Exchange& processes) {
  processesOfThisProgram() = &processes;
}

Exchange& processes() {
  return *processesOfThisProgram();
}

}  // namespace relievo::batch
