// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/batch/arguments.h"
#include "core/provenance/provenance.h"
#include "core/session/surface.h"

namespace relievo::batch {

/// Where what a verb writes to `out` comes from.
Provenance provenanceOfVerb(const MapArguments& arguments, const Surface& surface,
                            const std::filesystem::path& out, const Task& task);
Provenance provenanceOfVerb(const MapArguments& arguments, const LargeMap& map,
                            const std::filesystem::path& out, const Task& task);

/// What a picture, map or log of ours carries, wherever its format keeps it; nothing if it carries
/// none: a figure's project, or a provenance (see isProject). @throw FileError  missing or damaged
std::optional<std::string> carriedState(const std::filesystem::path& file);

/// The file that a carrier was made from.
struct FoundInput {
  std::filesystem::path file;
  bool changed = false;  ///< Its checksum is another one, and that was accepted.
};
/// Finds and checks the input: `given` if it is not empty, else where the state says, beside the
/// carrier, and in the working folder.
/// @throw FileError  (E501) not there, or changed and not accepted
FoundInput findInput(const std::filesystem::path& carrier, const InputFile& input,
                     const std::string& given, bool accept_changed, const Task& task);

/// A provenance that a file carries, and the input it was made from.
struct StoredState {
  Provenance provenance;
  std::filesystem::path input;
};
/// @throw FileError  no state in the file; and as findInput
StoredState storedState(const std::filesystem::path& file, const std::string& given,
                        bool accept_changed, const Task& task);

/// The surface of a stored state; tells its messages on stderr.
Surface loadStored(const StoredState& state, const Task& task);

}  // namespace relievo::batch
