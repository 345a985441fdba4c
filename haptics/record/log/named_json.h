// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "haptics/loop/core_snapshot.h"

namespace relievo {

// Options and states as JSON on one line without blanks, every member by its name (NamedFields).
// Numbers come back to the last bit.
std::string toJson(const HapticOptions& options);
std::string toJson(const CoreSnapshot& snapshot);
/// Its points, and not what follows from them.
std::string toJson(const GuidePath& path);

// What was written by any build: a name that this one does not know is left aside, and a member
// that the text does not name keeps the value it begins with.
/// @return false: it is no such JSON, or a member cannot have its value
bool fromJson(std::string_view text, HapticOptions& options);
bool fromJson(std::string_view text, CoreSnapshot& snapshot);
/// All of it has to be there. @return false: also if it is no path (completePath())
bool fromJson(std::string_view text, GuidePath& path);

}  // namespace relievo
