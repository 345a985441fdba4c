// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/replaceable.h"

#include <system_error>

#include "core/base/error.h"

namespace relievo {

void requireReplaceable(const std::filesystem::path& file) {
  std::error_code unknown;  // What cannot be asked cannot be opened either, which says why.
  const std::filesystem::file_status status = std::filesystem::status(file, unknown);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return;
  throw WriteError("Cannot write " + file.string() +
                   ": what has this name is no regular file. It was left as it is. Choose another "
                   "name.");
}

}  // namespace relievo
