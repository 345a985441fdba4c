// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/task.h"

namespace relievo {

/// Name of the entry that carries a state: PNG text chunk, comment line of a CSV file, line of a
/// TIFF's description after the caption, and element of an SVG's or a PDF's metadata.
inline constexpr std::string_view kStateKey = "relievo:state";

/// The state that a PNG, TIFF, PDF, SVG, CSV or PLY file of ours carries, as JSON: a provenance, in
/// pictures a project, in clouds how they were prepared; nothing if it has none. The file is told
/// by its content, not by its name. An import process reads it. [any thread]
/// @throw FileError  missing, or damaged before the entry; Cancelled
std::optional<std::string> embeddedState(const std::filesystem::path& file, const Task& task = {});

/// The same, in this process. [worker process]
std::optional<std::string> embeddedStateHere(const std::filesystem::path& file);

}  // namespace relievo
