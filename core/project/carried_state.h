// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "core/project/project.h"

namespace relievo {

/// Is the state that a picture carries a figure's project, and not a provenance? Told by the first
/// key, which in what we write names the kind.
bool isProject(std::string_view state);

/// The work that a picture or log shows: a figure's project as it is, or a project made from the
/// view of a provenance. `file` is as in the state. @param source  names it in errors
/// @throw FileError  neither of both, damaged, or a provenance without a view
Project projectFromState(std::string_view state, const std::string& source);

}  // namespace relievo
