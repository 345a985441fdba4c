// SPDX-License-Identifier: BSD-3-Clause
#include "core/file/unnamed_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace relievo {

OwnedFd unnamedFile(const std::filesystem::path& folder) {
  const std::string place = folder.empty() ? "." : folder.string();
  OwnedFd file(::open(place.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600));
  if (file.get() >= 0) return file;
  // Not every file system knows files without a name.
  std::string name = place + "/.relievo-spill-XXXXXX";
  file.reset(::mkostemp(name.data(), O_CLOEXEC));
  if (file.get() >= 0) ::unlink(name.c_str());
  return file;
}

}  // namespace relievo
