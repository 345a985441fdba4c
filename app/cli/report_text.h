// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "app/cli/json.h"

namespace relievo::batch {

/// A report, also where it tells names that are no UTF-8: those as textOfName() writes them.
std::string reportText(Json report);

/// A number of a file as people read it: what is stored as float, or as a whole number and a scale,
/// has digits as double that nobody measured. @return  the double of the short text
double shownNumber(double value);

/// "1 file is there", "2 files are there": a count, and what follows it.
std::string counted(std::uint64_t count, const char* one, const char* more);

}  // namespace relievo::batch
