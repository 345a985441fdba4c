// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace relievo::batch {

/// What the parser of the command line refuses, in two sentences of ours.
/// @param sentence  CLI::ParseError::what()
std::string refusalText(std::string sentence);

}  // namespace relievo::batch
