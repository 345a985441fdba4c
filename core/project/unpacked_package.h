// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "core/base/task.h"

namespace relievo {

/// Unpacks a package into a new folder of `parent` that has the package's name, with a number where
/// that is taken, whole or not at all; where one of these folders holds the very same project and
/// its files, that is the one. [worker]
/// @return the folder, in which project.json lies
/// @throw FileError  as unpackPackage  @throw WriteError  also where `parent` takes no folder
/// @throw Cancelled
std::filesystem::path unpackedPackage(const std::filesystem::path& package,
                                      const std::filesystem::path& parent, const Task& task = {});

}  // namespace relievo
