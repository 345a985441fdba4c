// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/prepare/align/align.h"

namespace relievo {

// What parent and child agree on.
inline constexpr const char* kPrepareProgram = "relievo-prepare";
inline constexpr const char* kPrepareArgument = "prepare-" RELIEVO_VERSION_STRING;

/// main() of relievo-prepare: does one job under limits and answers its parent.
/// @param align  does the methods `points` and `auto` of the step Align; empty: none can be done
/// @return  exit status
int runPrepareWorker(int argc, char** argv, const AlignFunction& align);

}  // namespace relievo
