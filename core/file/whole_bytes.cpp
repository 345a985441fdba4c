// SPDX-License-Identifier: BSD-3-Clause
#include "core/file/whole_bytes.h"

#include <unistd.h>

#include <cerrno>

namespace relievo {

bool readWhole(int fd, void* out, std::size_t bytes) {
  auto* to = static_cast<char*>(out);
  while (bytes > 0) {
    const ssize_t got = ::read(fd, to, bytes);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    to += got;
    bytes -= static_cast<std::size_t>(got);
  }
  return true;
}

}  // namespace relievo
