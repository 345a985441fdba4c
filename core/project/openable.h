// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "core/base/task.h"
#include "core/message/message.h"

namespace relievo {

/// Why the program cannot open a file; nothing: it can. Scans, height maps and maps by tiles are
/// read to their end, and so is the input of a project. Of pictures, packages and others that carry
/// a state only that they can be read is said. [worker] @throw Cancelled
std::optional<Message> openingRefusal(const std::filesystem::path& file, const Task& task = {});

}  // namespace relievo
