// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/verbs/touch_setup.h"

namespace relievo::python {

/// The words that a command line would have behind its verb. The parameters of Python become words
/// and the words become the records of the verbs, by the parser of the verbs: no default, range or
/// name of an option stands here a second time.
using Words = std::vector<std::string>;

/// FILE and how its surface is made. @throw ArgumentError
batch::MapArguments mapArguments(const Words& words);
/// Which window of which level. @throw ArgumentError
batch::RegionArguments regionArguments(const Words& words);
/// As `relievo touch` has them; a stroke need not be a file, and nothing need be written.
/// @param words  FILE and its options first @throw ArgumentError
batch::TouchArguments touchArguments(const Words& words);

}  // namespace relievo::python
