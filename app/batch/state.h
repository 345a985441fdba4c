// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "app/batch/arguments.h"
#include "core/provenance/provenance.h"
#include "core/session/surface.h"

namespace relievo::batch {

/// Where what a verb writes to `out` comes from.
Provenance provenanceOfVerb(const MapArguments& arguments, const Surface& surface,
                            const std::filesystem::path& out, const Task& task);

/// A state that a file carries, and the input it was made from.
struct StoredState {
  Provenance provenance;
  std::filesystem::path input;
  bool input_changed = false;  ///< Its checksum is another one, and that was accepted.
};

/// Finds and checks the input: `given` if it is not empty, else where the state says, beside the
/// file, and in the working folder.
/// @throw FileError  no state in the file, or no input (E501); input changed and not accepted
/// (E501)
StoredState storedState(const std::filesystem::path& file, const std::string& given,
                        bool accept_changed, const Task& task);

/// The surface of a stored state; tells its messages on stderr.
Surface loadStored(const StoredState& state, const Task& task);

}  // namespace relievo::batch
