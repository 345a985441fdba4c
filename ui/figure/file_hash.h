// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "core/base/task.h"

namespace relievo {

/// SHA-256 of a file's bytes, hexadecimal; empty if it cannot be read. [worker] @throw Cancelled
std::string sha256Of(const std::filesystem::path& file, const Task& task = {});

}  // namespace relievo
