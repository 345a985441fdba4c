// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/task.h"

namespace relievo {

/// Who opens a file.
enum class InputKind : std::uint8_t {
  scan,       ///< importScan; also files that nobody here reads: its refusal says what they are.
  raster,     ///< importRaster.
  tiled_map,  ///< TiledMap.
};

/// What a file is if it carries a state of ours; embeddedState and embeddedStateOf say whether it
/// does.
enum class HostFileKind : std::uint8_t { none, picture, recording, table, project, package };

/// What a file is, by its content first and its name second.
struct InputFacts {
  InputKind kind = InputKind::scan;
  HostFileKind host_file = HostFileKind::none;
  bool is_hdf5 = false;    ///< Of recordings.
  bool is_log = false;     ///< By its first columns and its name, as the window takes recordings.
  bool in_blocks = false;  ///< Can PointStream read its points? True also of damaged headers.
  bool has_faces = false;  ///< A PLY that says so.
  friend bool operator==(const InputFacts&, const InputFacts&) = default;
};

/// Asks an import process, which takes some milliseconds; nobody else says what a file is.
/// [any thread]
/// @throw FileError  missing, a directory, without permission, or empty; Cancelled
InputFacts inputFacts(const std::filesystem::path& file, const Task& task = {});

/// The same of several files by one process; nothing for those that cannot be opened. [any thread]
/// @throw FileError  there is no such process; Cancelled
std::vector<std::optional<InputFacts>> inputFacts(const std::vector<std::filesystem::path>& files,
                                                  const Task& task = {});

/// The same, in this process. [worker process]
InputFacts inputFactsHere(const std::filesystem::path& file);

}  // namespace relievo
