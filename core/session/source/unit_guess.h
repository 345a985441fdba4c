// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/base/unit.h"
#include "core/cloud/scan.h"
#include "core/message/message.h"

namespace relievo {

/// What a scan without a unit most likely has (docs/adr/0102-units-are-guessed.md).
struct UnitGuess {
  LengthUnit unit = LengthUnit::mm;
  /// Beyond doubt that it is no millimetre: used unasked, and said. Else only offered.
  bool is_strong = false;
  Message reason;  ///< "its coordinates are those of a map projection"
};

/// From coordinates, size, shape and format. @pre info.bounds
UnitGuess guessUnit(const ScanInfo& info);

struct UnitInUse {
  LengthUnit unit = LengthUnit::mm;
  UnitSource source = UnitSource::assumed;
};

/// The one rule of window and command line: the chosen unit, else the file's, else a strong guess,
/// else millimetres.
/// @param chosen_source  how `chosen` was chosen, if it was
UnitInUse unitInUse(const ScanInfo& info, const std::optional<LengthUnit>& chosen,
                    UnitSource chosen_source);

/// What to say of a unit that nobody stated: assumed or guessed, why, and what is likelier.
/// Nothing for others.
std::optional<Message> unitWords(const ScanInfo& info, const UnitInUse& unit);

}  // namespace relievo
