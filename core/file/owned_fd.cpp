// SPDX-License-Identifier: BSD-3-Clause
#include "core/file/owned_fd.h"

#include <unistd.h>

namespace relievo {

void OwnedFd::reset(int fd) noexcept {
  if (fd_ >= 0) ::close(fd_);
  fd_ = fd;
}

}  // namespace relievo
