// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace relievo {

/// Whoever writes a file beside its place and renames it asks this first: a pipe, a device or a
/// folder of that name, also behind a symbolic link as /dev/stdout is one, would be gone.
/// [any thread]
/// @throw WriteError  there is something that is no regular file
void requireReplaceable(const std::filesystem::path& file);

}  // namespace relievo
