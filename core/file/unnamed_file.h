// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "core/file/owned_fd.h"

namespace relievo {

/// A new file without a name in a folder, for reading and writing: it vanishes when it is closed,
/// and with the process however it ends. [any thread]
/// @return  holds -1 if the system refuses; errno says why
OwnedFd unnamedFile(const std::filesystem::path& folder);

}  // namespace relievo
