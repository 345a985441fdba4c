// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/session/nodata.h"

namespace relievo {

/// The height (file unit) that stands for none: as somebody said, else the suspect one
/// (docs/adr/0216).
inline std::optional<double> missingHeight(const std::optional<NodataChoice>& said,
                                           const std::optional<SuspectHeight>& suspect) {
  if (said) return said->value;
  return suspect ? std::optional(suspect->value) : std::nullopt;
}

}  // namespace relievo
