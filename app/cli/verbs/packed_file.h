// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "core/base/task.h"

namespace relievo::batch {

/// The file that a recording of an unpacked package names: beside it, also behind a number, or in
/// the folder of inputs. Whoever made the package chose the name, so nothing else is looked at, by
/// whatever path or link. @param sha256  empty: not known, any is taken
/// @throw FileError  the package does not hold it  @throw Cancelled
std::filesystem::path packedFile(const std::filesystem::path& package_folder,
                                 const std::filesystem::path& recording,
                                 const std::filesystem::path& named, const std::string& sha256,
                                 const Task& task);

}  // namespace relievo::batch
