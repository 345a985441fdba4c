// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace relievo {

/// A fault of ours, one deep in every reader, to see that its fuzz target finds such places
/// (docs/dev/fuzzing.md). Only builds with RELIEVO_PLANTED_FAULTS hold it.
inline void plantedFault([[maybe_unused]] bool reached) noexcept {
#ifdef RELIEVO_PLANTED_FAULTS
  if (reached) __builtin_trap();
#endif
}

}  // namespace relievo
