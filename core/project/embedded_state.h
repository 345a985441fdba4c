// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/project/project.h"

namespace relievo {

/// The state of embeddedState(), and that of an HDF5 recording. [worker]
/// @throw FileError  as embeddedState
std::optional<std::string> embeddedStateOf(const std::filesystem::path& host_file);

/// The work that a picture, a log or a project file shows, wherever its format keeps it; `file` is
/// where the state says, absolute. Nothing: it carries no state of ours, or one that shows no
/// region (a map). [worker]
/// @throw FileError  missing, damaged, or a state that this version cannot read
std::optional<Project> embeddedProject(const std::filesystem::path& host_file);

/// The same of a state that was read already. @throw FileError  this version cannot read it
std::optional<Project> embeddedProject(const std::filesystem::path& host_file,
                                       std::string_view state);

/// A state as text. What older versions wrote into pictures, a provenance, becomes a project;
/// nothing if it has no view. @param source  names it in errors  @throw FileError
std::optional<Project> projectFromState(std::string_view state, const std::string& source);

}  // namespace relievo
