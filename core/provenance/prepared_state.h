// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/prepare/prepare.h"
#include "core/provenance/sha256.h"

namespace relievo {

/// The recipe that does the same again: scans with their checksums and the unit that was taken, and
/// the poses that were found, which are then used and not searched again.
/// @param inputs  one for each scan, named as they are found from the recipe's folder
Recipe recipeAgain(const Recipe& recipe, const Prepared& prepared,
                   const std::vector<InputFile>& inputs);

/// What a prepared cloud carries about itself, as JSON of one line: program, inputs, recipe, what
/// every step left, poses, library versions. No dates and no times: the same files and steps give
/// the same bytes.
std::string preparedState(const Recipe& recipe_again, const Prepared& prepared,
                          const std::vector<InputFile>& inputs);

/// Is this the state of a prepared cloud? Such a state is no view and no project.
bool isPreparedState(std::string_view json) noexcept;

/// A recipe as a file keeps it, in which names of scans are textOfName(), and back.
/// @throw FileError  no recipe; names `source`
std::string recipeText(const Recipe& recipe, int indent = 2);
Recipe recipeFromText(std::string_view text, const std::string& source);

}  // namespace relievo
