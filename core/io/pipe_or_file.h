// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <system_error>

#include "core/io/file_check.h"

namespace relievo {

/// Of what is read from its beginning to its end, once: a pipe or a device, whose writer may be
/// awaited when it is read, or a file that is there. [any thread]
/// @throw FileError  as checkedFileSize, but for pipes and devices
inline void requirePipeOrFile(const std::filesystem::path& file) {
  std::error_code unknown;
  const std::filesystem::file_type type = std::filesystem::status(file, unknown).type();
  if (type == std::filesystem::file_type::fifo || type == std::filesystem::file_type::character) {
    return;
  }
  static_cast<void>(checkedFileSize(file));
}

}  // namespace relievo
