// SPDX-License-Identifier: BSD-3-Clause
#include "core/provenance/program.h"

#include "core/provenance/commit.h"

namespace relievo {

std::string_view programVersion() noexcept {
  return RELIEVO_VERSION_STRING;
}

std::string_view programCommit() noexcept {
  return kCommit;
}

std::string versionLines() {
  return "relievo " + std::string(programVersion()) + "\ncommit " + std::string(programCommit()) +
         '\n';
}

}  // namespace relievo
